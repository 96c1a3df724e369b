// SPDX-License-Identifier: MIT
// Attachment of a scene to a node of another scene, such as a glTF file.
#pragma once

#include <map>

#include "scene/scene.h"

namespace strobe::scene {

// Attaches scenes as parts of one scene. Meshes, materials and textures of a part are added once, even if the part is
// attached several times.
class Attacher {
 public:
  explicit Attacher(Scene& scene) : scene_(scene) {}

  // Adds a part below `node`. The node takes over the cuts of the part. The names of the part's nodes, clips, cameras
  // and lights get the prefix "NAME/", where NAME is the name of `node`. `animation` chooses clips: "all", "none" or a
  // name. Equal parts have equal keys. Throws `Error` for an unknown clip.
  void attach(const std::string& key, const Scene& part, int node, const std::string& animation);

 private:
  struct Shared {
    int meshes = 0, materials = 0, textures = 0;  // index of the part's first one
  };
  Shared share(const Scene& part);
  void attachClip(Animation clip, const std::string& prefix, int nodes, int cameras, int lights);
  void attachTexts(const Scene& part, const std::string& name);

  Scene& scene_;
  std::map<std::string, Shared> shared_;
};

}  // namespace strobe::scene
