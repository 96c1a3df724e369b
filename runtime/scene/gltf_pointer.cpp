// SPDX-License-Identifier: MIT
#include "scene/gltf_pointer.h"

#include <charconv>

namespace strobe::scene {

namespace {

using Property = PropertyTrack::Property;

const Json& listAt(const GltfFile& file, const std::string& pointer) {
  if (pointer == "/nodes/") return file.all("nodes");
  if (pointer == "/cameras/") return file.all("cameras");
  return file.list(file.extension(file.json(), "KHR_lights_punctual"), "lights", "");
}

struct Row {
  const char* list;        // the pointer up to the number
  const char* rest;        // and after it
  const char* needs = "";  // a member that the object must have
  std::optional<Property> property = {};
  Track::Target target = Track::Target::Translation;
  int components = 1;
};

constexpr const char* kLights = "/extensions/KHR_lights_punctual/lights/";

const Row kRows[] = {
    {"/nodes/", "/translation", "", {}, Track::Target::Translation, 3},
    {"/nodes/", "/rotation", "", {}, Track::Target::Rotation, 4},
    {"/nodes/", "/scale", "", {}, Track::Target::Scale, 3},
    {"/cameras/", "/perspective/yfov", "perspective", Property::FieldOfView},
    {"/cameras/", "/perspective/znear", "perspective", Property::Near},
    {"/cameras/", "/orthographic/ymag", "orthographic", Property::HalfHeight},
    {"/cameras/", "/orthographic/znear", "orthographic", Property::Near},
    {kLights, "/color", "", Property::Color, Track::Target::Translation, 3},
    {kLights, "/intensity", "", Property::Intensity},
    {kLights, "/range", "", Property::Range},
    {kLights, "/spot/innerConeAngle", "spot", Property::InnerCone},
    {kLights, "/spot/outerConeAngle", "spot", Property::OuterCone},
};

// The number that a pointer has between the two parts of a row; nothing where it has other parts.
std::optional<size_t> numberIn(const std::string& pointer, const Row& row) {
  const std::string list = row.list, rest = row.rest;
  if (!pointer.starts_with(list) || !pointer.ends_with(rest) || pointer.size() <= list.size() + rest.size()) return {};
  size_t number = 0;
  const char *from = pointer.data() + list.size(), *to = pointer.data() + pointer.size() - rest.size();
  auto [end, failure] = std::from_chars(from, to, number);
  return failure == std::errc() && end == to ? std::optional(number) : std::nullopt;
}

}  // namespace

std::optional<PointerTarget> pointerTarget(const GltfFile& file, const std::string& pointer, const std::string& where) {
  for (const Row& row : kRows) {
    std::optional<size_t> number = numberIn(pointer, row);
    if (!number) continue;
    const Json& list = listAt(file, row.list);
    bool is_there = *number < list.size() && (!*row.needs || list[*number].contains(row.needs));
    if (!is_there) file.refuse(where, fmt::format("its pointer '{}' leads to nothing", pointer));
    PointerTarget result;
    (row.property ? result.index : result.node) = int(*number);
    result.target = row.target;
    result.property = row.property;
    result.components = row.components;
    return result;
  }
  return std::nullopt;
}

}  // namespace strobe::scene
