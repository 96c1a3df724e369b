// SPDX-License-Identifier: MIT
#include "base/error.h"

#include <algorithm>
#include <cstdio>

namespace strobe {

std::string Place::text() const {
  std::string text = file;
  if (line > 0) text += fmt::format(":{}", line);
  if (line > 0 && column > 0) text += fmt::format(":{}", column);
  return text;
}

static std::string withPlace(const std::string& message, const Place& place) {
  return place.file.empty() ? message : place.text() + ": " + message;
}

Error::Error(std::string message, Place place, int exit_code)
    : std::runtime_error(withPlace(message, place)),
      message_(std::move(message)),
      place_(std::move(place)),
      exit_code_(exit_code) {}

void throwIfAny(const std::vector<std::string>& messages, int exit_code) {
  if (messages.empty()) return;
  std::string joined = messages.front();
  for (size_t i = 1; i < messages.size(); ++i) joined += "\n" + messages[i];
  throw Error(joined, {}, exit_code);
}

// Levenshtein distance with a transposition counted as one edit.
static size_t editDistance(std::string_view a, std::string_view b) {
  std::vector<std::vector<size_t>> d(a.size() + 1, std::vector<size_t>(b.size() + 1));
  for (size_t i = 0; i <= a.size(); ++i) d[i][0] = i;
  for (size_t j = 0; j <= b.size(); ++j) d[0][j] = j;
  for (size_t i = 1; i <= a.size(); ++i) {
    for (size_t j = 1; j <= b.size(); ++j) {
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (a[i - 1] != b[j - 1])});
      bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  }
  return d[a.size()][b.size()];
}

std::string nearestName(std::string_view name, const std::vector<std::string>& candidates) {
  std::string best;
  size_t best_distance = std::max<size_t>(2, name.size() / 3) + 1;
  for (const std::string& candidate : candidates) {
    size_t distance = editDistance(name, candidate);
    if (distance < best_distance) best = candidate, best_distance = distance;
  }
  return best;
}

std::string didYouMean(std::string_view name, const std::vector<std::string>& candidates) {
  std::string near = nearestName(name, candidates);
  return near.empty() ? "" : fmt::format("; did you mean '{}'?", near);
}

void assertFailed(const char* expression, const char* file, int line, const std::string& detail) {
  std::fprintf(stderr, "%s:%d: internal error: %s %s\n", file, line, expression, detail.c_str());
  std::abort();
}

}  // namespace strobe
