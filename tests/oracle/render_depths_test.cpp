// SPDX-License-Identifier: MIT
// Depths at the time of a tap: cards that pass through each other in depth while they slide, against the closed form.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "oracle/render.h"

namespace strobe::oracle {
namespace {

constexpr int kWidth = 128, kHeight = 4, kSamples = 32;
constexpr double kCamera = 100;  // its height; depths are those below it

class RenderDepths : public RenderTest {};

// tests/oracle/scenes/cards.lua, said once more: columns [left, right) at height z at the capture.
struct Card {
  double left, right, z, value, d = 0, rise = 0;

  bool isAt(double x, double t) const { return left <= x - d * t && x - d * t < right && z + rise * t < kCamera; }
};

struct Cards {
  std::vector<Card> cards;
  double wall_z = -50, wall = .1;

  lab::Shot shot() const {
    Numbers numbers = {{"wall_z", wall_z}, {"wall", wall}};
    for (size_t k = 0; k < cards.size(); ++k) {
      const Card& card = cards[k];
      const std::pair<const char*, double> own[] = {{"left", card.left}, {"right", card.right}, {"z", card.z},
                                                    {"v", card.value},   {"d", card.d},         {"rise", card.rise}};
      for (const auto& [name, value] : own) numbers.push_back({fmt::format("{}{}", name, k), value});
    }
    return shotOf("cards", kWidth, kHeight, numbers);
  }

  double valueAt(double x, double t) const {
    double nearest = wall_z, value = wall;
    for (const Card& card : cards)
      if (card.isAt(x, t) && card.z + card.rise * t > nearest) nearest = card.z + card.rise * t, value = card.value;
    return value;
  }

  // All times at which the colour of a pixel may change.
  std::vector<double> times(double x, Window window) const {
    std::vector<double> times = {window.open, window.close};
    auto add = [&](double time) {
      if (time > window.open && time < window.close) times.push_back(time);
    };
    std::vector<Card> all = cards;
    all.push_back({.z = wall_z});
    for (const Card& card : all) {
      for (double border : {card.left, card.right}) add((x - border) / card.d);
      for (const Card& other : all) add((other.z - card.z) / (card.rise - other.rise));
      add((kCamera - card.z) / card.rise);
    }
    std::sort(times.begin(), times.end());
    return times;
  }

  Exposure at(int pixel, Window window) const {
    const double x = pixel + .5;
    const std::vector<double> ends = times(x, window);
    Exposure exposure;
    double last = valueAt(x, (ends[0] + ends[1]) / 2);
    for (size_t i = 0; i + 1 < ends.size(); ++i) {
      const double value = valueAt(x, (ends[i] + ends[i + 1]) / 2);
      exposure.colour += value * (ends[i + 1] - ends[i]) / (window.close - window.open);
      exposure.variation += std::abs(value - last);
      last = value;
    }
    return exposure;
  }

  double errorOf(const lab::Picture& picture, Window window) const {
    double sum = 0;
    for (int x = 0; x < kWidth; ++x) sum += std::pow(colorOf(picture).at(x, 1, 0) - at(x, window).colour, 2);
    return std::sqrt(sum / kWidth);
  }
};

std::vector<std::string> settings(const std::string& depths, const std::vector<std::string>& more) {
  std::vector<std::string> all = {"depths=" + depths, fmt::format("samples={}", kSamples), "tile=20"};
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

// Towards the camera over the exposure, or away where the capture is at its start; when that passes what does neither.
double riseIn(Window window) { return window.open < 0 ? 40 : -40; }
double swapIn(Window window) { return window.open + (window.open < 0 ? .3 : .7) * (window.close - window.open); }

// A card that slides to the right, and one that slides to the left and rises through it.
Cards crossing(Window window) {
  const double rise = riseIn(window), swap = (window.open + window.close) / 2 + .1;
  return {{{30, 75, 0, .5, 20}, {45, 90, -rise * swap, 1, -12, rise}}};
}

// One card that slides and rises through the wall.
Cards rising(Window window) {
  const double rise = riseIn(window);
  return {{{44, 76, -50 - rise * swapIn(window), .9, 20, rise}}};
}

// One card that slides and rises past the camera in the middle of what is left of the exposure.
Cards passing() { return {{{44, 76, 0, .9, 20, 200}}}; }

}  // namespace

// What of each layer is in front is told by depths at the time of a sample. The bound is that of as many samples, and
// half a pixel of the slower card's way: places are rounded to texels.
TEST_F(RenderDepths, LayersChangePlacesWithinTheExposure) {
  const std::vector<std::string> all = {"preset=captured", "mask=all", "revealed_layers=2"};
  for (const Anchor& anchor : anchors()) {
    const Cards cards = crossing(anchor.window);
    lab::Picture tap = render(with(cards.shot(), "hybrid", settings("tap", all), anchor.name));
    expectWithin(
        colorOf(tap), [&](int x, int) { return cards.at(x, anchor.window); },
        [](const Exposure& e) { return e.variation * (1. / (2 * kSamples) + .5 / 12) + 1e-4; }, anchor.name);
    lab::Picture capture = render(with(cards.shot(), "hybrid", settings("capture", all), anchor.name));
    fmt::print("{}: {:.4f}, {:.4f}\n", anchor.name, cards.errorOf(capture, anchor.window), cards.errorOf(tap, anchor.window));
  }
}

TEST_F(RenderDepths, EachFilter) {
  struct Filter {
    std::string pipeline;
    std::vector<std::string> set;
  };
  const Filter filters[] = {
      {"mcguire2012", {}},
      {"mcguire2012", {"weights=uniform"}},
      {"guertin2014", {}},
      {"jimenez2014", {}},
      {"ue4", {}},
      {"hdrp", {}},
      {"layers2024", {}},
      {"hybrid", {"preset=captured", "mask=all"}},
      {"hybrid", {"preset=captured", "mask=all", "composite=in_gather"}},
      {"hybrid", {"preset=captured", "mask=all", "composite=alpha_over", "weights=uniform"}},
      {"hybrid", {"preset=captured", "mask=all", "composite=alpha_over", "weights=mcguire2012"}},
      {"hybrid", {"preset=captured", "mask=all", "composite=alpha_over", "weights=jimenez2014"}},
      {"hybrid", {"preset=captured", "mask=all", "composite=alpha_over", "weights=guertin2014"}},
  };
  for (const Filter& filter : filters)
    for (const Anchor& anchor : anchors()) {
      const Cards cards = rising(anchor.window);
      auto errorAt = [&](const char* depths) {
        return cards.errorOf(render(with(cards.shot(), filter.pipeline, settings(depths, filter.set), anchor.name)), anchor.window);
      };
      fmt::print("{} {} {}: {:.4f}, {:.4f}\n", filter.pipeline, fmt::join(filter.set, " "), anchor.name, errorAt("capture"), errorAt("tap"));
    }
}

}  // namespace strobe::oracle
