// SPDX-License-Identifier: MIT
#include "scene/attach.h"

#include <algorithm>

#include "scene/motion.h"

namespace strobe::scene {

// Index into a list that follows `before` other elements; -1 stays.
static int shifted(int index, int before) { return index < 0 ? index : index + before; }

Attacher::Shared Attacher::share(const Scene& part) {
  const Shared first{int(scene_.meshes.size()), int(scene_.materials.size()), int(scene_.textures.size())};
  for (const Mesh& mesh : part.meshes) {
    scene_.meshes.push_back(mesh);
    for (Geometry& geometry : scene_.meshes.back().geometries) geometry.material += first.materials;
  }
  for (Material material : part.materials) {
    for (TextureUse* use : {&material.base_color_texture, &material.metallic_roughness_texture,
                            &material.normal_texture, &material.emissive_texture})
      use->texture = shifted(use->texture, first.textures);
    scene_.materials.push_back(std::move(material));
  }
  scene_.textures.insert(scene_.textures.end(), part.textures.begin(), part.textures.end());
  return first;
}

void Attacher::attachClip(Animation clip, const std::string& prefix, int nodes, int cameras, int lights) {
  clip.name = prefix + clip.name;
  for (Track& track : clip.tracks) track.node += nodes;
  for (WeightTrack& track : clip.weights) track.node += nodes;
  for (PropertyTrack& track : clip.properties) track.index += track.isOfCamera() ? cameras : lights;
  scene_.animations.push_back(std::move(clip));
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
void Attacher::attachTexts(const Scene& part, const std::string& name) {
  for (const std::string& warning : part.warnings) scene_.warnings.push_back(name + ": " + warning);
  for (const std::string& assumption : part.assumptions) scene_.assumptions.push_back(name + ": " + assumption);
  if (!part.attribution.is_object() || part.attribution.empty()) return;
  scene_.attribution["parts"][name] = part.attribution;
  const std::string credit = creditOf(part.attribution);
  std::string before = scene_.attribution.value("copyright", "");
  if (before.find(credit) == std::string::npos)
    scene_.attribution["copyright"] = before.empty() ? credit : before + "; " + credit;
}

void Attacher::attach(const std::string& key, const Scene& part, int node, const std::string& animation) {
  std::vector<const Animation*> clips = clipsOf(part, animation);
  if (animation == "all") {  // including clips that yield: `yieldClips` decides for the whole scene
    clips.clear();
    for (const Animation& clip : part.animations) clips.push_back(&clip);
  }
  auto known = shared_.find(key);
  if (known == shared_.end()) known = shared_.emplace(key, share(part)).first;
  const Shared& first = known->second;
  const std::string name = scene_.nodes[size_t(node)].name, prefix = name + "/";
  const int nodes = int(scene_.nodes.size()), cameras = int(scene_.cameras.size());
  const int lights = int(scene_.lights.size()), skins = int(scene_.skins.size());
  for (Node own : part.nodes) {
    own.name = prefix + own.name;
    own.parent = own.parent < 0 ? node : own.parent + nodes;
    own.mesh = shifted(own.mesh, first.meshes);
    own.camera = shifted(own.camera, cameras);
    own.light = shifted(own.light, lights);
    own.skin = shifted(own.skin, skins);
    scene_.nodes.push_back(std::move(own));
  }
  for (Skin skin : part.skins) {
    for (int& joint : skin.joints) joint += nodes;
    scene_.skins.push_back(std::move(skin));
  }
  for (Camera camera : part.cameras) {
    camera.name = prefix + camera.name;
    scene_.cameras.push_back(std::move(camera));
  }
  for (Light light : part.lights) {
    light.name = prefix + light.name;
    scene_.lights.push_back(std::move(light));
  }
  for (const Animation* clip : clips) attachClip(*clip, prefix, nodes, cameras, lights);
  std::vector<double>& cuts = scene_.nodes[size_t(node)].cuts;
  cuts.insert(cuts.end(), part.cuts.begin(), part.cuts.end());
  std::sort(cuts.begin(), cuts.end());
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  attachTexts(part, name);
}

}  // namespace strobe::scene
