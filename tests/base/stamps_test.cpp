// SPDX-License-Identifier: MIT
#include "base/stamps.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace strobe {
namespace stamps_test {

class StampsTest : public ::testing::Test {
 protected:
  StampsTest() { std::filesystem::create_directories(folder_); }
  ~StampsTest() override { std::filesystem::remove_all(folder_); }

  static void settle() { std::this_thread::sleep_for(std::chrono::milliseconds(120)); }
  Stamps of(const Path& path) {
    Stamps stamps;
    stamps.add(path);
    return stamps;
  }

  Path folder_ = Path(::testing::TempDir()) / "stamps_test";
  Path file_ = folder_ / "a.txt";
};

TEST_F(StampsTest, DetectChangesOfAFile) {
  writeFileAtomically(file_, "one");
  EXPECT_FALSE(of(file_).current()) << "the file may change again within the same clock tick";
  settle();
  Stamps before = of(file_);
  EXPECT_TRUE(before.current());
  auto time = std::filesystem::last_write_time(file_);
  writeFileAtomically(file_, "two");
  std::filesystem::last_write_time(file_, time);
  EXPECT_FALSE(before.current()) << "same size and modification time";
  settle();
  Stamps after = of(file_);
  EXPECT_TRUE(after.current());
  std::filesystem::remove(file_);
  EXPECT_FALSE(after.current());
}

TEST_F(StampsTest, DetectNewFiles) {
  settle();
  Stamps folder = of(folder_), missing = of(file_);
  EXPECT_TRUE(folder.current() && missing.current());
  writeFileAtomically(file_, "one");
  EXPECT_FALSE(folder.current());
  EXPECT_FALSE(missing.current());
}

}  // namespace stamps_test
}  // namespace strobe
