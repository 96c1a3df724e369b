// SPDX-License-Identifier: MIT
// Every folder has few sentences that readers have to read twice; each pattern finds its sample.
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

TEST(ProseProject, FoldersAreReadable) {
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

// A pattern that never matches would pass on any project. The samples are in a raw literal, which has no text units, so
// they do not count as sentences of this folder.
TEST(Prose, EachPatternFindsASample) {
  std::istringstream samples(R"(starts with a relative clause | What passes read.
'what ...' in place of a noun | Marks what moves over the pixel.
'is no X' | The path is no line.
relative clause after a preposition | The pass by whose mask rays start.
perception for computation | The pass is told the exposure.
people as data | The mask that nobody reads.
pronoun without a noun | The velocity and that of the tile.
there is none | The first pose if there is none.
idiom | Traced in turn of their priority.
private word | Rays at their own time.
 | Which layers does a pass read?
 | The published "what is behind" remains, and `what is`.)");
  for (std::string line; std::getline(samples, line);) {
    const size_t bar = line.find(" | ");
    EXPECT_EQ(fmt::format("{}", fmt::join(proseReasons(line.substr(bar + 3)), "; ")), line.substr(0, bar)) << line;
  }
}

}  // namespace prose_test
}  // namespace strobe::repo
