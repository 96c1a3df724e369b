// SPDX-License-Identifier: MIT
#include "base/lease.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <functional>

#include "base/process_name.h"
#include "common/temporary_folder.h"

namespace strobe {
namespace lease_test {

namespace fs = std::filesystem;

// A process that runs `work` and then waits to be killed.
pid_t started(const std::function<void()>& work) {
  int ends[2];
  EXPECT_EQ(::pipe(ends), 0);
  pid_t child = ::fork();
  if (child == 0) {
    work();
    EXPECT_EQ(::write(ends[1], "x", 1), 1);
    for (;;) ::pause();
  }
  char done = 0;
  EXPECT_EQ(::read(ends[0], &done, 1), 1);
  for (int end : ends) ::close(end);
  return child;
}

void killed(pid_t child) {
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
}

void write(const Path& file, const std::string& text) { writeFileAtomically(file, text, Flush::no); }

void setAge(const Path& file, double seconds) {
  fs::last_write_time(file, fs::file_time_type::clock::now() - std::chrono::milliseconds(int64_t(seconds * 1000)));
}

class Leases : public ::testing::Test {
 protected:
  testing::TemporaryFolder folder_;
  const Path file_ = folder_.path() / "name.lock";
};

TEST_F(Leases, HaveOneHolderAtATime) {
  {
    std::unique_ptr<Lease> lease = Lease::claim(file_);
    ASSERT_TRUE(lease);
    EXPECT_EQ(readText(file_), processName());
    EXPECT_FALSE(Lease::claim(file_));
    EXPECT_TRUE(Lease::claim(folder_.path() / "other.lock"));
  }
  EXPECT_TRUE(fs::is_empty(folder_.path())) << "nothing is left";
  EXPECT_TRUE(Lease::claim(file_));
}

// 16 processes each add 1 to a number ten times and claim the number before each addition. Some claims find the lease
// of a killed process.
TEST_F(Leases, ExcludeProcesses) {
  const Path number = folder_.path() / "number";
  write(number, "0");
  killed(started([this] { (void)Lease::claim(file_).release(); }));
  std::vector<pid_t> children;
  for (int i = 0; i < 16; ++i) {
    children.push_back(::fork());
    if (children.back() != 0) continue;
    for (int j = 0; j < 10; ++j) {
      std::unique_ptr<Lease> lease;
      while (!(lease = Lease::claim(file_))) ::usleep(500);
      write(number, std::to_string(std::stoi(readText(number)) + 1));
    }
    ::_exit(0);
  }
  for (pid_t child : children) ::waitpid(child, nullptr, 0);
  EXPECT_EQ(readText(number), "160");
}

TEST_F(Leases, AreTakenOverFromEndedProcesses) {
  pid_t holder = started([this] { (void)Lease::claim(file_).release(); });
  EXPECT_FALSE(Lease::claim(file_)) << "it runs";
  ::kill(holder, SIGKILL);
  siginfo_t info{};
  ASSERT_EQ(::waitid(P_PID, id_t(holder), &info, WEXITED | WNOWAIT), 0);
  EXPECT_TRUE(Lease::claim(file_)) << "its parent has not waited for it yet";
  ::waitpid(holder, nullptr, 0);
}

// A process on another machine keeps its lease by renewing the file's modification time.
TEST_F(Leases, AreTakenOverFromOtherMachinesIfNotRenewed) {
  write(file_, "elsewhere-0000.1");
  EXPECT_FALSE(Lease::claim(file_));
  setAge(file_, kLease_s - 5);
  EXPECT_FALSE(Lease::claim(file_));
  setAge(file_, kLease_s + 5);
  std::unique_ptr<Lease> lease = Lease::claim(file_);
  ASSERT_TRUE(lease);
  // The holder was only suspended: it must not remove a lease that another process has taken over.
  write(file_, "elsewhere-0000.2");
  lease.reset();
  EXPECT_EQ(readText(file_), "elsewhere-0000.2");
}

TEST_F(Leases, OnFoldersNameTheHolder) {
  const std::unique_ptr<Lease> lease = Lease::ofFolder(folder_.path() / "new");
  try {
    Lease::ofFolder(folder_.path() / "new");
    ADD_FAILURE() << "it was claimed twice";
  } catch (const Error& error) {
    EXPECT_EQ(error.exitCode(), 2);
    EXPECT_EQ(error.message(), "another program works in this folder: process " + processName());
  }
  EXPECT_THROW(Lease::claim(folder_.path() / "missing/name.lock"), WriteError);
}

TEST(ProcessNames, IdentifyEndedProcessesOfThisMachine) {
  const std::string here = processName(), host = here.substr(0, here.find('.'));
  EXPECT_EQ(here, host + "." + std::to_string(::getpid()));
  EXPECT_FALSE(hasEnded(here));
  pid_t child = started([] {});
  const std::string name = host + "." + std::to_string(child);
  EXPECT_FALSE(hasEnded(name));
  killed(child);
  EXPECT_TRUE(hasEnded(name));
  EXPECT_FALSE(hasEnded("elsewhere-0000." + std::to_string(child)));
  for (const char* other : {"", ".", "x", "12", ".12"}) EXPECT_FALSE(hasEnded(other)) << other;
}

}  // namespace lease_test
}  // namespace strobe
