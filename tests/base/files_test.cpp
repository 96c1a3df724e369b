// SPDX-License-Identifier: MIT
#include "base/files.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <cstdlib>

#include "base/error.h"
#include "common/refusal.h"
#include "common/temporary_folder.h"

namespace strobe {
namespace files_test {

namespace fs = std::filesystem;

class Files : public ::testing::Test {
 protected:
  const testing::TemporaryFolder temporary_;
  const Path folder_ = temporary_.path();
};

TEST_F(Files, WrittenFileIsComplete) {
  writeFileAtomically(folder_ / "new" / "file.txt", std::string_view("first"));
  writeFileAtomically(folder_ / "new" / "file.txt", std::string_view("second"));
  EXPECT_EQ(readText(folder_ / "new" / "file.txt"), "second");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_ / "new"), fs::directory_iterator()), 1);
}

// A limit on file sizes stands in for a full disk: the write fails half way.
TEST_F(Files, FailedWriteKeepsTheOldFile) {
  writeFileAtomically(folder_ / "file.txt", std::string_view("old"));
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit before;
  ::getrlimit(RLIMIT_FSIZE, &before);
  rlimit small = {1024, before.rlim_max};
  ::setrlimit(RLIMIT_FSIZE, &small);
  const std::string message = testing::refusalOf(
      [&] { writeFileAtomically(folder_ / "file.txt", std::string_view(std::string(100000, 'x'))); });
  ::setrlimit(RLIMIT_FSIZE, &before);
  EXPECT_NE(message.find("file.txt: cannot be written: "), std::string::npos) << message;
  EXPECT_EQ(readText(folder_ / "file.txt"), "old");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1);
}

TEST_F(Files, MissingFileIsNamed) {
  const std::string refused = testing::refusalOf([&] { readText(folder_ / "absent.txt"); });
  EXPECT_NE(refused.find("absent.txt: cannot be read: No such file"), std::string::npos) << refused;
}

TEST_F(Files, ExtensionsMayBeInCapitals) {
  for (const char* name : {"a.glb", "A.GLB", "b/a.gLb", ".glb"}) EXPECT_TRUE(hasExtension(name, ".glb")) << name;
  for (const char* name : {"", "glb", "a.glb2", "a.gltf", "aglb"}) EXPECT_FALSE(hasExtension(name, ".glb")) << name;
}

TEST(Names, NearestNameIsAMisspellingOnly) {
  std::vector<std::string> names = {"depth", "normal", "velocity"};
  EXPECT_EQ(nearestName("dept", names), "depth");
  EXPECT_EQ(nearestName("veloctiy", names), "velocity");
  EXPECT_EQ(nearestName("zzzzzz", names), "");
}

}  // namespace files_test
}  // namespace strobe
