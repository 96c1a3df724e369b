// SPDX-License-Identifier: MIT
#include "scene/mitsuba.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "image/exr.h"
#include "math/constants.h"
#include "scene/bend.h"
#include "scene/key_search.h"
#include "scene/ply.h"
#include "scene/textures.h"
#include "scene/xml.h"

namespace strobe::scene {

namespace {

std::string numberList(const vec3& v) { return fmt::format("{}, {}, {}", v.x, v.y, v.z); }

std::string numberList(const dmat4& m) {
  std::string text;
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) text += (text.empty() ? "" : " ") + fmt::format("{}", m[column][row]);
  return text;
}

// Identifiers of Mitsuba have no dots: a dot leads to a parameter.
std::string idOf(const std::string& kind, size_t index, std::string name) {
  std::replace(name.begin(), name.end(), '.', '_');
  return fmt::format("{}_{}{}", kind, index, name.empty() ? "" : "_" + name);
}

bool isBlack(const vec3& color) { return color == vec3(0); }

// Emitters and sensors of Mitsuba look along +z, with x to the left.
dmat4 lookingAlongZ(const dmat4& world) {
  auto unit = [&](int c) { return dvec4(glm::normalize(dvec3(world[c])), 0); };
  return dmat4(-unit(0), unit(1), -unit(2), world[3]);
}

// Level 0 in linear values, times `factor`.
image::Image linearTexels(const Texture& texture, const vec3& factor) {
  image::Image image(texture.width, texture.height, 3);
  const std::vector<uint8_t>& bytes = texture.levels[0];
  const auto* reals = reinterpret_cast<const float*>(bytes.data());
  auto valueAt = [&](size_t i) {
    if (texture.format == Texture::Format::Rgba32f) return reals[i];
    const double stored = bytes[i] / 255.0;
    return float(texture.format == Texture::Format::Rgba8Srgb ? linearFromSrgb(stored) : stored);
  };
  for (size_t pixel = 0; pixel < size_t(texture.width) * size_t(texture.height); ++pixel)
    for (size_t c = 0; c < 3; ++c) image.values[3 * pixel + c] = factor[int(c)] * valueAt(4 * pixel + c);
  return image;
}

// Radiance by direction, from +y (first row) to -y.
image::Image gradientOf(const Environment& environment) {
  image::Image image(8, 256, 3);
  for (int y = 0; y < image.height; ++y) {
    const double up = std::cos(kPi * (y + 0.5) / image.height);
    const vec3 radiance = glm::mix(environment.ground, environment.sky, float(0.5 + 0.5 * up));
    for (int x = 0; x < image.width; ++x)
      for (int c = 0; c < 3; ++c) image.at(x, y, c) = radiance[c];
  }
  return image;
}

// Poses of all objects during the exposure.
class Paths {
 public:
  Paths(const Scene& scene, const std::function<Pose(double)>& pose_at, const FrameView& frame)
      : instances_(instancesOf(scene)), height_(frame.height) {
    for (const Mesh& mesh : scene.meshes) bounds_.push_back(vertexBounds(mesh));
    for (size_t i = 0; i < kPathTimes; ++i) {
      poses_.push_back(pose_at(glm::mix(frame.open_s, frame.close_s, double(i) / double(kPathTimes - 1))));
      poses_.back().bends.clear();
      addSizes(poses_.back());
    }
  }

  // At the times of a path (scene/key_search.h), without deformation.
  const std::vector<Pose>& poses() const { return poses_; }
  // Distance of the farthest corner of a bound from the camera, metres.
  double farthest() const { return farthest_; }

  template <class TransformOf>
  std::vector<dmat4> pathOf(const TransformOf& transform_of) const {
    std::vector<dmat4> path;
    for (const Pose& pose : poses_) path.push_back(transform_of(pose));
    return path;
  }

