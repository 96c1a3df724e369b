// SPDX-License-Identifier: MIT
// Frames of normal maps against the formulas of glTF 2.0: a square that faces the camera, under one light from +X, with
// a map that leans to its x. The vertices' tangents define the frame; without tangents, the texture coordinates of the
// lookup define it.
#include <fmt/format.h>

#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/constants.hpp>

#include "common/temporary_folder.h"
#include "oracle/render.h"
#include "scene/gltf_asset.h"

namespace strobe::oracle {
namespace render_tangents_test {

using glm::dvec3;

constexpr int kSize = 9;

// One texel, 218 128 218, as PNG: (0.71, 0.004, 0.71).
const char* const kLeaning =
    "data:image/"
    "png;base64,iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAIAAACQd1PeAAAADElEQVR42mO41XALAARsAjUuHifuAAAAAElFTkSuQmCC";

class RenderTangents : public RenderTest {
 protected:
  static Path file() { return testing::processFolder() / "a.gltf"; }

  static std::vector<float> four(const std::vector<float>& one) {
    std::vector<float> all;
    for (int i = 0; i < 4; ++i) all.insert(all.end(), one.begin(), one.end());
    return all;
  }

  // The square. All four vertices have `tangent`; if it is empty, the file has no tangents.
  static scene::Asset square(const std::vector<float>& tangent) {
    scene::Asset asset;
    asset.add<float>({-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0}, "VEC3", 3, 5126);
    asset.add<float>(four({0, 0, 1}), "VEC3", 3, 5126);
    asset.add<float>({0, 1, 1, 1, 1, 0, 0, 0}, "VEC2", 2, 5126);
    asset.add<uint16_t>({0, 1, 2, 0, 2, 3}, "SCALAR", 1, 5123);
    Json& json = asset.json;
    json["meshes"] = Json::parse(
        R"([{"primitives":[{"attributes":{"POSITION":0,"NORMAL":1,"TEXCOORD_0":2},"indices":3,"material":0}]}])");
    if (!tangent.empty()) asset.primitive()["attributes"]["TANGENT"] = asset.add(four(tangent), "VEC4", 4, 5126);
    json["images"] = Json::array({{{"uri", kLeaning}}});
    json["textures"] = Json::parse(R"([{"source":0}])");
    json["materials"] = Json::parse(R"([{"doubleSided":true,"normalTexture":{"index":0},
        "pbrMetallicRoughness":{"metallicFactor":0,"roughnessFactor":0.9}}])");
    json["nodes"] = Json::parse(R"([{"mesh":0},{"camera":0,"translation":[0,0,4]},
        {"rotation":[0,0.5,0,0.8660254037844386],"extensions":{"KHR_lights_punctual":{"light":0}}}])");
    json["scenes"][0]["nodes"] = {0, 1, 2};
    json["cameras"] = Json::parse(R"([{"type":"perspective","perspective":{"yfov":0.4,"znear":0.1}}])");
    json["extensions"]["KHR_lights_punctual"]["lights"] = Json::parse(R"([{"type":"directional","intensity":3}])");
    json["extensionsUsed"] = {"KHR_lights_punctual", "KHR_texture_transform"};
    return asset;
  }

  static lab::Shot shot(scene::Asset asset) {
    scene::writeQuickly(file(), asset.whole().dump());
    lab::Shot result;
    result.scene = file();
    result.width = result.height = kSize;
    return with(result, "none");
  }

  // The middle pixel, which shows the point that faces the camera, by rasterisation and by rays.
  static double middleOf(const scene::Asset& asset) {
    const lab::Shot one = shot(asset);
    const double raster = colorOf(render(one)).at(kSize / 2, kSize / 2, 0);
    const double rays = colorOf(render(with(one, "ground_truth", {"samples=2"}))).at(kSize / 2, kSize / 2, 0);
    EXPECT_NEAR(raster, rays, 1e-5);
    return raster;
  }

  // glTF 2.0, appendix B, for white with roughness 0.9 under 3 lx from +X, 60 degrees off the view direction.
  static double expected(const dvec3& tangent, double handedness) {
    const dvec3 normal(0, 0, 1), view(0, 0, 1), light(std::sin(glm::radians(60.)), 0, std::cos(glm::radians(60.)));
    const dvec3 map(218 / 127.5 - 1, 128 / 127.5 - 1, 218 / 127.5 - 1);
    const dvec3 n = glm::normalize(map.x * tangent + map.y * handedness * glm::cross(normal, tangent) + map.z * normal);
    const double nl = glm::dot(n, light), nv = glm::dot(n, view), a2 = std::pow(.9, 4);
    if (nl <= 0) return 0;
    const dvec3 h = glm::normalize(view + light);
    const double bell = std::pow(glm::dot(n, h), 2) * (a2 - 1) + 1, d = a2 / (glm::pi<double>() * bell * bell);
    const double g = .5 / (nl * std::sqrt(nv * nv * (1 - a2) + a2) + nv * std::sqrt(nl * nl * (1 - a2) + a2));
    const double f = .04 + .96 * std::pow(1 - glm::dot(view, h), 5);
    return 3 * nl * ((1 - f) / glm::pi<double>() + f * d * g);
  }
};

