// SPDX-License-Identifier: MIT
// OpenEXR files with one or several parts and any number of layers. The name of a channel is LAYER.COMPONENT
// ("velocity.X") or COMPONENT ("R"). Parts with a name keep the full channel names, because programs derive layers from
// channel names.
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

// Pixel type of an OpenEXR channel.
enum class ExrKind { real, half, uint };  // stored as 32-bit float, 16-bit float, 32-bit unsigned integer

// One channel of an OpenEXR part: full name, pixel type and the values of all pixels.
struct ExrChannel {
  std::string name;
  ExrKind kind = ExrKind::real;
  std::vector<float> values;  // width * height, top row first; empty for `uint`
  std::vector<uint32_t> ids;  // values of `uint`; empty for other kinds
};

// Part of a file: channels of one size.
struct ExrPart {
  std::string name;  // unique in a file of several parts; a single part may have ""
  int x = 0, y = 0;  // position of the top left pixel in the display window of the file
  int width = 0;
  int height = 0;
  std::vector<ExrChannel> channels;
  std::map<std::string, std::string> texts;  // string attributes (the run record among them)

  const ExrChannel* find(const std::string& channel) const;  // nullptr when absent

  size_t clamped = 0;  // number of finite values beyond the largest half float, stored as 65504

  // Adds the channels of `image` as LAYER.COMPONENT, or as COMPONENT if `layer` is empty. `components` has one letter
  // or "name" per channel of the image. Sets the size of an empty part; asserts the size of others.
  void add(const std::string& layer, const std::vector<std::string>& components, const Image& image,
           ExrKind kind = ExrKind::real);
  void add(const std::string& layer, const std::vector<std::string>& components, const UintImage& image);
};

// Content of a file: its first part, the attributes of all parts, and the further parts. The standard attributes have
// the meaning that OpenEXR defines, and every part has them.
struct ExrFile : ExrPart {
  std::vector<ExrPart> further;
  int display_width = 0, display_height = 0;            // display window of all parts; 0: size of the first part
  std::optional<Primaries> primaries;                   // chromaticities; absent: Rec. 709
  std::optional<std::array<int, 2>> frames_per_second;  // numerator, denominator
  std::optional<float> shutter_angle;                   // degrees
  std::optional<float> exposure_s;                      // expTime
  std::optional<glm::mat4> camera_from_world;           // worldToCamera
  std::optional<glm::mat4> ndc_from_world;              // worldToNDC

  std::vector<const ExrPart*> parts() const&;               // in the order of the file
  std::vector<const ExrPart*> parts() && = delete;          // the parts would end with the file
  const ExrPart* part(const std::string& part_name) const;  // nullptr when absent
};

// Encodes with ZIP compression and without a date, so that equal content gives equal bytes.
std::string encodeExr(const ExrFile& content);
void writeExr(const Path& file, const ExrFile& content);

// Reads a flat file with scan lines or tiles. The image of a part is its data window, with its place in the display
// window. Throws `Error` naming the file if it is missing, cut short, not an OpenEXR, deep or subsampled.
ExrFile readExr(const Path& file);

// Reads one part: the part with the name of the layer, else the first part with channels of the layer, else the first
// part. Other parts may have content that `readExr` refuses.
ExrFile readExrLayer(const Path& file, const std::string& layer);

// Colour of a layer as RGB; "" is the unnamed layer. The name of a part selects its first layer too. A layer without R,
// G, B that has Y or a single channel becomes grey RGB. Throws `Error` (place: `file`) with the list of channels if the
// layer is absent.
Image colourOf(const ExrPart& content, const std::string& layer, const Path& file);

// Named channels as one image. Throws `Error` with the nearest name if a channel is absent.
Image channelsOf(const ExrPart& content, const std::vector<std::string>& names, const Path& file);
UintImage idsOf(const ExrPart& content, const std::vector<std::string>& names, const Path& file);

}  // namespace strobe::image
