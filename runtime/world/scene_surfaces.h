// SPDX-License-Identifier: MIT
// Materials and textures of a scene on the device, shared by all copies of the scene that have their own poses.
#pragma once

#include <vector>

#include "gpu/resources.h"
#include "scene/scene.h"

namespace strobe::world {

class SceneSurfaces {
 public:
  SceneSurfaces(const gpu::Device& device, const scene::Scene& scene);

  const gpu::Buffer& materials() const { return materials_; }
  // Textures with their samplers; one white texel for a scene without textures.
  const std::vector<VkDescriptorImageInfo>& textures() const { return infos_; }

 private:
  void uploadMaterials(const gpu::Device& device, const scene::Scene& scene);
  void uploadTextures(const gpu::Device& device, const scene::Scene& scene);

  gpu::Buffer materials_;
  std::vector<gpu::Image> textures_;
  std::vector<gpu::Owned<VkSampler>> samplers_;
  std::vector<VkDescriptorImageInfo> infos_;
};

}  // namespace strobe::world
