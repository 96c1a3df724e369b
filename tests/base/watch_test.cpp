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
  FileWatch watch_;
};

TEST_F(WatchTest, DetectsFileChangesOnly) {
  save("inner/a.lua");
  watch_.add(folder_);
  EXPECT_FALSE(watch_.changed()) << "nothing since";
  save("inner/a.lua");
  EXPECT_TRUE(watch_.changed()) << "written";
  EXPECT_FALSE(watch_.changed()) << "reported once";
  fs::rename(folder_ / "inner/a.lua", folder_ / "inner/b.lua");
  EXPECT_TRUE(watch_.changed()) << "renamed";
  fs::remove(folder_ / "inner/b.lua");
  EXPECT_TRUE(watch_.changed()) << "removed";
  std::ifstream read(folder_ / "inner/b.lua");
  EXPECT_FALSE(watch_.changed()) << "reading is not a change";
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
  EXPECT_TRUE(watch_.changed()) << "the new folder may already contain files";
  save("new/a.lua");
  EXPECT_TRUE(watch_.changed());
}

TEST_F(WatchTest, FollowsAReplacedFolder) {
  watch_.add(folder_);
  save("inner/a.lua");
  fs::create_directories(folder_ / "next");
  EXPECT_TRUE(watch_.changed());
  fs::rename(folder_ / "inner", folder_ / "before");
  fs::rename(folder_ / "next", folder_ / "inner");
  EXPECT_TRUE(watch_.changed());
  save("inner/a.lua");
  EXPECT_TRUE(watch_.changed()) << "file in the replacing folder";
}

// A folder that was replaced under the same name is watched again when it is added again.
TEST_F(WatchTest, RewatchesAReplacedFlatFolder) {
  const Path inner = folder_ / "inner";
  watch_.addFlat(inner);
  fs::rename(inner, folder_ / "before");
  fs::create_directories(inner);
  watch_.addFlat(inner);
  watch_.changed();
  save("inner/a.lua");
  EXPECT_TRUE(watch_.changed());
}

TEST_F(WatchTest, FlatFolderExcludesItsSubfolders) {
  watch_.addFlat(folder_);
  save("inner/a.lua");
  EXPECT_FALSE(watch_.changed());
  save("a.lua");
  EXPECT_TRUE(watch_.changed());
}

// An edit of a linked file happens in the folder of the link's target.
TEST_F(WatchTest, FollowsLinksToFiles) {
  const Path store = folder_.parent_path() / "watch_test_store";
  fs::create_directories(store / "deep");
  save("../watch_test_store/deep/a.lua");
  fs::create_symlink("deep/a.lua", store / "mid.lua");
  fs::create_symlink("../../watch_test_store/mid.lua", folder_ / "inner/a.lua");
  watch_.add(folder_);
  save("../watch_test_store/deep/a.lua");
  EXPECT_TRUE(watch_.changed()) << "target of two links written";
  fs::create_symlink("other.lua", store / "next.lua");
  EXPECT_TRUE(watch_.changed()) << "link created in a folder of the chain";
  fs::rename(store / "next.lua", store / "mid.lua");
  EXPECT_TRUE(watch_.changed()) << "link of the chain replaced";

  FileWatch flat;
  flat.addFlat(folder_ / "inner");
  flat.addBehind(folder_ / "inner/a.lua");
  flat.addBehind(folder_ / "inner");
  save("../watch_test_store/other.lua");
  EXPECT_TRUE(flat.changed()) << "target of a link in a flat folder";
  fs::remove_all(store);
}

TEST_F(WatchTest, NewLinkIsAChange) {
  save("a.lua");
  watch_.add(folder_);
  fs::create_symlink("../a.lua", folder_ / "inner/b.lua");
  EXPECT_TRUE(watch_.changed());
  fs::create_hard_link(folder_ / "a.lua", folder_ / "inner/c.lua");
  EXPECT_TRUE(watch_.changed()) << "hard link";
}

TEST_F(WatchTest, CircularLinkIsIgnored) {
  fs::create_symlink("b", folder_ / "a");
  fs::create_symlink("a", folder_ / "b");
  watch_.add(folder_);
  EXPECT_FALSE(watch_.changed());
}

TEST_F(WatchTest, MissingFolderIsNotAMistake) {
  watch_.add(folder_ / "nowhere");
  watch_.addFlat(folder_ / "nowhere");
  EXPECT_FALSE(watch_.changed());
}

}  // namespace watch_test
}  // namespace strobe
