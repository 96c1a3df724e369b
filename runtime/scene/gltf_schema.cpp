// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <map>

#include "math/constants.h"
#include "scene/gltf_parts.h"

namespace strobe::scene {

namespace {

enum class Form {
  Text,
  Flag,
  Number,   // from `low` to `high`
  Whole,    // from `low` to `high`
  Index,    // index into the list `of`
  Numbers,  // list of `count` numbers from `low` to `high`; any length if `count` is 0
  Texts,
  Indices,    // indices into the list `of`
  Object,     // object of kind `of`
  Objects,    // list of objects
  IndexMap,   // object with indices into the list `of`
  IndexMaps,  // list of index maps
  WholeMap,   // object with whole numbers
  Wholes,     // list of whole numbers
};

constexpr double kAny = HUGE_VAL;
constexpr double kPositive = 1e-300;  // least number that counts as positive

struct Member {
  const char* name;
  Form form = Form::Text;
  bool needed = false;
  const char* of = "";
  double low = -kAny, high = kAny;
  size_t count = 0;
  size_t least = 0;  // least number of elements of a list or a map
  std::vector<Json> choices = {};
};

struct ObjectKind {
  std::vector<Member> members;
  std::map<std::string, const char*> extensions = {};  // allowed extensions, and their kinds
};

Member wholeFrom(const char* name, double low, bool needed = false) {
  return {.name = name, .form = Form::Whole, .needed = needed, .low = low};
}
Member numberFrom(const char* name, double low, double high = kAny, bool needed = false) {
  return {.name = name, .form = Form::Number, .needed = needed, .low = low, .high = high};
}
Member numbers(const char* name, size_t count, double low = -kAny, double high = kAny) {
  return {.name = name, .form = Form::Numbers, .low = low, .high = high, .count = count};
}
Member indexOf(const char* name, const char* list, bool needed = false) {
  return {.name = name, .form = Form::Index, .needed = needed, .of = list};
}
Member object(const char* name, const char* kind, bool needed = false) {
  return {.name = name, .form = Form::Object, .needed = needed, .of = kind};
}
Member objects(const char* name, const char* kind, bool needed = false) {
  return {.name = name, .form = Form::Objects, .needed = needed, .of = kind, .least = needed ? size_t(1) : 0};
}
Member oneOf(const char* name, Form form, std::vector<Json> choices, bool needed = false) {
  return {.name = name, .form = form, .needed = needed, .low = 0, .choices = std::move(choices)};
}
Member text(const char* name, bool needed = false) { return {.name = name, .needed = needed}; }
Member flag(const char* name) { return {.name = name, .form = Form::Flag}; }

// Tables of the standard, "Properties Reference", and of the specifications of extensions.
const std::map<std::string, ObjectKind>& kinds() {
  static const std::map<std::string, ObjectKind> all = {
      {"file",
       {{object("asset", "asset", true),
         indexOf("scene", "scenes"),
         objects("scenes", "scene"),
         objects("nodes", "node"),
         objects("meshes", "mesh"),
         objects("accessors", "accessor"),
         objects("bufferViews", "buffer view"),
         objects("buffers", "buffer"),
         objects("materials", "material"),
         objects("textures", "texture"),
         objects("images", "image"),
         objects("samplers", "sampler"),
         objects("cameras", "camera"),
         objects("skins", "skin"),
         objects("animations", "animation"),
         {.name = "extensionsUsed", .form = Form::Texts},
         {.name = "extensionsRequired", .form = Form::Texts}},
        {{"KHR_lights_punctual", "lights"}, {"KHR_materials_variants", "variants"}}}},
      {"asset", {{text("version", true), text("minVersion"), text("copyright"), text("generator")}}},
      {"scene", {{{.name = "nodes", .form = Form::Indices, .of = "nodes"}}}},
      {"node",
       {{indexOf("camera", "cameras"),
         indexOf("skin", "skins"),
         indexOf("mesh", "meshes"),
         {.name = "children", .form = Form::Indices, .of = "nodes"},
         numbers("matrix", 16),
         numbers("rotation", 4),
         numbers("scale", 3),
         numbers("translation", 3),
         numbers("weights", 0)},
        {{"KHR_lights_punctual", "light of a node"}, {"EXT_mesh_gpu_instancing", "instances"}}}},
      {"mesh", {{objects("primitives", "primitive", true), numbers("weights", 0)}}},
      {"primitive",
       {{{.name = "attributes", .form = Form::IndexMap, .needed = true, .of = "accessors", .least = 1},
         indexOf("indices", "accessors"),
         indexOf("material", "materials"),
         {.name = "mode", .form = Form::Whole, .low = 0, .high = 6},
         {.name = "targets", .form = Form::IndexMaps, .of = "accessors"}},
        {{"KHR_materials_variants", "variants of a primitive"}, {"KHR_draco_mesh_compression", "draco"}}}},
      {"accessor",
       {{indexOf("bufferView", "bufferViews"), wholeFrom("byteOffset", 0),
         oneOf("componentType", Form::Whole, {5120, 5121, 5122, 5123, 5125, 5126}, true), flag("normalized"),
         wholeFrom("count", 1, true),
         oneOf("type", Form::Text, {"SCALAR", "VEC2", "VEC3", "VEC4", "MAT2", "MAT3", "MAT4"}, true), numbers("max", 0),
         numbers("min", 0), object("sparse", "sparse")}}},
      {"sparse",
       {{wholeFrom("count", 1, true), object("indices", "sparse indices", true),
         object("values", "sparse values", true)}}},
      {"sparse indices",
       {{indexOf("bufferView", "bufferViews", true), wholeFrom("byteOffset", 0),
         oneOf("componentType", Form::Whole, {5121, 5123, 5125}, true)}}},
      {"sparse values", {{indexOf("bufferView", "bufferViews", true), wholeFrom("byteOffset", 0)}}},
      {"buffer view",
       {{indexOf("buffer", "buffers", true),
         wholeFrom("byteOffset", 0),
         wholeFrom("byteLength", 1, true),
         {.name = "byteStride", .form = Form::Whole, .low = 4, .high = 252},
         oneOf("target", Form::Whole, {34962, 34963})},
        {{"EXT_meshopt_compression", "meshopt"}}}},
      {"buffer", {{text("uri"), wholeFrom("byteLength", 1, true)}, {{"EXT_meshopt_compression", "meshopt fallback"}}}},
      {"material",
       {{object("pbrMetallicRoughness", "metallic roughness"), object("normalTexture", "normal texture"),
         object("occlusionTexture", "occlusion texture"), object("emissiveTexture", "texture use"),
         numbers("emissiveFactor", 3, 0, 1), oneOf("alphaMode", Form::Text, {"OPAQUE", "MASK", "BLEND"}),
         numberFrom("alphaCutoff", 0), flag("doubleSided")},
        {{"KHR_materials_unlit", "unlit"}, {"KHR_materials_emissive_strength", "emissive strength"}}}},
      {"metallic roughness",
       {{numbers("baseColorFactor", 4, 0, 1), object("baseColorTexture", "texture use"),
         numberFrom("metallicFactor", 0, 1), numberFrom("roughnessFactor", 0, 1),
         object("metallicRoughnessTexture", "texture use")}}},
      {"texture use",
       {{indexOf("index", "textures", true), wholeFrom("texCoord", 0)},
        {{"KHR_texture_transform", "texture transform"}}}},
      {"normal texture",
       {{indexOf("index", "textures", true), wholeFrom("texCoord", 0), numberFrom("scale", -kAny)},
        {{"KHR_texture_transform", "texture transform"}}}},
      {"occlusion texture",
       {{indexOf("index", "textures", true), wholeFrom("texCoord", 0), numberFrom("strength", 0, 1)},
        {{"KHR_texture_transform", "texture transform"}}}},
      {"texture transform",
       {{numbers("offset", 2), numberFrom("rotation", -kAny), numbers("scale", 2), wholeFrom("texCoord", 0)}}},
      {"texture", {{indexOf("sampler", "samplers"), indexOf("source", "images")}}},
      {"image", {{text("uri"), text("mimeType"), indexOf("bufferView", "bufferViews")}}},
      {"sampler",
       {{oneOf("magFilter", Form::Whole, {9728, 9729}),
         oneOf("minFilter", Form::Whole, {9728, 9729, 9984, 9985, 9986, 9987}),
         oneOf("wrapS", Form::Whole, {10497, 33071, 33648}), oneOf("wrapT", Form::Whole, {10497, 33071, 33648})}}},
      {"camera",
       {{oneOf("type", Form::Text, {"perspective", "orthographic"}, true), object("perspective", "perspective"),
         object("orthographic", "orthographic")}}},
      {"perspective",
       {{numberFrom("aspectRatio", kPositive), numberFrom("yfov", kPositive, kAny, true), numberFrom("zfar", kPositive),
         numberFrom("znear", kPositive, kAny, true)}}},
      {"orthographic",
       {{numberFrom("xmag", -kAny, kAny, true), numberFrom("ymag", -kAny, kAny, true),
         numberFrom("zfar", kPositive, kAny, true), numberFrom("znear", 0, kAny, true)}}},
      {"skin",
       {{indexOf("inverseBindMatrices", "accessors"),
         indexOf("skeleton", "nodes"),
         {.name = "joints", .form = Form::Indices, .needed = true, .of = "nodes", .least = 1}}}},
      {"animation", {{objects("channels", "channel", true), objects("samplers", "keys", true)}}},
      {"channel", {{wholeFrom("sampler", 0, true), object("target", "target", true)}}},
      {"target", {{indexOf("node", "nodes"), text("path", true)}, {{"KHR_animation_pointer", "pointer"}}}},
      {"keys",
       {{indexOf("input", "accessors", true), indexOf("output", "accessors", true),
         oneOf("interpolation", Form::Text, {"LINEAR", "STEP", "CUBICSPLINE"})}}},
      // Extensions.
      {"lights", {{objects("lights", "light", true)}}},
      {"light",
       {{oneOf("type", Form::Text, {"directional", "point", "spot"}, true), numbers("color", 3, 0, 1),
         numberFrom("intensity", 0), numberFrom("range", kPositive), object("spot", "spot")}}},
      {"spot", {{numberFrom("innerConeAngle", 0, kPi / 2), numberFrom("outerConeAngle", kPositive, 1.5707964)}}},
      {"light of a node", {{wholeFrom("light", 0, true)}}},
      {"instances", {{{.name = "attributes", .form = Form::IndexMap, .needed = true, .of = "accessors", .least = 1}}}},
      {"variants", {{objects("variants", "variant", true)}}},
      {"variant", {{text("name", true)}}},
      {"variants of a primitive", {{objects("mappings", "mapping", true)}}},
      {"mapping",
       {{indexOf("material", "materials", true), {.name = "variants", .form = Form::Wholes, .needed = true}}}},
      {"pointer", {{text("pointer", true)}}},
      {"unlit", {}},
      {"emissive strength", {{numberFrom("emissiveStrength", 0)}}},
      {"draco",
       {{indexOf("bufferView", "bufferViews", true),
         {.name = "attributes", .form = Form::WholeMap, .needed = true, .least = 1}}}},
      {"meshopt",
       {{indexOf("buffer", "buffers", true),
         wholeFrom("byteOffset", 0),
         wholeFrom("byteLength", 1, true),
         {.name = "byteStride", .form = Form::Whole, .needed = true, .low = 1, .high = 256},
         wholeFrom("count", 1, true),
         oneOf("mode", Form::Text, {"ATTRIBUTES", "TRIANGLES", "INDICES"}, true),
         oneOf("filter", Form::Text, {"NONE", "OCTAHEDRAL", "QUATERNION", "EXPONENTIAL"})}}},
      {"meshopt fallback", {{flag("fallback")}}},
  };
  return all;
}

class FormChecker {
 public:
  explicit FormChecker(const GltfFile& file) : file_(file) {}

