// SPDX-License-Identifier: MIT
// The documentation is connected: links of Markdown files, the length of the README, the index.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <sstream>

#include "base/files.h"
#include "common/source.h"
#include "repo/lint.h"

namespace strobe::repo {
namespace docs_test {

namespace fs = std::filesystem;

std::vector<Source> pages() {
  std::vector<Source> result = readSources(sourceFolder());
  std::erase_if(result, [](const Source& source) { return !source.path.ends_with(".md"); });
  return result;
}

// The page without fenced and indented code and text in backticks.
std::string proseOf(const std::string& page) {
  std::istringstream lines(page);
  std::string prose;
  bool fenced = false;
  for (std::string line; std::getline(lines, line);) {
    bool fence = line.starts_with("```");
    if (!fenced && !fence && !line.starts_with("    ")) prose += line;
    fenced = fenced != fence;
    prose += "\n";
  }
  return std::regex_replace(prose, std::regex("`[^`\n]*`"), "x");
}

// The anchor of a heading: lower case with letters, digits and hyphens only.
std::string anchorOf(const std::string& heading) {
  std::string anchor;
  for (char c : heading) {
    if (std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '_' || (c & 0x80))
      anchor += char(std::tolower(c));
    if (c == ' ') anchor += '-';
  }
  return anchor;
}

bool hasHeading(const std::string& page, const std::string& anchor) {
  std::istringstream lines(page);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("#") && anchorOf(line.substr(line.find_first_not_of("# "))) == anchor) return true;
  return false;
}

// Broken targets of "[text](target)" and "![text](target)".
Findings brokenLinks(const std::vector<Source>& pages, const fs::path& folder) {
  static const std::regex link(R"rx(\]\(([^)\s]+)\))rx");
  Findings findings;
  for (const Source& page : pages) {
    std::istringstream lines(proseOf(page.text));
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
      ++number;
      for (std::sregex_iterator at(line.begin(), line.end(), link), end; at != end; ++at) {
        std::string target = (*at)[1];
        if (target.find("://") != std::string::npos || target.starts_with("mailto:")) continue;
        size_t hash = target.find('#');
        std::string file = target.substr(0, hash), anchor = hash == std::string::npos ? "" : target.substr(hash + 1);
        fs::path path = file.empty() ? folder / page.path : (folder / page.path).parent_path() / file;
        bool good = fs::exists(path);
        if (good && !anchor.empty()) good = hasHeading(readText(path), anchor);
        if (!good) findings.push_back(page.path + ":" + std::to_string(number) + ": " + target);
      }
    }
  }
  return findings;
}

// Missing files of this repository that pages name as code: `runtime/x.cpp`. Pages on projects name files of a project.
Findings namedButMissing(const std::vector<Source>& pages, const fs::path& folder) {
  static const std::regex named("`((?:runtime|shaders|passes|scripts|tests|docs|experiments|tools)/[a-z0-9_./]*)`");
  Findings findings;
  for (const Source& page : pages)
    for (std::sregex_iterator at(page.text.begin(), page.text.end(), named), end; at != end; ++at)
      if (!page.path.ends_with("projects.md") && !fs::exists(folder / (*at)[1].str()))
        findings.push_back(page.path + ": " + (*at)[1].str());
  return findings;
}

// Changes shown as "--- FILE" whose removed and context lines are not in that file in this order. "..." skips lines.
Findings staleDiffs(const std::vector<Source>& pages, const fs::path& folder) {
  Findings findings;
  for (const Source& page : pages) {
    std::istringstream lines(page.text);
    bool inside = false;
    std::string file, text;
    size_t from = 0;
    for (std::string line; std::getline(lines, line);) {
      if (line.starts_with("```")) inside = line == "```diff";
      if (!inside || line.size() < 2 || line.find("...") != std::string::npos) continue;
      if (line.starts_with("--- ")) {
        file = line.substr(4, line.find(',') - 4);
        text = fs::exists(folder / file) ? readText(folder / file) : "";
        from = 0;
      } else if (line[0] == '-' || line[0] == ' ') {
        from = text.find("\n" + line.substr(1) + "\n", from);
        if (from == std::string::npos) findings.push_back(page.path + ": " + file + " has no line " + line.substr(1));
        if (from == std::string::npos) from = 0;
      }
    }
  }
  return findings;
}

std::string joined(const Findings& findings) {
  std::string text;
  for (const std::string& finding : findings) text += finding + "\n";
  return text;
}

TEST(Docs, EveryRelativeLinkHasATarget) {
  ASSERT_GT(pages().size(), 20u);
  EXPECT_EQ(joined(brokenLinks(pages(), sourceFolder())), "");
}

TEST(Docs, BrokenLinksAreFound) {
  auto links = [](const std::string& text) { return brokenLinks({{"docs/x.md", text}}, sourceFolder()).size(); };
  EXPECT_EQ(links("[a](../README.md) [b](https://example.org/x) `[c](none.md)`\n\n    [d](none.md)\n"), 0u);
  EXPECT_EQ(links("[a](README.md)\n[b](none.md) ![c](pictures/none.png)\n"), 2u);
  EXPECT_EQ(links("[a](../README.md#start) [b](../README.md#no-such-heading)\n"), 1u);
}

TEST(Docs, NamedFilesExist) {
  EXPECT_EQ(joined(namedButMissing(pages(), sourceFolder())), "");
  EXPECT_EQ(
      namedButMissing({{"docs/x.md", "`runtime/none.cpp` `runtime/page/page.h` `none/x`"}}, sourceFolder()).size(), 1u);
}

TEST(Docs, ShownChangesMatchTheFiles) {
  EXPECT_EQ(joined(staleDiffs(pages(), sourceFolder())), "");
  std::string page = "```diff\n--- LICENSE\n-no such line\n+more\n```\n-nor this, outside\n";
  EXPECT_EQ(staleDiffs({{"docs/x.md", page}}, sourceFolder()).size(), 1u);
}

TEST(Docs, ReadmeIsShort) {
  std::string readme = readText(sourceFolder() / "README.md");
  EXPECT_LE(std::count(readme.begin(), readme.end(), '\n'), 100);
}

TEST(Docs, IndexHasEveryPage) {
  std::string index = readText(sourceFolder() / "docs/README.md");
  for (const std::string& name : namesIn(sourceFolder() / "docs", ".md"))
    if (name != "README") EXPECT_NE(index.find("(" + name + ".md"), std::string::npos) << name;
}

}  // namespace docs_test
}  // namespace strobe::repo
