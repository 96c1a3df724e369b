// SPDX-License-Identifier: MIT
// Sample files compared with an independent implementation of glTF's text (gltf_reference.py): every node, and every
// vertex with a skin or morph targets, at rest and in every clip from start to end.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "base/process.h"
#include "common/home.h"
#include "common/source.h"
#include "scene/bend.h"
#include "scene/gltf.h"
#include "scene/motion.h"

namespace strobe::scene {
namespace gltf_poses_test {

namespace fs = std::filesystem;

// Shares of a clip: start, end, and times mostly between keys.
const std::vector<double> kShares = {0, 0.0625, 0.125, 0.25, 0.3, 0.4375, 0.5, 0.6, 0.75, 0.875, 0.95, 1};

class Poses : public ::testing::Test {
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

  // Largest difference of a matrix component, relative to the largest component of the matrix.
  static double worstOfNodes(const Poser& poser, const Json& poses) {
    double worst = 0;
    for (const Json& pose : poses) {
      std::vector<dmat4> worlds = poser.nodesAt(pose["t"], pose["t"]);
      EXPECT_EQ(worlds.size(), pose["worlds"].size());
      for (size_t node = 0; node < worlds.size(); ++node) {
        double largest = 1, difference = 0;
        for (int k = 0; k < 16; ++k) {
          double value = pose["worlds"][node][size_t(k)];
          largest = std::max(largest, std::abs(value));
          difference = std::max(difference, std::abs(worlds[node][k / 4][k % 4] - value));
        }
        worst = std::max(worst, difference / largest);
      }
    }
    return worst;
  }

  // Corners of an instance's triangles, by geometry; world space.
  static std::vector<std::vector<dvec3>> cornersOf(const Scene& scene, const Instance& instance, size_t index,
                                                   const Pose& pose) {
    std::vector<BentVertex> bent;
    if (bends(scene, instance)) bent = bentVertices(scene, instance, pose.bends[index]);
    std::vector<std::vector<dvec3>> corners;
    size_t first = 0;
    for (const Geometry& geometry : scene.meshes[size_t(instance.mesh)].geometries) {
      corners.emplace_back();
      for (uint32_t i : geometry.indices) {
        dvec3 position = bent.empty() ? dvec3(geometry.vertices[i].position) : bent[first + i].position;
        corners.back().push_back(dvec3(pose.world_from_instance[index] * dvec4(position, 1)));
      }
      first += geometry.vertices.size();
    }
    return corners;
  }

  struct Worst {
    double difference = 0;  // relative to the largest coordinate of the primitive
    size_t corners = 0;
  };

  static void addBent(const Scene& scene, const Pose& pose, const Json& bent, Worst& worst) {
    const std::vector<Instance> instances = instancesOf(scene);
    std::map<int, size_t> met;  // primitives compared so far, by node
    for (const Json& part : bent) {
      const int node = part["node"];
      const size_t primitive = met[node]++;
      for (size_t i = 0; i < instances.size(); ++i) {
        if (instances[i].node != node) continue;
        const auto corners = cornersOf(scene, instances[i], i, pose);
        ASSERT_LT(primitive, corners.size());
        ASSERT_EQ(part["corners"].size(), 3 * corners[primitive].size());
        double largest = 0, difference = 0;
        for (size_t k = 0; k < part["corners"].size(); ++k) {
          const double value = part["corners"][k];
          largest = std::max(largest, std::abs(value));
          difference = std::max(difference, std::abs(corners[primitive][k / 3][int(k % 3)] - value));
        }
        worst.difference = std::max(worst.difference, difference / largest);
        worst.corners += corners[primitive].size();
      }
    }
  }

  static void comparePoses(const Scene& scene, const std::string& clip, const Json& poses, Worst& worst) {
    Poser poser(scene, -1, clip);
    // Rotations of splines have length 1, up to rounding in a few dozen double operations.
    EXPECT_LE(worstOfNodes(poser, poses), 1e-12) << clip;
    for (const Json& pose : poses) addBent(scene, poser.at(pose["t"]), pose["bent"], worst);
  }

  // Compares a file; returns its number of clips.
  static size_t compare(const Path& file, const Json& expected, Worst& worst) {
    SCOPED_TRACE(file.string());
    Scene scene = loadGltf(file);
    EXPECT_EQ(expected["clips"].size(), scene.animations.size());
    Worst own;
    comparePoses(scene, "none", expected["rest"], own);
    for (size_t i = 0; i < scene.animations.size() && i < expected["clips"].size(); ++i)
      comparePoses(scene, scene.animations[i].name, expected["clips"][i], own);
    // A vertex is stored in single precision, relative to the centre of its mesh.
    EXPECT_LE(own.difference, 2e-7);
    worst.difference = std::max(worst.difference, own.difference), worst.corners += own.corners;
    return expected["clips"].size();
  }

  static void compareAll(const std::string& folder, size_t least_files, size_t least_clips, size_t least_corners) {
    std::vector<Path> files = filesIn(folder);
    if (files.empty()) GTEST_SKIP() << "no shared scenes (set STROBE_DATA)";
    if (run({.arguments = {"sh", "-c", "command -v python3"}}).code() != 0) GTEST_SKIP() << "no python3";
    Json expected = referenceOf(files);
    size_t clips = 0;
    Worst worst;
    for (size_t i = 0; i < files.size(); ++i) clips += compare(files[i], expected[i], worst);
    EXPECT_GE(files.size(), least_files);
    EXPECT_GE(clips, least_clips);
    EXPECT_GE(worst.corners, least_corners);
    RecordProperty("bent", fmt::format("{:.1e} of {} corners", worst.difference, worst.corners));
  }
};

TEST_F(Poses, OfTheAssetGeneratorMatchTheText) { compareAll("gltf_asset_generator", 30, 19, 500); }

TEST_F(Poses, OfTheSamplesMatchTheText) { compareAll("khronos_samples", 9, 16, 100000); }

// Within a frame a stepped channel keeps its value at the raster time, for any keys.
TEST_F(Poses, StepsAreStaticWithinAFrame) {
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

}  // namespace gltf_poses_test
}  // namespace strobe::scene