  // Keys of an instance, with their deviation, px. Nothing for a sheared instance that moves.
  std::optional<Keys> keysOfInstance(size_t index) const {
    const auto path = pathOf([&](const Pose& pose) { return pose.world_from_instance[index]; });
    const Bounds& own = bounds_[size_t(instances_[index].mesh)];
    const bool moves = std::any_of(path.begin(), path.end(), [&](const dmat4& one) { return one != path[0]; });
    if (!moves || own.empty()) return Keys{{path[0]}, 0};
    if (std::any_of(path.begin(), path.end(), isSheared)) return std::nullopt;
    return keysOf(path, kDeviation_px, [&](size_t time, const dmat4& between) {
      double deviation = 0;
      for (int k = 0; k < 8; ++k)
        deviation = std::max(deviation, glm::length((between - path[time]) * dvec4(own.corner(k), 1)));
      return deviation / pixelAt(poses_[time], boxOf(index, poses_[time]));
    });
  }

  // Keys of a camera or a light. A deviation of the position is measured at the distance of the nearest object, a
  // deviation of the axes for a field of view of one radian.
  std::vector<dmat4> keysOfView(const std::vector<dmat4>& path) const {
    auto deviation = [&](size_t time, const dmat4& between) {
      double turned = 0;
      for (int c = 0; c < 3; ++c) turned = std::max(turned, glm::length(between[c] - path[time][c]));
      return turned * height_ + glm::length(between[3] - path[time][3]) / nearest_pixel_[time];
    };
    return keysOf(path, kDeviation_px, deviation).transforms;
  }

 private:
  static constexpr double kDeviation_px = 0.001;

  // World bounds of an instance.
  Bounds boxOf(size_t index, const Pose& pose) const {
    return bounds_[size_t(instances_[index].mesh)].transformed(pose.world_from_instance[index]);
  }

  // Size of a pixel at the nearest point of a box, metres.
  double pixelAt(const Pose& pose, const Bounds& box) const {
    const Camera& camera = pose.camera;
    if (camera.orthographic) return 2 * camera.half_height / height_;
    const dvec3 eye(pose.world_from_camera[3]);
    const double distance = glm::length(eye - glm::clamp(eye, box.low, box.high));
    return 2 * std::tan(camera.vertical_fov / 2) / height_ * std::max(distance, camera.near);
  }

  void addSizes(const Pose& pose) {
    const dvec3 eye(pose.world_from_camera[3]);
    farthest_ = std::max(farthest_, 4 * pose.camera.near);
    nearest_pixel_.push_back(HUGE_VAL);
    for (size_t i = 0; i < instances_.size(); ++i) {
      const Bounds box = boxOf(i, pose);
      if (box.empty()) continue;
      for (int k = 0; k < 8; ++k) farthest_ = std::max(farthest_, glm::length(box.corner(k) - eye));
      nearest_pixel_.back() = std::min(nearest_pixel_.back(), pixelAt(pose, box));
    }
  }

  const std::vector<Instance> instances_;
  const int height_;            // of the picture, px
  std::vector<Bounds> bounds_;  // by mesh
  std::vector<Pose> poses_;
  double farthest_ = 0;
  std::vector<double> nearest_pixel_;  // by time: size of a pixel at the nearest object, metres
};

class Exporter {
 public:
  Exporter(const Scene& scene, const std::function<Pose(double)>& pose_at, const FrameView& frame, const Path& folder)
      : scene_(scene),
        frame_(frame),
        folder_(folder),
        instances_(instancesOf(scene)),
        raster_(pose_at(frame.raster_s)),
        paths_(scene, pose_at, frame) {
    for (const Instance& instance : instances_)
      for (const Geometry& geometry : meshOf(instance).geometries) used_.insert(size_t(geometry.material));
    is_unlit_ = std::all_of(used_.begin(), used_.end(), [&](size_t i) { return scene.materials[i].unlit; });
  }

  MitsubaExport write() {
    xml_.open("scene", {{"version", "3.0.0"}});
    writeIntegrator();
    writeSensor();
    writeBackground();
    for (size_t i = 0; i < raster_.lights.size(); ++i) writeLight(i);
    for (size_t i : used_) writeMaterial(i);
    for (size_t i = 0; i < instances_.size(); ++i) writeInstance(i);
    xml_.close();
    checkShading();
    return finish();
  }

