// SPDX-License-Identifier: MIT
#include "oracle/render.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>

#include "common/home.h"
#include "common/source.h"
#include "shader/backends.h"

namespace strobe::oracle {

namespace {

std::unique_ptr<lab::Workbench> the_bench;

// The device must be destroyed before the libraries that created it.
class BenchEnvironment : public ::testing::Environment {
 public:
  void TearDown() override { the_bench.reset(); }
};
const ::testing::Environment* const kEnvironment = ::testing::AddGlobalTestEnvironment(new BenchEnvironment);

}  // namespace

lab::Workbench& RenderTest::bench() {
  if (!the_bench) {
    the_bench = std::make_unique<lab::Workbench>(home(), "", true);
    // A frame is one submission, as on hardware devices, and its barriers are validated.
    the_bench->frames_in_flight = 2;
  }
  return *the_bench;
}

std::vector<std::string> RenderTest::backends() {
  std::vector<std::string> names;
  for (const shader::BackendRow& row : shader::backends())
    if (shader::isPresent(row, bench().device().info())) names.push_back(row.name);
  return names;
}

void RenderTest::TearDown() {
  if (!the_bench) return;
  for (const std::string& message : the_bench->device().takeMessages()) ADD_FAILURE() << "validation: " << message;
}

lab::Shot shotOf(const std::string& scene, int width, int height, const Numbers& numbers) {
  lab::Shot shot;
  Path own = sourceFolder() / "tests/oracle/scenes" / (scene + ".lua");
  Path common = sourceFolder() / "scripts/scenes/oracles" / (scene + ".lua");
  shot.scene = std::filesystem::exists(own) ? own : common;
  shot.width = width;
  shot.height = height;
  shot.frame = 0;
  shot.sets = {{"scene.width", std::to_string(width)}, {"scene.height", std::to_string(height)}};
  for (const auto& [name, value] : numbers) shot.sets.push_back({"scene." + name, fmt::format("{}", value)});
  return shot;
}

const std::string& hybridSteps() {
  static const std::string file = sourceFolder() / "experiments/pipelines/hybrid_steps.lua";
  return file;
}

lab::Shot with(lab::Shot shot, const std::string& pipeline, const std::vector<std::string>& settings,
               const std::string& anchor) {
  shot.pipeline = pipeline;
  if (!anchor.empty()) shot.anchor = anchor;
  for (const std::string& setting : settings) {
    size_t equals = setting.find('=');
    shot.sets.push_back({setting.substr(0, equals), setting.substr(equals + 1)});
  }
  return shot;
}

const image::Image& imageOf(const lab::Picture& picture, const std::string& output) {
  return picture.frame.outputs.at(output).floats;
}

const image::Image& colorOf(const lab::Picture& picture) { return imageOf(picture, "color"); }

uint64_t counterOf(const lab::Picture& picture, const std::string& name) {
  for (const auto& [counter, count] : picture.frame.counters)
    if (counter == name) return count;
  ADD_FAILURE() << "no counter " << name;
  return 0;
}

int iterationsOf(const lab::Picture& picture, const std::string& loop) {
  for (const auto& [name, count] : picture.frame.iterations)
    if (name == loop) return count;
  ADD_FAILURE() << "no loop " << loop;
  return 0;
}

const std::vector<Anchor>& anchors() {
  static const std::vector<Anchor> all = {{"end", kCloseAnchor}, {"centre", kCentreAnchor}, {"start", kOpenAnchor}};
  return all;
}

// The fourth channel is alpha or a count, not a colour.
static double sumOverColors(const image::Image& a, const std::function<double(size_t)>& value) {
  double sum = 0;
  for (size_t i = 0; i < a.values.size(); ++i)
    if (int(i % size_t(a.channels)) < 3) sum += value(i);
  return sum / (double(a.width) * a.height * std::min(a.channels, 3));
}

double rms(const image::Image& a) {
  return std::sqrt(sumOverColors(a, [&](size_t i) { return double(a.values[i]) * a.values[i]; }));
}

double rmsDifference(const image::Image& a, const image::Image& b) {
  return std::sqrt(sumOverColors(a, [&](size_t i) { return std::pow(double(a.values[i]) - b.values[i], 2); }));
}

double largestDifference(const image::Image& a, const image::Image& b) {
  double largest = a.values.size() == b.values.size() ? 0 : kInfinity;
  for (size_t i = 0; i < std::min(a.values.size(), b.values.size()); ++i)
    largest = std::max(largest, std::abs(double(a.values[i]) - b.values[i]));
  return largest;
}

bool identical(const image::Image& a, const image::Image& b) {
  return a.width == b.width && a.height == b.height && a.values.size() == b.values.size() &&
         std::memcmp(a.values.data(), b.values.data(), a.values.size() * sizeof(float)) == 0;
}

void expectWithin(const image::Image& color, const ExactAt& exact, const BoundOf& bound, const std::string& what) {
  double worst = 0;
  std::string place;
  for (int y = 0; y < color.height; ++y) {
    for (int x = 0; x < color.width; ++x) {
      Exposure truth = exact(x, y);
      double excess = std::abs(color.at(x, y, 0) - truth.colour) - bound(truth);
      if (excess <= worst) continue;
      worst = excess;
      place = fmt::format("({}, {}) is {:.6f}, exactly {:.6f}, bound {:.6f}", x, y, color.at(x, y, 0), truth.colour,
                          bound(truth));
    }
  }
  EXPECT_LE(worst, 0) << what << ": " << place;
}

}  // namespace strobe::oracle
