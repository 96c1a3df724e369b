// SPDX-License-Identifier: MIT
// Files with non-finite numbers: files that cannot be drawn are refused by name; all others give finite pictures and a
// warning.

#include <cstring>

#include "base/json.h"
#include "common/refusal.h"
#include "common/temporary_folder.h"
#include "oracle/render.h"

namespace strobe::stability {
namespace damage_test {

const float kNan = std::nanf(""), kInf = INFINITY;

std::string base64(const void* data, size_t size) {
  const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const auto* bytes = static_cast<const uint8_t*>(data);
  std::string text;
  for (size_t i = 0; i < size; i += 3) {  // all data here have a multiple of three bytes
    uint32_t bits = uint32_t(bytes[i]) << 16 | uint32_t(bytes[i + 1]) << 8 | bytes[i + 2];
    for (int k = 3; k >= 0; --k) text += digits[bits >> (6 * k) & 63];
  }
  return text;
}

// A file with one lit square, two triangles, in front of a camera; tests damage it.
struct File {
  Json json = {{"asset", {{"version", "2.0"}}}, {"scene", 0}, {"scenes", {{{"nodes", {0, 1}}}}}};
  Json attributes = Json::object();
  std::vector<float> positions = {-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, -1, 0, 1, 1, 0, -1, 1, 0};

  File() {
    json["buffers"] = json["bufferViews"] = json["accessors"] = Json::array();
    json["nodes"] = {{{"name", "square"}, {"mesh", 0}}, {{"camera", 0}, {"translation", {0, 0, 2}}}};
    json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 0.8}, {"znear", 0.1}}}}};
    json["materials"] = {{{"name", "paint"}, {"extensions", {{"KHR_materials_unlit", Json::object()}}}}};
    json["extensionsUsed"] = {"KHR_materials_unlit"};
  }
  // Adds an accessor with these floats; returns its index.
  int add(const std::vector<float>& values, const char* type, int width) {
    std::vector<float> padded = values;
    while (padded.size() % 3) padded.push_back(0);
    std::string uri = "data:application/octet-stream;base64," + base64(padded.data(), padded.size() * 4);
    int index = int(json["accessors"].size());
    json["buffers"].push_back({{"uri", uri}, {"byteLength", padded.size() * 4}});
    json["bufferViews"].push_back({{"buffer", index}, {"byteLength", values.size() * 4}});
    json["accessors"].push_back(
        {{"bufferView", index}, {"componentType", 5126}, {"type", type}, {"count", values.size() / size_t(width)}});
    return index;
  }
  lab::Shot shot(const std::string& pipeline) {
    attributes["POSITION"] = add(positions, "VEC3", 3);
    json["meshes"] = {{{"name", "square"}, {"primitives", {{{"attributes", attributes}, {"material", 0}}}}}};
    static int count = 0;
    Path file = testing::processFolder() / fmt::format("damaged_{}.gltf", count++);
    writeFileAtomically(file, json.dump());
    lab::Shot shot;
    shot.scene = file;
    shot.pipeline = pipeline;
    shot.width = 24;
    shot.height = 16;
    shot.moves = {"square=0.2,0.1,0"};
    return shot;
  }
};

class Damage : public oracle::RenderTest {
 protected:
  // Expects a finite picture and this warning from every pipeline.
  static void expectDrawn(const File& file, const std::string& says) {
    for (const std::string& pipeline : script::pipelineNames(bench().home())) {
      File own = file;
      lab::Shot shot = own.shot(pipeline);
      if (pipeline == "ground_truth") shot.sets.push_back({"samples", "4"});
      lab::Picture picture = render(shot);
      for (const char* output : {"color", "velocity"})
        for (float value : oracle::imageOf(picture, output).values)
          ASSERT_TRUE(std::isfinite(value)) << pipeline << " " << output;
      std::string warnings = fmt::format("{}", fmt::join(picture.warnings, "\n"));
      EXPECT_NE(warnings.find(says), std::string::npos) << pipeline << ": " << warnings;
    }
  }
  static void expectRefused(File file, const std::string& says) {
    lab::Shot shot = file.shot("none");
    const std::string said = testing::refusalOf([&] { render(shot); });
    EXPECT_NE(said.find(says), std::string::npos) << said;
  }
};

TEST_F(Damage, TrianglesWithoutFinitePositionsAreOmitted) {
  for (float bad : {kNan, kInf, -kInf, 1e30f}) {
    File file;
    file.positions[9] = bad;
    expectDrawn(file, "1 triangles have positions that are not finite and are left out");
    if (bad == kInf) break;  // the remaining values give the same warning
  }
}

TEST_F(Damage, NormalsTextureCoordinatesAndColoursAreReplaced) {
  File file;
  std::vector<float> normals(18, 0), uvs(12, 0), colors(18, .5f);
  for (size_t i = 2; i < 18; i += 3) normals[i] = 1;
  normals[4] = kNan;
  uvs[3] = kInf;
  colors[7] = kNan;
  file.attributes["NORMAL"] = file.add(normals, "VEC3", 3);
  file.attributes["TEXCOORD_0"] = file.add(uvs, "VEC2", 2);
  file.attributes["COLOR_0"] = file.add(colors, "VEC3", 3);
  File with_normals = file;
  lab::Shot shot = with_normals.shot("none");
  std::string warnings = fmt::format("{}", fmt::join(render(shot).warnings, "\n"));
  EXPECT_NE(warnings.find("1 vertices have normals that are not finite"), std::string::npos) << warnings;
  EXPECT_NE(warnings.find("1 vertices have colours that are negative or not finite"), std::string::npos) << warnings;
  expectDrawn(file, "1 vertices have texture coordinates that are not finite; 0, 0 is used instead");
}

TEST_F(Damage, NonFiniteRadiancesAreReplaced) {
  File file;
  file.json["materials"][0] = {{"emissiveFactor", {1, 0, 0}},
                               {"doubleSided", true},
                               {"extensions", {{"KHR_materials_emissive_strength", {{"emissiveStrength", 1e300}}}}}};
  file.json["extensionsUsed"] = {"KHR_materials_emissive_strength"};
  expectDrawn(file, "radiances that were not finite numbers; NaN became 0 and infinity 65504");
}

TEST_F(Damage, TransformsThatCannotBeDrawnAreNamed) {
  for (double scale : {1e200, 1e30}) {
    File file;
    file.json["nodes"][0]["scale"] = {scale, 1, 1};
    expectRefused(file, "the transform of node 'square' cannot be drawn; nothing is drawn");
  }
  File vanishing;
  vanishing.json["nodes"][0]["scale"] = {1e-30, 1e-30, 1e-30};
  lab::Shot shot = vanishing.shot("hybrid");
  for (float value : oracle::colorOf(render(shot)).values) ASSERT_TRUE(std::isfinite(value));
}

TEST_F(Damage, NonFiniteKeysAreRefused) {
  File file;
  int times = file.add({0, 1, 2}, "SCALAR", 1), values = file.add({0, 0, 0, 1, kNan, 0, 2, 0, 0}, "VEC3", 3);
  file.json["animations"] = {{{"samplers", {{{"input", times}, {"output", values}}}},
                              {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}}}}};
  expectRefused(file, "its value 1 is not finite");
}

}  // namespace damage_test
}  // namespace strobe::stability