  void check(const Json& json, const std::string& kind_name, const std::string& where) {
    if (!json.is_object()) file_.refuse(where, "is not an object");
    const ObjectKind& kind = kinds().at(kind_name);
    file_.text(json, "name", where);
    for (const Member& member : kind.members) {
      if (member.needed) file_.require(json, member.name, where);
      if (json.contains(member.name)) checkMember(json, member, where);
    }
    checkExtensions(json, kind, where);
  }

 private:
  void checkMember(const Json& json, const Member& member, const std::string& where) {
    const std::string place = where.empty() ? member.name : where + "." + member.name;
    switch (member.form) {
      case Form::Text:
        file_.text(json, member.name, where);
        break;
      case Form::Flag:
        file_.flag(json, member.name, where);
        break;
      case Form::Number:
        requireRange(member, file_.number(json, member.name, 0, where), where);
        break;
      case Form::Whole:
        requireRange(member, double(file_.size(json, member.name, {}, where)), where);
        break;
      case Form::Index:
        file_.index(json, member.name, member.of, where);
        break;
      case Form::Object:
        check(json[member.name], member.of, place);
        break;
      case Form::IndexMap:
      case Form::WholeMap:
        checkMap(file_.object(json, member.name, where), member, place);
        break;
      default:
        checkList(file_.list(json, member.name, where), member, where, place);
    }
    requireChoice(member, json[member.name], where);
  }

