// SPDX-License-Identifier: MIT
// Readers of the parts of a scene's description (json_scene.h), one table each. Mistakes are added to `problems`; the
// returned value is then valid, but without meaning.
#pragma once

#include "scene/scene_files.h"
#include "scene/shapes.h"
#include "scene/textures.h"

namespace strobe::scene {

// Members of a table: position, rotation (degrees: about z, then x, then y), scale (one number or three), look_at (a
// point in the same space, which -z faces).
Transform readTransform(SceneFields& fields);

Shape readShape(const Json& json, const Place& place, Problems& problems);
// An image has only level 0. Its further levels depend on its use, for colours or for numbers.
Texture readTexture(const Json& json, const Place& place, Problems& problems, const Painter& paint, SceneFiles& files);
Light readLight(const Json& json, const Place& place, Problems& problems);
Camera readCamera(const Json& json, const Place& place, Problems& problems);

// True if the table's "kind" is `kind`, as its constructor wrote it.
bool isKind(const Json& json, const std::string& kind);

// Text of a table without source places. Equal tables have equal texts, wherever they were written.
std::string contentOf(const Json& json);

}  // namespace strobe::scene
