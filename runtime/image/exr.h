// SPDX-License-Identifier: MIT
// OpenEXR files: one part, any number of layers. A channel's name is its layer and component ("R", "velocity.X").
#pragma once

#include <array>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/files.h"
#include "image/image.h"

namespace strobe::image {

enum class ExrKind { real, half, uint };  // stored as 32-bit float, 16-bit float, 32-bit unsigned integer

struct ExrChannel {
  std::string name;
  ExrKind kind = ExrKind::real;
  std::vector<float> values;  // width * height, top row first; empty for `uint`
  std::vector<uint32_t> ids;  // the same for `uint`; empty otherwise
};

// The whole content of a file. The standard attributes keep the meaning OpenEXR gives them.
struct ExrFile {
  int width = 0;
  int height = 0;
  std::vector<ExrChannel> channels;
  std::map<std::string, std::string> texts;             // string attributes (the run record among them)
  std::optional<std::array<int, 2>> frames_per_second;  // numerator, denominator
  std::optional<float> shutter_angle;                   // degrees
  std::optional<float> exposure_s;                      // expTime
  std::optional<glm::mat4> camera_from_world;           // worldToCamera
  std::optional<glm::mat4> ndc_from_world;              // worldToNDC

  const ExrChannel* find(const std::string& name) const;  // nullptr when absent

  // Adds the channels of `image` as layer.component, or without a layer when it is empty; `components` has one letter
  // or "name" per channel of the image. Sets the size of an empty file, asserts it otherwise.
  void add(const std::string& layer, const std::vector<std::string>& components, const Image& image,
           ExrKind kind = ExrKind::real);
  void add(const std::string& layer, const std::vector<std::string>& components, const UintImage& image);
};

// ZIP compression, no date: the bytes depend on nothing but the content.
std::string encodeExr(const ExrFile& content);
void writeExr(const Path& file, const ExrFile& content);

// Reads any flat file (the first part of several), scan lines or tiles; the data window becomes the image.
// Throws `Error` naming the file when it is missing, cut short, not an OpenEXR, deep or subsampled.
ExrFile readExr(const Path& file);

// The colour of a layer ("" is the unnamed one) as RGB. A layer with neither R, G, B but a single channel, or Y,
// becomes grey RGB. Throws `Error` (place: `file`) listing the layers there are when it is absent.
Image colourOf(const ExrFile& content, const std::string& layer, const Path& file);

// The named channels as one image; throws `Error` as above, with the nearest name.
Image channelsOf(const ExrFile& content, const std::vector<std::string>& names, const Path& file);
UintImage idsOf(const ExrFile& content, const std::vector<std::string>& names, const Path& file);

}  // namespace strobe::image
