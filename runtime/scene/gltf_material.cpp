// SPDX-License-Identifier: MIT
#include <cmath>
#include <map>
#include <tuple>

#include "base/memory.h"
#include "scene/gltf_parts.h"
#include "scene/textures.h"

namespace strobe::scene {

namespace {

class MaterialReader {
 public:
  MaterialReader(GltfFile& file, Scene& scene, uint64_t most_bytes)
      : file_(file), scene_(scene), most_bytes_(most_bytes) {}

  void read() {
    const Json& materials = file_.all("materials");
    for (size_t i = 0; i < materials.size(); ++i)
      scene_.materials.push_back(readMaterial(materials[i], fmt::format("materials[{}]", i)));
    // Default of primitives without a material. The default of glTF is a white metal, which lamps alone would leave
    // black.
    Material plain;
    plain.name = "default";
    plain.base_color = vec4(0.8f, 0.8f, 0.8f, 1);
    plain.double_sided = false;
    scene_.materials.push_back(plain);
    requireMemory();
    for (size_t i = 0; i < scene_.textures.size(); ++i) fill(scene_.textures[i], images_of_[i]);
  }

 private:
  void warn(const std::string& text) { scene_.warnings.push_back(text); }

  Material readMaterial(const Json& json, const std::string& where) {
    Material material;
    material.name = file_.text(json, "name");
    const Json& pbr = file_.object(json, "pbrMetallicRoughness", where);
    auto color = file_.numbers(pbr, "baseColorFactor", {1, 1, 1, 1}, where);
    material.base_color = vec4(color[0], color[1], color[2], color[3]);
    material.metallic = float(file_.number(pbr, "metallicFactor", 1, where));
    material.roughness = float(file_.number(pbr, "roughnessFactor", 1, where));
    material.base_color_texture = readUse(pbr, "baseColorTexture", true, where);
    material.metallic_roughness_texture = readUse(pbr, "metallicRoughnessTexture", false, where);
    material.normal_texture = readUse(json, "normalTexture", false, where);
    material.normal_scale = float(file_.number(file_.object(json, "normalTexture", where), "scale", 1, where));
    material.emissive_texture = readUse(json, "emissiveTexture", true, where);
    auto emissive = file_.numbers(json, "emissiveFactor", {0, 0, 0}, where);
    const Json& strength = file_.extension(json, "KHR_materials_emissive_strength");
    material.emissive =
        vec3(emissive[0], emissive[1], emissive[2]) * float(file_.number(strength, "emissiveStrength", 1, where));
    file_.extension(json, "KHR_materials_unlit", &material.unlit);
    material.double_sided = file_.flag(json, "doubleSided", where);
    readAlpha(json, where, material);
    return material;
  }

  void readAlpha(const Json& json, const std::string& where, Material& material) {
    std::string mode = file_.text(json, "alphaMode", where);
    if (mode.empty() || mode == "OPAQUE") return;
    material.alpha = mode == "MASK" ? Material::Alpha::Mask : Material::Alpha::Blend;
    material.alpha_cutoff = float(file_.number(json, "alphaCutoff", 0.5, where));
  }

  TextureUse readUse(const Json& owner, const char* key, bool is_color, const std::string& where) {
    TextureUse use;
    const Json& info = file_.object(owner, key, where);
    int texture = file_.index(info, "index", "textures", where);
    if (texture < 0) return use;
    size_t set = file_.size(info, "texCoord", 0, where);
    const Json& transform = file_.extension(info, "KHR_texture_transform");
    auto offset = file_.numbers(transform, "offset", {0, 0}, where);
    auto scale = file_.numbers(transform, "scale", {1, 1}, where);
    set = file_.size(transform, "texCoord", set, where);
    use.uv_transform =
        uvTransform({offset[0], offset[1]}, file_.number(transform, "rotation", 0, where), {scale[0], scale[1]});
    if (set > 1)
      warn(fmt::format("{}: {} uses texture coordinate set {}, which is not supported; set 0 is used instead", where,
                       key, set));
    use.uv_set = set == 1 ? 1 : 0;
    use.texture = textureIndex(texture, is_color);
    return use;
  }

  Texture::Wrap wrapOf(const Json& sampler, const char* key, const std::string& where) {
    size_t mode = file_.size(sampler, key, 10497, where);
    return mode == 33071 ? Texture::Wrap::Clamp : mode == 33648 ? Texture::Wrap::Mirror : Texture::Wrap::Repeat;
  }

