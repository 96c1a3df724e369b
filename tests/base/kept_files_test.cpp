// SPDX-License-Identifier: MIT
#include "base/kept_files.h"

#include <gtest/gtest.h>

#include <chrono>

#include "common/temporary_folder.h"

namespace strobe {
namespace kept_files_test {

namespace fs = std::filesystem;

class KeptFilesIn : public ::testing::Test {
 protected:
  void write(const std::string& name, const std::string& text) const { writeFileAtomically(folder_ / name, text); }

  const testing::TemporaryFolder temporary_;
  const Path folder_ = temporary_.path();
};

TEST_F(KeptFilesIn, FindsStoredBytesByKey) {
  const KeptFiles kept(folder_ / "new");
  const std::string bytes = {'1', 0, '2'};
  kept.keep("a", bytes);
  EXPECT_EQ(kept.find("a"), bytes);
  EXPECT_FALSE(kept.find("b"));
  kept.keep("none", "");
  EXPECT_EQ(kept.find("none"), "");
}

TEST_F(KeptFilesIn, IgnoresDamagedFiles) {
  const KeptFiles kept(folder_);
  kept.keep("a", "bytes");
  const std::string whole = readText(folder_ / "a");
  for (size_t size = 0; size < whole.size(); ++size) {
    write("a", whole.substr(0, size));
    EXPECT_FALSE(kept.find("a")) << size << " bytes";
  }
  std::string other = whole;
  other.back() ^= 1;
  write("a", other);
  EXPECT_FALSE(kept.find("a"));
  write("a", whole);
  EXPECT_TRUE(kept.find("a"));
}

TEST_F(KeptFilesIn, UnusableFolderIsIgnored) {
  write("file", "a file in the place of the folder");
  for (const Path& folder : {folder_ / "file", Path()}) {
    KeptFiles(folder).keep("a", "bytes");
    EXPECT_FALSE(KeptFiles(folder).find("a"));
  }
}

constexpr size_t kOne = 32 + 8;  // hash + content, bytes

TEST_F(KeptFilesIn, EvictsTheOldestFiles) {
  const KeptFiles kept(folder_);
  for (int i = 0; i < 9; ++i) {
    kept.keep(std::to_string(i), "8 bytes.");
    fs::last_write_time(folder_ / std::to_string(i), fs::file_time_type::clock::now() - std::chrono::hours(9 - i));
  }
  KeptFiles(folder_, 9 * kOne).makeRoom();
  EXPECT_TRUE(kept.find("0")) << "there is room";
  KeptFiles(folder_, 8 * kOne).makeRoom();
  EXPECT_FALSE(kept.find("2"));
  for (int i = 3; i < 9; ++i) EXPECT_TRUE(kept.find(std::to_string(i))) << i;
}

TEST_F(KeptFilesIn, OneProcessStaysWithinTheLimit) {
  const KeptFiles kept(folder_, 20 * kOne);
  for (int i = 0; i < 200; ++i) kept.keep(std::to_string(i), "8 bytes.");
  EXPECT_LE(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 27);
}

}  // namespace kept_files_test
}  // namespace strobe