 private:
  const Mesh& meshOf(const Instance& instance) const { return scene_.meshes[size_t(instance.mesh)]; }

  void leaveOut(const std::string& what, const std::string& name = "") { left_out_[what].insert(name); }

  void writeTransform(const std::vector<dmat4>& keys) {
    const bool moves = keys.size() > 1;
    if (moves) xml_.open("animation", {{"name", "to_world"}});
    for (size_t k = 0; k < keys.size(); ++k) {
      if (moves) xml_.open("transform", {{"time", fmt::format("{}", double(k) / double(keys.size() - 1))}});
      else xml_.open("transform", {{"name", "to_world"}});
      xml_.empty("matrix", {{"value", numberList(keys[k])}});
      xml_.close();
    }
    if (moves) xml_.close();
  }

  // ---- picture

  void writeIntegrator() {
    xml_.open("integrator", {{"type", is_unlit_ ? "aov" : "path"}});
    if (is_unlit_) xml_.value("string", "aovs", "color:albedo");
    else xml_.value("integer", "max_depth", "2");
    xml_.close();
  }

  void writeSensor() {
    const Camera& camera = raster_.camera;
    const double half_width = camera.half_height * frame_.width / frame_.height;
    const dmat4 scale = glm::scale(dmat4(1), camera.orthographic ? dvec3(half_width, half_width, 1) : dvec3(1));
    xml_.open("sensor", {{"type", camera.orthographic ? "orthographic" : "perspective"}});
    writeTransform(paths_.keysOfView(
        paths_.pathOf([&](const Pose& pose) { return lookingAlongZ(pose.world_from_camera) * scale; })));
    if (!camera.orthographic) {
      xml_.value("float", "fov", fmt::format("{}", camera.vertical_fov * 180 / kPi));
      xml_.value("string", "fov_axis", "y");
    }
    xml_.value("float", "near_clip", fmt::format("{}", camera.near));
    xml_.value("float", "far_clip", fmt::format("{}", 4 * paths_.farthest()));
    xml_.value("float", "shutter_open", "0");
    xml_.value("float", "shutter_close", "1");
    writeFilm();
    xml_.close();
    for (const Pose& pose : paths_.poses())
      if (!(pose.camera == camera))
        leaveOut("changes of the lens (the file has the lens of the raster time)", camera.name);
  }

  void writeFilm() {
    xml_.open("sampler", {{"type", "independent"}});
    xml_.value("integer", "sample_count", "1024");
    xml_.close();
    xml_.open("film", {{"type", "hdrfilm"}});
    xml_.value("integer", "width", std::to_string(frame_.width));
    xml_.value("integer", "height", std::to_string(frame_.height));
    xml_.value("string", "pixel_format", "rgb");
    xml_.value("string", "component_format", "float32");
    xml_.empty("rfilter", {{"type", "box"}});
    xml_.close();
  }

  // ---- light

  void writeBackground() {
    const Environment& environment = scene_.environment;
    const bool even = environment.background || environment.sky == environment.ground;
    const vec3 radiance = environment.background.value_or(environment.sky);
    if (even && isBlack(radiance)) return;
    xml_.open("emitter", {{"type", even ? "constant" : "envmap"}});
    if (even) xml_.empty("rgb", {{"name", "radiance"}, {"value", numberList(radiance)}});
    else xml_.value("string", "filename", keepImage("background.exr", gradientOf(environment)));
    xml_.close();
    if (is_unlit_ && even) writeSurroundings(radiance);
    if (is_unlit_ && !even) leaveOut("the gradient of the background (black in the file, because the scene is unlit)");
  }

  // An image of colours shows only surfaces, so a sphere around the scene stands in for the background.
  void writeSurroundings(const vec3& radiance) {
    xml_.open("shape", {{"type", "sphere"}, {"id", "background"}});
    xml_.value("point", "center", numberList(vec3(raster_.world_from_camera[3])));
    xml_.value("float", "radius", fmt::format("{}", 2 * paths_.farthest()));
    xml_.open("bsdf", {{"type", "twosided"}});
    xml_.open("bsdf", {{"type", "diffuse"}});
    writeColor("reflectance", radiance, {}, "background_color");
    xml_.close(), xml_.close(), xml_.close();
  }

