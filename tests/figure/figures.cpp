// SPDX-License-Identifier: MIT
#include "figures.h"

#include <cmath>

#include "common/home.h"
#include "program/run.h"
#include "script/evaluate.h"

namespace strobe::figure {

using image::Image;

namespace {

Image colorOf(const std::string& arm, int step) {
  Image color(kWidth, kHeight, 4, 1);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      color.at(x, y, 0) = float(x) / kWidth;
      color.at(x, y, 1) = float(y) / kHeight;
      color.at(x, y, 2) = float((x + y + step) % 5) / 5 + (arm == "truth" && x > 20 ? 0.0625f : 0);
    }
  return color;
}

Image filled(int width, int height, int channels, float (*value)(int x, int y, int c)) {
  Image image(width, height, channels);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < channels; ++c) image.at(x, y, c) = value(x, y, c);
  return image;
}

Taken taken(const std::string& arm, int step) {
  lab::Picture picture;
  auto& outputs = picture.frame.outputs;
  outputs["color"] = {"rgba32f", colorOf(arm, step), {}};
  outputs["velocity"] = {
      "rg32f", filled(kWidth, kHeight, 2, [](int x, int, int c) { return c == 0 && x < 32 ? 12.0f : 0.0f; }), {}};
  outputs["depth"] = {"r32f", filled(kWidth, kHeight, 1, [](int x, int, int) { return 1.0f + float(x) / 16; }), {}};
  auto inner = [](int x, int y, int) { return x >= 20 && x < 30 && y < 18 ? 1.0f : 0.0f; };
  if (arm == "truth") outputs["inner"] = {"r8_unorm", filled(kWidth, kHeight, 1, inner), {}};
  picture.frame.taps["half.speed"] = {
      "rg32f",
      filled(kWidth / 2, kHeight / 2, 2, [](int x, int y, int c) { return c == 1 ? float(x + y) : 0.0f; }),
      {}};
  picture.record["shot"] = {{"exposure", 0.5}, {"anchor", "centre"}, {"fps", 12}, {"set", {{"scene.pixels", 40}}}};
  picture.record["pipeline"] = {{"name", arm}, {"values", {{"samples", 16}}}, {"nodes", {{"half", {{"tile", 2}}}}}};
  picture.record["scene"]["attribution"] = {{"copyright", "A room by A. N. Other, CC BY"}};
  picture.ndc_from_world = mat4(0);  // keeps x and y, sets w = -z
  picture.ndc_from_world[0][0] = picture.ndc_from_world[1][1] = 1;
  picture.ndc_from_world[2][3] = -1;
  Taken made{"still", arm, step, std::make_shared<lab::Picture>(std::move(picture)), {}, {}, {}};
  made.divides = {{"half.speed", 2}};
  // ndc (0.5, 0.5) at a distance of 2: three quarters of the width from the left, a quarter of the height from the top.
  made.nodes_ws = {{"ball", {1, 1, -2}}, {"behind", {0, 0, 3}}};
  return made;
}

}  // namespace

const Taken& findTaken(const std::string& shot, const std::string& arm, int step) {
  static std::map<std::string, Taken> all;
  if (shot != "still") throw Error("there is no shot '" + shot + "'");
  std::string key = arm + std::to_string(step);
  if (!all.count(key)) all.emplace(key, taken(arm, step));
  return all.at(key);
}

Json dataOf(const std::string& lua, const std::string& kind) {
  testing::TemporaryFolder folder;
  testing::writeText(folder / "x.lua", R"lua(
local check, fields, figure = require "strobe.check", require "strobe.fields", require "strobe.figure"
local function made(place, t)
  local self = fields.checker({}).at(place)
  self.options = { exposure = {}, fps = {} }
  local data = figure[KIND](self, t, {}, { shots = { "still", "other" }, arms = { "plain", "truth" }, truth = "truth" })
  self.problems:raise()
  data.size = { 64, 36 }
  return data
end
return made(caller_place(1), {
)lua" + lua + "})\n");
  std::string text = testing::contentOf(folder / "x.lua");
  text.replace(text.find("KIND"), 4, kind == "figure" ? "\"checked\"" : "\"checked_film\"");
  testing::writeText(folder / "x.lua", text);
  return script::evaluateData(home(), folder / "x.lua");
}

Colour colourAt(const Image& image, int x, int y) { return {image.at(x, y, 0), image.at(x, y, 1), image.at(x, y, 2)}; }

int levelsApart(const Colour& a, const Colour& b) {
  float worst = 0;
  for (size_t c = 0; c < 3; ++c) worst = std::max(worst, std::abs(a[c] - b[c]));
  return int(std::lround(255 * worst));
}

}  // namespace strobe::figure
