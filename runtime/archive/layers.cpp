// SPDX-License-Identifier: MIT
#include "archive/layers.h"

#include "lab/capture.h"
#include "lab/record.h"

namespace strobe::archive {

Json layersJson(const Images& images) {
  Json json = Json::object();
  for (const auto& [name, image] : images) {
    Json size = {std::max(image.floats.width, image.uints.width), std::max(image.floats.height, image.uints.height)};
    json[name] = {{"format", image.format}, {"size", std::move(size)}, {"hash", lab::hashOf(image)}};
  }
  return json;
}

void writeLayers(const Path& file, const lab::Picture& picture, const Json& record, const Images& images) {
  lab::Picture kept = picture;
  kept.record = record;
  kept.frame.outputs.clear(), kept.frame.taps.clear();
  for (const auto& [name, image] : images)
    (name.find('.') == std::string::npos ? kept.frame.outputs : kept.frame.taps)[name] = image;
  lab::ExrOptions options;
  options.multipart = true;
  image::writeExr(file, lab::exrOf(kept, options));
}

Images readLayers(const Path& file, const Json& layers) {
  Images images = lab::imagesOf(image::readExr(file), file);
  for (const auto& [name, layer] : layers.items()) {
    if (!images.count(name)) throw Error(fmt::format("has no layer '{}'", name), {file.string()});
    images[name].format = layer.at("format").get<std::string>();
    if (lab::hashOf(images[name]) != layer.at("hash").get<std::string>())
      throw Error(fmt::format("layer '{}' differs from the manifest", name), {file.string()});
  }
  return images;
}

}  // namespace strobe::archive
