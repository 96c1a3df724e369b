// SPDX-License-Identifier: MIT
#include "base/interruption.h"

#include <signal.h>
#include <unistd.h>

#include <atomic>
#include <limits>

#include "base/error.h"
#include "base/log.h"

namespace strobe {

namespace {

constexpr int kSignals[] = {SIGINT, SIGTERM, SIGUSR1};
constexpr double kGrace_s = 2;
constexpr unsigned kMost_s = 10;  // a batch system kills a process after 30 s

constexpr double kNever = std::numeric_limits<double>::infinity();

bool exists = false;
std::atomic<double> limit_s = kNever;  // time of the limit, by `clockSeconds`
std::atomic<double> signal_s = 0;      // time of the first signal, by `clockSeconds`; 0: none
static_assert(std::atomic<double>::is_always_lock_free, "a signal handler writes it");

[[noreturn]] void endNow(int) {
  constexpr char kText[] = "interrupted; the same command continues\n";
  [[maybe_unused]] ssize_t written = ::write(STDERR_FILENO, kText, sizeof kText - 1);
  ::_exit(kTryAgain);
}

void requestStop(int signal) {
  if (signal_s != 0 && signal == SIGUSR1) return;
  if (signal_s != 0) endNow(signal);
  signal_s = clockSeconds();
  ::alarm(kMost_s);
}

void handle(int signal, void (*handler)(int)) {
  struct sigaction action {};
  ::sigaction(signal, nullptr, &action);
  if (action.sa_handler == SIG_IGN) return;
  action = {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;
  ::sigaction(signal, &action, nullptr);
}

bool isTimeUp() { return clockSeconds() >= limit_s; }

[[noreturn]] void stop() { throw Stopped{signal_s != 0 ? "interrupted" : "the time is up (--time-left)"}; }

}  // namespace

Interruption::Interruption(double time_left_s) {
  STROBE_ASSERT(!exists, "an interruption handler exists already");
  exists = true;
  signal_s = 0;
  limit_s = time_left_s > 0 ? clockSeconds() + time_left_s : kNever;
  for (int signal : kSignals) handle(signal, requestStop);
  handle(SIGALRM, endNow);
}

Interruption::~Interruption() {
  ::alarm(0);
  for (int signal : kSignals) handle(signal, SIG_DFL);
  handle(SIGALRM, SIG_DFL);
  signal_s = 0;
  limit_s = kNever;
  exists = false;
}

void stopIfRequested() {
  if (signal_s != 0 || isTimeUp()) stop();
}

void stopIfOverdue() {
  if (isTimeUp() || (signal_s != 0 && clockSeconds() > signal_s + kGrace_s)) stop();
}

void stopIfLonger(double seconds) {
  if (clockSeconds() + seconds > limit_s) throw Stopped{"the time is up (--time-left)"};
}

void waitFor(double seconds) {
  for (const double end_s = clockSeconds() + seconds; clockSeconds() < end_s; ::usleep(20000)) stopIfRequested();
}

}  // namespace strobe