  void writeLight(size_t index) {
    const Light& light = raster_.lights[index];
    constexpr double kDegrees = 180 / kPi;
    const bool sun = light.type == Light::Type::Directional, spot = light.type == Light::Type::Spot;
    xml_.open("emitter", {{"type", sun    ? "directional"
                                   : spot ? "spot"
                                          : "point"},
                          {"id", idOf("light", index, light.name)}});
    writeTransform(paths_.keysOfView(
        paths_.pathOf([&](const Pose& pose) { return lookingAlongZ(pose.world_from_light[index]); })));
    xml_.empty("rgb", {{"name", sun ? "irradiance" : "intensity"}, {"value", numberList(light.emitted())}});
    if (spot) xml_.value("float", "cutoff_angle", fmt::format("{}", light.outer_cone * kDegrees));
    if (spot) xml_.value("float", "beam_width", fmt::format("{}", light.inner_cone * kDegrees));
    xml_.close();
    checkLight(index, light);
  }

  void checkLight(size_t index, const Light& light) {
    if (is_unlit_) return;
    if (light.range > 0) leaveOut("ranges of lights", light.name);
    if (!light.shadow) leaveOut("lights without shadows (they cast shadows in the file)", light.name);
    if (light.type == Light::Type::Spot)
      leaveOut("the falloff between the cones of spot lights (linear in the angle in the file)", light.name);
    for (const Pose& pose : paths_.poses())
      if (!(pose.lights[index] == light))
        leaveOut("changes of lights (the file has the lights of the raster time)", light.name);
  }

  // ---- materials

  std::string keepImage(const std::string& name, const image::Image& image) {
    image::ExrFile file;
    file.add("", {"R", "G", "B"}, image);
    image::writeExr(folder_ / name, file);
    files_.push_back(folder_ / name);
    return name;
  }

  // A colour times a texture. Mitsuba allows reflectances above 1 only in textures.
  void writeColor(const std::string& name, const vec3& factor, const TextureUse& use, const std::string& file) {
    const bool even = use.texture < 0;
    const bool large = name == "reflectance" && std::max({factor.x, factor.y, factor.z}) > 1;
    if (even && !large) return xml_.empty("rgb", {{"name", name}, {"value", numberList(factor)}});
    image::Image texels(2, 2, 3);
    for (size_t i = 0; i < texels.values.size(); ++i) texels.values[i] = factor[int(i % 3)];
    if (!even) texels = linearTexels(scene_.textures[size_t(use.texture)], factor);
    xml_.open("texture", {{"type", "bitmap"}, {"name", name}});
    xml_.value("string", "filename", written_.insert(file).second ? keepImage(file + ".exr", texels) : file + ".exr");
    if (!even) writeSampler(scene_.textures[size_t(use.texture)]);
    xml_.close();
  }

  void writeSampler(const Texture& texture) {
    static constexpr const char* kWraps[] = {"repeat", "mirror", "clamp"};  // in the order of Texture::Wrap
    xml_.value("string", "filter_type", texture.magnify == Texture::Filter::Nearest ? "nearest" : "bilinear");
    xml_.value("string", "wrap_mode", kWraps[int(texture.wrap_u)]);
    if (texture.wrap_u != texture.wrap_v)
      leaveOut("different wrap modes of u and v (the file has the mode of u)", texture.name);
    if (texture.between != Texture::Levels::None || texture.minify != texture.magnify)
      leaveOut("minification filters of textures (all samples read the largest level)", texture.name);
  }

