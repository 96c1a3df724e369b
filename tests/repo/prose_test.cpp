// SPDX-License-Identifier: MIT
// Folders have few sentences that readers have to read twice; each pattern finds a sample of its own.
#include "repo/prose.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <sstream>

#include "base/error.h"
#include "base/files.h"
#include "common/source.h"
#include "repo/text_units.h"

namespace strobe::repo {
namespace prose_test {

constexpr double kMostFlagged = 0.02;  // of a folder's text units
const char* const kCovered[] = {"passes",  "shaders", "scripts", "docs",      "experiments",
                                "project", "runtime", "tools",   "README.md", "ARTIFACT.md"};

std::string linesOf(const Findings& findings) {
  std::string text;
  for (const std::string& finding : findings) text += finding + "\n";
  return text;
}

std::string summaryOf(const std::string& name, const FolderProse& folder) {
  return fmt::format("{:12} {:5} text units {:5} flagged {:5.1f} %\n", name, folder.units, folder.flagged.size(),
                     100 * folder.share());
}

ProseReport projectProse() {
  std::string accepted = readText(sourceFolder() / "tests/repo/accepted_sentences.txt");
  return checkProse(readSources(sourceFolder()), parseAcceptedSentences(accepted));
}

TEST(ProseProject, FoldersAreReadableAtOnce) {
  ProseReport report = projectProse();
  for (const auto& [name, folder] : report.folders)
    if (folder.units) std::fputs(summaryOf(name, folder).c_str(), stdout);
  for (const char* name : kCovered) {
    const FolderProse& folder = report.folders[name];
    EXPECT_GT(folder.units, 0) << name;
    EXPECT_LE(folder.share(), kMostFlagged) << summaryOf(name, folder) << linesOf(folder.flagged);
  }
  EXPECT_EQ(linesOf(report.unused), "");
}

// Calls `visit(reason, sentence)` for each line "REASON | SENTENCE". Samples are in raw literals, which have no text
// units, so they do not count as sentences of this folder.
void forSamples(const std::string& samples, const std::function<void(const std::string&, const std::string&)>& visit) {
  std::istringstream lines(samples);
  for (std::string line; std::getline(lines, line);) {
    size_t bar = line.find(" | ");
    if (bar != std::string::npos) visit(line.substr(0, bar), line.substr(bar + 3));
  }
}

TEST(Prose, FindsASampleOfEachPattern) {
  forSamples(R"(
starts with a relative clause | What passes read.
starts with a relative clause | Whose samples these are.
starts with a relative clause | Of several layers the nearest.
starts with a relative clause | Whether the layer has a surface. Is it valid?  No.
starts with a relative clause | That of the nearest layer is first
starts with a relative clause | In what order passes run
'what ...' in place of a noun | Marks what moves over the pixel.
'what ...' in place of a noun | marks What is behind
'is no X' | The path is no line.
'is no X' | There is no_thing here, there are no "things", there was no use
relative clause after a preposition | The pass by whose mask rays start.
relative clause after a preposition | layers, of which two are valid
perception for computation | The pass is told the exposure.
perception for computation | Depth tells the layers apart.
perception for computation | The scene asks for a camera.
perception for computation | Errors are held against the mean.
people as data | The mask that nobody reads.
people as data | Somebody's pass.
pronoun without a noun | The velocity and that of the tile.
pronoun without a noun | Rays are those that hit.
pronoun without a noun | The same of the second layer.
there is none | The first pose if there is none.
there is none | A tile and the border of it.
idiom | Traced in turn of their priority.
idiom | It has no matter to add.
idiom | Traced, or else it is black.
idiom | Shows what formats change.
'is no X' | A card of 5" width, which is no line
'is no X' | An open `code is no line
private word | The layer explains the sample.
private word | Rays at their own time.
private word | Paths that bends lengthen.
)",
             [](const std::string& reason, const std::string& sentence) {
               std::vector<std::string> reasons = proseReasons(sentence);
               EXPECT_TRUE(std::count(reasons.begin(), reasons.end(), reason)) << reason << ": " << sentence;
             });
}

TEST(Prose, LeavesPlainSentences) {
  forSamples(R"(
question | Which layers does a pass read?
question | How far is each method from the truth? Which one is nearest to it?
start | Whatever the pass reads
start | Often the nearest layer, as published
what | The format states what passes read
no | The path is no longer a line, and no worse than before.
no | The layer has no surface, so the sample is not valid.
which | The layer which is nearest, in whichever order
ask | The launcher asks first on a terminal, and asks for a confirmation.
names | A foretelling Survey of Shafts
part of a word | The soft elsewhere of items, the bend_limit and the unlikely case
quoted | The published "what is behind" and “nobody” remain.
code | Set `what is` to `those of` if `has none` fails.
quotation in code | Write `"` and then `it is no line "` here.
)",
             [](const std::string& name, const std::string& sentence) {
               EXPECT_EQ(linesOf(proseReasons(sentence)), "") << name << ": " << sentence;
             });
}

// "LINE: TEXT" of each text unit.
std::string unitsIn(const char* path, const std::string& text) {
  std::string list;
  for (const TextUnit& unit : textUnits({path, text})) list += fmt::format("{}: {}\n", unit.line, unit.text);
  return list;
}

TEST(TextUnits, AreCommentBlocksOfCode) {
  EXPECT_EQ(unitsIn("a.cpp", R"(// SPDX-License-Identifier: MIT
// A block of two
//   lines, 'and an apostrophe.

int a;  // a trailing comment
        // with its second line
int b;  // another trailing comment, "quoted"
// A comment alone on its line.
char c = '"';  // not in a literal
/* In block
   comments too. */
// too short
std::string url = "https://not/a/comment";
)"),
            "2: A block of two lines, 'and an apostrophe.\n5: a trailing comment with its second line\n"
            "7: another trailing comment, \"quoted\"\n8: A comment alone on its line.\n9: not in a literal\n"
            "10: In block comments too.\n");
}

TEST(TextUnits, AreCommentBlocksOfScripts) {
  EXPECT_EQ(unitsIn("a.py", R"(#!/usr/bin/env python3
"""The doc string of
a module."""
a = "not a # comment here"  # but here is one
b = 'four words in quotes'
)"),
            "2: The doc string of a module.\n4: but here is one\n");
  std::string shell =
      "#!/bin/sh\n# A comment of shell scripts.\nx=${#x}; say 'three or four words'  # and it goes on\n";
  EXPECT_EQ(unitsIn("a.sh", shell), "2: A comment of shell scripts.\n3: and it goes on\n");
  EXPECT_EQ(unitsIn("a", shell), unitsIn("a.sh", shell));
  EXPECT_EQ(unitsIn("a", "# A text without a shebang.\n"), "");
}

TEST(TextUnits, AreDocStringsOfLua) {
  EXPECT_EQ(unitsIn("a.lua", R"(---@field a string a LuaLS annotation
return pass.compute {
  doc   = "One line of text",
  fails = "Several lines " ..
          "of text, " -- a comment
    .. "in two units of text",
  other = 'A literal that joins ' .. "a \"second\" one",
  named = "A literal before " .. name .. " and the literal after it",
  list = { "a text of this list", "and a second text" },
}
)"),
            "3: One line of text\n4: Several lines of text,\n6: in two units of text\n7: A literal that joins a "
            "\"second\" one\n8: and the literal after it\n9: a text of this list\n9: and a second text\n");
}

TEST(TextUnits, AreMessagesOfCpp) {
  EXPECT_EQ(unitsIn("a.cpp", R"x(
fail("a message of \"five\" words " "and a second part",
     "too short", "void run() { this is code }");
fail("a second message "
     "of two lines");
std::regex(R"(a "raw" literal is read)");
auto code = R"y(a raw literal of
several "lines" is not read)y";
int million = 1'000'000; fail("a literal after digit separators");
)x"),
            "2: a message of \"five\" words and a second part\n4: a second message of two lines\n"
            "6: a \"raw\" literal is read\n9: a literal after digit separators\n");
}

TEST(TextUnits, AreParagraphsAndCellsOfMarkdown) {
  EXPECT_EQ(unitsIn("a.md", R"(# A heading of five words
A paragraph with
    an indented line.

| a header | the cell of a header |
|---|---|
| a cell with `code` in it | short |

    some code that is indented

```lua
-- some code between two fences
```
<!-- a comment of
HTML --> A number in <!--= mark -->1.2<!--/--> is read.
)"),
            "2: A paragraph with an indented line.\n5: the cell of a header\n7: a cell with `code` in it\n"
            "15: A number in 1.2 is read.\n");
}

TEST(Prose, CountsByTopFolderWithoutGeneratedPages) {
  const std::string plain = "A path that is not a line.\n", reason = "'is no X': ", flagged = R"(A path that is no line.
)";
  ProseReport report = checkProse({{"docs/a.md", flagged + "\n" + plain},
                                   {"docs/b/c.md", plain},
                                   {"README.md", plain},
                                   {"passes/a.lua", "\n-- A comment of two lines:\n-- " + flagged},
                                   {"docs/reference/a.md", flagged},
                                   {"docs/stability.md", flagged},
                                   {"experiments/a/result.md", flagged},
                                   {"tools/mutate/mutations.md", flagged},
                                   {"CHANGELOG.md", flagged}},
                                  {});
  EXPECT_EQ(report.folders.size(), 3u);
  EXPECT_EQ(report.folders["docs"].units, 3);
  EXPECT_DOUBLE_EQ(report.folders["docs"].share(), 1.0 / 3);
  EXPECT_EQ(linesOf(report.folders["docs"].flagged), "docs/a.md:1: " + reason + flagged);
  EXPECT_EQ(report.folders["README.md"].flagged.size(), 0u);
  EXPECT_EQ(linesOf(report.folders["passes"].flagged),
            "passes/a.lua:2: " + reason + "A comment of two lines: " + flagged);
}

TEST(Prose, AcceptsSentencesOfTheList) {
  const std::string first = "The first sentence.", reads = "Nobody reads it.", writes = "Somebody writes it.";
  const Source page{"docs/a.md", first + " Nobody\nreads it. " + writes + "\n"};
  auto check = [&](const std::string& list) {
    ProseReport report = checkProse({page}, parseAcceptedSentences(list));
    return fmt::format("{} {}", report.folders["docs"].flagged.size(), linesOf(report.unused));
  };
  auto entry = [](const std::string& sentence) { return "docs/a.md: " + sentence + "\n"; };
  EXPECT_EQ(check(""), "1 ");
  EXPECT_EQ(check("# comment\n" + entry(reads)), "1 ");
  EXPECT_EQ(check(entry(reads) + entry(writes)), "0 ");
  EXPECT_EQ(check("docs/b.md: " + reads + "\n"),
            "1 accepted_sentences.txt:1: is no longer in its file: " + reads + "\n");
  EXPECT_EQ(check("\n" + entry(first)), "1 accepted_sentences.txt:2: is not flagged: " + first + "\n");
  EXPECT_THROW(parseAcceptedSentences("A sentence without a file\n"), Error);
  EXPECT_THROW(parseAcceptedSentences("A sentence: with a colon\n"), Error);
}

}  // namespace prose_test
}  // namespace strobe::repo
