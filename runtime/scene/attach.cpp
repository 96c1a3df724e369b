// SPDX-License-Identifier: MIT
#include "scene/attach.h"

#include <algorithm>

#include "scene/motion.h"

namespace strobe::scene {

// Index into a list that follows `before` other elements; -1 stays.
static int shifted(int index, int before) { return index < 0 ? index : index + before; }

AttachedPart addedPart(Scene part, Scene& scene) {
  AttachedPart added{std::move(part), int(scene.meshes.size()), int(scene.materials.size()),
                     int(scene.textures.size())};
  for (const Mesh& mesh : added.scene.meshes) {
    scene.meshes.push_back(mesh);
    for (Geometry& geometry : scene.meshes.back().geometries) geometry.material += added.first_material;
  }
  for (Material material : added.scene.materials) {
    for (TextureUse* use : {&material.base_color_texture, &material.metallic_roughness_texture,
                            &material.normal_texture, &material.emissive_texture})
      use->texture = shifted(use->texture, added.first_texture);
    scene.materials.push_back(std::move(material));
  }
  scene.textures.insert(scene.textures.end(), added.scene.textures.begin(), added.scene.textures.end());
  return added;
}

static void attachClip(Animation clip, const std::string& prefix, int nodes, int cameras, int lights, Scene& scene) {
  clip.name = prefix + clip.name;
  for (Track& track : clip.tracks) track.object += track.isOfNode() ? nodes : track.isOfCamera() ? cameras : lights;
  scene.animations.push_back(std::move(clip));
}

static std::string creditOf(const Json& attribution) {
  for (const char* key : {"copyright", "text"})
    if (attribution.contains(key) && attribution[key].is_string()) {
      const std::string text = attribution[key].get<std::string>();
      return text.substr(0, text.find('\n'));
    }
  return "";
}

// Copies warnings, assumptions and credits, with the name of the node.
static void attachTexts(const Scene& part, const std::string& name, Scene& scene) {
  for (const std::string& warning : part.warnings) scene.warnings.push_back(name + ": " + warning);
  for (const std::string& assumption : part.assumptions) scene.assumptions.push_back(name + ": " + assumption);
  if (!part.attribution.is_object() || part.attribution.empty()) return;
  scene.attribution["parts"][name] = part.attribution;
  const std::string credit = creditOf(part.attribution);
  std::string before = scene.attribution.value("copyright", "");
  if (before.find(credit) == std::string::npos)
    scene.attribution["copyright"] = before.empty() ? credit : before + "; " + credit;
}

void attach(const AttachedPart& added, int node, const std::string& animation, Scene& scene) {
  const Scene& part = added.scene;
  std::vector<const Animation*> clips = clipsOf(part, animation);
  if (animation == "all") {  // including clips that yield: `yieldClips` decides for the whole scene
    clips.clear();
    for (const Animation& clip : part.animations) clips.push_back(&clip);
  }
  const std::string name = scene.nodes[size_t(node)].name, prefix = name + "/";
  const int nodes = int(scene.nodes.size()), cameras = int(scene.cameras.size());
  const int lights = int(scene.lights.size()), skins = int(scene.skins.size());
  for (Node own : part.nodes) {
    own.name = prefix + own.name;
    own.parent = own.parent < 0 ? node : own.parent + nodes;
    own.mesh = shifted(own.mesh, added.first_mesh);
    own.camera = shifted(own.camera, cameras);
    own.light = shifted(own.light, lights);
    own.skin = shifted(own.skin, skins);
    scene.nodes.push_back(std::move(own));
  }
  for (Skin skin : part.skins) {
    for (int& joint : skin.joints) joint += nodes;
    scene.skins.push_back(std::move(skin));
  }
  for (Camera camera : part.cameras) {
    camera.name = prefix + camera.name;
    scene.cameras.push_back(std::move(camera));
  }
  for (Light light : part.lights) {
    light.name = prefix + light.name;
    scene.lights.push_back(std::move(light));
  }
  for (const Animation* clip : clips) attachClip(*clip, prefix, nodes, cameras, lights, scene);
  std::vector<double>& cuts = scene.nodes[size_t(node)].cuts;
  cuts.insert(cuts.end(), part.cuts.begin(), part.cuts.end());
  std::sort(cuts.begin(), cuts.end());
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  attachTexts(part, name, scene);
}

}  // namespace strobe::scene
