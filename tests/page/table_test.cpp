// SPDX-License-Identifier: MIT
// A table has the same content in its three forms: text columns are aligned, Markdown and HTML have every cell, with
// text escaped.
#include "page/table.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/utf8.h"
#include "page/markup.h"

namespace strobe::page {
namespace table_test {

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  for (size_t from = 0; from < text.size();) {
    size_t end = text.find('\n', from);
    lines.push_back(text.substr(from, end - from));
    from = end + 1;
  }
  return lines;
}

int countOf(const std::string& text, const std::string& what) {
  int count = 0;
  for (size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++count;
  return count;
}

// Cells of a Markdown line, without surrounding spaces.
std::vector<std::string> cellsOf(const std::string& line) {
  std::vector<std::string> cells(1);
  for (size_t i = 1; i + 1 < line.size(); ++i) {
    if (line[i] == '|' && line[i - 1] != '\\') cells.emplace_back();
    else cells.back() += line[i];
  }
  for (std::string& cell : cells) {
    cell.erase(0, std::min(cell.find_first_not_of(' '), cell.size()));
    cell.erase(cell.find_last_not_of(' ') + 1);
  }
  return cells;
}

Table made() {
  Table table{"", {"name", {"error", true}, "note"}};
  table.add({"truth ±", {0.5, "0.5"}, "a | b"});
  table.add({"日本", {12.25, "12.25"}, ""});
  table.add({"é", {NAN, "–"}});
  return table;
}

TEST(TextTable, ColumnsAlignByDisplayWidth) {
  EXPECT_EQ(textOf(made()),
            "name     error  note\n"
            "truth ±    0.5  a | b\n"
            "日本     12.25\n"
            "é            –\n");
}

TEST(TextTable, CaptionsAndNotesAreSeparateLines) {
  Table table{"What `x` is", {"a"}, {{"1"}}, {"see [there](x.md)"}};
  EXPECT_EQ(textOf(table), "What `x` is\n\na\n1\n\nsee there\n");
}

TEST(MarkdownTable, EveryLineHasTheSameNumberOfCells) {
  std::vector<std::string> lines = linesOf(markdownOf(made()));
  ASSERT_EQ(lines.size(), 5u);
  EXPECT_EQ(cellsOf(lines[1]), (std::vector<std::string>{"---", "---:", "---"}));
  EXPECT_EQ(cellsOf(lines[2]), (std::vector<std::string>{"truth ±", "0.5", "a \\| b"}));
  EXPECT_EQ(cellsOf(lines[4]), (std::vector<std::string>{"é", "–", ""}));
}

TEST(MarkdownTable, WithoutRowsIsEmpty) { EXPECT_EQ(markdownOf(Table{"", {"a"}}), ""); }

TEST(MarkdownTable, LineEndStaysInItsCell) {
  EXPECT_EQ(linesOf(markdownOf(Table{"", {"a"}, {{"one\ntwo"}}})).size(), 3u);
}

TEST(HtmlTable, EscapesEveryCell) {
  Table table = made();
  table.rows[0][2] = {"<b> & `x<y`", Emphasis::bad, "say \"so\""};
  std::string html = htmlOf(table);
  EXPECT_EQ(countOf(html, "<th scope=\"col\""), 3);
  EXPECT_EQ(countOf(html, "<th scope=\"row\">"), 3) << "the first cell names the row";
  EXPECT_EQ(countOf(html, "<td"), 6) << "missing cells are empty cells";
  EXPECT_NE(html.find("<td class=\"bad\" title=\"say &quot;so&quot;\">&lt;b&gt; &amp; <code>x&lt;y</code></td>"),
            std::string::npos)
      << html;
  EXPECT_NE(html.find("<td class=\"number\">12.25</td>"), std::string::npos) << html;
}

TEST(Table, DropsEmptyColumns) {
  Table table{"", {"a", "b", "c"}, {{"1", "", "3"}, {"4"}}};
  table = withoutEmptyColumns(table);
  ASSERT_EQ(table.columns.size(), 2u);
  EXPECT_EQ(table.columns[1].title, "c");
  EXPECT_EQ(table.rows[0][1].text, "3");
}

TEST(Table, MarksTheSmallestShownValue) {
  Table table{"", {"a", {"b", true}}};
  table.add({"floor", {0.1, "0.1", Emphasis::faint}});
  table.add({"one", {0.2001, "0.2"}});
  table.add({"two", {0.2002, "0.2"}});
  table.add({"three", {NAN, "–"}});
  table.add({"four", {3, "3"}});
  markBest(table, 1);
  std::vector<Emphasis> marks;
  for (const Row& row : table.rows) marks.push_back(row[1].mark);
  EXPECT_EQ(marks,
            (std::vector<Emphasis>{Emphasis::faint, Emphasis::best, Emphasis::best, Emphasis::none, Emphasis::none}));
  EXPECT_EQ(cellsOf(linesOf(markdownOf(table))[3])[1], "**0.2**");
}

TEST(Table, MarksNothingWithoutACompetitor) {
  Table table{"", {"a", "b"}, {{"one", {1, "1"}}}};
  markBest(table, 1);
  EXPECT_EQ(table.rows[0][1].mark, Emphasis::none);
}

TEST(Markup, IsKeptByDocumentsAndShownByPages) {
  EXPECT_EQ(inlineHtml("**a `b`** [c & d](e.md#f)"),
            "<strong>a <code>b</code></strong> <a href=\"e.md#f\">c &amp; d</a>");
  EXPECT_EQ(inlinePlain("**a `b`** [c & d](e.md#f)"), "a `b` c & d");
}

TEST(Markup, LeavesOtherTextUnchanged) {
  for (const char* text : {"[0,T]", "2 * 3 ** 2", "a ` b", "normal [world] (x)", "[x](javascript:alert(1))"}) {
    EXPECT_EQ(inlinePlain(text), text);
    EXPECT_EQ(inlineHtml(text), escaped(text));
  }
}

TEST(DisplayWidth, CountsColumns) {
  EXPECT_EQ(displayWidth("naïve – ±"), 9u);
  EXPECT_EQ(displayWidth("e\xcc\x81"), 1u) << "a combining accent";
  EXPECT_EQ(displayWidth("日本"), 4u);
  EXPECT_EQ(paddedLeft("é", 3), "  é");
}

}  // namespace table_test
}  // namespace strobe::page
