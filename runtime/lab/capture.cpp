// SPDX-License-Identifier: MIT
#include "lab/capture.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/lists.h"
#include "base/log.h"
#include "image/cryptomatte.h"
#include "image/png.h"
#include "lab/limits.h"

namespace strobe::lab {

image::Image colorOf(const Picture& picture) { return image::threeChannels(picture.frame.outputs.at("color").floats); }

// Layer and channel names of an output in a file.
struct LayerName {
  std::string layer;
  std::vector<std::string> components;
};

static LayerName layerName(const std::string& output, int channels) {
  if (output == "color" && channels >= 3) return {"", {"R", "G", "B", "A"}};
  if (output == "depth" && channels == 1) return {"", {"Z"}};
  if (output == "normal") return {"N", {"X", "Y", "Z", "W"}};
  if (output == "id") return {"", {"id", "geometry", "primitive", "unused"}};
  if (channels == 1) return {output, {"Y"}};
  if (channels == 2) return {output, {"X", "Y"}};
  return {output, {"R", "G", "B", "A"}};
}

std::vector<std::string> componentNames(const std::string& output, int channels) {
  std::vector<std::string> names = layerName(output, channels).components;
  names.resize(size_t(channels));
  return names;
}

// ---- layers

static void addLayer(image::ExrPart& part, const std::string& output, const graph::ReadImage& read,
                     image::ExrKind kind) {
  LayerName name = layerName(output, read.channels());
  name.components.resize(size_t(read.channels()));
  if (read.isUint()) part.add(name.layer, name.components, read.uints);
  else part.add(name.layer, name.components, read.floats, kind);
}

// String attribute of a part: format of the image on the device.
static const char* const kFormat = "strobeFormat";

static image::ExrPart partOf(const std::string& output, const graph::ReadImage& read, image::ExrKind kind) {
  image::ExrPart part;
  part.name = output;
  part.texts[kFormat] = read.format;
  addLayer(part, output, read, kind);
  return part;
}

using Named = std::pair<std::string, const graph::ReadImage*>;

// Color first, then the other requested images, outputs before taps.
static std::vector<Named> chosen(const Picture& picture, const std::vector<std::string>& layers) {
  std::vector<Named> images = {{"color", &picture.frame.outputs.at("color")}};
  std::vector<std::string> known;
  for (const auto* all : {&picture.frame.outputs, &picture.frame.taps})
    for (const auto& [name, read] : *all) {
      known.push_back(name);
      bool wanted = layers.empty() || contains(layers, name);
      if (wanted && name != "color") images.push_back({name, &read});
    }
  for (const std::string& layer : layers)
    if (!contains(known, layer))
      throw Error(fmt::format("the picture has no output or tap '{}'{}; it has {}", layer, didYouMean(layer, known),
                              fmt::join(known, ", ")));
  return images;
}

// ---- mattes

static std::shared_ptr<const image::IdCoverage> coverageOf(const Picture& picture) {
  if (picture.id_coverage) return picture.id_coverage;
  auto ids = picture.frame.outputs.find("id");
  if (ids == picture.frame.outputs.end() || !ids->second.isUint())
    throw Error("the picture has no output 'id' of integers, which mattes need");
  STROBE_ASSERT(picture.record["shot"].value("aa", 1) == 1, "the ids of the other samples are lost");
  auto seen = std::make_shared<image::IdCoverage>();
  seen->add(ids->second.uints);
  return seen;
}

static std::vector<image::CryptomatteLayer> mattesOf(const std::vector<IdName>& ids) {
  std::vector<std::string> nodes, materials;
  for (const IdName& id : ids) {
    nodes.push_back(id.node);
    materials.insert(materials.end(), id.materials.begin(), id.materials.end());
  }
  return {{"CryptoObject", nodes, [&ids](image::IdShare seen) { return nodeOf(ids, seen.instance); }},
          {"CryptoMaterial", materials,
           [&ids](image::IdShare seen) { return materialOf(ids, seen.instance, seen.geometry); }}};
}

// Part for the layers of `name`: a new part if `multipart`, otherwise the first part.
static image::ExrPart& placeFor(image::ExrFile& file, const std::string& name, bool multipart) {
  if (!multipart) return file;
  file.further.emplace_back().name = name;
  return file.further.back();
}

static void addMattes(image::ExrFile& file, const Picture& picture, bool multipart) {
  std::shared_ptr<const image::IdCoverage> seen = coverageOf(picture);
  for (const image::CryptomatteLayer& layer : mattesOf(picture.id_names)) {
    image::ExrPart& part = placeFor(file, layer.name, multipart);
    size_t crowded = image::addCryptomatte(part, layer, *seen);
    if (crowded > 0)
      warn(fmt::format("{}: {} pixels have more than six mattes; the smallest mattes are left out", layer.name,
                       crowded));
    image::addCryptomatteTexts(file.texts, layer);
    if (multipart) image::addCryptomatteTexts(part.texts, layer);
  }
  if (!picture.frame.outputs.count("coverage"))
    placeFor(file, "coverage", multipart).add("coverage", {"Y"}, image::coverageOf(*seen));
}

// ---- files

// Warning about values beyond the range of 16-bit floats, or "".
static std::string clampedWarning(const image::ExrFile& file) {
  size_t clamped = 0;
  for (const image::ExrPart* part : file.parts()) clamped += part->clamped;
  return clamped == 0 ? "" : kHalfClampedLimit.text(fmt::format("{} values are beyond 65504", clamped));
}

// Record of the picture, with the warnings of its file.
static Json recordIn(const image::ExrFile& file, const Picture& picture) {
  Json record = picture.record;
  if (std::string warning = clampedWarning(file); !warning.empty()) record["warnings"].push_back(warning);
  return record;
}

static void describe(image::ExrFile& file, const Picture& picture) {
  const Json& shot = picture.record["shot"];
  double fps = shot["fps"].get<double>(), exposure = shot["exposure"].get<double>();
  int per_1000_s = int(std::lround(fps * 1000)), divisor = std::gcd(per_1000_s, 1000);
  file.frames_per_second = std::array<int, 2>{per_1000_s / divisor, 1000 / divisor};
  file.shutter_angle = float(360 * exposure);
  file.exposure_s = float(exposure / fps);
  file.camera_from_world = picture.camera_from_world;
  file.ndc_from_world = picture.ndc_from_world;
  file.texts["strobe"] = recordIn(file, picture).dump();
  if (!picture.id_names.empty()) file.texts["strobeIds"] = toJson(picture.id_names).dump();
}

// Sorts the images: float images of the color's size first, integer images of this size next, others last. Blender
// stops reading at a part with integers. Returns the first image outside the first group.
static std::vector<Named>::iterator sortedForReaders(std::vector<Named>& images, const Picture& picture) {
  const image::Image& color = picture.frame.outputs.at("color").floats;
  auto whole = [&](const Named& image) {
    return image.second->width() == color.width && image.second->height() == color.height;
  };
  auto rest = std::stable_partition(images.begin(), images.end(),
                                    [&](const Named& image) { return whole(image) && !image.second->isUint(); });
  std::stable_partition(rest, images.end(), whole);
  return rest;
}

static void addPart(image::ExrFile& file, image::ExrPart part) {
  if (file.channels.empty()) static_cast<image::ExrPart&>(file) = std::move(part);
  else file.further.push_back(std::move(part));
}

image::ExrFile exrOf(const Picture& picture, const ExrOptions& options) {
  image::ExrFile file;
  image::ExrKind kind = options.half ? image::ExrKind::half : image::ExrKind::real;
  auto add = [&](const Named& image) {
    const auto& [name, read] = image;
    if (options.multipart) addPart(file, partOf(name, *read, kind));
    else if (file.channels.empty() || (read->width() == file.width && read->height() == file.height))
      addLayer(file, name, *read, kind);
    else
      warn(fmt::format("'{}' is {}x{}, not as large as the color, and is left out of the file; --multipart keeps it",
                       name, read->width(), read->height()));
  };
  std::vector<Named> images = chosen(picture, options.layers);
  auto rest = sortedForReaders(images, picture);
  std::for_each(images.begin(), rest, add);
  if (options.cryptomatte) addMattes(file, picture, options.multipart);
  std::for_each(rest, images.end(), add);
  if (std::string warning = clampedWarning(file); !warning.empty()) warn(warning);
  describe(file, picture);
  return file;
}

static graph::ReadImage imageOf(const image::ExrPart& part, const Path& file) {
  LayerName name = layerName(part.name, int(part.channels.size()));
  name.components.resize(part.channels.size());
  for (std::string& component : name.components)
    if (!name.layer.empty()) component = name.layer + "." + component;
  graph::ReadImage read;
  read.format = part.texts.at(kFormat);
  if (part.channels.front().kind == image::ExrKind::uint) read.uints = image::idsOf(part, name.components, file);
  else read.floats = image::channelsOf(part, name.components, file);
  return read;
}

std::map<std::string, graph::ReadImage> imagesOf(const image::ExrFile& content, const Path& file) {
  std::map<std::string, graph::ReadImage> images;
  for (const image::ExrPart* part : content.parts())
    if (part->texts.count(kFormat)) images[part->name] = imageOf(*part, file);
  if (images.empty()) throw Error("has no part that is an output or a tap", {file.string()});
  return images;
}

void checkPictureName(const Path& file) {
  std::string ending = file.extension().string();
  if (ending == ".exr" || ending == ".png") return;
  throw Error(fmt::format("--out '{}' ends in neither .exr nor .png", file.string()), {}, 2);
}

std::vector<Path> writePicture(const Picture& picture, const Path& file, const ExrOptions& options) {
  checkPictureName(file);
  auto beside = [&file](const char* ending) {
    Path other = file;
    return other.replace_extension(ending);
  };
  Json record = picture.record;
  if (file.extension() == ".exr") {
    image::ExrFile content = exrOf(picture, options);
    record = recordIn(content, picture);
    image::writeExr(file, content);
  } else {
    image::writePng(file, image::toneMap(colorOf(picture)));
  }
  std::vector<Path> written = {file, beside(".record.json"), beside(".timings.json")};
  writeFileAtomically(written[1], record.dump(2) + "\n");
  writeFileAtomically(written[2], picture.timings.dump(2) + "\n");
  return written;
}

}  // namespace strobe::lab
