// SPDX-License-Identifier: MIT
// Pictures of the renderer, for tests against references that share no code with it. One device, with validation,
// serves every test of the program; a validation message fails the test that caused it.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "lab/workbench.h"
#include "oracle/closed_form.h"

namespace strobe::oracle {

class RenderTest : public ::testing::Test {
 protected:
  void TearDown() override;

  static lab::Workbench& bench();
  static lab::Picture render(const lab::Shot& shot) { return bench().render(shot); }
  // Names of the ray tracing backends of the device.
  static std::vector<std::string> backends();
};

using Numbers = std::vector<std::pair<std::string, double>>;

// A shot of scripts/scenes/oracles/<scene>.lua or tests/oracle/scenes/<scene>.lua at frame 0. The scenes' lengths are
// in pixels. `numbers` are parameters of the scene.
lab::Shot shotOf(const std::string& scene, int width, int height, const Numbers& numbers = {});

// The pipeline of the experiments that combines steps of the hybrids.
const std::string& hybridSteps();

// The shot with another pipeline and more settings ("NAME=VALUE"). An empty anchor keeps the shot's anchor.
lab::Shot with(lab::Shot shot, const std::string& pipeline, const std::vector<std::string>& settings = {},
               const std::string& anchor = "");

const image::Image& colorOf(const lab::Picture& picture);
const image::Image& imageOf(const lab::Picture& picture, const std::string& output);

// Count of "node.counter"; fails the test if that counter is missing.
uint64_t counterOf(const lab::Picture& picture, const std::string& name);
int iterationsOf(const lab::Picture& picture, const std::string& loop);

struct Anchor {
  std::string name;
  Window window;
};
const std::vector<Anchor>& anchors();

// Root mean square over all colour values; both images have the same size.
double rms(const image::Image& a);
double rmsDifference(const image::Image& a, const image::Image& b);
double largestDifference(const image::Image& a, const image::Image& b);

// Bit for bit: the same size and values.
bool identical(const image::Image& a, const image::Image& b);

// Expects the red channel of every pixel within `bound` of the exact exposure; the failure names the worst pixel.
using ExactAt = std::function<Exposure(int x, int y)>;
using BoundOf = std::function<double(const Exposure&)>;
void expectWithin(const image::Image& color, const ExactAt& exact, const BoundOf& bound, const std::string& what);

}  // namespace strobe::oracle
