// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <sstream>

#include "scene/gltf_parts.h"

namespace strobe::scene {

namespace {

// Formats of an attribute. Component types by letters: "f" floats, "b" bytes, "B" unsigned bytes, "s" and "S" shorts,
// "I" unsigned integers; "n" after a letter: normalized.
struct AttributeKind {
  std::vector<std::string> types;
  std::string components;
  std::string quantised = "";  // added by KHR_mesh_quantization
};

const std::map<std::string, AttributeKind> kAttributeFormats = {
    {"POSITION", {{"VEC3"}, " f ", " b bn B Bn s sn S Sn "}},
    {"NORMAL", {{"VEC3"}, " f ", " bn sn "}},
    {"TANGENT", {{"VEC4"}, " f ", " bn sn "}},
    {"TEXCOORD", {{"VEC2"}, " f Bn Sn ", " b bn B s sn S "}},
    {"COLOR", {{"VEC3", "VEC4"}, " f Bn Sn "}},
    {"JOINTS", {{"VEC4"}, " B S "}},
    {"WEIGHTS", {{"VEC4"}, " f Bn Sn "}}};

const std::map<std::string, AttributeKind> kChangeFormats = {{"POSITION", {{"VEC3"}, " f ", " b bn s sn "}},
                                                             {"NORMAL", {{"VEC3"}, " f ", " bn sn "}},
                                                             {"TANGENT", {{"VEC3"}, " f ", " bn sn "}},
                                                             {"TEXCOORD", {{"VEC2"}, " f bn Bn sn Sn ", " b B s S "}},
                                                             {"COLOR", {{"VEC3", "VEC4"}, " f bn Bn sn Sn "}}};

const AttributeKind kIndexFormat = {{"SCALAR"}, " B S I "};
const AttributeKind kTimeFormat = {{"SCALAR"}, " f "};
const std::map<std::string, AttributeKind> kKeyFormats = {{"translation", {{"VEC3"}, " f "}},
                                                          {"rotation", {{"VEC4"}, " f bn Bn sn Sn "}},
                                                          {"scale", {{"VEC3"}, " f "}},
                                                          {"weights", {{"SCALAR"}, " f bn Bn sn Sn "}}};

std::string componentsName(const AccessorFormat& format) {
  static const std::map<int, std::string> letters = {{5120, "b"}, {5121, "B"}, {5122, "s"},
                                                     {5123, "S"}, {5125, "I"}, {5126, "f"}};
  return letters.at(format.component_type) + (format.normalized ? "n" : "");
}

std::string wordsOf(const std::string& components) {
  static const std::map<char, std::string> words = {
      {'b', "bytes"},           {'B', "unsigned bytes"},    {'s', "shorts"},
      {'S', "unsigned shorts"}, {'I', "unsigned integers"}, {'f', "floats"}};
  return (components.ends_with('n') ? "normalized " : "") + words.at(components.front());
}

class UseChecker {
 public:
  UseChecker(const GltfFile& file, std::vector<std::string>& warnings) : file_(file), warnings_(warnings) {}

  void check() {
    quantised_ = declares(file_, "KHR_mesh_quantization");
    each("meshes", [&](const Json& json, const std::string& where) { checkMesh(json, where); });
    each("animations", [&](const Json& json, const std::string& where) { checkAnimation(json, where); });
    each("cameras", [&](const Json& json, const std::string& where) {
      if (json.contains("perspective") && json.contains("orthographic"))
        file_.refuse(where, "is both perspective and orthographic");
    });
    each("images", [&](const Json& json, const std::string& where) {
      if (json.contains("uri") == json.contains("bufferView"))
        file_.refuse(where, json.contains("uri") ? "has both uri and bufferView" : "has neither uri nor bufferView");
    });
    checkScenes();
  }

 private:
  void each(const std::string& list, const std::function<void(const Json&, const std::string&)>& check) {
    for (size_t i = 0; i < file_.all(list).size(); ++i) check(file_.all(list)[i], fmt::format("{}[{}]", list, i));
  }

  void requireFormat(int accessor, const AttributeKind& kind, const std::string& name, const std::string& where) {
    const AccessorFormat format = file_.format(accessor);
    const std::string components = " " + componentsName(format) + " ";
    bool known = std::find(kind.types.begin(), kind.types.end(), format.type) != kind.types.end();
    bool quantised = kind.quantised.find(components) != std::string::npos;
    if (known && (kind.components.find(components) != std::string::npos || (quantised && quantised_))) return;
    file_.refuse(
        where, fmt::format("{}: accessors[{}] is {} of {}, not {} of {}{}", name, accessor, format.type,
                           wordsOf(componentsName(format)), fmt::join(kind.types, " or "), wordsOfAll(kind.components),
                           known && quantised ? " (KHR_mesh_quantization would allow it)" : ""));
  }

