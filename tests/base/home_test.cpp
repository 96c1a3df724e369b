// SPDX-License-Identifier: MIT
// Where files are found, and how they are named.
#include "base/home.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include "base/error.h"
#include "common/source.h"

namespace strobe {
namespace {

namespace fs = std::filesystem;

class Homes : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (fs::temp_directory_path() / "strobe_home_XXXXXX").string();
    folder_ = ::mkdtemp(pattern.data());
  }
  void TearDown() override { fs::remove_all(folder_); }

  void write(const std::string& file, const std::string& text = "") const { writeFileAtomically(folder_ / file, text); }

  Path folder_;
};

TEST_F(Homes, FindFilesByName) {
  write("ours/passes/edge/b.lua");
  write("ours/passes/edge/a.lua");
  write("ours/passes/x.lua");
  write("ours/passes/x.glsl");
  Home home(folder_ / "ours");
  EXPECT_EQ(home.find("passes/edge/a.lua"), folder_ / "ours/passes/edge/a.lua");
  EXPECT_FALSE(home.find("passes/edge/c.lua"));
  EXPECT_EQ(home.at("passes/edge/c.lua"), folder_ / "ours/passes/edge/c.lua");
  EXPECT_EQ(home.namesIn("passes/edge", ".lua"), (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(home.namesBelow("passes", ".lua"), (std::vector<std::string>{"edge/a", "edge/b", "x"}));
  EXPECT_TRUE(home.namesBelow("nothing", ".lua").empty());
}

TEST_F(Homes, ShowPathsRelativeToTheirRoot) {
  write("ours/passes/a.lua", "text");
  Home home(folder_ / "ours");
  EXPECT_EQ(home.shown(folder_ / "ours/passes/a.lua"), "passes/a.lua");
  EXPECT_EQ(home.shown("/elsewhere/a.lua"), "/elsewhere/a.lua");
  EXPECT_EQ(home.nameOf(folder_ / "ours/passes/a.lua"), "passes/a.lua");
  EXPECT_FALSE(home.nameOf(folder_ / "other/a.lua"));
  EXPECT_EQ(home.read(folder_ / "ours/passes/a.lua"), "text");
  try {
    home.read(folder_ / "ours/passes/b.lua");
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "passes/b.lua: cannot be read: No such file or directory");
  }
}

TEST_F(Homes, AreFoundByThePlaceOfTheProgram) {
  EXPECT_EQ(Home::shippedWith(folder_ / "bin/strobe"), sourceFolder());
  write("share/strobe/scripts/strobe/pass.lua");
  EXPECT_EQ(Home::shippedWith(folder_ / "bin/strobe"), folder_ / "share/strobe");
  EXPECT_EQ(Home::shippedWith(folder_ / "elsewhere/bin/strobe"), sourceFolder());
}

TEST_F(Homes, HaveSharedDataWhereThereIsSome) {
  EXPECT_FALSE(Home(folder_ / "ours").data());
  fs::create_directories(folder_ / "shared");
  EXPECT_EQ(Home(folder_ / "ours").data(), folder_ / "shared");
  EXPECT_FALSE(Home({folder_ / "ours"}, folder_ / "nowhere").data());
}

}  // namespace
}  // namespace strobe
