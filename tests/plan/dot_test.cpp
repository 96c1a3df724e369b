// SPDX-License-Identifier: MIT
// The graph of a plan as text for Graphviz.
#include "plan/dot.h"

#include <gtest/gtest.h>

#include "plan/builder.h"

namespace strobe::plan::test {
namespace dot_test {

std::string dotOf(const PipelineDesc& pipeline) {
  CompileOptions options;
  options.width = 64, options.height = 32;
  return toDot(compile(pipeline, options));
}

size_t count(const std::string& text, const std::string& part) {
  size_t found = 0;
  for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

TEST(Dot, HasABoxPerNodeAnEdgePerPairAndTheOutputs) {
  Builder b;
  b.raster("seen", {}, {"depth", "color rgba32f"});
  b.compute("blur", {{"depth", "seen.depth"}, {"color", "seen.color"}}, {"blurred rgba32f"});
  b.compute("unused", {{"depth", "seen.depth"}}, {"nothing"});
  b.output("color", "blur.blurred");
  b.output("depth", "seen.depth");
  std::string dot = dotOf(b.pipeline);
  EXPECT_NE(dot.find("\"seen\" [label=\"seen\\nraster 64x32\""), std::string::npos) << dot;
  EXPECT_NE(dot.find("\"blur\" [label=\"blur\\ncompute 64x32\""), std::string::npos) << dot;
  EXPECT_EQ(dot.find("unused"), std::string::npos) << "the node is culled\n" << dot;
  EXPECT_EQ(count(dot, "\"seen\" -> \"blur\""), 1u) << dot;
  EXPECT_NE(dot.find("[label=\" depth\\ncolor\"]"), std::string::npos) << dot;
  EXPECT_NE(dot.find("\"blur\" -> \"output color\" [label=\" blurred\""), std::string::npos) << dot;
  EXPECT_NE(dot.find("\"seen\" -> \"output depth\" [label=\"\""), std::string::npos) << dot;
  EXPECT_EQ(count(dot, "{"), count(dot, "}"));
}

TEST(Dot, LoopIsACluster) {
  Builder b;
  b.beginLoop("time", 4);
  b.compute("sample", {}, {}, {"sum rgba32f"});
  b.endLoop();
  b.compute("mean", {{"sum", "sample.sum"}}, {"color rgba32f"});
  b.output("color", "mean.color");
  std::string dot = dotOf(b.pipeline);
  size_t cluster = dot.find("subgraph cluster_0"), end = dot.find("  }\n"), sample = dot.find("\"sample\" [");
  ASSERT_NE(cluster, std::string::npos) << dot;
  EXPECT_TRUE(cluster < sample && sample < end) << dot;
  EXPECT_NE(dot.find("label=\"time: 4 times\""), std::string::npos) << dot;
  EXPECT_GT(dot.find("\"mean\" ["), end) << dot;
}

}  // namespace dot_test
}  // namespace strobe::plan::test
