// SPDX-License-Identifier: MIT
// Animated sample files against a reading of glTF's text that shares no code (gltf_reference.py): every node of every
// clip from its start to its end.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "base/process.h"
#include "common/home.h"
#include "common/source.h"
#include "scene/defaults.h"
#include "scene/gltf.h"
#include "scene/motion.h"

namespace strobe::scene {
namespace {

namespace fs = std::filesystem;

// Starts, ends, and times of which most lie between keys.
const std::vector<double> kShares = {0, 0.0625, 0.125, 0.25, 0.3, 0.4375, 0.5, 0.6, 0.75, 0.875, 0.95, 1};

class Poses : public testing::Test {
 protected:
  static std::vector<Path> filesIn(const std::string& folder) {
    std::vector<Path> files;
    std::optional<Path> data = home().data();
    if (!data || !fs::is_directory(*data / "scenes" / folder)) return files;
    for (const auto& entry : fs::recursive_directory_iterator(*data / "scenes" / folder)) {
      std::string extension = entry.path().extension().string();
      if (extension == ".glb" || extension == ".gltf") files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    return files;
  }

  static Json referenceOf(const std::vector<Path>& files) {
    std::vector<std::string> arguments = {"python3", sourceFolder() / "tests/scene/gltf_reference.py",
                                          fmt::format("{}", fmt::join(kShares, ","))};
    arguments.insert(arguments.end(), files.begin(), files.end());
    ProgramEnd end = run({.arguments = arguments});
    EXPECT_TRUE(end.succeeded()) << end.errors;
    return end.succeeded() ? Json::parse(end.output) : Json(std::vector<Json>(files.size()));
  }

  // Nodes that stand where their joints have them (gltf.h), and what hangs on them, are not where the text puts nodes.
  static std::vector<bool> placed(const Scene& scene, const Json& file) {
    std::vector<bool> skinned;
    for (const Json& node : file["nodes"]) skinned.push_back(node.contains("skin"));
    for (int node : hierarchyOrder(scene)) {
      int parent = scene.nodes[size_t(node)].parent;
      if (parent >= 0 && skinned[size_t(parent)]) skinned[size_t(node)] = true;
    }
    return skinned;
  }

  // Largest difference of any component of any matrix, relative to the largest of the matrix's own.
  static double worstOf(const Scene& scene, const std::string& clip, const Json& expected,
                        const std::vector<bool>& left_out) {
    Poser poser(scene, -1, clip);
    double worst = 0;
    for (const Json& pose : expected) {
      std::vector<dmat4> worlds = poser.nodesAt(pose["t"], pose["t"]);
      for (size_t node = 0; node < left_out.size(); ++node) {
        double largest = 1, difference = 0;
        for (int k = 0; k < 16; ++k) {
          double value = pose["worlds"][node][size_t(k)];
          largest = std::max(largest, std::abs(value));
          difference = std::max(difference, std::abs(worlds[node][k / 4][k % 4] - value));
        }
        if (!left_out[node]) worst = std::max(worst, difference / largest);
      }
    }
    return worst;
  }

  // How many clips there were.
  static size_t compare(const Path& file, const Json& expected) {
    SCOPED_TRACE(file.string());
    Scene scene = loadGltf(file);
    std::string text = readText(file);
    bool binary = text.starts_with("glTF");
    uint32_t size = 0;
    if (binary) std::memcpy(&size, &text[12], 4);
    Json json = Json::parse(binary ? text.substr(20, size) : text);
    EXPECT_EQ(expected.size(), scene.animations.size());
    for (size_t i = 0; i < scene.animations.size() && i < expected.size(); ++i)
      // Rotations of splines are of length 1 but for the rounding of a few dozen operations on doubles.
      EXPECT_LE(worstOf(scene, scene.animations[i].name, expected[i], placed(scene, json)), 1e-12)
          << scene.animations[i].name;
    return expected.size();
  }

  static void compareAll(const std::string& folder, size_t least_files, size_t least_clips) {
    std::vector<Path> files = filesIn(folder);
    if (files.empty()) GTEST_SKIP() << "no shared scenes (set STROBE_DATA)";
    if (run({.arguments = {"sh", "-c", "command -v python3"}}).code() != 0) GTEST_SKIP() << "no python3";
    Json expected = referenceOf(files);
    size_t clips = 0;
    for (size_t i = 0; i < files.size(); ++i) clips += compare(files[i], expected[i]);
    EXPECT_GE(files.size(), least_files);
    EXPECT_GE(clips, least_clips);
  }
};

TEST_F(Poses, OfTheAssetGeneratorAreThoseOfTheText) { compareAll("gltf_asset_generator", 30, 19); }

TEST_F(Poses, OfTheSamplesAreThoseOfTheText) { compareAll("khronos_samples", 9, 16); }

// Within a frame a stepped channel stays as it is at the capture, wherever its keys lie.
TEST_F(Poses, StepsStandStillWithinAFrame) {
  int steps = 0;
  for (const Path& file : filesIn("khronos_samples")) {
    Scene scene = loadGltf(file);
    for (const Animation& clip : scene.animations) {
      bool stepped = std::all_of(clip.tracks.begin(), clip.tracks.end(),
                                 [](const Track& track) { return track.interpolation == Track::Interpolation::Step; });
      if (!stepped || clip.tracks.empty()) continue;
      Poser poser(scene, -1, clip.name);
      for (double key : clip.tracks[0].times) {
        ++steps;
        EXPECT_EQ(poser.nodesAt(key - 0.02, key), poser.nodesAt(key + 0.02, key)) << clip.name << " at " << key;
      }
    }
  }
  if (steps == 0) GTEST_SKIP() << "no shared scenes (set STROBE_DATA)";
  EXPECT_GE(steps, 9);
}

}  // namespace
}  // namespace strobe::scene
