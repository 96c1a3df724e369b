// SPDX-License-Identifier: MIT
// The option `render --renderdoc`, with Debian's renderdoccmd.
#include <gtest/gtest.h>

#include "base/json.h"
#include "program/run.h"

namespace strobe::testing {
namespace renderdoc_test {

const std::string kShot = "render hybrid --scene oracles/bar --size 64x32";

// Skipped without RenderDoc and Mesa's software device.
class RenderDoc : public ::testing::Test {
 protected:
  void SetUp() override {
    if (runLine("command -v renderdoccmd").exit_code != 0) GTEST_SKIP() << "no renderdoccmd";
    if (runLine("ls /usr/lib/*/libvulkan_lvp.so").exit_code != 0) GTEST_SKIP() << "no software device of Mesa";
  }
  // Environment of a software device that RenderDoc accepts.
  std::string acceptedDevice() {
    const Json manifest = {{"file_format_version", "1.0.0"},
                           {"ICD", {{"library_path", STROBE_TEST_DRIVER}, {"api_version", "1.3.0"}}}};
    writeText(folder_ / "driver.json", manifest.dump());
    return "STROBE_VALIDATION=0 VK_DRIVER_FILES=" + (folder_ / "driver.json");
  }

  TemporaryFolder folder_;
};

TEST_F(RenderDoc, CapturesAFrameWithTheNamesOfPasses) {
  const std::string file = folder_ / "new/frame.rdc", picture = folder_ / "frame.png", plain = folder_ / "plain.png";
  Outcome outcome = run(kShot + " -o " + picture + " --renderdoc " + file, acceptedDevice());
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find(file + "\n"), std::string::npos) << outcome.out;
  EXPECT_TRUE(contentOf(file).starts_with("RDOC"));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_.path() / "new"), {}), 1) << "temporary files are left";

  const std::string xml = folder_ / "frame.xml";
  Outcome converted = runLine("renderdoccmd convert -f " + file + " -o " + xml + " -c xml");
  ASSERT_EQ(converted.exit_code, 0) << converted.out << converted.err;
  const std::string text = contentOf(xml);
  EXPECT_NE(text.find("vkCmdBeginDebugUtilsLabelEXT"), std::string::npos);
  for (const char* pass : {"visibility", "gbuffer", "ray_reveal", "gather_revealed", "composite"})
    EXPECT_NE(text.find(std::string(">") + pass + "<"), std::string::npos) << pass;

  ASSERT_EQ(run(kShot + " --backend bvh -o " + plain, "STROBE_VALIDATION=0").exit_code, 0);
  EXPECT_EQ(contentOf(picture), contentOf(plain)) << "a capture changes the picture";
}

TEST_F(RenderDoc, CaptureIsTheOnlyOutputByDefault) {
  Outcome outcome = run(kShot + " --renderdoc frame.rdc", "-C " + folder_.path().string() + " " + acceptedDevice());
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "frame.rdc\n");
}

TEST_F(RenderDoc, DevicesWithHiddenFeaturesAreRefused) {
  Outcome outcome = run(kShot + " --renderdoc " + (folder_ / "frame.rdc"), "STROBE_VALIDATION=0");
  if (outcome.exit_code == 0) GTEST_SKIP() << "RenderDoc accepts this device";
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.err.find("; RenderDoc hides these features"), std::string::npos) << outcome.err;
}

TEST_F(RenderDoc, CaptureNeedsTheLayer) {
  Outcome outcome = run(kShot + " --renderdoc " + (folder_ / "frame.rdc"),
                        "STROBE_VALIDATION=0 DISABLE_VULKAN_RENDERDOC_CAPTURE_1_24=1");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.err.find("RenderDoc"), std::string::npos) << outcome.err;
  EXPECT_FALSE(fs::exists(folder_ / "frame.rdc"));
}

TEST(RenderDocOption, MissingLibraryIsNamedBeforeTheDeviceIsCreated) {
  TemporaryFolder folder;
  writeText(folder / "librenderdoc.so", "");
  Outcome outcome = run(kShot + " --renderdoc frame.rdc", "LD_LIBRARY_PATH=" + folder.path().string());
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_TRUE(outcome.err.starts_with("strobe: --renderdoc: RenderDoc is not loaded: install it")) << outcome.err;
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
}

TEST(RenderDocOption, OtherFileNamesAreRefused) {
  Outcome outcome = run(kShot + " --renderdoc frame.png");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.err, "strobe: --renderdoc: 'frame.png' is not an .rdc file\n");
}

}  // namespace renderdoc_test
}  // namespace strobe::testing
