// SPDX-License-Identifier: MIT
#include "base/interruption.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <functional>

namespace strobe {
namespace interruption_test {

struct End {
  int signal = 0, status = -1;
  std::string text;
};

// What becomes of a process that does `work`, and what it writes to stderr.
End endOf(const std::function<void()>& work) {
  int ends[2];
  EXPECT_EQ(::pipe(ends), 0);
  pid_t child = ::fork();
  if (child == 0) {
    ::dup2(ends[1], STDERR_FILENO);
    work();
    ::_exit(7);
  }
  ::close(ends[1]);
  End end;
  char buffer[256];
  for (ssize_t got; (got = ::read(ends[0], buffer, sizeof buffer)) > 0;) end.text.append(buffer, size_t(got));
  ::close(ends[0]);
  int status = 0;
  ::waitpid(child, &status, 0);
  if (WIFSIGNALED(status)) end.signal = WTERMSIG(status);
  else end.status = WEXITSTATUS(status);
  return end;
}

TEST(Interruption, SaysItsLineAndEndsByTheSignal) {
  for (int signal : {SIGINT, SIGTERM}) {
    End end = endOf([signal] {
      Interruption interruption([] { return "interrupted; 7 of 18 points are kept"; });
      ::kill(::getpid(), signal);
      ::sleep(10);
    });
    EXPECT_EQ(end.signal, signal);
    EXPECT_EQ(end.text, "interrupted; 7 of 18 points are kept\n");
  }
}

// What cannot be counted does not keep the program from its end; after its life signals do what they did.
TEST(Interruption, EndsWithoutItsWordsAndLeavesNothingBehind) {
  End failed = endOf([] {
    Interruption interruption([]() -> std::string { throw std::runtime_error("no folder"); });
    ::kill(::getpid(), SIGINT);
    ::sleep(10);
  });
  EXPECT_EQ(failed.signal, SIGINT);
  EXPECT_EQ(failed.text, "interrupted\n");
  End after = endOf([] {
    {
      Interruption interruption([] { return "not said"; });
    }
    {
      Interruption interruption([] { return "not said"; });
    }
    ::kill(::getpid(), SIGINT);
  });
  EXPECT_EQ(after.signal, SIGINT);
  EXPECT_EQ(after.text, "");
  End ignored = endOf([] {
    ::signal(SIGINT, SIG_IGN);
    Interruption interruption([] { return "not said"; });
    ::kill(::getpid(), SIGINT);
  });
  EXPECT_EQ(ignored.status, 7) << "a job in the background";
  EXPECT_EQ(ignored.text, "");
}

}  // namespace interruption_test
}  // namespace strobe
