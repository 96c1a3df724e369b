// SPDX-License-Identifier: MIT
#include "base/interruption.h"

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <utility>

#include "base/error.h"
#include "base/log.h"

namespace strobe {

namespace {

constexpr int kSignals[] = {SIGINT, SIGTERM};

// End of the pipe that the handler writes to; -1 if the pipe has no reader.
std::atomic<int> writing_end = -1;

void passOn(int signal) {
  const int saved = errno;
  const unsigned char number = static_cast<unsigned char>(signal);
  [[maybe_unused]] ssize_t written = ::write(writing_end, &number, 1);
  errno = saved;
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

}  // namespace

Interruption::Interruption(std::function<std::string()> last_words) : last_words_(std::move(last_words)) {
  STROBE_ASSERT(writing_end < 0, "an interruption handler exists already");
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) throw Error("cannot create a pipe for signals");
  reading_ = ends[0];
  writing_end = ends[1];
  for (int signal : kSignals) handle(signal, passOn);
  thread_ = std::thread([this] { wait(); });
}

Interruption::~Interruption() {
  for (int signal : kSignals) handle(signal, SIG_DFL);
  passOn(0);
  thread_.join();
  ::close(reading_);
  ::close(writing_end.exchange(-1));
}

// Waits for a signal, erases the progress line of a terminal, and prints the last message.
void Interruption::wait() {
  unsigned char signal = 0;
  while (::read(reading_, &signal, 1) < 0 && errno == EINTR) continue;
  if (signal == 0) return;
  std::string text;
  try {
    text = last_words_();
  } catch (const std::exception&) {
    text = "interrupted";
  }
  if (::isatty(STDERR_FILENO)) std::fputs("\r\033[K", stderr);
  note(text);
  handle(signal, SIG_DFL);
  ::kill(::getpid(), signal);
}

}  // namespace strobe
