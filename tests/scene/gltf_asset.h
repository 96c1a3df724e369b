// SPDX-License-Identifier: MIT
// Small glTF assets written by tests; each accessor extends their single buffer.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <vector>

#include "common/temporary_folder.h"
#include "scene/gltf.h"

namespace strobe::scene {

// Writes without the flush to disk that output files get: tests write thousands of files.
inline void writeQuickly(const Path& file, std::string_view bytes) {
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary).write(bytes.data(), std::streamsize(bytes.size()));
}

class Gltf : public ::testing::Test {
 protected:
  Scene load(const Json& json, const GltfOptions& options = {}) {
    writeQuickly(folder_ / "a.gltf", json.dump());
    return loadGltf(folder_ / "a.gltf", options);
  }
  std::string failure(const Json& json, const GltfOptions& options = {}) {
    try {
      load(json, options);
    } catch (const Error& error) {
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
      return error.what();
    }
    return "";
  }

  const testing::TemporaryFolder temporary_;
  const Path folder_ = temporary_.path();
};

inline std::string base64(const std::vector<uint8_t>& bytes) {
  const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (size_t i = 0; i < bytes.size(); i += 3) {
    uint32_t bits =
        bytes[i] << 16 | (i + 1 < bytes.size() ? bytes[i + 1] << 8 : 0) | (i + 2 < bytes.size() ? bytes[i + 2] : 0);
    for (int k = 3; k >= 0; --k) text += digits[bits >> (6 * k) & 63];
  }
  size_t padding = (3 - bytes.size() % 3) % 3;
  return text.replace(text.size() - padding, padding, padding, '=');
}

// Adds the names of all extensions in `json` to `names`.
inline void listExtensions(const Json& json, std::set<std::string>& names) {
  for (const auto& [key, value] : json.items()) {
    if (key == "extensions" && value.is_object())
      for (const auto& [name, extension] : value.items()) names.insert(name);
    if (value.is_structured()) listExtensions(value, names);
  }
}

// Declares the extensions that objects of the file use.
inline void declareExtensions(Json& json) {
  std::set<std::string> names;
  listExtensions(json, names);
  for (const char* key : {"extensionsUsed", "extensionsRequired"})
    for (const Json& name : json.value(key, Json::array())) names.erase(name.get<std::string>());
  for (const std::string& name : names) json["extensionsUsed"].push_back(name);
}

// An asset whose single buffer grows with each accessor. `whole` declares the used extensions.
struct Asset {
  Json json = Json::parse(R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
    "meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"accessors":[],"bufferViews":[],"buffers":[]})");
  std::vector<uint8_t> bytes;

  template <class T>
  int add(const std::vector<T>& values, const char* type, int components, int component_type, bool normalized = false) {
    int view = int(json["bufferViews"].size());
    json["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", bytes.size()}, {"byteLength", values.size() * sizeof(T)}});
    json["accessors"].push_back({{"bufferView", view},
                                 {"componentType", component_type},
                                 {"count", values.size() / components},
                                 {"type", type},
                                 {"normalized", normalized}});
    const uint8_t* data = reinterpret_cast<const uint8_t*>(values.data());
    bytes.insert(bytes.end(), data, data + values.size() * sizeof(T));
    while (bytes.size() % 4) bytes.push_back(0);
    return int(json["accessors"].size()) - 1;
  }
  Json whole() {
    Json result = json;
    declareExtensions(result);
    result["buffers"] =
        Json::array({{{"byteLength", bytes.size()}, {"uri", "data:application/octet-stream;base64," + base64(bytes)}}});
    return result;
  }
  Json& primitive() { return json["meshes"][0]["primitives"][0]; }
};

inline Asset triangle() {
  Asset asset;
  asset.add<float>({0, 0, 0, 2, 0, 0, 0, 2, 0}, "VEC3", 3, 5126);
  return asset;
}

}  // namespace strobe::scene