  void checkList(const Json& list, const Member& member, const std::string& where, const std::string& place) {
    if (double(list.size()) < member.least) file_.refuse(where, fmt::format("has no {}", member.name));
    if (member.count > 0 && list.size() != member.count)
      file_.refuse(where, fmt::format("'{}' does not have {} numbers", member.name, member.count));
    for (size_t i = 0; i < list.size(); ++i) {
      const std::string element = fmt::format("{}[{}]", place, i);
      const Json holder = {{member.name, list[i]}};
      switch (member.form) {
        case Form::Texts:
          file_.text(holder, member.name, element);
          break;
        case Form::Numbers:
          requireRange(member, file_.number(holder, member.name, 0, element), element);
          break;
        case Form::Wholes:
          file_.size(holder, member.name, {}, element);
          break;
        case Form::Indices:
          file_.index(holder, member.name, member.of, where);
          break;
        case Form::IndexMaps:
          checkMap(list[i], member, element);
          break;
        default:
          check(list[i], member.of, element);
      }
    }
  }

  void checkMap(const Json& map, const Member& member, const std::string& where) {
    if (!map.is_object()) file_.refuse(where, "is not an object");
    if (map.size() < member.least) file_.refuse(where, "is empty");
    for (const auto& [name, value] : map.items())
      if (member.form == Form::WholeMap) file_.size(map, name, {}, where);
      else file_.index(map, name, member.of, where);
  }

