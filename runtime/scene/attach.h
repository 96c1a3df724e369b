// SPDX-License-Identifier: MIT
// A scene as a part of another: a glTF file at a node.
#pragma once

#include <map>

#include "scene/scene.h"

namespace strobe::scene {

// Attaches scenes to one. Meshes, materials and textures of a part are added once, however often it is attached.
class Attacher {
 public:
  explicit Attacher(Scene& scene) : scene_(scene) {}

  // Adds a part below `node`, which takes over the cuts of the part. "NAME/" of the node is put before the names of
  // nodes, clips, cameras and lights of the part. `animation` chooses clips: "all", "none" or a name. Equal parts have
  // equal keys. Throws `Error` for an unknown clip.
  void attach(const std::string& key, const Scene& part, int node, const std::string& animation);

 private:
  struct Shared {
    int meshes = 0, materials = 0, textures = 0;  // index of the first of the part
  };
  Shared share(const Scene& part);
  void attachClip(Animation clip, const std::string& prefix, int nodes, int cameras, int lights);
  void attachTexts(const Scene& part, const std::string& name);

  Scene& scene_;
  std::map<std::string, Shared> shared_;
};

}  // namespace strobe::scene
