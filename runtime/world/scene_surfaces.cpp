// SPDX-License-Identifier: MIT
#include "world/scene_surfaces.h"

#include "scene/textures.h"
#include "shared/scene.h"

namespace strobe::world {

using namespace scene;
using namespace shared;

SceneSurfaces::SceneSurfaces(const gpu::Device& device, const Scene& scene, gpu::Uploads& uploads) {
  uploadMaterials(scene, uploads);
  uploadTextures(device, scene, uploads);
}

// Taps of anisotropic filtering, for textures with linear minification and levels; otherwise 1.
static constexpr uint32_t kMostTaps = 4;

static SceneTextureUse textureUse(const Scene& scene, const TextureUse& use) {
  const auto& m = use.uv_transform;
  uint32_t taps = kMostTaps;
  if (use.texture >= 0) {
    const Texture& texture = scene.textures[size_t(use.texture)];
    bool blends = texture.minify == Texture::Filter::Linear && texture.between != Texture::Levels::None;
    taps = blends ? kMostTaps : 1;
  }
  return {use.texture, uint32_t(use.uv_set), vec2(m[0]), vec2(m[1]), vec2(m[2]), taps};
}

static uint32_t flagsOf(const Material& material) {
  return (material.unlit ? MATERIAL_UNLIT : 0) | (material.alpha == Material::Alpha::Mask ? MATERIAL_ALPHA_MASK : 0) |
         (material.alpha == Material::Alpha::Blend ? MATERIAL_ALPHA_BLEND : 0) |
         (material.double_sided ? 0 : MATERIAL_ONE_SIDED);
}

// Mean colour of a material: its factor times the mean of its texture.
static vec3 meanColor(const Scene& scene, const Material& material) {
  vec3 factor(material.base_color);
  int texture = material.base_color_texture.texture;
  return texture < 0 ? factor : factor * meanColor(scene.textures[size_t(texture)]);
}

void SceneSurfaces::uploadMaterials(const Scene& scene, gpu::Uploads& uploads) {
  std::vector<SceneMaterial> materials;
  for (const Material& source : scene.materials) {
    SceneMaterial material;
    material.base_color = source.base_color;
    material.mean_color = meanColor(scene, source);
    material.emissive = source.emissive;
    material.metallic = source.metallic;
    material.roughness = source.roughness;
    material.alpha_cutoff = source.alpha_cutoff;
    material.normal_scale = source.normal_scale;
    material.flags = flagsOf(source);
    material.uses[USE_BASE_COLOR] = textureUse(scene, source.base_color_texture);
    material.uses[USE_METALLIC_ROUGHNESS] = textureUse(scene, source.metallic_roughness_texture);
    material.uses[USE_NORMAL] = textureUse(scene, source.normal_texture);
    material.uses[USE_EMISSIVE] = textureUse(scene, source.emissive_texture);
    materials.push_back(material);
  }
  materials_ = uploads.array("scene.materials", materials, gpu::kReadByAddress);
}

// In the order of Texture::Format and Texture::Wrap.
static constexpr VkFormat kFormats[] = {VK_FORMAT_R8G8B8A8_SRGB, VK_FORMAT_R8G8B8A8_UNORM,
                                        VK_FORMAT_R32G32B32A32_SFLOAT};
static constexpr VkSamplerAddressMode kWraps[] = {
    VK_SAMPLER_ADDRESS_MODE_REPEAT, VK_SAMPLER_ADDRESS_MODE_MIRRORED_REPEAT, VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE};

static VkFilter filterOf(Texture::Filter filter) {
  return filter == Texture::Filter::Linear ? VK_FILTER_LINEAR : VK_FILTER_NEAREST;
}

static gpu::SamplerDesc samplerOf(const Texture& texture) {
  gpu::SamplerDesc desc;
  desc.magnify = filterOf(texture.magnify);
  desc.minify = filterOf(texture.minify);
  desc.between =
      texture.between == Texture::Levels::Linear ? VK_SAMPLER_MIPMAP_MODE_LINEAR : VK_SAMPLER_MIPMAP_MODE_NEAREST;
  desc.first_level_only = texture.between == Texture::Levels::None;
  desc.wrap_u = kWraps[int(texture.wrap_u)];
  desc.wrap_v = kWraps[int(texture.wrap_v)];
  return desc;
}

// Levels to upload. A texture without level selection and with equal filters needs one level.
static size_t levelsOf(const Texture& texture) {
  bool alike = texture.between == Texture::Levels::None && texture.magnify == texture.minify;
  return alike ? 1 : texture.levels.size();
}

void SceneSurfaces::uploadTextures(const gpu::Device& device, const Scene& scene, gpu::Uploads& uploads) {
  // A white texel replaces an empty list of textures, because the array must not be empty.
  Texture white;
  white.name = "white";
  white.width = white.height = 1;
  white.levels = {{255, 255, 255, 255}};
  std::vector<const Texture*> sources;
  for (const Texture& texture : scene.textures) sources.push_back(&texture);
  if (sources.empty()) sources.push_back(&white);
  for (const Texture* source : sources) {
    gpu::ImageDesc desc;
    desc.format = kFormats[int(source->format)];
    desc.width = uint32_t(source->width);
    desc.height = uint32_t(source->height);
    desc.levels = uint32_t(levelsOf(*source));
    std::vector<std::vector<uint8_t>> levels(source->levels.begin(), source->levels.begin() + desc.levels);
    textures_.push_back(uploads.image("scene.texture." + source->name, desc, levels));
    gpu::Owned<VkSampler>& sampler = samplers_[samplerOf(*source)];
    if (!sampler.get()) sampler = gpu::makeSampler(device, "scene.sampler", samplerOf(*source));
    infos_.push_back(gpu::inGeneral(textures_.back().view(), sampler.get()));
  }
}

}  // namespace strobe::world
