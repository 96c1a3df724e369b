// SPDX-License-Identifier: MIT
// Materials and textures of a scene on the device, shared by all copies of the scene that have their own poses.
#pragma once

#include <map>
#include <vector>

#include "gpu/staging.h"
#include "scene/scene.h"

namespace strobe::world {

// Material buffer, textures and samplers of a scene on the device.
class SceneSurfaces {
 public:
  // The data is on the device when `uploads` has finished.
  SceneSurfaces(const gpu::Device& device, const scene::Scene& scene, gpu::Uploads& uploads);

  const gpu::Buffer& materials() const { return materials_; }
  // Textures with their samplers; one white texel for a scene without textures.
  const std::vector<VkDescriptorImageInfo>& textures() const { return infos_; }

 private:
  void uploadMaterials(const scene::Scene& scene, gpu::Uploads& uploads);
  void uploadTextures(const gpu::Device& device, const scene::Scene& scene, gpu::Uploads& uploads);

  gpu::Buffer materials_;
  std::vector<gpu::DeviceImage> textures_;
  std::map<gpu::SamplerDesc, gpu::Owned<VkSampler>> samplers_;  // at most 144, of the 4,000 that each device allows
  std::vector<VkDescriptorImageInfo> infos_;
};

}  // namespace strobe::world