  void requireRange(const Member& member, double value, const std::string& where) {
    if (value >= member.low && value <= member.high) return;
    const std::string low = member.low == kPositive ? "above 0" : fmt::format("{} or more", member.low);
    const std::string range = member.high == kAny       ? low
                              : member.low == kPositive ? fmt::format("above 0 and up to {}", member.high)
                                                        : fmt::format("from {} to {}", member.low, member.high);
    file_.refuse(where, fmt::format("'{}' is {}, not {}", member.name, value, range));
  }

  void requireChoice(const Member& member, const Json& value, const std::string& where) {
    const std::vector<Json>& choices = member.choices;
    if (choices.empty() || std::find(choices.begin(), choices.end(), value) != choices.end()) return;
    const std::string got = value.is_string() ? fmt::format("'{}'", value.get<std::string>()) : value.dump();
    file_.refuse(where, fmt::format("{} {} is unknown", member.name, got));
  }

  void checkExtensions(const Json& json, const ObjectKind& kind, const std::string& where) {
    const std::string place = where.empty() ? "extensions" : where + ".extensions";
    for (const auto& [name, value] : file_.object(json, "extensions", where).items()) {
      if (!value.is_object()) file_.refuse(place, fmt::format("'{}' is not an object", name));
      if (!declares(file_, name)) file_.refuse(place, fmt::format("{} is not in extensionsUsed", name));
      auto found = kind.extensions.find(name);
      if (found != kind.extensions.end()) check(value, found->second, place + "." + name);
      else if (isSupported(name)) file_.refuse(place, fmt::format("{} is not allowed here", name));
    }
  }

  static bool isSupported(const std::string& name) {
    const std::vector<std::string>& names = supportedExtensions();
    return std::find(names.begin(), names.end(), name) != names.end();
  }

  const GltfFile& file_;
};

}  // namespace

const std::vector<std::string>& supportedExtensions() {
  static const std::vector<std::string> names = {"KHR_lights_punctual",        "KHR_materials_unlit",
                                                 "KHR_texture_transform",      "KHR_materials_emissive_strength",
                                                 "KHR_mesh_quantization",      "EXT_mesh_gpu_instancing",
                                                 "KHR_materials_variants",     "KHR_animation_pointer",
                                                 "KHR_draco_mesh_compression", "EXT_meshopt_compression"};
  return names;
}

bool declares(const GltfFile& file, const std::string& extension) {
  for (const char* key : {"extensionsUsed", "extensionsRequired"}) {
    const Json& names = file.all(key);
    if (std::find(names.begin(), names.end(), Json(extension)) != names.end()) return true;
  }
  return false;
}

void requireForm(const GltfFile& file) { FormChecker(file).check(file.json(), "file", ""); }

}  // namespace strobe::scene
