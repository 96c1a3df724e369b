// SPDX-License-Identifier: MIT
#include "base/memory.h"

#include <gtest/gtest.h>

#include "common/temporary_folder.h"

namespace strobe {
namespace memory_test {

class Memory : public ::testing::Test {
 protected:
  void write(const std::string& file, const std::string& text) const {
    writeFileAtomically(folder_.path() / file, std::string_view(text), Flush::no);
  }
  uint64_t available() const { return availableMemory(folder_.path()); }

  testing::TemporaryFolder folder_;
};

TEST_F(Memory, EqualsMemAvailable) {
  EXPECT_EQ(available(), UINT64_MAX) << "no file states a value";
  write("proc/meminfo", "MemTotal:  8000 kB\nMemFree:   100 kB\nMemAvailable:   3000 kB\nSwapFree:   0 kB\n");
  EXPECT_EQ(available(), 3000u << 10);
  write("proc/meminfo", "MemAvailable:   3000 kB\nSwapFree:   500 kB\n");
  EXPECT_EQ(available(), 3500u << 10);
}

// The minimum over the system and all enclosing control groups; pages of files count as free.
TEST_F(Memory, IsLimitedByControlGroups) {
  write("proc/meminfo", "MemAvailable: 1000000 kB\n");
  write("proc/self/cgroup", "0::/user/job\n");
  write("sys/fs/cgroup/user/job/memory.max", "max\n");
  write("sys/fs/cgroup/user/job/memory.current", "5000\n");
  EXPECT_EQ(available(), 1000000u << 10) << "without a limit";
  write("sys/fs/cgroup/user/memory.max", "10000\n");
  write("sys/fs/cgroup/user/memory.current", "7000\n");
  EXPECT_EQ(available(), 3000u) << "of the group above";
  write("sys/fs/cgroup/user/memory.stat", "anon 5000\ninactive_file 1500\nactive_file 500\n");
  EXPECT_EQ(available(), 5000u);
  write("sys/fs/cgroup/user/memory.current", "20000\n");
  EXPECT_EQ(available(), 0u) << "above its limit";
}

TEST_F(Memory, IsWrittenWithAUnit) {
  EXPECT_EQ(bytesText(12), "12 bytes");
  EXPECT_EQ(bytesText(3u << 20), "3 MiB");
  EXPECT_EQ(bytesText(uint64_t{3} << 29), "1.5 GiB");
}

}  // namespace memory_test
}  // namespace strobe
