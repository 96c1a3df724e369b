// SPDX-License-Identifier: MIT
// `--move`, `--spin` and `--cuts` (motion.h).
#include <cmath>

#include "base/numbers.h"
#include "scene/motion.h"

namespace strobe::scene {

// Number with spaces around it and an optional '+' before it.
static std::optional<double> spacedNumber(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  return finiteNumber(text);
}

// Numbers between commas; nothing if a part is not a number.
static std::optional<std::vector<double>> numbersOf(std::string_view text) {
  std::vector<double> numbers;
  for (size_t at = 0; at <= text.size();) {
    size_t comma = std::min(text.find(',', at), text.size());
    std::optional<double> number = spacedNumber(text.substr(at, comma - at));
    if (!number) return std::nullopt;
    numbers.push_back(*number);
    at = comma + 1;
  }
  return numbers;
}

struct Asked {
  int node;
  std::vector<double> numbers;
};

// Reads `NODE=a,b,...` with exactly `count` numbers. The name may contain '='.
static Asked parse(const Scene& scene, const std::string& option, const std::string& text, const std::string& form,
                   size_t count) {
  size_t equals = text.rfind('=');
  if (equals == std::string::npos || equals == 0)
    throw Error(fmt::format("{} '{}' is not {}", option, text, form), {}, 2);
  std::optional<std::vector<double>> numbers = numbersOf(std::string_view(text).substr(equals + 1));
  if (!numbers) throw Error(fmt::format("{} '{}' is not {}", option, text, form), {}, 2);
  if (numbers->size() != count)
    throw Error(fmt::format("{} '{}' has {} numbers, not {}: {}", option, text, numbers->size(), count, form), {}, 2);
  return {nodeByName(scene, text.substr(0, equals)), *numbers};
}

ConstantMotion moveFromOption(const Scene& scene, const std::string& text, double fps, double rest_time_s) {
  Asked asked = parse(scene, "--move", text, "NODE=dx,dy,dz", 3);
  ConstantMotion motion;
  motion.node = asked.node;
  motion.velocity = dvec3(asked.numbers[0], asked.numbers[1], asked.numbers[2]) * fps;
  motion.rest_time = rest_time_s;
  return motion;
}

ConstantMotion spinFromOption(const Scene& scene, const std::string& text, double fps, double rest_time_s) {
  Asked asked = parse(scene, "--spin", text, "NODE=ax,ay,az,degrees", 4);
  dvec3 axis(asked.numbers[0], asked.numbers[1], asked.numbers[2]);
  double largest = std::max({std::abs(axis.x), std::abs(axis.y), std::abs(axis.z)});
  if (largest == 0) throw Error(fmt::format("--spin '{}': the axis is 0,0,0", text), {}, 2);
  ConstantMotion motion;
  motion.node = asked.node;
  motion.axis = glm::normalize(axis / largest);
  motion.angular_velocity = glm::radians(asked.numbers[3]) * fps;
  motion.rest_time = rest_time_s;
  return motion;
}

std::vector<double> cutsFromOption(const std::string& text) {
  if (text.empty()) return {};
  std::optional<std::vector<double>> cuts = numbersOf(text);
  if (!cuts) throw Error(fmt::format("--cuts '{}' is not T,T,..., a list of times in seconds", text), {}, 2);
  if (!increase(*cuts)) throw Error(fmt::format("--cuts '{}': the times do not increase", text), {}, 2);
  return *cuts;
}

}  // namespace strobe::scene
