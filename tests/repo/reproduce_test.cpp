// SPDX-License-Identifier: MIT
// tools/reproduce: every measured number of the pages has a mark with a claim, and an edited number is found.
#include "repo/reproduce.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <regex>

#include "base/files.h"
#include "common/source.h"

namespace strobe::repo {
namespace reproduce_test {

namespace fs = std::filesystem;

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

class Reproduce : public ReproduceTest {
 protected:
  void TearDown() override { fs::remove_all(copy_); }

  // Copies the pages and the files they name, so that tests can change them.
  void copyPages() {
    copy_ = fs::path(::testing::TempDir()) / ::testing::UnitTest::GetInstance()->current_test_info()->name();
    fs::remove_all(copy_);
    fs::create_directories(copy_);
    for (const char* part : {"README.md", "ARTIFACT.md", "docs", "experiments"})
      fs::copy(sourceFolder() / part, copy_ / part, fs::copy_options::recursive);
    fs::create_directories(copy_ / "tools/mutate");
    fs::copy(sourceFolder() / "tools/mutate/mutations.md", copy_ / "tools/mutate/mutations.md");
  }
  void replace(const std::string& page, const std::string& what, const std::string& by) {
    std::string text = readText(copy_ / page);
    size_t at = text.find(what);
    ASSERT_NE(at, std::string::npos) << page << " has no " << what;
    writeFileAtomically(copy_ / page, text.replace(at, what.size(), by));
  }
  Outcome marks() { return reproduce({"--marks", "--root", copy_.string()}); }
  // A claim that reads committed results and starts no device.
  Outcome claim(const std::string& more = "--smoke") {
    return reproduce(
        {"--smoke", "--only", "readme_real_scenes", "--root", copy_.string(), "-o", (copy_ / "out").string(), more});
  }

