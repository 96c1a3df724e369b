// SPDX-License-Identifier: MIT
// Seeded mistakes: one change to valid files each, and the complete expected error.
#include <gtest/gtest.h>

#include "home.h"
#include "script/evaluate.h"

namespace strobe::script {
namespace mistakes_test {

static const char* kPipeline = R"(local pipeline = require "strobe.pipeline"
local base     = require "passes.base"
local largest  = require "passes.tile.largest"
local smear    = require "passes.smear"
local add      = require "passes.add"

return pipeline {
  doc = "a pipeline to make mistakes in",
  params = {
    tile = pipeline.int { 32, min = 2, max = 64, unit = "px", doc = "side of a tile" },
    order = pipeline.choice { "rows", "columns", doc = "which first" },
  },
  presets = { fine = { doc = "x", set = { tile = 4 } } },
  build = function(p)
    local g = base {}
    local far = largest { velocity = g.velocity, id = g.id, tile = p.tile, order = p.order }
    local l = pipeline.loop {
      name = "shutter", count = 8,
      body = function()
        return { sum = add { time = "sample" }.sum }
      end,
    }
    local s = smear {
      color = l.sum,
      max = far.max,
    }
    return {
      depth = g.depth,
      color = s.color,
    }
  end,
}
)";

static const char* kSample = "scripts/pipelines/sample.lua";
static const char* kLargest = "passes/tile/largest.lua";
static const char* kSmear = "passes/smear.lua";

struct Mistake {
  const char* file;
  const char* from;
  const char* to;
  const char* error;
};

static const Mistake kMistakes[] = {
#include "mistakes.inc"
};

static std::string replaced(std::string text, const std::string& from, const std::string& to) {
  size_t at = text.find(from);
  STROBE_ASSERT(at != std::string::npos, "{}", from);
  return text.replace(at, from.size(), to);
}

TEST(Mistakes, UnchangedPipelineIsValid) {
  TestHome home;
  home.write(kSample, kPipeline);
  EXPECT_NO_THROW(evaluatePipeline(home.home(), {"sample", {}}));
}

TEST(Mistakes, EachIsRefusedWithItsLineAndTheNearestName) {
  TestHome home;
  std::map<std::string, std::string> files = samplePasses();
  files[kSample] = kPipeline;
  for (const Mistake& mistake : kMistakes) {
    for (const auto& [path, text] : files) home.write(path, text);
    home.write(mistake.file, replaced(files[mistake.file], mistake.from, mistake.to));
    std::string error = "none";
    try {
      evaluatePipeline(home.home(), {"sample", {}});
    } catch (const Error& caught) {
      error = caught.what();
    }
    EXPECT_EQ(error, mistake.error) << mistake.from << " -> " << mistake.to;
  }
  EXPECT_GE(std::size(kMistakes), 60u);
}

}  // namespace mistakes_test
}  // namespace strobe::script
