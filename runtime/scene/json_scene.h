// SPDX-License-Identifier: MIT
// Scenes described in Lua: the plain data that scripts/strobe/scene.lua builds (its comments are the reference of what
// may be written) becomes a `Scene`; shapes and textures are made here.
#pragma once

#include "scene/scene.h"

namespace strobe::scene {

// `file` is what errors show for tables that say no place of their own. Equal meshes, materials and textures are made
// once. Throws one `Error` with all mistakes: unknown keys, wrong types, values out of range, unknown node names.
Scene sceneFromJson(const Json& description, const std::string& file);

}  // namespace strobe::scene
