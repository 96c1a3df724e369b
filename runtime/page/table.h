// SPDX-License-Identifier: MIT
// A table as a value, and the three ways in which it is shown: aligned text for a terminal, Markdown for the documents,
// HTML for pages. Cells are written in the inline notation of markup.h: `code`, **strong** and [text](address).
#pragma once

#include <limits>
#include <string>
#include <vector>

namespace strobe::page {

// How a cell stands out in Markdown and HTML, by more than colour: `best` and `bad` are bold.
enum class Mark { none, best, bad, faint };

struct Cell {
  Cell() = default;
  Cell(std::string shown, Mark how = Mark::none, std::string hint = "")
      : text(std::move(shown)), mark(how), tip(std::move(hint)) {}
  Cell(const char* shown, Mark how = Mark::none, std::string hint = "") : Cell(std::string(shown), how, hint) {}
  // A number and how it is written (number.h).
  Cell(double number, std::string shown, Mark how = Mark::none) : text(std::move(shown)), mark(how), value(number) {}

  std::string text;
  Mark mark = Mark::none;
  std::string tip;                                          // shown where the pointer rests; HTML alone
  double value = std::numeric_limits<double>::quiet_NaN();  // what `text` says, where it is a number
};

using Row = std::vector<Cell>;

struct Column {
  Column(std::string name, bool right = false) : title(std::move(name)), numeric(right) {}
  Column(const char* name, bool right = false) : Column(std::string(name), right) {}

  std::string title;
  bool numeric = false;  // aligned at the right
};

// The first column names the row.
struct Table {
  std::string caption;
  std::vector<Column> columns;
  std::vector<Row> rows;           // at most as many cells as there are columns; missing ones are empty
  std::vector<std::string> notes;  // a paragraph each, below the table

  void add(Row row) { rows.push_back(std::move(row)); }
};

// The table without the columns that are empty in every row.
Table withoutEmptyColumns(Table table);

// Marks the smallest (or largest) value of a column as `best`: every cell that shows the same text as that does, among
// those that are not marked yet and have a finite value. Nothing is marked where fewer than two cells compete.
void markBest(Table& table, size_t column, bool largest = false);

// Each ends in a newline. A table without columns is "", and so is the Markdown of one without rows.
std::string textOf(const Table& table);
std::string markdownOf(const Table& table);
std::string htmlOf(const Table& table);

}  // namespace strobe::page