  static std::string wordsOfAll(const std::string& components) {
    std::vector<std::string> words;
    std::istringstream stream(components);
    for (std::string one; stream >> one;) words.push_back(wordsOf(one));
    return fmt::format("{}", fmt::join(words, ", "));
  }

  // --- meshes -------------------------------------------------------------------------------------------------------

  void checkMesh(const Json& json, const std::string& where) {
    const Json& primitives = json["primitives"];
    for (size_t p = 0; p < primitives.size(); ++p)
      checkPrimitive(primitives[p], fmt::format("{}.primitives[{}]", where, p));
  }

  void checkPrimitive(const Json& json, const std::string& where) {
    const Json& attributes = json["attributes"];
    const int positions = file_.index(
        attributes, attributes.contains("POSITION") ? "POSITION" : attributes.begin().key(), "accessors", where);
    const size_t count = file_.format(positions).count;
    for (const auto& [name, value] : attributes.items()) {
      checkAttribute(attributes, name, count, kAttributeFormats, where);
      requireSets(attributes, name, where);
    }
    checkTangents(attributes, where);
    const Json& targets = file_.list(json, "targets", where);
    for (size_t t = 0; t < targets.size(); ++t) {
      const std::string place = fmt::format("{}.targets[{}]", where, t);
      if (targets[t].empty()) file_.refuse(place, "changes nothing");
      for (const auto& [name, value] : targets[t].items()) {
        checkAttribute(targets[t], name, count, kChangeFormats, place);
        if (!attributes.contains(name))
          file_.refuse(place, fmt::format("changes {}, which is not an attribute of the primitive", name));
      }
    }
    const int indices = file_.index(json, "indices", "accessors", where);
    if (indices >= 0) requireFormat(indices, kIndexFormat, "indices", where);
    checkVariants(json, where);
    checkTextures(json, where);
  }

  // Throws unless each variant exists and chooses one material.
  void checkVariants(const Json& json, const std::string& where) {
    const size_t count = file_.list(file_.extension(file_.json(), "KHR_materials_variants"), "variants", where).size();
    std::set<size_t> chosen;
    for (const Json& mapping : file_.list(file_.extension(json, "KHR_materials_variants"), "mappings", where))
      for (const Json& value : mapping["variants"]) {
        const size_t variant = file_.size({{"variant", value}}, "variant", std::nullopt, where);
        if (variant >= count)
          file_.refuse(where, fmt::format("'variant' is {}, but the file has {} variants", variant, count));
        if (!chosen.insert(variant).second)
          file_.refuse(where, fmt::format("chooses two materials for variant {}", variant));
      }
  }

  void checkAttribute(const Json& attributes, const std::string& name, size_t count,
                      const std::map<std::string, AttributeKind>& kinds, const std::string& where) {
    const int accessor = file_.index(attributes, name, "accessors", where);
    const AccessorFormat format = file_.format(accessor);
    if (format.count != count)
      file_.refuse(where, fmt::format("{} has {} elements, not {}", name, format.count, count));
    if (name.starts_with('_')) {
      if (format.component_type == 5125)
        file_.refuse(where, name + " has components of type unsigned integer, which is not allowed");
      return;
    }
    auto kind = kinds.find(semanticOf(name));
    if (kind == kinds.end()) file_.refuse(where, fmt::format("attribute '{}' is unknown", name));
    requireFormat(accessor, kind->second, name, where);
  }

  // Throws unless the sets of an attribute are numbered from 0, with equal numbers of joints and weights.
  void requireSets(const Json& attributes, const std::string& name, const std::string& where) {
    const std::string semantic = semanticOf(name);
    if (name.starts_with('_') || semantic == name) return;
    const int set = std::stoi(name.substr(semantic.size() + 1));
    std::vector<std::string> needed;
    if (set > 0) needed.push_back(fmt::format("{}_{}", semantic, set - 1));
    if (semantic == "JOINTS") needed.push_back(fmt::format("WEIGHTS_{}", set));
    if (semantic == "WEIGHTS") needed.push_back(fmt::format("JOINTS_{}", set));
    for (const std::string& other : needed)
      if (!attributes.contains(other)) file_.refuse(where, other + " is missing");
  }

  void checkTangents(const Json& attributes, const std::string& where) {
    const int index = file_.index(attributes, "TANGENT", "accessors", where);
    if (index < 0) return;
    const Values values = file_.accessor(index, where, {"VEC4"});
    for (size_t i = 0; i < values.count; ++i)
      if (std::abs(values.at(i, 3)) != 1)
        file_.refuse(where, fmt::format("TANGENT {} has a w of {}, not 1 or -1", i, values.at(i, 3)));
  }

