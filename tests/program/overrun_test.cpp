// SPDX-License-Identifier: MIT
// A shader that never ends, in a command without a window.
#include <gtest/gtest.h>

#include "common/home.h"
#include "program/run.h"

namespace strobe::testing {
namespace overrun_test {

const char* const kExperiment = R"lua(
local experiment = require "strobe.experiment"
return experiment {
  title = "Endless", size = { 64, 36 }, regions = { "whole" }, measures = { "rmse" },
  truth = { pipeline = "ground_truth", set = { samples = 4 } },
  arms = { { name = "none", pipeline = "none" }, { name = "endless", pipeline = "hybrid" },
           { name = "later", pipeline = "mcguire2012" } },
  shots = { { name = "bar", scene = "oracles/bar", frame = 0 } },
}
)lua";

class Overrun : public ::testing::Test {
 protected:
  Overrun() {
    const fs::path home = folder_.path() / "home";
    fs::create_directories(home);
    for (const char* part : {"passes", "scripts", "shaders"})
      fs::copy(strobe::home().shipped() / part, home / part, fs::copy_options::recursive);
    const fs::path shader = home / "shaders/tile/tile_max.glsl";
    std::string text = contentOf(shader), head = "void run(ivec2 tile) {\n";
    EXPECT_NE(text.find(head), std::string::npos);
    text.insert(text.find(head) + head.size(),
                "  while (texelFetch(velocity_tex, tile, 0).x < 1e30) imageStore(longest_img, tile, vec4(1));\n");
    writeText(shader, text);
  }
  Outcome limited(const std::string& arguments) const {
    return run(arguments + " --time-limit 1", "STROBE_VALIDATION=0 STROBE_HOME=" + (folder_ / "home"));
  }

  TemporaryFolder folder_;
};

TEST_F(Overrun, OfASweepNamesThePointAndTheKeptPoints) {
  writeText(folder_ / "x.lua", kExperiment);
  Outcome outcome = limited("sweep " + (folder_ / "x.lua") + " -o " + (folder_ / "out"));
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.err.find("strobe: bar, endless: '"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("ran for more than 1 s on the device (--time-limit); 1 of 3 points is kept; the same "
                             "command continues\n"),
            std::string::npos)
      << outcome.err;
}

}  // namespace overrun_test
}  // namespace strobe::testing
