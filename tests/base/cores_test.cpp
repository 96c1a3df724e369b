// SPDX-License-Identifier: MIT
#include "base/cores.h"

#include <gtest/gtest.h>

#include "base/files.h"
#include "common/temporary_folder.h"

namespace strobe {
namespace cores_test {

TEST(Cores, AreTheMinimumOfProcessorsQuotaAndTask) {
  EXPECT_EQ(coresOf(8, 0, nullptr), 8u);
  EXPECT_EQ(coresOf(8, 2.5, nullptr), 3u);
  EXPECT_EQ(coresOf(8, 2.5, "2"), 2u);
  EXPECT_EQ(coresOf(2, 4, "4"), 2u);
  EXPECT_EQ(coresOf(0, 0, "none"), 1u);
  EXPECT_EQ(coresOf(8, 0.2, nullptr), 1u);
  EXPECT_GE(allowedCores(), 1u);
  EXPECT_LE(allowedCores(), machineCores());
}

// Files of a cgroup hierarchy below a temporary root.
class Cgroup : public ::testing::Test {
 protected:
  void write(const std::string& file, const std::string& text) {
    std::filesystem::create_directories((root_.path() / file).parent_path());
    writeFileAtomically(root_.path() / file, text);
  }
  double quota() const { return cgroupQuota(root_.path()); }
  testing::TemporaryFolder root_;
};

TEST_F(Cgroup, VersionTwoGivesTheLowestQuota) {
  EXPECT_EQ(quota(), 0) << "without cgroups";
  write("proc/self/cgroup", "0::/slurm/job_7/step_0\n");
  write("sys/fs/cgroup/slurm/job_7/step_0/cpu.max", "max 100000\n");
  EXPECT_EQ(quota(), 0);
  write("sys/fs/cgroup/slurm/cpu.max", "800000 100000\n");
  write("sys/fs/cgroup/slurm/job_7/cpu.max", "250000 100000\n");
  EXPECT_EQ(quota(), 2.5);
}

TEST_F(Cgroup, VersionOneGivesItsQuota) {
  write("proc/self/cgroup", "5:memory:/job\n4:cpu,cpuacct:/job\n0::/\n");
  write("sys/fs/cgroup/cpu/job/cpu.cfs_period_us", "50000\n");
  write("sys/fs/cgroup/cpu/job/cpu.cfs_quota_us", "-1\n");
  EXPECT_EQ(quota(), 0);
  write("sys/fs/cgroup/cpu/job/cpu.cfs_quota_us", "75000\n");
  EXPECT_EQ(quota(), 1.5);
}

// A container mounts its own cgroup at the root, but names the path of the host.
TEST_F(Cgroup, ContainerGivesTheQuotaAtItsRoot) {
  write("proc/self/cgroup", "0::/../../host/path\n");
  write("sys/fs/cgroup/cpu.max", "100000 100000\n");
  EXPECT_EQ(quota(), 1);
}

}  // namespace cores_test
}  // namespace strobe