  // Name of an attribute without its set: "TEXCOORD" for "TEXCOORD_0". A name without a set is unchanged. Empty for an
  // invalid form.
  static std::string semanticOf(const std::string& name) {
    auto is_single = [](const std::string& one) { return one == "POSITION" || one == "NORMAL" || one == "TANGENT"; };
    if (is_single(name)) return name;
    const size_t end = name.find('_');
    if (end == std::string::npos || is_single(name.substr(0, end))) return "";
    const std::string number = name.substr(end + 1);
    const bool digits = !number.empty() && number.size() < 4 && std::all_of(number.begin(), number.end(), ::isdigit);
    return digits && (number == "0" || number.front() != '0') ? name.substr(0, end) : "";
  }

  void checkTextures(const Json& primitive, const std::string& where) {
    const int index = file_.index(primitive, "material", "materials", where);
    if (index < 0) return;
    const Json& material = file_.all("materials")[size_t(index)];
    const Json& pbr = file_.object(material, "pbrMetallicRoughness", where);
    for (const auto& [owner, key] : {std::pair(&pbr, "baseColorTexture"), std::pair(&pbr, "metallicRoughnessTexture"),
                                     std::pair(&material, "normalTexture"), std::pair(&material, "emissiveTexture")}) {
      if (!owner->contains(key)) continue;
      const Json& use = (*owner)[key];
      size_t set = file_.size(use, "texCoord", 0, where);
      set = file_.size(file_.extension(use, "KHR_texture_transform"), "texCoord", set, where);
      if (primitive["attributes"].contains(fmt::format("TEXCOORD_{}", set))) continue;
      warnings_.push_back(fmt::format(
          "{}: {} of materials[{}] reads TEXCOORD_{}, which is missing; 0, 0 is used instead", where, key, index, set));
    }
  }

  // --- the rest -----------------------------------------------------------------------------------------------------

  void checkAnimation(const Json& json, const std::string& where) {
    const Json& channels = json["channels"];
    const Json& samplers = json["samplers"];
    for (size_t s = 0; s < samplers.size(); ++s) {
      const std::string place = fmt::format("{}.samplers[{}]", where, s);
      const int input = file_.index(samplers[s], "input", "accessors", place);
      requireFormat(input, kTimeFormat, "input", place);
      const size_t least = file_.text(samplers[s], "interpolation", place) == "CUBICSPLINE" ? 2 : 1;
      if (file_.format(input).count < least)
        file_.refuse(place, fmt::format("CUBICSPLINE needs at least {} keys, not 1", least));
      const double first = file_.accessor(input, place, {"SCALAR"}).at(0, 0);
      if (first < 0) file_.refuse(place, fmt::format("its first key is at {} s, below 0", first));
    }
    for (size_t k = 0; k < channels.size(); ++k) {
      const std::string place = fmt::format("{}.channels[{}]", where, k);
      const size_t sampler = file_.size(channels[k], "sampler", std::nullopt, place);
      if (sampler >= samplers.size())
        file_.refuse(place,
                     fmt::format("'sampler' is {}, but the animation has {} samplers", sampler, samplers.size()));
      const Json& target = channels[k]["target"];
      const std::string path = file_.text(target, "path", place);
      if (path != "pointer" && !file_.extension(target, "KHR_animation_pointer").empty())
        file_.refuse(place, fmt::format("has a pointer, but its path is '{}'", path));
      auto kind = kKeyFormats.find(path);
      if (kind == kKeyFormats.end()) continue;
      requireFormat(file_.index(samplers[sampler], "output", "accessors", place), kind->second, kind->first, place);
    }
  }

  void checkScenes() {
    std::set<int> children;
    each("nodes", [&](const Json& json, const std::string& where) {
      for (int child : file_.indexList(json, "children", "nodes", where)) children.insert(child);
    });
    each("scenes", [&](const Json& json, const std::string& where) {
      std::set<int> roots;
      for (int node : file_.indexList(json, "nodes", "nodes", where)) {
        if (!roots.insert(node).second) file_.refuse(where, fmt::format("lists node {} twice", node));
        if (children.count(node)) file_.refuse(where, fmt::format("its node {} is a child of another node", node));
      }
    });
  }

  const GltfFile& file_;
  std::vector<std::string>& warnings_;
  bool quantised_ = false;
};

}  // namespace

void requireUses(const GltfFile& file, std::vector<std::string>& warnings) { UseChecker(file, warnings).check(); }

}  // namespace strobe::scene
