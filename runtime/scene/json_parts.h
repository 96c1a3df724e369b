// SPDX-License-Identifier: MIT
// Parts of a scene's description (json_scene.h): one table each to the thing it describes. Mistakes go to `problems`;
// what is returned then is of the right kind but of no use.
#pragma once

#include "scene/scene_files.h"
#include "scene/shapes.h"
#include "scene/textures.h"

namespace strobe::scene {

// position, rotation (degrees: about z, then x, then y), scale (a number or three), look_at (a point in the same space
// that -z turns to).
struct Placement {
  dvec3 translation = dvec3(0);
  dquat rotation = dquat(1, 0, 0, 0);
  dvec3 scale = dvec3(1);
};
Placement readPlacement(Fields& fields);

Shape readShape(const Json& json, const Place& place, Problems& problems);
// An image has level 0 alone. Its further levels depend on its use, for colours or for numbers.
Texture readTexture(const Json& json, const Place& place, Problems& problems, const Painter& paint, SceneFiles& files);
Light readLight(const Json& json, const Place& place, Problems& problems);
Camera readCamera(const Json& json, const Place& place, Problems& problems);

// The table's "kind" must be `kind`, as its constructor wrote it.
bool isKind(const Json& json, const std::string& kind);

// The text of a table without the places in it: equal for equal things, wherever they were written.
std::string contentOf(const Json& json);

}  // namespace strobe::scene
