// SPDX-License-Identifier: MIT
#include "lab/capture.h"

#include "base/log.h"
#include "image/png.h"

namespace strobe::lab {

image::Image colorOf(const Picture& picture) { return image::threeChannels(picture.frame.outputs.at("color").floats); }

// How an output is called in a file: layer and components.
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

static void addLayer(image::ExrFile& file, const std::string& output, const graph::ReadImage& read, bool half) {
  bool uint = !read.uints.values.empty();
  int channels = uint ? read.uints.channels : read.floats.channels;
  LayerName name = layerName(output, channels);
  name.components.resize(size_t(channels));
  if (uint) file.add(name.layer, name.components, read.uints);
  else file.add(name.layer, name.components, read.floats, half ? image::ExrKind::half : image::ExrKind::real);
}

image::ExrFile exrOf(const Picture& picture, bool half) {
  image::ExrFile file;
  const image::Image& color = picture.frame.outputs.at("color").floats;
  file.width = color.width;
  file.height = color.height;
  for (const auto* images : {&picture.frame.outputs, &picture.frame.taps}) {
    for (const auto& [name, read] : *images) {
      int width = std::max(read.floats.width, read.uints.width);
      int height = std::max(read.floats.height, read.uints.height);
      if (width == file.width && height == file.height) addLayer(file, name, read, half);
      else
        warn(fmt::format("'{}' is {}x{}, not as large as the color, and is left out of the file", name, width, height));
    }
  }
  const Json& shot = picture.record["shot"];
  double fps = shot["fps"].get<double>(), exposure = shot["exposure"].get<double>();
  file.frames_per_second = std::array<int, 2>{int(std::lround(fps * 1000)), 1000};
  file.shutter_angle = float(360 * exposure);
  file.exposure_s = float(exposure / fps);
  file.camera_from_world = picture.camera_from_world;
  file.ndc_from_world = picture.ndc_from_world;
  file.texts["strobe"] = picture.record.dump();
  return file;
}

void checkPictureName(const Path& file) {
  std::string ending = file.extension().string();
  if (ending == ".exr" || ending == ".png") return;
  throw Error(fmt::format("--out '{}' ends in neither .exr nor .png", file.string()), {}, 2);
}

std::vector<Path> writePicture(const Picture& picture, const Path& file, bool half) {
  checkPictureName(file);
  auto beside = [&file](const char* ending) {
    Path other = file;
    return other.replace_extension(ending);
  };
  if (file.extension() == ".exr") image::writeExr(file, exrOf(picture, half));
  else image::writePng(file, image::toneMap(colorOf(picture)));
  std::vector<Path> written = {file, beside(".record.json"), beside(".timings.json")};
  writeFileAtomically(written[1], picture.record.dump(2) + "\n");
  writeFileAtomically(written[2], picture.timings.dump(2) + "\n");
  return written;
}

}  // namespace strobe::lab