// 3.7.2.1: x of the map along TANGENT, y along cross(NORMAL, TANGENT) times its w.
TEST_F(RenderTangents, TangentsComeFromTheFile) {
  for (const std::vector<float>& t : {std::vector<float>{1, 0, 0, 1},
                                      {-1, 0, 0, 1},
                                      {0, 1, 0, 1},
                                      {0, 1, 0, -1},
                                      {.6f, .8f, 0, 1},
                                      {.6f, -.8f, 0, -1},
                                      {-.28f, .96f, 0, 1}}) {
    EXPECT_NEAR(middleOf(square(t)), expected({t[0], t[1], t[2]}, t[3]), 3e-4) << t[0] << ' ' << t[1] << ' ' << t[3];
  }
  EXPECT_NEAR(expected({1, 0, 0}, 1), .902, 1e-3);
  EXPECT_NEAR(expected({0, 1, 0}, 1), .33, 1e-2);
}

// Without tangents the texture coordinates define the frame. Here they grow along x and against y: TANGENT 1, 0, 0, 1.
TEST_F(RenderTangents, CoordinatesReplaceMissingTangents) {
  for (const Json& part : {Json::object(), Json({{"scale", {-1, 1, 1}}}), Json({{"rotation", {0, 0, .6, .8}}}),
                           Json({{"rotation", {0, 1, 0, 0}}}), Json({{"scale", {1, 1, 0}}})}) {
    scene::Asset with_tangents = square({1, 0, 0, 1}), without = square({});
    with_tangents.json["nodes"][0].update(part), without.json["nodes"][0].update(part);
    const image::Image a = colorOf(render(shot(with_tangents))), b = colorOf(render(shot(without)));
    EXPECT_LE(oracle::largestDifference(a, b), 1e-5) << part.dump();
  }
}

// Tangents follow the joints of a vertex, here with a quarter turn about z, and morph targets.
TEST_F(RenderTangents, TangentsDeformWithTheMesh) {
  scene::Asset skinned = square({1, 0, 0, 1});
  skinned.primitive()["attributes"]["JOINTS_0"] =
      skinned.add<uint8_t>({0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0}, "VEC4", 4, 5121);
  skinned.primitive()["attributes"]["WEIGHTS_0"] = skinned.add<float>(four({.5f, .5f, 0, 0}), "VEC4", 4, 5126);
  skinned.json["nodes"].push_back({{"children", {4, 5}}, {"rotation", {0, 0, std::sqrt(.5), std::sqrt(.5)}}});
  for (int joint = 0; joint < 2; ++joint) skinned.json["nodes"].push_back(Json::object());
  skinned.json["scenes"][0]["nodes"] = {0, 1, 2, 3};
  skinned.json["skins"] = Json::parse(R"([{"joints":[4,5]}])");
  skinned.json["nodes"][0]["skin"] = 0;
  EXPECT_NEAR(middleOf(skinned), expected({0, 1, 0}, 1), 1e-4);

  for (const auto& [change, tangent] : {std::pair(std::vector<float>{-2, 0, 0}, dvec3(-1, 0, 0)),
                                        std::pair(std::vector<float>{-1, 1, 0}, dvec3(0, 1, 0))}) {
    scene::Asset morphed = square({1, 0, 0, 1});
    morphed.primitive()["targets"] = Json::array({{{"TANGENT", morphed.add(four(change), "VEC3", 3, 5126)}}});
    morphed.json["meshes"][0]["weights"] = {1};
    EXPECT_NEAR(middleOf(morphed), expected(tangent, 1), 1e-4);
  }
}

// The same texels by the same coordinates, from the file or from KHR_texture_transform.
TEST_F(RenderTangents, TangentsFollowTheCoordinatesOfTheLookup) {
  struct Case {
    Json transform;
    double a, b, c, d;  // u' = a u + b v, v' = c u + d v
    dvec3 tangent;
    double handedness;
  };
  const double s = std::sin(1.1), k = std::cos(1.1);
  const std::vector<Case> cases = {
      {{{"rotation", 3.14159265358979}}, -1, 0, 0, -1, {-1, 0, 0}, 1},
      {{{"scale", {-1, 1}}}, -1, 0, 0, 1, {-1, 0, 0}, -1},
      {{{"scale", {1, -1}}}, 1, 0, 0, -1, {1, 0, 0}, -1},
      // u' = cos u + sin v; u grows along x and v against y.
      {{{"rotation", 1.1}, {"offset", {.25, .5}}, {"scale", {2, 2}}}, 2 * k, 2 * s, -2 * s, 2 * k, {k, -s, 0}, 1},
  };
  for (const Case& one : cases) {
    scene::Asset transformed = square({}), written = square({});
    transformed.json["materials"][0]["normalTexture"]["extensions"]["KHR_texture_transform"] = one.transform;
    std::vector<float> uvs;
    for (const auto& [u, v] : {std::pair(0, 1), std::pair(1, 1), std::pair(1, 0), std::pair(0, 0)})
      uvs.insert(uvs.end(), {float(one.a * u + one.b * v), float(one.c * u + one.d * v)});
    written.primitive()["attributes"]["TEXCOORD_0"] = written.add(uvs, "VEC2", 2, 5126);
    EXPECT_NEAR(middleOf(transformed), expected(one.tangent, one.handedness), 1e-4) << one.transform.dump();
    EXPECT_NEAR(middleOf(written), expected(one.tangent, one.handedness), 1e-4) << one.transform.dump();
  }
}

}  // namespace render_tangents_test
}  // namespace strobe::oracle
