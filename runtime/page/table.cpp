// SPDX-License-Identifier: MIT
#include "page/table.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/json.h"
#include "base/utf8.h"
#include "page/markup.h"
#include "page/templates.h"

namespace strobe::page {

namespace {

const TableCell& cellOf(const Row& row, size_t column) {
  static const TableCell kEmpty;
  return column < row.size() ? row[column] : kEmpty;
}

void requireSound(const Table& table) {
  for (const Row& row : table.rows)
    STROBE_ASSERT(row.size() <= table.columns.size(), "{} cells in {} columns", row.size(), table.columns.size());
}

// Line of aligned text, without trailing blanks.
std::string alignedLine(const Table& table, const std::vector<std::string>& cells, const std::vector<size_t>& widths) {
  std::string line;
  for (size_t c = 0; c < cells.size(); ++c) {
    if (c > 0) line += "  ";
    line += table.columns[c].numeric ? paddedLeft(cells[c], widths[c]) : paddedRight(cells[c], widths[c]);
  }
  return line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
}

// Escapes bars and replaces line ends, because both would end the cell.
std::string markdownCell(const std::string& text) {
  std::string result;
  for (char c : text) result += c == '|' ? std::string("\\|") : std::string(1, c == '\n' ? ' ' : c);
  return result;
}

std::string markdownLine(const std::vector<std::string>& cells) {
  std::string line = "|";
  for (const std::string& cell : cells) line += " " + cell + (cell.empty() ? "|" : " |");
  return line + "\n";
}

std::string markedMarkdown(const TableCell& cell) {
  bool bold = cell.mark == Emphasis::best || cell.mark == Emphasis::bad;
  std::string text = markdownCell(cell.text);
  return bold && !text.empty() && text.find("**") == std::string::npos ? "**" + text + "**" : text;
}

const char* cellClassOf(Emphasis mark) {
  switch (mark) {
    case Emphasis::best:
      return "best";
    case Emphasis::bad:
      return "bad";
    case Emphasis::faint:
      return "faint";
    case Emphasis::none:
      break;
  }
  return "";
}

std::string classesOf(const Column& column, Emphasis mark) {
  std::string classes = column.numeric ? "number" : "";
  if (mark != Emphasis::none) classes += (classes.empty() ? "" : " ") + std::string(cellClassOf(mark));
  return classes;
}

Json cellJson(const Column& column, const TableCell& cell, bool names_the_row) {
  return {{"cell_html", inlineHtml(cell.text)},
          {"classes", classesOf(column, cell.mark)},
          {"tip", cell.tip},
          {"names_the_row", names_the_row}};
}

}  // namespace

Table withoutEmptyColumns(Table table) {
  requireSound(table);
  for (size_t c = table.columns.size(); c-- > 0;) {
    auto is_empty = [&](const Row& row) { return cellOf(row, c).text.empty(); };
    if (!std::all_of(table.rows.begin(), table.rows.end(), is_empty)) continue;
    table.columns.erase(table.columns.begin() + long(c));
    for (Row& row : table.rows)
      if (c < row.size()) row.erase(row.begin() + long(c));
  }
  return table;
}

void markBest(Table& table, size_t column, bool largest) {
  auto competes = [&](const Row& row) {
    return column < row.size() && row[column].mark == Emphasis::none && std::isfinite(row[column].value);
  };
  const TableCell* best = nullptr;
  int competing = 0;
  for (const Row& row : table.rows) {
    if (!competes(row)) continue;
    ++competing;
    if (!best || (largest ? row[column].value > best->value : row[column].value < best->value)) best = &row[column];
  }
  if (competing < 2) return;
  std::string text = best->text;
  for (Row& row : table.rows)
    if (competes(row) && row[column].text == text) row[column].mark = Emphasis::best;
}

std::string textOf(const Table& table) {
  requireSound(table);
  if (table.columns.empty()) return "";
  std::vector<std::vector<std::string>> lines(1);
  for (const Column& column : table.columns) lines[0].push_back(inlinePlain(column.title));
  for (const Row& row : table.rows) {
    lines.emplace_back();
    for (size_t c = 0; c < table.columns.size(); ++c) lines.back().push_back(inlinePlain(cellOf(row, c).text));
  }
  std::vector<size_t> widths(table.columns.size(), 0);
  for (const auto& line : lines)
    for (size_t c = 0; c < line.size(); ++c) widths[c] = std::max(widths[c], displayWidth(line[c]));
  std::string text = table.caption.empty() ? "" : inlinePlain(table.caption) + "\n\n";
  for (const auto& line : lines) text += alignedLine(table, line, widths);
  for (const std::string& note : table.notes) text += "\n" + inlinePlain(note) + "\n";
  return text;
}

std::string markdownOf(const Table& table) {
  requireSound(table);
  if (table.columns.empty() || table.rows.empty()) return "";
  std::vector<std::string> titles, rules;
  for (const Column& column : table.columns) {
    titles.push_back(markdownCell(column.title));
    rules.push_back(column.numeric ? "---:" : "---");
  }
  std::string text = table.caption.empty() ? "" : table.caption + "\n\n";
  text += markdownLine(titles) + markdownLine(rules);
  for (const Row& row : table.rows) {
    std::vector<std::string> cells;
    for (size_t c = 0; c < table.columns.size(); ++c) cells.push_back(markedMarkdown(cellOf(row, c)));
    text += markdownLine(cells);
  }
  for (const std::string& note : table.notes) text += "\n" + note + "\n";
  return text;
}

std::string htmlOf(const Table& table) {
  requireSound(table);
  if (table.columns.empty()) return "";
  Json json = {{"caption_html", inlineHtml(table.caption)},
               {"columns", Json::array()},
               {"rows", Json::array()},
               {"notes", Json::array()}};
  for (const Column& column : table.columns)
    json["columns"].push_back(
        {{"title_html", inlineHtml(column.title)}, {"classes", classesOf(column, Emphasis::none)}});
  for (const Row& row : table.rows) {
    Json cells = Json::array();
    for (size_t c = 0; c < table.columns.size(); ++c)
      cells.push_back(cellJson(table.columns[c], cellOf(row, c), c == 0));
    json["rows"].push_back({{"cells", cells}});
  }
  for (const std::string& note : table.notes) json["notes"].push_back({{"note_html", inlineHtml(note)}});
  return rendered("table.mustache", json);
}

}  // namespace strobe::page