  void writeMaterial(size_t index) {
    const Material& material = scene_.materials[index];
    const float diffuse = material.unlit ? 1 : 1 - material.metallic;
    xml_.open("bsdf", {{"type", "twosided"}, {"id", idOf("material", index, material.name)}});
    xml_.open("bsdf", {{"type", "diffuse"}});
    writeColor("reflectance", vec3(material.base_color) * diffuse, material.base_color_texture,
               fmt::format("material_{}", index));
    xml_.close(), xml_.close();
    checkMaterial(material);
  }

  void checkMaterial(const Material& material) {
    if (material.alpha != Material::Alpha::Opaque) leaveOut("alpha of materials (opaque in the file)", material.name);
    if (!material.double_sided) leaveOut("back-face culling", material.name);
    if (material.unlit) return;
    leaveOut("specular reflection", material.name);
    if (material.normal_texture.texture >= 0) leaveOut("normal maps", material.name);
    if (material.metallic_roughness_texture.texture >= 0) leaveOut("metallic-roughness textures", material.name);
  }

  void checkShading() {
    if (is_unlit_) return;
    leaveOut("shading at the raster time (the file is shaded at each time, as with --shading full)");
    const Environment& environment = scene_.environment;
    if (!isBlack(environment.sky) || !isBlack(environment.ground))
      leaveOut("ambient light (in the file, the background lights surfaces)");
  }

  // ---- objects

  const TextureUse& textureOf(const Geometry& geometry) const {
    const Material& material = scene_.materials[size_t(geometry.material)];
    return material.base_color_texture.texture >= 0 ? material.base_color_texture : material.emissive_texture;
  }

  // PLY files of an instance: the files of its mesh, or separate files if it deforms.
  std::vector<std::string> meshFiles(size_t index) {
    const Instance& instance = instances_[index];
    std::vector<BentVertex> bent;
    if (bends(scene_, instance)) bent = bentVertices(scene_, instance, raster_.bends[index]);
    const BentVertex* next = bent.empty() ? nullptr : bent.data();
    const std::string stem = next ? fmt::format("deformed_{}", index) : fmt::format("mesh_{}", instance.mesh);
    std::vector<std::string> names;
    for (const Geometry& geometry : meshOf(instance).geometries) {
      names.push_back(fmt::format("{}_{}.ply", stem, names.size()));
      if (written_.insert(names.back()).second) {
        files_.push_back(folder_ / names.back());
        writeFileAtomically(files_.back(), plyOf(geometry, textureOf(geometry), next));
      }
      if (next) next += geometry.vertices.size();
    }
    return names;
  }

  // Makes a surface of a static object an emitter.
  void writeEmission(const Material& material, size_t index) {
    const bool unlit = material.unlit;
    xml_.open("emitter", {{"type", "area"}});
    writeColor("radiance", unlit ? vec3(material.base_color) : material.emissive,
               unlit ? material.base_color_texture : material.emissive_texture,
               fmt::format("{}_{}", unlit ? "material" : "emission", index));
    xml_.close();
    leaveOut(
        "emission of both sides, without light on other surfaces (in the file, front faces emit and light other "
        "surfaces)",
        material.name);
    const bool both = material.base_color_texture.texture >= 0 && material.emissive_texture.texture >= 0;
    if (both && !unlit) leaveOut("different texture coordinates of emission and base colour", material.name);
  }

  // Without keys, the geometry is part of a group, which moves.
  void writeGeometry(const Geometry& geometry, const std::string& file, const std::string& id,
                     const std::vector<dmat4>& keys) {
    const size_t index = size_t(geometry.material);
    const Material& material = scene_.materials[index];
    const bool emits = !is_unlit_ && (material.unlit || !isBlack(material.emissive)), still = !keys.empty();
    xml_.open("shape", {{"type", "ply"}, {"id", id}});
    xml_.value("string", "filename", file);
    if (geometry.faceted) xml_.value("boolean", "face_normals", "true");
    if (still) writeTransform(keys);
    if (still && emits && material.unlit) writeBlack();
    else xml_.empty("ref", {{"id", idOf("material", index, material.name)}});
    if (still && emits) writeEmission(material, index);
    xml_.close();
    if (!still && emits) leaveOut("emission of moving objects (unlit materials are lit in the file)", material.name);
    auto colored = [](const Vertex& vertex) { return vertex.color != vec4(1); };
    if (std::any_of(geometry.vertices.begin(), geometry.vertices.end(), colored))
      leaveOut("vertex colours", material.name);
  }

