// SPDX-License-Identifier: MIT
#include "base/log.h"

#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>

namespace strobe {

static bool onTerminal() {
  static const bool terminal = ::isatty(STDERR_FILENO);
  return terminal;
}

static bool inColour() {
  const char* no_color = std::getenv("NO_COLOR");
  return onTerminal() && !(no_color && *no_color);
}

void note(const std::string& text) { std::fprintf(stderr, "%s\n", text.c_str()); }

void warn(const std::string& text) {
  if (inColour()) {
    std::fprintf(stderr, "\033[33mwarning:\033[0m %s\n", text.c_str());
  } else {
    std::fprintf(stderr, "warning: %s\n", text.c_str());
  }
}

double clockSeconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

Progress::Progress(std::string label, int total)
    : label_(std::move(label)), total_(total), started_s_(clockSeconds()) {}

Progress::~Progress() {
  if (onTerminal() && shown_s_ > 0) std::fprintf(stderr, "\r\033[K");
}

void Progress::advance(int by) {
  done_ += by;
  double now = clockSeconds();
  if (!onTerminal() || now - shown_s_ < 0.2) return;
  shown_s_ = now;
  double rate = done_ / std::max(now - started_s_, 1e-9);
  double left_s = rate > 0 ? (total_ - done_) / rate : 0;
  std::fprintf(stderr, "\r\033[K%s %d/%d  %.1f/s  %.0f s left", label_.c_str(), done_, total_, rate, left_s);
}

}  // namespace strobe
