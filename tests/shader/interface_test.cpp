// SPDX-License-Identifier: MIT
#include "shader/interface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "common/home.h"
#include "common/refusal.h"
#include "common/temporary_folder.h"

namespace strobe::shader {
namespace interface_test {

class Shaders : public ::testing::Test {
 protected:
  void SetUp() override {
    interface_.pass = "scale";
    interface_.place = "passes/scale.lua:3";
    interface_.reads = {{"depth", false, true}};
    interface_.writes = {{"result", "r32f", false, false}};
    interface_.params = {{"factor", false}};
    interface_.variants = {{"mode", {"plain", "double"}, 1}};
  }

  Path write(const std::string& name, const std::string& text) {
    std::ofstream(folder_ / name) << text;
    return folder_ / name;
  }

  std::string errorOf(const std::string& text) {
    Path file = write("scale.glsl", text);
    return testing::refusalOf([&] { compilePass(home(), interface_, file, ShaderStage::Compute); });
  }

  std::vector<std::string> unused(const std::vector<Path>& files) {
    return nameProblems(home(), interface_, files, namesUsed(home(), files));
  }

  const testing::TemporaryFolder temporary_;
  const Path folder_ = temporary_.path();
  Interface interface_;
};

const char* kGood =
    "void run(ivec2 p) {\n"
    "  float f = params.factor;\n"
    "#if PARAM_mode == mode_double\n"
    "  f *= 2.0;\n"
    "#endif\n"
    "  imageStore(result_img, p, f * texelFetch(depth_tex, p, 0));\n"
    "}\n";

TEST_F(Shaders, UnknownChoiceIsNamed) {
  std::string text = kGood;
  text.replace(text.find("mode_double"), 11, "mode_dubble");
  EXPECT_EQ(errorOf(text), "");  // the preprocessor replaces the unknown name by 0
  std::vector<std::string> problems = unused({folder_ / "scale.glsl"});
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_NE(problems[0].find("compares PARAM_mode with mode_dubble"), std::string::npos) << problems[0];
  EXPECT_NE(problems[0].find("did you mean 'mode_double'"), std::string::npos) << problems[0];
}

TEST_F(Shaders, ChoicesAreUsedByName) {
  EXPECT_EQ(errorOf(kGood), "");
  EXPECT_TRUE(unused({folder_ / "scale.glsl"}).empty());
}

TEST_F(Shaders, ParameterOfAFormatMayBeUnused) {
  interface_.variants.push_back({"precision", {"full", "half"}, 0});
  EXPECT_EQ(errorOf(kGood), "");
  EXPECT_EQ(unused({folder_ / "scale.glsl"}).size(), 1u);
  interface_.variants.back().decides_format = true;
  EXPECT_TRUE(unused({folder_ / "scale.glsl"}).empty());
}

TEST_F(Shaders, ErrorsHaveTheUsersLineAndBothPlaces) {
  std::string error = errorOf("void run(ivec2 p) {\n  imageStore(result_img, p, texelFetch(dept_tex, p, 0));\n}\n");
  EXPECT_NE(error.find("scale.glsl:2: "), std::string::npos) << error;
  EXPECT_NE(error.find("passes/scale.lua:3"), std::string::npos) << error;
  EXPECT_NE(error.find("did you mean 'depth_tex'?"), std::string::npos) << error;
  error = errorOf("void run(ivec2 p) {\n\n  imageStore(result_img, p, vec4(params.facto));\n}\n");
  EXPECT_NE(error.find("scale.glsl:3: "), std::string::npos) << error;
  EXPECT_NE(error.find("did you mean 'factor'?"), std::string::npos) << error;
}

TEST_F(Shaders, AllErrorsAreReportedAtOnce) {
  std::string error = errorOf("void run(ivec2 p) {\n  float a = one;\n  float b = two;\n}\n");
  EXPECT_NE(error.find("'one'"), std::string::npos) << error;
  EXPECT_NE(error.find("'two'"), std::string::npos) << error;
}

TEST_F(Shaders, ErrorsInsideAnIncludeNameTheInclude) {
  write("part.glsl", "float part() {\n  return absent;\n}\n");
  std::string error = errorOf(std::string("#include \"part.glsl\"\n") + kGood);
  EXPECT_NE(error.find("part.glsl:2: "), std::string::npos) << error;
}

TEST_F(Shaders, ErrorsAfterTheShaderNameTheShader) {
  std::string misspelt = kGood;
  misspelt.replace(misspelt.find("run"), 3, "ran");
  std::string error = errorOf(misspelt);
  EXPECT_NE(error.find("scale.glsl: no function 'void run(ivec2 pixel)'"), std::string::npos) << error;
  error = errorOf(std::string(kGood, strlen(kGood) - 2));  // without the last brace
  EXPECT_NE(error.find("scale.glsl: "), std::string::npos) << error;
  EXPECT_NE(error.find("after the shader"), std::string::npos) << error;
}

TEST_F(Shaders, UnusedDeclarationsAreReported) {
  Path file = write("scale.glsl", "void run(ivec2 p) { imageStore(result_img, p, vec4(1)); }\n");
  std::vector<std::string> problems = unused({file});
  EXPECT_EQ(problems.size(), 3u);  // unused: the read, the parameter and the variant
  for (const std::string& problem : problems)
    EXPECT_NE(problem.find("passes/scale.lua:3"), std::string::npos) << problem;
}

TEST_F(Shaders, CommentsAreNotUses) {
  Path file = write("scale.glsl",
                    "// depth_tex, params.factor\n/* PARAM_mode\n params.factor */\n"
                    "void run(ivec2 p) { imageStore(result_img, p, vec4(other.factor)); }\n");
  EXPECT_EQ(unused({file}).size(), 3u);
  write("part.glsl", "#if PARAM_mode == 9\n  float f = texelFetch(depth_tex, p, 0).x * params\n  . factor;\n#endif\n");
  file = write("scale.glsl", "#include \"part.glsl\"\nvoid run(ivec2 p) { imageStore(result_img, p, vec4(1)); }\n");
  EXPECT_TRUE(unused({file}).empty());
}

TEST_F(Shaders, EveryReadFileIsReported) {
  write("part.glsl", "float part() { return 1.0; }\n");
  Path file = write("scale.glsl", std::string("#include \"part.glsl\"\n") + kGood);
  std::vector<Path> files;
  textWithIncludes(home(), file, &files);
  EXPECT_EQ(files, (std::vector<Path>{file, folder_ / "part.glsl"}));
}

// A pass that reads the scene without deformed meshes: no declaration and no code for deformed vertices.
TEST_F(Shaders, FeaturesThatTheSceneLacksAreNotCompiled) {
  auto words = [&](bool bends) {
    Interface in;
    in.pass = "visibility";
    in.raster = in.scene = true;
    in.writes = {{"hit", "rgba32ui", true, false}};
    for (const char* fact : {"alpha", "blend", "one_sided", "shadows"}) in.facts.push_back({fact, true});
    in.facts.push_back({"deforms", bends});
    return compilePass(home(), in, home().at("shaders/gbuffer/visibility.vert.glsl"), ShaderStage::Vertex);
  };
  auto names = [](const std::vector<uint32_t>& spirv) {
    return std::string(reinterpret_cast<const char*>(spirv.data()), spirv.size() * sizeof(uint32_t));
  };
  EXPECT_NE(names(words(true)).find("first_deformed"), std::string::npos);
  EXPECT_NE(names(words(true)).find("SceneDeformedVert"), std::string::npos);
  for (const char* trace : {"bend", "bent", "Bend", "Bent"})
    EXPECT_EQ(names(words(false)).find(trace), std::string::npos) << trace;
  EXPECT_LT(words(false).size(), words(true).size());
}

}  // namespace interface_test
}  // namespace strobe::shader
