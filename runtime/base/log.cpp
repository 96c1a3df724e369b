// SPDX-License-Identifier: MIT
#include "base/log.h"

#include <unistd.h>

#include <algorithm>
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

static constexpr double kBetween_s = 0.2;

StatusLine::~StatusLine() {
  if (shown_s_ > 0) std::fputs("\r\033[K", stderr);
}

bool StatusLine::isDue() { return onTerminal() && clockSeconds() - shown_s_ >= kBetween_s; }

void StatusLine::print(const std::string& text) {
  shown_s_ = clockSeconds();
  std::fprintf(stderr, "\r\033[K%s", text.c_str());
}

void Progress::reach(int done) {
  done_ = std::min(done, total_);
  const double now_s = clockSeconds();
  if (!first_s_) first_s_ = now_s, first_done_ = done_;
  line_.show([&] { return text(now_s); });
}

std::string Progress::text(double now_s) const {
  std::string text = fmt::format("{} {}/{} {}", label_, done_, total_, unit_);
  const double elapsed_s = first_s_ ? now_s - *first_s_ : 0;
  if (elapsed_s < kBetween_s || done_ == first_done_) return text;
  const double rate = (done_ - first_done_) / elapsed_s;
  return text + fmt::format("  {:.1f}/s  {:.0f} s left", rate, (total_ - done_) / rate);
}

}  // namespace strobe
