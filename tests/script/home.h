// SPDX-License-Identifier: MIT
// A home folder for a test: the library of the source tree, and the passes and pipelines that the test writes.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <string>

#include "base/home.h"
#include "common/source.h"

namespace strobe::script {

// Passes for test pipelines.
inline const std::map<std::string, std::string>& samplePasses() {
  static const std::map<std::string, std::string> passes = {
      {"passes/base.lua", R"(local pass = require "strobe.pass"
return pass.raster {
  name = "base", shader = "base/base", doc = "everything of the nearest surface",
  writes = {
    color    = { format = "rgba16f", doc = "linear" },
    depth    = { format = "r32f", doc = "view depth, m" },
    id       = { format = "r32ui", doc = "instance" },
    velocity = { format = "rg32f", doc = "px over the exposure" },
  },
}
)"},
      {"passes/tile/largest.lua", R"(local pass = require "strobe.pass"
return pass.compute {
  name = "largest", shader = "tile/largest", doc = "longest velocity of a tile",
  size = { of = "velocity", divide = "tile" },
  reads = {
    velocity = { doc = "px over the exposure" },
    id = { doc = "instance", uint = true, optional = true },
  },
  writes = { max = { format = "rg32f", doc = "px over the exposure" } },
  params = {
    tile = pass.int { 20, min = 1, max = 256, unit = "px", doc = "side of a tile" },
    bias = pass.float { 0.1, min = 0, max = 1, doc = "share" },
    order = pass.choice { "rows", "columns", default = "columns", doc = "which first" },
    fast = pass.bool { true, doc = "whether" },
  },
  counters = { clamped = "tiles that were clamped" },
}
)"},
      {"passes/smear.lua", R"(local pass = require "strobe.pass"
return pass.compute {
  name = "smear", shader = "smear", doc = "average along the velocity",
  reads = { color = { doc = "linear", linear = true }, max = { doc = "px over the exposure" } },
  writes = { color = { format = "rgba16f", doc = "linear" } },
  params = { taps = pass.int { 8, min = 1, max = 64, doc = "images taken" } },
}
)"},
      {"passes/add.lua", R"(local pass = require "strobe.pass"
return pass.trace {
  name = "add", shader = "add", doc = "adds an image of one time",
  updates = { sum = { format = "rgba32f", doc = "sum of images" } },
  writes = { done = { format = "r32f", doc = "non-zero when there is enough" } },
}
)"}};
  return passes;
}

class TestHome {
 public:
  TestHome() {
    static int count = 0;
    namespace fs = std::filesystem;
    std::string name = "strobe_script_" + std::to_string(::getpid()) + "_" + std::to_string(count++);
    folder_ = fs::temp_directory_path() / name;
    fs::create_directories(folder_ / "scripts/pipelines");
    fs::create_directories(folder_ / "scripts/scenes");
    fs::copy(sourceFolder() / "scripts/strobe", folder_ / "scripts/strobe");
    for (const auto& [path, text] : samplePasses()) write(path, text);
  }
  ~TestHome() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  TestHome(const TestHome&) = delete;
  TestHome& operator=(const TestHome&) = delete;

  const Path& folder() const { return folder_; }
  // Scripts are evaluated by the program of the environment or by `program`.
  Home home() const { return home(Home::fromEnvironment().program()); }
  Home home(const Path& program) const { return Home({folder_}, {}, program); }

  void write(const std::string& path, const std::string& text) const {
    std::filesystem::create_directories((folder_ / path).parent_path());
    std::ofstream(folder_ / path, std::ios::binary) << text;
  }

 private:
  Path folder_;
};

}  // namespace strobe::script
