// SPDX-License-Identifier: MIT
#include "scene/gltf_validator.h"

namespace strobe::scene {

// A second mesh at node 4: a triangle with two joints and a morph target; nodes 5 and 6 are the joints.
static void addBending(Asset& asset, int times) {
  Json& json = asset.json;
  int joints = asset.add<uint8_t>({0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0}, "VEC4", 4, 5121);
  int weights = asset.add<float>({1, 0, 0, 0, 1, 0, 0, 0, 0.5f, 0.5f, 0, 0}, "VEC4", 4, 5126);
  int binds =
      asset.add<float>({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1},
                       "MAT4", 16, 5126);
  int change = asset.add<float>({0, 0, 0, 0, 1, 0, 0, 0, 0}, "VEC3", 3, 5126);
  int keys = asset.add<float>({0, 1}, "SCALAR", 1, 5126);
  json["accessors"][change]["min"] = {0, 0, 0};
  json["accessors"][change]["max"] = {0, 1, 0};
  json["meshes"].push_back(
      {{"primitives", Json::array({{{"attributes", {{"POSITION", 0}, {"JOINTS_0", joints}, {"WEIGHTS_0", weights}}},
                                    {"targets", Json::array({{{"POSITION", change}}})}}})},
       {"weights", {0.5}}});
  json["skins"] = Json::array({{{"joints", {5, 6}}, {"inverseBindMatrices", binds}, {"skeleton", 5}}});
  json["nodes"].push_back({{"mesh", 1}, {"skin", 0}, {"weights", {0.25}}});
  json["nodes"].push_back({{"children", {6}}});
  json["nodes"].push_back({{"translation", {0, 1, 0}}});
  for (int node : {4, 5}) json["scenes"][0]["nodes"].push_back(node);
  Json& clip = json["animations"][0];
  clip["samplers"].push_back({{"input", times}, {"output", keys}});
  clip["channels"].push_back({{"sampler", 2}, {"target", {{"node", 4}, {"path", "weights"}}}});
}

Asset everything() {
  Asset asset = triangle();
  int uvs = asset.add<float>({0, 0, 1, 0, 0, 1}, "VEC2", 2, 5126);
  int normals = asset.add<float>({0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3", 3, 5126);
  int indices = asset.add<uint16_t>({0, 1, 2}, "SCALAR", 1, 5123);
  int times = asset.add<float>({0, 1}, "SCALAR", 1, 5126);
  int moves = asset.add<float>({0, 0, 0, 1, 0, 0}, "VEC3", 3, 5126);
  int turns = asset.add<float>({0, 0, 0, 1, 0, 0, 1, 0}, "VEC4", 4, 5126);
  Json& json = asset.json;
  json["accessors"][0]["min"] = {0, 0, 0};
  json["accessors"][0]["max"] = {2, 2, 0};
  json["accessors"][times]["min"] = {0};
  json["accessors"][times]["max"] = {1};
  asset.primitive()["attributes"]["TEXCOORD_0"] = uvs;
  asset.primitive()["attributes"]["NORMAL"] = normals;
  asset.primitive()["indices"] = indices;
  asset.primitive()["material"] = 0;
  json["materials"] = Json::parse(R"([{"alphaMode":"MASK","alphaCutoff":0.5,"doubleSided":true,
      "emissiveFactor":[0,0,0],"pbrMetallicRoughness":{"baseColorFactor":[1,1,1,1],"metallicFactor":0,
      "roughnessFactor":1,"baseColorTexture":{"index":0,"texCoord":0,
      "extensions":{"KHR_texture_transform":{"offset":[0,0],"rotation":0,"scale":[1,1]}}}}}])");
  json["images"] = Json::array({{{"uri",
                                  "data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mP8/"
                                  "5+hHgAHggJ/PchI7wAAAABJRU5Erk"
                                  "Jggg=="}}});
  json["samplers"] = Json::parse(R"([{"magFilter":9728,"minFilter":9984,"wrapS":33071,"wrapT":33648}])");
  json["textures"] = Json::parse(R"([{"source":0,"sampler":0}])");
  json["cameras"] = Json::parse(R"([{"type":"perspective","perspective":{"yfov":1,"znear":0.1,"aspectRatio":2}},
      {"type":"orthographic","orthographic":{"xmag":1,"ymag":1,"znear":0.1,"zfar":9}}])");
  json["nodes"] = Json::parse(R"([{"mesh":0,"children":[1],"translation":[0,0,0]},{"camera":0,"rotation":[0,0,0,1]},
      {"camera":1},{"extensions":{"KHR_lights_punctual":{"light":0}}}])");
  json["scenes"][0]["nodes"] = {0, 2, 3};
  json["extensions"]["KHR_lights_punctual"]["lights"] = Json::parse(
      R"([{"type":"spot","intensity":3,"color":[1,1,1],"range":9,"spot":{"innerConeAngle":0.1,"outerConeAngle":0.4}}])");
  json["extensionsUsed"] = {"KHR_lights_punctual", "KHR_texture_transform"};
  json["animations"] = Json::array(
      {{{"samplers", Json::array({{{"input", times}, {"output", moves}}, {{"input", times}, {"output", turns}}})},
        {"channels", Json::array({{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}},
                                  {{"sampler", 1}, {"target", {{"node", 1}, {"path", "rotation"}}}}})}}});
  addBending(asset, times);
  for (size_t i = 0; i < json["accessors"].size(); ++i) json["accessors"][i].erase("normalized");
  return asset;
}

}  // namespace strobe::scene
