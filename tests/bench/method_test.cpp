// SPDX-License-Identifier: MIT
// Methods as they are written on the command line.
#include <gtest/gtest.h>

#include "bench/measure.h"

namespace strobe::bench::test {
namespace method_test {

void expectRefusal(const std::string& text, const std::string& wanted) {
  try {
    methodFrom(text);
    ADD_FAILURE() << text;
  } catch (const Error& error) {
    EXPECT_EQ(error.exitCode(), 2);
    EXPECT_NE(std::string(error.what()).find(wanted), std::string::npos) << error.what();
  }
}

TEST(Method, IsAPipelineWithSettings) {
  lab::Arm plain = methodFrom("hybrid");
  EXPECT_EQ(plain.pipeline, "hybrid");
  EXPECT_TRUE(plain.sets.empty());
  lab::Arm set = methodFrom("pipelines/x.lua:preset=text,samples=32,gain=0.5,edge.size=3");
  EXPECT_EQ(set.name, "pipelines/x.lua:preset=text,samples=32,gain=0.5,edge.size=3");
  EXPECT_EQ(set.pipeline, "pipelines/x.lua");
  EXPECT_EQ(set.sets,
            (script::Settings{{"preset", "text"}, {"samples", int64_t(32)}, {"gain", 0.5}, {"edge.size", int64_t(3)}}));
}

TEST(Method, OtherSpellingsAreRefused) {
  expectRefusal("", "is not PIPELINE or PIPELINE:NAME=VALUE,NAME=VALUE");
  expectRefusal("hybrid:", "'hybrid:' is not PIPELINE or PIPELINE:NAME=VALUE,NAME=VALUE");
  expectRefusal(":samples=3", "is not PIPELINE or");
  expectRefusal("hybrid:samples", "'hybrid:samples': 'samples' is not NAME=VALUE");
  expectRefusal("hybrid:samples=3,,x=1", "'' is not NAME=VALUE");
}

}  // namespace method_test
}  // namespace strobe::bench::test