  int textureIndex(int texture, bool is_color) {
    const Json& json = file_.all("textures").at(texture);
    std::string where = fmt::format("textures[{}]", texture);
    int image = file_.index(json, "source", "images", where);
    if (image < 0) {
      warn(where + ": the format of its image is not supported; the texture is left out");
      return -1;
    }
    int sampler_index = file_.index(json, "sampler", "samplers", where);
    const Json none = Json::object();
    const Json& sampler = sampler_index < 0 ? none : file_.all("samplers").at(sampler_index);
    where = sampler_index < 0 ? where : fmt::format("samplers[{}]", sampler_index);
    Texture lookup;
    lookup.wrap_u = wrapOf(sampler, "wrapS", where);
    lookup.wrap_v = wrapOf(sampler, "wrapT", where);
    readFilters(sampler, where, lookup);
    std::tuple key(image, is_color, lookup.wrap_u, lookup.wrap_v, lookup.magnify, lookup.minify, lookup.between);
    auto [known, is_new] = textures_.emplace(key, int(scene_.textures.size()));
    if (is_new) scene_.textures.push_back(emptyTexture(image, lookup, is_color)), images_of_.push_back(image);
    return known->second;
  }

  // Defaults of a sampler: linear filters, with all levels.
  void readFilters(const Json& sampler, const std::string& where, Texture& lookup) {
    using Filter = Texture::Filter;
    using Levels = Texture::Levels;
    size_t magnify = file_.size(sampler, "magFilter", 9729, where),
           minify = file_.size(sampler, "minFilter", 9987, where);
    static const std::map<size_t, std::pair<Filter, Levels>> kinds = {
        {9728, {Filter::Nearest, Levels::None}},    {9729, {Filter::Linear, Levels::None}},
        {9984, {Filter::Nearest, Levels::Nearest}}, {9985, {Filter::Linear, Levels::Nearest}},
        {9986, {Filter::Nearest, Levels::Linear}},  {9987, {Filter::Linear, Levels::Linear}}};
    lookup.magnify = magnify == 9728 ? Filter::Nearest : Filter::Linear;
    std::tie(lookup.minify, lookup.between) = kinds.at(minify);
  }

  // `texture` has the wrap modes and filters. `fill` adds the texels later.
  Texture emptyTexture(int image, Texture texture, bool is_color) {
    texture.name = file_.text(file_.all("images").at(image), "name");
    if (texture.name.empty()) texture.name = fmt::format("image_{}", image);
    texture.format = is_color ? Texture::Format::Rgba8Srgb : Texture::Format::Rgba8Unorm;
    if (!bytes_.count(image)) bytes_[image] = file_.imageBytes(image);
    return texture;
  }

  // Checks the memory of all images, because a small file may state a large size. All levels together have a third more
  // texels than the first level. While levels are built, the texels of two levels are held as floats.
  void requireMemory() {
    uint64_t bytes = 0, most_texels = 0;
    std::string largest;
    auto texelsOf = [](ImageSize size) { return uint64_t(size.width) * uint64_t(size.height); };
    std::map<int, ImageSize> sizes;
    for (const auto& [image, encoded] : bytes_)
      sizes[image] = imageSize(encoded.data(), encoded.size()).value_or(ImageSize());
    for (const auto& [image, size] : sizes) bytes += 4 * texelsOf(size);
    for (size_t i = 0; i < images_of_.size(); ++i) {
      const ImageSize size = sizes[images_of_[i]];
      bytes += texelsOf(size) * 16 / 3;
      if (texelsOf(size) <= most_texels) continue;
      most_texels = texelsOf(size);
      largest = fmt::format("images[{}] of {}x{} texels", images_of_[i], size.width, size.height);
    }
    bytes += most_texels * 5 / 4 * sizeof(vec4);
    if (bytes <= most_bytes_) return;
    file_.refuse("", fmt::format("its decoded images need {} of memory, but only {} are available; the largest is {}",
                                 bytesText(bytes), bytesText(most_bytes_), largest));
  }

  DecodedImage decode(int image) {
    const std::vector<uint8_t>& bytes = bytes_.at(image);
    std::optional<DecodedImage> decoded = decodeImage(bytes.data(), bytes.size());
    if (decoded) return *std::move(decoded);
    const std::string uri = file_.text(file_.all("images").at(image), "uri");
    file_.refuse(fmt::format("images[{}]", image),
                 fmt::format("{}is not a readable PNG or JPEG", !uri.empty() && uri.size() < 100 ? uri + " " : ""));
  }

  void fill(Texture& texture, int image) {
    auto decoded = images_.find(image);
    if (decoded == images_.end()) decoded = images_.emplace(image, decode(image)).first;
    texture.width = decoded->second.width;
    texture.height = decoded->second.height;
    texture.levels = {decoded->second.rgba};
    buildLevels(texture);
  }

  using Lookup = std::tuple<int, bool, Texture::Wrap, Texture::Wrap, Texture::Filter, Texture::Filter, Texture::Levels>;
  GltfFile& file_;
  Scene& scene_;
  const uint64_t most_bytes_;
  std::map<int, std::vector<uint8_t>> bytes_;  // encoded images
  std::map<int, DecodedImage> images_;
  std::vector<int> images_of_;  // by texture
  std::map<Lookup, int> textures_;
};

}  // namespace

void readMaterials(GltfFile& file, Scene& scene, uint64_t most_bytes) {
  MaterialReader(file, scene, most_bytes).read();
}

}  // namespace strobe::scene
