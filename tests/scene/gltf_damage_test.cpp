// SPDX-License-Identifier: MIT
// Random damage to a glTF file, compared with the validator.
#include <cstdlib>

#include "scene/gltf_validator.h"

namespace strobe::scene {
namespace gltf_damage_test {

namespace fs = std::filesystem;

// The file with all features, plus extensions, sparse accessors and more kinds of textures.
Json damageable() {
  Asset asset = everything();
  const int sparse_indices = asset.add<uint16_t>({1}, "SCALAR", 1, 5123);
  const int sparse_values = asset.add<float>({2, 0, 0}, "VEC3", 3, 5126);
  Json& json = asset.json;
  json["accessors"][0]["sparse"] = {
      {"count", 1},
      {"indices", {{"bufferView", json["accessors"][sparse_indices]["bufferView"]}, {"componentType", 5123}}},
      {"values", {{"bufferView", json["accessors"][sparse_values]["bufferView"]}}}};
  for (Json& accessor : json["accessors"]) accessor.erase("normalized");
  json["materials"].push_back(
      Json::parse(R"({"name":"glow","emissiveFactor":[1,0.5,0],"normalTexture":{"index":0,"scale":2},
      "occlusionTexture":{"index":0,"strength":0.5},"emissiveTexture":{"index":0},
      "extensions":{"KHR_materials_emissive_strength":{"emissiveStrength":3}}})"));
  json["materials"].push_back(Json::parse(R"({"extensions":{"KHR_materials_unlit":{}}})"));
  asset.primitive()["extensions"]["KHR_materials_variants"]["mappings"] =
      Json::parse(R"([{"material":1,"variants":[0]},{"material":2,"variants":[1]}])");
  json["extensions"]["KHR_materials_variants"]["variants"] = Json::parse(R"([{"name":"a"},{"name":"b"}])");
  for (const char* name : {"KHR_materials_emissive_strength", "KHR_materials_unlit", "KHR_materials_variants"})
    json["extensionsUsed"].push_back(name);
  json["scenes"].push_back({{"name", "other"}, {"nodes", {2}}});
  return asset.whole();
}

// Pointers to all values in a file except the bytes of its buffers.
void listPointers(const Json& json, const std::string& at, std::vector<std::string>& pointers) {
  if (!at.empty() && !at.ends_with("/uri")) pointers.push_back(at);
  if (json.is_object())
    for (const auto& [name, value] : json.items()) listPointers(value, at + "/" + name, pointers);
  for (size_t i = 0; json.is_array() && i < json.size(); ++i)
    listPointers(json[i], fmt::format("{}/{}", at, i), pointers);
}

class Damager {
 public:
  explicit Damager(uint32_t seed) : state_(seed * 2654435761u + 1) {}

  // Changes, removes, swaps or duplicates a value; returns a description.
  std::string damage(Json& json) {
    std::vector<std::string> pointers;
    listPointers(json, "", pointers);
    const std::string at = pointers[random() % pointers.size()], other = pointers[random() % pointers.size()];
    const Json::json_pointer pointer(at), second(other);
    Json& holder = json.at(pointer.parent_pointer());
    Json& value = json.at(pointer);
    const uint32_t kind = random() % 8;
    if (kind == 0) {
      if (holder.is_array()) holder.erase(holder.begin() + std::stol(pointer.back()));
      else holder.erase(pointer.back());
      return at + " removed";
    }
    if (kind == 1 && value.is_array() && !value.empty()) {
      value.push_back(Json(value[random() % value.size()]));
      return at + " with a doubled element";
    }
    if (kind == 2 && !at.starts_with(other + "/") && !other.starts_with(at + "/")) {
      std::swap(value, json.at(second));
      return at + " and " + other + " swapped";
    }
    value = changed(value);
    return at + " = " + value.dump().substr(0, 60);
  }

 private:
  uint32_t random() { return state_ = state_ * 1664525u + 1013904223u, state_ >> 8; }

  Json changed(const Json& value) {
    const std::vector<Json> others = {
        -1, 0, 1, 2, 3, 0.5, 1e9, 4294967296.0, "x", "", true, Json::array(), Json::object()};
    if (value.is_number() && random() % 2 == 0) return value.get<double>() + (random() % 2 == 0 ? 1 : -1);
    if (value.is_number_integer() && random() % 3 == 0) return 5120 + random() % 7;
    return others[random() % others.size()];
  }

  uint32_t state_;
};

// STROBE_DAMAGED_FILES is the number of files.
TEST(GltfValidator, AgreesOnDamagedFiles) {
  if (!hasValidator()) GTEST_SKIP() << "no node, or no gltf-validator in STROBE_NODE_MODULES";
  const char* asked = std::getenv("STROBE_DAMAGED_FILES");
  const int count = asked ? std::atoi(asked) : 100;
  const testing::TemporaryFolder folder;
  const Json whole = damageable();
  std::vector<Path> files = {folder / "whole.gltf"};
  std::vector<std::string> what = {"whole"};
  writeQuickly(files[0], whole.dump());
  for (int seed = 0; seed < count; ++seed) {
    Json json = whole;
    Damager damager{uint32_t(seed)};
    what.push_back(fmt::format("seed {}: {}", seed, damager.damage(json)));
    if (seed % 3 == 2) what.back() += "; " + damager.damage(json);
    files.push_back(folder / fmt::format("{:05}.gltf", seed));
    writeQuickly(files.back(), json.dump());
  }
  const Tally tally = expectAgreement(files, [&](size_t i) { return what[i]; });
  EXPECT_EQ(refusalOf(files[0]), "");
  fmt::print("{} files refused, {} load without errors, {} with listed ones\n", tally.refused, tally.loaded,
             tally.listed);
  EXPECT_GE(tally.refused, size_t(count) / 3);
  EXPECT_GE(tally.loaded, size_t(count) / 20);
}

}  // namespace gltf_damage_test
}  // namespace strobe::scene
