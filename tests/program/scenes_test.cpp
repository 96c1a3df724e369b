// SPDX-License-Identifier: MIT
// Every scene of the shared data gives a picture or a clear refusal, never a crash; the short form tests every third
// scene. Scenes of single objects give pictures.
#include <gtest/gtest.h>

#include <algorithm>

#include "base/files.h"
#include "common/all_cases.h"
#include "common/home.h"
#include "common/source.h"
#include "program/run.h"

namespace strobe::testing {
namespace scenes_test {

std::vector<fs::path> sceneFiles() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(*home().data() / "scenes")) {
    std::string ending = entry.path().extension().string();
    if (ending == ".glb" || ending == ".gltf") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

TEST(SharedScenes, EachRendersOrIsRefused) {
  if (!home().data()) GTEST_SKIP() << "no shared data: STROBE_DATA names its folder";
  TemporaryFolder folder;
  int rendered = 0, number = 0;
  for (const fs::path& file : sceneFiles()) {
    if (number++ % 3 && !allCases()) continue;
    Outcome outcome = run("render none --size 64x36 --scene '" + file.string() + "' -o " + (folder / "picture.exr"),
                          "STROBE_VALIDATION=0");
    bool picture = outcome.exit_code == 0 && fs::exists(folder / "picture.exr");
    bool refusal = outcome.exit_code == 1 && outcome.err.find(file.filename().string()) != std::string::npos;
    EXPECT_TRUE(picture || refusal) << file << ": exit code " << outcome.exit_code << "\n" << outcome.err;
    rendered += picture;
    fs::remove(folder / "picture.exr");
  }
  EXPECT_GT(rendered, 0);
}

TEST(ObjectScenes, EachRenders) {
  TemporaryFolder folder;
  int rendered = 0;
  for (const auto& entry : fs::directory_iterator(sourceFolder() / "scripts/scenes/objects")) {
    Outcome outcome =
        run("render none --size 64x36 --scene '" + entry.path().string() + "' -o " + (folder / "picture.exr"));
    EXPECT_EQ(outcome.exit_code, 0) << entry.path() << "\n" << outcome.err;
    rendered += fs::remove(folder / "picture.exr");
  }
  EXPECT_GE(rendered, 10);
}

}  // namespace scenes_test
}  // namespace strobe::testing