  void writeBlack() {
    xml_.open("bsdf", {{"type", "diffuse"}});
    xml_.empty("rgb", {{"name", "reflectance"}, {"value", "0, 0, 0"}});
    xml_.close();
  }

  // Keys of an instance. A sheared object that moves is static in the file, as at the raster time.
  std::vector<dmat4> keysOf(size_t index, const std::string& name) {
    const std::optional<Keys> keys = paths_.keysOfInstance(index);
    if (!keys) leaveOut("motion of sheared objects (the file has their poses at the raster time)", name);
    if (!keys) return {raster_.world_from_instance[index]};
    if (keys->deviation > 0.05)
      leaveOut(fmt::format("motion between {} keys", kMostKeys),
               fmt::format("{}: up to {:.2g} px", name, keys->deviation));
    return keys->transforms;
  }

  void writeShapes(size_t index, const std::string& id, const std::vector<dmat4>& keys) {
    const std::vector<Geometry>& geometries = meshOf(instances_[index]).geometries;
    const std::vector<std::string> names = meshFiles(index);
    for (size_t g = 0; g < geometries.size(); ++g)
      if (!geometries[g].indices.empty()) writeGeometry(geometries[g], names[g], fmt::format("{}_{}", id, g), keys);
  }

  std::string groupOf(size_t index) const {
    const Instance& instance = instances_[index];
    if (bends(scene_, instance)) return idOf("deformed", index, "");
    return idOf("mesh", size_t(instance.mesh), meshOf(instance).name);
  }

  // Static objects are shapes. Moving objects are instances of groups of shapes.
  void writeInstance(size_t index) {
    const std::string& name = scene_.nodes[size_t(instances_[index].node)].name;
    const std::string id = idOf("instance", index, name), group = groupOf(index);
    if (bends(scene_, instances_[index])) leaveOut("deformation (the file has the vertices of the raster time)", name);
    const std::vector<dmat4> keys = keysOf(index, name);
    if (keys.size() == 1) return writeShapes(index, id, keys);
    if (written_.insert("group " + group).second) {
      xml_.open("shape", {{"type", "shapegroup"}, {"id", group}});
      writeShapes(index, group, {});
      xml_.close();
    }
    xml_.open("shape", {{"type", "instance"}, {"id", id}});
    xml_.empty("ref", {{"id", group}});
    writeTransform(keys);
    xml_.close();
  }

  MitsubaExport finish() {
    MitsubaExport result{files_, {}};
    Xml head;
    head.comment(fmt::format("Strobe: scene {}. Time 0 is shutter open, time 1 is shutter close.", scene_.name));
    for (const auto& [what, names] : left_out_) {
      const std::string list = fmt::format("{}", fmt::join(names, ", "));
      result.left_out.push_back(list.empty() ? what : fmt::format("{}: {}", what, list));
      head.comment("Left out: " + result.left_out.back());
    }
    result.files.push_back(folder_ / "scene.xml");
    writeFileAtomically(result.files.back(),
                        "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n" + head.document() + xml_.document());
    return result;
  }

  const Scene& scene_;
  const FrameView frame_;
  const Path folder_;
  const std::vector<Instance> instances_;
  const Pose raster_;
  const Paths paths_;
  std::set<size_t> used_;  // materials in use
  bool is_unlit_ = false;  // true if all materials in use are unlit
  Xml xml_;
  std::vector<Path> files_;
  std::set<std::string> written_;                          // files and groups
  std::map<std::string, std::set<std::string>> left_out_;  // names, by the feature that is left out
};

}  // namespace

MitsubaExport exportMitsuba(const Scene& scene, const std::function<Pose(double)>& pose_at, const FrameView& frame,
                            const Path& folder) {
  return Exporter(scene, pose_at, frame, folder).write();
}

}  // namespace strobe::scene
