// SPDX-License-Identifier: MIT
// Table as a value, with three formats: aligned text for a terminal, Markdown for documents, HTML for pages. Cells use
// the inline notation of markup.h: `code`, **strong** and [text](address).
#pragma once

#include <limits>
#include <string>
#include <vector>

namespace strobe::page {

// Emphasis of a cell in Markdown and HTML. `best` and `bad` are bold, so that emphasis does not depend on colour.
enum class Emphasis { none, best, bad, faint };

// Cell of a table: text, emphasis, tooltip and, for a number, its value.
struct TableCell {
  TableCell() = default;
  TableCell(std::string shown, Emphasis how = Emphasis::none, std::string hint = "")
      : text(std::move(shown)), mark(how), tip(std::move(hint)) {}
  TableCell(const char* shown, Emphasis how = Emphasis::none, std::string hint = "")
      : TableCell(std::string(shown), how, std::move(hint)) {}
  // Number and its text (number.h).
  TableCell(double number, std::string shown, Emphasis how = Emphasis::none)
      : text(std::move(shown)), mark(how), value(number) {}

  std::string text;
  Emphasis mark = Emphasis::none;
  std::string tip;                                          // tooltip, HTML only
  double value = std::numeric_limits<double>::quiet_NaN();  // number in `text`; NaN: not a number
};

using Row = std::vector<TableCell>;

// Column of a table: title and alignment; columns of numbers are right-aligned.
struct Column {
  Column(std::string name, bool right = false) : title(std::move(name)), numeric(right) {}
  Column(const char* name, bool right = false) : Column(std::string(name), right) {}

  std::string title;
  bool numeric = false;  // right-aligned
};

// Table of a report. The first column names the row.
struct Table {
  std::string caption;
  std::vector<Column> columns;
  std::vector<Row> rows;           // at most one cell per column; missing cells are empty
  std::vector<std::string> notes;  // paragraphs below the table

  void add(Row row) { rows.push_back(std::move(row)); }
};

// Removes the columns that are empty in every row.
Table withoutEmptyColumns(Table table);

// Marks the smallest (or largest) value of a column as `best`, in every cell with the same text. Only cells with a
// finite value and without a mark take part. Marks nothing if fewer than two cells take part.
void markBest(Table& table, size_t column, bool largest = false);

// Each text ends in a newline. A table without columns gives ""; Markdown also gives "" for a table without rows.
std::string textOf(const Table& table);
std::string markdownOf(const Table& table);
std::string htmlOf(const Table& table);

}  // namespace strobe::page
