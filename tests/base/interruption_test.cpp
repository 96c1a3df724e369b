// SPDX-License-Identifier: MIT
#include "base/interruption.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <functional>

namespace strobe {
namespace interruption_test {

struct End {
  int signal = 0, status = -1;
  std::string text;
};

// Exit status and stderr of a child process that runs `work`.
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

// The exit code of a process that stops, computed as in `main`.
int codeOf(const std::function<void()>& work) {
  try {
    work();
    return 7;
  } catch (const Stopped& stopped) {
    std::fputs((stopped.reason + "\n").c_str(), stderr);
    return kTryAgain;
  }
}

TEST(Interruption, StopsAfterTheCurrentStep) {
  for (int signal : {SIGINT, SIGTERM, SIGUSR1}) {
    End end = endOf([signal] {
      Interruption interruption;
      stopIfRequested();
      ::kill(::getpid(), signal);
      stopIfOverdue();  // work goes on for two seconds
      ::_exit(codeOf([] { stopIfRequested(); }));
    });
    EXPECT_EQ(end.status, kTryAgain);
    EXPECT_EQ(end.text, "interrupted\n");
  }
  End waiting = endOf([] {
    Interruption interruption;
    ::kill(::getpid(), SIGTERM);
    ::_exit(codeOf([] { waitFor(100); }));
  });
  EXPECT_EQ(waiting.status, kTryAgain);
}

TEST(Interruption, SecondSignalEndsAtOnce) {
  End end = endOf([] {
    Interruption interruption;
    for (int signal : {SIGINT, SIGUSR1}) ::kill(::getpid(), signal);
    std::fputs("runs\n", stderr);
    ::kill(::getpid(), SIGTERM);
    ::sleep(10);
  });
  EXPECT_EQ(end.status, kTryAgain);
  EXPECT_EQ(end.text, "runs\ninterrupted; the same command continues\n");
}

TEST(Interruption, StopsBeforeATimeLimit) {
  End end = endOf([] {
    Interruption interruption(0.05);
    ::_exit(codeOf([] { stopIfLonger(1); }));
  });
  EXPECT_EQ(end.status, kTryAgain);
  EXPECT_EQ(end.text, "the time is up (--time-left)\n");
  end = endOf([] {
    Interruption interruption(0.05);
    stopIfOverdue();
    ::usleep(60000);
    ::_exit(codeOf([] { stopIfOverdue(); }));
  });
  EXPECT_EQ(end.status, kTryAgain);
  EXPECT_NO_THROW(stopIfLonger(1e9)) << "no limit";
}

// After an Interruption is destroyed, signals have their previous effect.
TEST(Interruption, RestoresSignalsAfterwards) {
  End after = endOf([] {
    for (int i = 0; i < 2; ++i) {
      Interruption interruption(0.001);
      ::usleep(2000);
    }
    stopIfRequested();
    ::kill(::getpid(), SIGINT);
  });
  EXPECT_EQ(after.signal, SIGINT);
  EXPECT_EQ(after.text, "");
  End ignored = endOf([] {
    ::signal(SIGINT, SIG_IGN);
    Interruption interruption;
    ::kill(::getpid(), SIGINT);
    stopIfRequested();
  });
  EXPECT_EQ(ignored.status, 7) << "a background job ignores SIGINT";
  EXPECT_EQ(ignored.text, "");
}

}  // namespace interruption_test
}  // namespace strobe
