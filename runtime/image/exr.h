// SPDX-License-Identifier: MIT
// OpenEXR files: one part or several, any number of layers. A channel's name is its layer and component ("R",
// "velocity.X"), in a part of its own too: programs take layers from there.
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
#include "image/primaries.h"

namespace strobe::image {

enum class ExrKind { real, half, uint };  // stored as 32-bit float, 16-bit float, 32-bit unsigned integer

struct ExrChannel {
  std::string name;
  ExrKind kind = ExrKind::real;
  std::vector<float> values;  // width * height, top row first; empty for `uint`
  std::vector<uint32_t> ids;  // the same for `uint`; empty otherwise
};

// Channels of one size.
struct ExrPart {
  std::string name;  // unique among several; of a single part also ""
  int x = 0, y = 0;  // of the top left pixel in the display window of the file
  int width = 0;
  int height = 0;
  std::vector<ExrChannel> channels;
  std::map<std::string, std::string> texts;  // string attributes (the run record among them)

  const ExrChannel* find(const std::string& channel) const;  // nullptr when absent

  size_t clamped = 0;  // finite values beyond the 65504 of a half float, which are stored as that

  // Adds the channels of `image` as layer.component, or without a layer when it is empty; `components` has one letter
  // or "name" per channel of the image. Sets the size of an empty part, asserts it otherwise.
  void add(const std::string& layer, const std::vector<std::string>& components, const Image& image,
           ExrKind kind = ExrKind::real);
  void add(const std::string& layer, const std::vector<std::string>& components, const UintImage& image);
};

// The whole content of a file: its first part, what holds for all parts, and the parts that follow. The standard
// attributes keep the meaning OpenEXR gives them, and stand in every part.
struct ExrFile : ExrPart {
  std::vector<ExrPart> further;
  int display_width = 0, display_height = 0;            // display window of all parts; 0: as large as the first
  std::optional<Primaries> primaries;                   // chromaticities; none: Rec. 709
  std::optional<std::array<int, 2>> frames_per_second;  // numerator, denominator
  std::optional<float> shutter_angle;                   // degrees
  std::optional<float> exposure_s;                      // expTime
  std::optional<glm::mat4> camera_from_world;           // worldToCamera
  std::optional<glm::mat4> ndc_from_world;              // worldToNDC

  std::vector<const ExrPart*> parts() const;                // in the order of the file
  const ExrPart* part(const std::string& part_name) const;  // nullptr when absent
};

// ZIP compression, no date: the bytes depend on nothing but the content.
std::string encodeExr(const ExrFile& content);
void writeExr(const Path& file, const ExrFile& content);

// Reads any flat file, scan lines or tiles; the data window of a part becomes its image, with its place in the display
// window.
// Throws `Error` naming the file when it is missing, cut short, not an OpenEXR, deep or subsampled.
ExrFile readExr(const Path& file);

// The part alone that has a layer: the one of that name, else the first with channels of the layer, else the first.
// Other parts may be what `readExr` refuses.
ExrFile readExrLayer(const Path& file, const std::string& layer);

// The colour of a layer ("" is the unnamed one) as RGB; the name of a part is that of its first layer too. A layer with
// neither R, G, B but a single channel, or Y, becomes grey RGB. Throws `Error` (place: `file`) listing the channels
// there are when it is absent.
Image colourOf(const ExrPart& content, const std::string& layer, const Path& file);

// The named channels as one image; throws `Error` as above, with the nearest name.
Image channelsOf(const ExrPart& content, const std::vector<std::string>& names, const Path& file);
UintImage idsOf(const ExrPart& content, const std::vector<std::string>& names, const Path& file);

}  // namespace strobe::image