  fs::path copy_;
};

TEST_F(Reproduce, EveryMeasuredNumberHasAMark) {
  Outcome outcome = reproduce({"--marks"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.text, "every measured number has a mark, every mark a claim\n");
}

TEST_F(Reproduce, NumberWithoutAMarkIsFound) {
  copyPages();
  for (const char* text : {"It takes 3.7 ms.", "It takes 37 ms.", "37 of 40 hold.", "| a |\n|---|\n| **37** |"}) {
    std::string page = readText(sourceFolder() / "docs/projects.md");
    writeFileAtomically(copy_ / "docs/projects.md", page + "\n" + text + "\n");
    Outcome outcome = marks();
    EXPECT_EQ(outcome.code, 1) << text;
    EXPECT_TRUE(contains(outcome.text, "docs/projects.md:") && contains(outcome.text, " has no mark")) << outcome.text;
  }
  std::string page = readText(sourceFolder() / "docs/projects.md");
  writeFileAtomically(copy_ / "docs/projects.md",
                      page + "\nVulkan 1.3, `3.7 ms`, 320x180, 16 samples.\n\n    3.7 ms\n");
  EXPECT_EQ(marks().code, 0) << marks().text;
}

TEST_F(Reproduce, IncompleteMarksAreFound) {
  copyPages();
  std::string page = readText(sourceFolder() / "docs/projects.md");
  auto found = [&](const std::string& text) {
    writeFileAtomically(copy_ / "docs/projects.md", page + "\n" + text + "\n");
    return marks().text;
  };
  EXPECT_TRUE(
      contains(found("A <!--= none -->3.7<!--/--> b."), "no claim of tools/reproduce/claims.py is called 'none'"));
  EXPECT_TRUE(contains(found("A <!--= none -->3.7 b."), "the mark 'none' has no end"));
  EXPECT_TRUE(contains(found("A <!--= none -->b<!--/-->."), "the mark 'none' has no number"));
  EXPECT_TRUE(contains(found("<!--= none -->3.7<!--/--> b."), "a line that begins with a mark"));
  EXPECT_TRUE(contains(found("A 3<!--/--> b."), "ends no mark"));
  EXPECT_TRUE(contains(found("A <!--= frame_time -->3.7<!--/--> b."), "'frame_time' is marked twice"));
}

TEST_F(Reproduce, ListedTextsAndPicturesExist) {
  copyPages();
  replace("README.md", "<!--= readme_frame_time -->", "");
  replace("docs/glossary.md", "0.5 is a shutter of 180 degrees", "a shutter");
  fs::copy(copy_ / "docs/pictures/demo.png", copy_ / "docs/pictures/another.png");
  std::string text = marks().text;
  EXPECT_TRUE(contains(text, "no page marks a number with 'readme_frame_time'")) << text;
  EXPECT_TRUE(contains(text, "definitions.py lists a text that is not there: 0.5 is a shutter")) << text;
  EXPECT_TRUE(contains(text, "docs/pictures/another.png: no claim of tools/reproduce/claims.py makes it")) << text;
}

TEST_F(Reproduce, EditedNumberIsFound) {
  copyPages();
  Outcome before = claim();
  EXPECT_EQ(before.code, 0) << before.text;
  EXPECT_TRUE(contains(before.text, "every verdict \"holds\"")) << before.text;
  replace("README.md", "**.0092**", "**.0085**");
  Outcome after = claim();
  EXPECT_EQ(after.code, 1) << after.text;
  EXPECT_TRUE(contains(after.text, "readme_real_scenes misses: line ")) << after.text;
  EXPECT_TRUE(contains(after.text, ": .0085 is 0.0092")) << after.text;
}

TEST_F(Reproduce, ReplaceWritesTheNewNumbers) {
  copyPages();
  const std::string page = readText(copy_ / "README.md");
  replace("README.md", "**.0092**", "**.9999**");
  EXPECT_EQ(claim("--replace").code, 1) << "the verdict is about the numbers stated before";
  EXPECT_EQ(readText(copy_ / "README.md"), page);
  EXPECT_EQ(claim().code, 0);
}

TEST_F(Reproduce, TablesOfClaimsMatchTheClaims) {
  copyPages();
  const std::string page = readText(copy_ / "ARTIFACT.md");
  replace("ARTIFACT.md", "| `figure1` |", "| `figure_one` |");
  Outcome outcome = marks();
  EXPECT_EQ(outcome.code, 1);
  EXPECT_TRUE(contains(outcome.text, "ARTIFACT.md: the tables of claims differ from")) << outcome.text;
  EXPECT_EQ(reproduce({"--table", "--root", copy_.string()}).code, 0);
  EXPECT_EQ(readText(copy_ / "ARTIFACT.md"), page);
}

TEST_F(Reproduce, SmokeTakesAtMostTenMinutesAndHasAllKinds) {
  std::smatch parts;
  const std::string text = reproduce({"--list", "--smoke"}).text;
  const std::regex counts(
      "[0-9]+ claims: numbers [0-9]+, experiments [0-9]+, figures [0-9]+, pages 1; about ([0-9.]+) minutes");
  ASSERT_TRUE(std::regex_search(text, parts, counts)) << text;
  EXPECT_LE(std::stod(parts[1]), 10);
  for (const char* claim : {"figure1 ", "experiment_curves ", "room_composites ", "stability_page "})
    EXPECT_TRUE(contains(text, std::string("\n") + claim)) << claim;
  EXPECT_TRUE(contains(text, "curves.lua -o FOLDER --only shot=pendulum")) << text;
}

TEST_F(Reproduce, SmokeCountsUntouchedClaims) {
  copyPages();
  const std::string text = claim().text;
  EXPECT_TRUE(contains(text, "\ntouched 1 claims: numbers 1\nnot touched ")) << text;
  EXPECT_TRUE(std::regex_search(text, std::regex("not touched [0-9]+ claims: .*, experiments [0-9]+, figures [0-9]+")))
      << text;
}

TEST_F(Reproduce, UnknownClaimsAreRefused) {
  Outcome outcome = reproduce({"--only", "real_scenes_iner"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_EQ(outcome.text,
            "strobe reproduce: there is no claim 'real_scenes_iner'; did you mean 'real_scenes_inner'?\n");
  EXPECT_EQ(reproduce({"--nonsense"}).code, 2);
}

}  // namespace reproduce_test
}  // namespace strobe::repo
