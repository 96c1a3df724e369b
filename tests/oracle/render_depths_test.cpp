// SPDX-License-Identifier: MIT
// Depths at the time of a tap: cards that pass through each other in depth while they slide, against the closed form.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "oracle/render.h"

namespace strobe::oracle {
namespace render_depths_test {

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

  // Root mean square over the row, or over what the capture does not see the first card at.
  double errorOf(const lab::Picture& picture, Window window, bool inside = true) const {
    double sum = 0;
    int count = 0;
    for (int x = 0; x < kWidth; ++x) {
      if (!inside && cards[0].isAt(x + .5, 0)) continue;
      sum += std::pow(colorOf(picture).at(x, 1, 0) - at(x, window).colour, 2);
      ++count;
    }
    return std::sqrt(sum / count);
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

// The same, but it is the wall that sinks.
Cards sinking(Window window) {
  const double rise = riseIn(window);
  return {{{44, 76, 0, .9, 20}, {-40, 170, rise * swapIn(window), .1, 0, -rise}}};
}

// One card that slides and rises past the camera in the middle of the exposure, of which the capture is the start.
Cards passing() { return {{{44, 76, 0, .9, 20, 200}}}; }

// One card that the capture at the start of the exposure does not see: it enters the picture, and comes out of the
// wall.
Cards entering() { return {{{-40, -2, -50 - 40 * .6, .9, 40, 40}}}; }

// A card 4 m before the camera that comes `nearer` within the exposure, before a wall:
// tests/oracle/scenes/approach.lua.
lab::Shot approach(double nearer) {
  lab::Shot shot = shotOf("approach", 64, 48);
  shot.sets.clear();
  shot.exposure = nearer / 2;  // frames: 48 m/s, 24 frames a second
  return shot;
}

lab::Shot tapped(lab::Shot shot, const std::vector<std::string>& taps) {
  shot.taps = taps;
  return shot;
}

// Wherever a layer has something at a depth that moves, its change is that of the pose, elsewhere 0. 1e-4: depths of
// 100 m in single precision, over half of the exposure. Returns at how many pixels.
int expectChange(const lab::Picture& picture, const image::Image& depths, const std::string& change, double depth,
                 glm::dvec2 of) {
  const image::Image& changes = picture.frame.taps.at(change).floats;
  int found = 0;
  for (int y = 0; y < depths.height; ++y)
    for (int x = 0; x < depths.width; ++x) {
      const bool moves = std::abs(depths.at(x, y, 0) - depth) < 1e-3;
      found += moves;
      for (int part = 0; part < 2; ++part)
        EXPECT_NEAR(changes.at(x, y, part), moves ? of[part] : 0, 1e-4) << change << " at " << x << ", " << y;
    }
  return found;
}

// At the pace of both parts of the exposure, through the camera and beyond it; by both ways of telling displacements,
// since the motion is even.
TEST_F(RenderDepths, ChangesAreThoseOfThePoses) {
  const std::string change = "raster_depth_change.change";
  for (const char* displacement : {"window", "extrapolated"})
    for (const Anchor& anchor : anchors())
      for (double nearer : {1., 5.}) {
        const std::vector<std::string> set = {"depths=tap", fmt::format("displacement={}", displacement)};
        lab::Picture picture = render(tapped(with(approach(nearer), "jimenez2014", set, anchor.name), {change}));
        EXPECT_GT(expectChange(picture, imageOf(picture, "depth"), change, 4, glm::dvec2(-nearer)), 100);
      }
}

// What turns back in depth at the capture has two paces; an exposure that has one of the parts knows that one alone.
TEST_F(RenderDepths, ChangesAreThoseOfBothParts) {
  const std::string change = "raster_depth_change.change";
  const std::map<std::string, glm::dvec2> expected = {{"close", {-12, -12}}, {"centre", {-12, 20}}, {"open", {20, 20}}};
  for (const Anchor& anchor : anchors()) {
    lab::Shot shot = shotOf("bent", 96, 32, {{"before_z", 12}, {"after_z", -20}});
    lab::Picture picture = render(tapped(with(shot, "jimenez2014", {"depths=tap"}, anchor.name), {change}));
    EXPECT_EQ(expectChange(picture, imageOf(picture, "depth"), change, kCamera, expected.at(anchor.name)), 32 * 32);
  }
}

// Of what is revealed, by what a ray hit and by what its instance carries, and of what the end of the exposure alone
// sees.
TEST_F(RenderDepths, ChangesOfOtherLayersAreToo) {
  const Cards covered{{{40, 72, 0, .5}, {50, 62, -5, 1, 20, -30}}};
  const std::string change = "revealed_depth_change.change";
  for (const Anchor& anchor : anchors()) {
    const std::vector<std::string> set = {"preset=captured", "mask=none", "mask.everywhere=true", "depths=tap"};
    lab::Picture picture = render(tapped(with(covered.shot(), "hybrid", set, anchor.name), {change}));
    EXPECT_EQ(expectChange(picture, imageOf(picture, "revealed_depth"), change, 105, glm::dvec2(30)), 12 * kHeight);
  }
  lab::Picture picture = render(tapped(with(entering().shot(), "hybrid", {"preset=layers", "depths=tap"}, "open"),
                                       {"close_layer.depth", "close_depth_change.change"}));
  const image::Image& depths = picture.frame.taps.at("close_layer.depth").floats;
  EXPECT_GT(
      expectChange(picture, depths, "close_depth_change.change", kCamera - entering().cards[0].z - 40, glm::dvec2(-40)),
      100);
}

// What is in front of all layers changes within the exposure: two cards that cross and change places, one that goes
// past the camera, one that only the end of the exposure sees. The bound is that of as many samples, and half a pixel
// of the slowest card's way: places are rounded to texels. Depths of the capture are wrong by much more.
TEST_F(RenderDepths, LayersChangePlacesWithinTheExposure) {
  struct Case {
    std::string what;
    Cards cards;
    Anchor anchor;
    std::string pipeline;
    std::vector<std::string> set;
    double slowest;  // px
  };
  const std::vector<std::string> captured = {"preset=captured", "mask=none", "mask.everywhere=true",
                                             "revealed_layers=2"};
  const Anchor open = anchors().back();
  ASSERT_EQ(open.name, "open");
  std::vector<Case> cases = {
      {"passing", passing(), open, "hybrid", captured, 20},
      {"passing", passing(), open, "layers2024", {}, 20},
      {"entering", entering(), open, "hybrid", {"preset=layers", "mask=none", "mask.everywhere=true"}, 40}};
  for (const Anchor& anchor : anchors()) {
    cases.push_back({"crossing", crossing(anchor.window), anchor, "hybrid", captured, 12});
    cases.push_back({"rising", rising(anchor.window), anchor, "hybrid", captured, 20});
    cases.push_back({"rising", rising(anchor.window), anchor, "layers2024", {}, 20});
  }
  for (const Case& c : cases) {
    const std::string what = fmt::format("{}, {}, {}", c.what, c.pipeline, c.anchor.name);
    auto drawn = [&](const char* depths) {
      return render(with(c.cards.shot(), c.pipeline, settings(depths, c.set), c.anchor.name));
    };
    const lab::Picture tap = drawn("tap");
    expectWithin(
        colorOf(tap), [&](int x, int) { return c.cards.at(x, c.anchor.window); },
        [&](const Exposure& e) { return e.variation * (1. / (2 * kSamples) + .5 / c.slowest) + 1e-4; }, what);
    const double error = c.cards.errorOf(tap, c.anchor.window),
                 before = c.cards.errorOf(drawn("capture"), c.anchor.window);
    EXPECT_GE(before, 8 * error) << what;
  }
}

// A card that comes out of the wall within the exposure, or goes into it. Where the capture sees the wall, what passes
// over it counts only at times at which it is in front; where it sees the card, only a method knows the wall to which
// it is revealed. What is left of the error is that of a method's weights: samples, for those that count each tap as a
// share of the exposure or have straight ramps; much, for those that are too opaque; of alpha_over's uniform ones what
// rests in front of the sky.
TEST_F(RenderDepths, EveryFilterHasThem) {
  struct Filter {
    std::string pipeline;
    std::vector<std::string> set;
    double share;
  };
  const std::string none = "mask=none", all = "mask.everywhere=true", over = "composite=alpha_over";
  const Filter filters[] = {
      {"mcguire2012", {}, .85},
      {"mcguire2012", {"weights=uniform"}, .1},
      {"guertin2014", {}, .85},
      {"jimenez2014", {}, .1},
      {"ue4", {}, .1},
      {"hdrp", {}, .15},
      {"hybrid", {none, all, "composite=in_gather"}, .1},
      {"hybrid", {none, all, over, "weights=uniform"}, .6},
      {"hybrid", {none, all, over, "weights=mcguire2012"}, .85},
      {"hybrid", {none, all, over, "weights=jimenez2014"}, .15},
      {"hybrid", {none, all, over, "weights=guertin2014"}, .85},
  };
  for (const Filter& filter : filters)
    for (const Anchor& anchor : anchors())
      for (const Cards& cards : {rising(anchor.window), sinking(anchor.window)}) {
        auto errorAt = [&](const char* depths) {
          lab::Picture picture = render(with(cards.shot(), filter.pipeline, settings(depths, filter.set), anchor.name));
          return cards.errorOf(picture, anchor.window, filter.pipeline == "hybrid");
        };
        const double capture = errorAt("capture"), tap = errorAt("tap");
        EXPECT_LE(tap, filter.share * capture) << fmt::format(
            "{} {} {}: {} cards", filter.pipeline, fmt::join(filter.set, " "), anchor.name, cards.cards.size());
      }
}

// What comes nearer before the capture alone, at the pace of that part: out of the checker behind it, which is flat
// here.
TEST_F(RenderDepths, EachPartHasItsPace) {
  const Cards like{{{30, 62, 0, .9, 20, 40}}, -10};
  const Anchor& centre = anchors()[1];
  ASSERT_EQ(centre.name, "centre");
  lab::Shot shot = shotOf("bent", kWidth, 8, {{"before_z", 40}, {"light", .1}, {"dark", .1}});
  auto errorAt = [&](const char* depths) {
    const std::vector<std::string> set = settings(depths, {"preset=captured", "mask=none", "mask.everywhere=true"});
    return like.errorOf(render(with(shot, "hybrid", set, "centre")), centre.window);
  };
  EXPECT_LE(errorAt("tap"), .1 * errorAt("capture"));  // as the card of the test above
}

// Where no depth changes every picture is that of the capture's.
TEST_F(RenderDepths, EvenDepthsAreThoseOfTheCapture) {
  const lab::Shot slides = shotOf("textured_bar", 64, 24);
  for (const char* pipeline : {"hybrid", "mcguire2012", "guertin2014", "hdrp", "layers2024"}) {
    std::vector<std::string> set;
    if (pipeline == std::string("hybrid")) set = {"preset=captured"};
    const lab::Picture capture = render(with(slides, pipeline, set));
    set.push_back("depths=tap");
    EXPECT_TRUE(identical(colorOf(capture), colorOf(render(with(slides, pipeline, set))))) << pipeline;
    for (const auto& step : capture.frame.times)
      EXPECT_EQ(step.name.find("depth_change"), std::string::npos) << step.name;
  }
}

}  // namespace render_depths_test
}  // namespace strobe::oracle
