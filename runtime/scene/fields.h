// SPDX-License-Identifier: MIT
// Strict reading of one table of a scene's description (base/strict.h), with vectors and colours.
#pragma once

#include "base/strict.h"
#include "scene/scene.h"

namespace strobe::scene {

// Checked reader of a table in a scene description that also reads 2D and 3D vectors and RGBA colours.
class SceneFields : public strobe::Fields {
 public:
  // Constructors in Lua add these keys to their tables.
  SceneFields(const Json& json, std::string what, const Place& outer, Problems& problems)
      : strobe::Fields(json, std::move(what), outer, problems) {
    allow("kind");
    allow("type");
  }

  dvec2 vector2(const std::string& key, std::optional<dvec2> fallback, double min = -1e9, double max = 1e9);
  dvec3 vector3(const std::string& key, std::optional<dvec3> fallback, double min = -1e9, double max = 1e9);
  // Three or four numbers; a missing fourth is 1.
  vec4 color(const std::string& key, std::optional<vec4> fallback, double max = 1);

 private:
  // The numbers of a list; empty, possibly with a mistake, if the list is missing or wrong.
  std::vector<double> listAt(const std::string& key, bool needed, size_t least, size_t most, double min, double max);
};

}  // namespace strobe::scene
