// SPDX-License-Identifier: MIT
// Scenes described in Lua. The plain data that scripts/strobe/scene.lua builds becomes a `Scene`; its comments are the
// reference of the allowed data. Shapes and textures are made here.
#pragma once

#include "scene/scene_files.h"
#include "scene/textures.h"

namespace strobe::scene {

// A number that a scene may suggest for its pictures (`shot` in its description), with its range.
struct Suggestion {
  std::string name;
  bool whole = false;
  double min = 0, max = 0;
};

// `file` is the place in errors for tables without a place. Equal meshes, materials and textures are made once. Files
// that the scene names are looked up in `places`, by default the folder of `file`. Throws one `Error` with all
// mistakes: unknown keys, wrong types, values out of range, unknown node names, files that cannot be read.
Scene sceneFromJson(const Json& description, const std::string& file, const std::vector<Suggestion>& suggestions = {},
                    const Painter& paint = paintPattern, const std::optional<FilePlaces>& places = std::nullopt);

// Throws the errors of `sceneFromJson`, without painting textures.
void checkScene(const Json& description, const std::string& file, const std::vector<Suggestion>& suggestions = {},
                const std::optional<FilePlaces>& places = std::nullopt);

}  // namespace strobe::scene
