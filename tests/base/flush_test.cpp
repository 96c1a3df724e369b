// SPDX-License-Identifier: MIT
// Flushes to disk when a file is written and renamed.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <vector>

#include "base/files.h"
#include "base/temporary_file.h"
#include "common/temporary_folder.h"

namespace {
std::vector<ino_t>* flushed = nullptr;  // set while a test records
}

// Replaces the C library's function.
extern "C" int fsync(int descriptor) {
  struct stat status {};
  if (flushed && ::fstat(descriptor, &status) == 0) flushed->push_back(status.st_ino);
  return int(::syscall(SYS_fsync, descriptor));
}

namespace strobe {
namespace flush_test {

ino_t inodeOf(const Path& path) {
  struct stat status {};
  EXPECT_EQ(::stat(path.c_str(), &status), 0) << path;
  return status.st_ino;
}

// A rename is durable after its folder is flushed; the content is flushed before the name.
TEST(Flush, RenameIsDurable) {
  testing::TemporaryFolder folder;
  const Path file = folder.path() / "a/file.txt", other = folder.path() / "film.mp4";
  std::vector<ino_t> order;
  flushed = &order;
  writeFileAtomically(file, std::string_view("content"));
  flushed = nullptr;
  EXPECT_EQ(order, (std::vector<ino_t>{inodeOf(file), inodeOf(file.parent_path())}));

  order.clear();
  TemporaryFile temporary(other);
  writeFileAtomically(temporary.path(), std::string_view("content"), Flush::no);
  flushed = &order;
  temporary.keep();
  writeFileAtomically(folder.path() / "quick.png", std::string_view("content"), Flush::no);
  flushed = nullptr;
  EXPECT_EQ(order, (std::vector<ino_t>{inodeOf(other), inodeOf(folder.path())})) << "no wait without a flush";
}

}  // namespace flush_test
}  // namespace strobe
