// SPDX-License-Identifier: MIT
#include "base/watch.h"

#include <gtest/gtest.h>

#include <fstream>

namespace strobe {
namespace watch_test {

namespace fs = std::filesystem;

class WatchTest : public ::testing::Test {
 protected:
  WatchTest() { fs::create_directories(folder_ / "inner"); }
  ~WatchTest() override { fs::remove_all(folder_); }

  void save(const std::string& name) { std::ofstream(folder_ / name) << "text\n"; }

  Path folder_ = Path(::testing::TempDir()) / "watch_test";
  Watch watch_;
};

TEST_F(WatchTest, SeesWhatHappensToFilesAndNothingElse) {
  save("inner/a.lua");
  watch_.add(folder_);
  EXPECT_FALSE(watch_.changed()) << "nothing since";
  save("inner/a.lua");
  EXPECT_TRUE(watch_.changed()) << "written";
  EXPECT_FALSE(watch_.changed()) << "said once";
  fs::rename(folder_ / "inner/a.lua", folder_ / "inner/b.lua");
  EXPECT_TRUE(watch_.changed()) << "renamed";
  fs::remove(folder_ / "inner/b.lua");
  EXPECT_TRUE(watch_.changed()) << "removed";
  std::ifstream(folder_ / "inner/b.lua");
  EXPECT_FALSE(watch_.changed()) << "looked for";
}

TEST_F(WatchTest, WaitsForTheEndOfAWrite) {
  watch_.add(folder_);
  std::ofstream file(folder_ / "a.lua");
  file << "half" << std::flush;
  EXPECT_FALSE(watch_.changed());
  file << " and half\n";
  file.close();
  EXPECT_TRUE(watch_.changed());
}

TEST_F(WatchTest, FollowsFoldersThatAppear) {
  watch_.add(folder_);
  fs::create_directories(folder_ / "new");
  EXPECT_TRUE(watch_.changed()) << "it may hold something already";
  save("new/a.lua");
  EXPECT_TRUE(watch_.changed());
}

TEST_F(WatchTest, FollowsAFolderInThePlaceOfAnother) {
  watch_.add(folder_);
  save("inner/a.lua");
  fs::create_directories(folder_ / "next");
  EXPECT_TRUE(watch_.changed());
  fs::rename(folder_ / "inner", folder_ / "before");
  fs::rename(folder_ / "next", folder_ / "inner");
  EXPECT_TRUE(watch_.changed());
  save("inner/a.lua");
  EXPECT_TRUE(watch_.changed()) << "in the place of the other";
}

// A folder that nothing deep lies around is found again by whoever adds it again.
TEST_F(WatchTest, KnowsNoFolderByItsNameAlone) {
  const Path inner = folder_ / "inner";
  watch_.addFlat(inner);
  fs::rename(inner, folder_ / "before");
  fs::create_directories(inner);
  watch_.addFlat(inner);
  watch_.changed();
  save("inner/a.lua");
  EXPECT_TRUE(watch_.changed());
}

TEST_F(WatchTest, AFlatOneHasNothingBelowIt) {
  watch_.addFlat(folder_);
  save("inner/a.lua");
  EXPECT_FALSE(watch_.changed());
  save("a.lua");
  EXPECT_TRUE(watch_.changed());
}

TEST_F(WatchTest, WhatIsNotThereIsNoMistake) {
  watch_.add(folder_ / "nowhere");
  watch_.addFlat(folder_ / "nowhere");
  EXPECT_FALSE(watch_.changed());
}

}  // namespace watch_test
}  // namespace strobe
