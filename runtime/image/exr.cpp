// SPDX-License-Identifier: MIT
#include "image/exr.h"

#include <ImfChannelList.h>
#include <ImfChromaticitiesAttribute.h>
#include <ImfFloatAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputPart.h>
#include <ImfMatrixAttribute.h>
#include <ImfMultiPartInputFile.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>
#include <ImfRationalAttribute.h>
#include <ImfStdIO.h>
#include <ImfStringAttribute.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <glm/gtc/type_ptr.hpp>
#include <set>
#include <stdexcept>

#include "base/error.h"

namespace strobe::image {
namespace {

// OpenEXR multiplies row vectors from the left, so its matrices have the memory layout of GLM matrices.
Imath::M44f toExr(const glm::mat4& matrix) {
  Imath::M44f result;
  std::memcpy(result.getValue(), glm::value_ptr(matrix), sizeof result);
  return result;
}

glm::mat4 fromExr(const Imath::M44f& matrix) { return glm::make_mat4(&matrix[0][0]); }

Imf::PixelType pixelType(ExrKind kind) {
  if (kind == ExrKind::uint) return Imf::UINT;
  return kind == ExrKind::half ? Imf::HALF : Imf::FLOAT;
}

void insertAttributes(const ExrFile& content, Imf::Header& header) {
  if (content.frames_per_second) {
    auto [numerator, denominator] = *content.frames_per_second;
    header.insert("framesPerSecond", Imf::RationalAttribute(Imf::Rational(numerator, unsigned(denominator))));
  }
  if (content.primaries) {
    auto exr = [](glm::dvec2 point) { return Imath::V2f(float(point.x), float(point.y)); };
    const Primaries& p = *content.primaries;
    Imf::Chromaticities stated(exr(p.red), exr(p.green), exr(p.blue), exr(p.white));
    header.insert("chromaticities", Imf::ChromaticitiesAttribute(stated));
  }
  if (content.shutter_angle) header.insert("shutterAngle", Imf::FloatAttribute(*content.shutter_angle));
  if (content.exposure_s) header.insert("expTime", Imf::FloatAttribute(*content.exposure_s));
  if (content.camera_from_world) header.insert("worldToCamera", Imf::M44fAttribute(toExr(*content.camera_from_world)));
  if (content.ndc_from_world) header.insert("worldToNDC", Imf::M44fAttribute(toExr(*content.ndc_from_world)));
}

Imath::Box2i windowOf(const ExrPart& part) {
  return {{part.x, part.y}, {part.x + part.width - 1, part.y + part.height - 1}};
}

Imath::Box2i displayOf(const ExrFile& content) {
  if (content.display_width == 0) return {{0, 0}, {content.width - 1, content.height - 1}};
  return {{0, 0}, {content.display_width - 1, content.display_height - 1}};
}

Imf::Header headerOf(const ExrPart& part, const ExrFile& content) {
  Imf::Header header(displayOf(content), windowOf(part));
  header.compression() = Imf::ZIP_COMPRESSION;
  if (!part.name.empty()) header.setName(part.name);
  if (!content.further.empty()) header.setType(Imf::SCANLINEIMAGE);
  for (const ExrChannel& channel : part.channels)
    header.channels().insert(channel.name, Imf::Channel(pixelType(channel.kind)));
  for (const auto& [name, text] : part.texts) header.insert(name, Imf::StringAttribute(text));
  insertAttributes(content, header);
  return header;
}

// Pixels of a part in the form that OpenEXR writes. Refers to the part.
struct PartSource {
  std::vector<std::vector<half>> halfs;
  Imf::FrameBuffer frame;

  explicit PartSource(const ExrPart& part);
};

PartSource::PartSource(const ExrPart& part) {
  STROBE_ASSERT(part.width > 0 && part.height > 0 && !part.channels.empty(), "{}x{}, {} channels", part.width,
                part.height, part.channels.size());
  size_t pixels = size_t(part.width) * part.height;
  std::set<std::string> names;
  halfs.reserve(part.channels.size());
  for (const ExrChannel& channel : part.channels) {
    bool uint = channel.kind == ExrKind::uint;
    STROBE_ASSERT((uint ? channel.ids.size() : channel.values.size()) == pixels, "channel {}", channel.name);
    STROBE_ASSERT(names.insert(channel.name).second, "two channels are named {}", channel.name);
    size_t bytes = 4;
    const void* data = uint ? static_cast<const void*>(channel.ids.data()) : channel.values.data();
    if (channel.kind == ExrKind::half) {
      data = halfs.emplace_back(channel.values.begin(), channel.values.end()).data();
      bytes = sizeof(half);
    }
    frame.insert(channel.name,
                 Imf::Slice::Make(pixelType(channel.kind), data, windowOf(part), bytes, bytes * size_t(part.width)));
  }
}

void writeParts(const ExrFile& content, Imf::OStream& stream) {
  std::set<std::string> names;
  std::vector<Imf::Header> headers;
  for (const ExrPart* part : content.parts()) {
    STROBE_ASSERT(!part->name.empty() && names.insert(part->name).second, "two parts are named '{}'", part->name);
    headers.push_back(headerOf(*part, content));
  }
  Imf::MultiPartOutputFile output(stream, headers.data(), int(headers.size()), false, 0);
  int index = 0;
  for (const ExrPart* part : content.parts()) {
    PartSource source(*part);
    Imf::OutputPart written(output, index++);
    written.setFrameBuffer(source.frame);
    written.writePixels(part->height);
  }
}

// String attributes of a part. `name` and `type` are left out, because OpenEXR itself describes a part by them.
std::map<std::string, std::string> textsIn(const Imf::Header& header) {
  std::map<std::string, std::string> texts;
  for (auto it = header.begin(); it != header.end(); ++it) {
    auto* text = dynamic_cast<const Imf::StringAttribute*>(&it.attribute());
    std::string name = it.name();
    if (text && name != "name" && name != "type") texts[name] = text->value();
  }
  return texts;
}

void readAttributes(const Imf::Header& header, ExrFile& content) {
  if (auto* rate = header.findTypedAttribute<Imf::RationalAttribute>("framesPerSecond"))
    content.frames_per_second = {rate->value().n, static_cast<int>(rate->value().d)};
  if (auto* angle = header.findTypedAttribute<Imf::FloatAttribute>("shutterAngle"))
    content.shutter_angle = angle->value();
  if (auto* time = header.findTypedAttribute<Imf::FloatAttribute>("expTime")) content.exposure_s = time->value();
  if (auto* matrix = header.findTypedAttribute<Imf::M44fAttribute>("worldToCamera"))
    content.camera_from_world = fromExr(matrix->value());
  if (auto* matrix = header.findTypedAttribute<Imf::M44fAttribute>("worldToNDC"))
    content.ndc_from_world = fromExr(matrix->value());
  if (auto* stated = header.findTypedAttribute<Imf::ChromaticitiesAttribute>("chromaticities")) {
    const Imf::Chromaticities& c = stated->value();
    content.primaries = {{c.red.x, c.red.y}, {c.green.x, c.green.y}, {c.blue.x, c.blue.y}, {c.white.x, c.white.y}};
  }
  Imath::Box2i display = header.displayWindow();
  content.display_width = display.max.x - display.min.x + 1;
  content.display_height = display.max.y - display.min.y + 1;
}

// A header may state any size, so the size is checked before memory is allocated. Even a constant image in OpenEXR's
// densest compression (256 lines to a block) stays below a factor of 65536.
void checkSize(const Imath::Box2i& window, size_t channel_count, size_t file_bytes) {
  int64_t width = int64_t(window.max.x) - window.min.x + 1;
  int64_t height = int64_t(window.max.y) - window.min.y + 1;
  constexpr int64_t kMaxSide = 65536, kMaxBytes = int64_t(16) << 30, kMaxFactor = 65536;
  if (width < 1 || height < 1 || width > kMaxSide || height > kMaxSide)
    throw std::runtime_error(fmt::format("its size of {}x{} is not in the range from 1 to 65536", width, height));
  int64_t bytes = width * height * 4 * int64_t(channel_count);
  if (bytes > kMaxBytes) throw std::runtime_error("it has more than 16 GiB of pixels");
  if (bytes / kMaxFactor > int64_t(file_bytes))
    throw std::runtime_error(
        fmt::format("its size of {}x{} is too large for a file of {} bytes", width, height, file_bytes));
}

ExrChannel emptyChannel(const std::string& name, const Imf::Channel& described, size_t pixels) {
  if (described.xSampling != 1 || described.ySampling != 1)
    throw std::runtime_error(fmt::format("channel '{}' is subsampled, which is not supported", name));
  ExrChannel channel{name, ExrKind::real, {}, {}};
  if (described.type == Imf::UINT) channel.kind = ExrKind::uint;
  if (described.type == Imf::HALF) channel.kind = ExrKind::half;
  if (channel.kind == ExrKind::uint) channel.ids.resize(pixels);
  else channel.values.resize(pixels);
  return channel;
}

// Points OpenEXR at the memory of `channel`. OpenEXR converts half floats when it reads; encodeExr converts them before
// it writes.
void insertSlice(Imf::FrameBuffer& frame, ExrChannel& channel, const Imath::Box2i& window) {
  size_t width = static_cast<size_t>(window.max.x - window.min.x + 1);
  bool uint = channel.kind == ExrKind::uint;
  char* data = uint ? reinterpret_cast<char*>(channel.ids.data()) : reinterpret_cast<char*>(channel.values.data());
  frame.insert(channel.name, Imf::Slice::Make(uint ? Imf::UINT : Imf::FLOAT, data, window, 4, 4 * width));
}

ExrPart decodedPart(Imf::MultiPartInputFile& input, int index, size_t file_bytes) {
  const Imf::Header& header = input.header(index);
  if (header.hasType() && Imf::isDeepData(header.type()))
    throw std::runtime_error("it has deep pixels, which are not supported");
  Imath::Box2i window = header.dataWindow();
  size_t channel_count = 0;
  for (auto it = header.channels().begin(); it != header.channels().end(); ++it) ++channel_count;
  checkSize(window, channel_count, file_bytes);

  ExrPart part;
  if (header.hasName()) part.name = header.name();
  part.x = window.min.x - header.displayWindow().min.x;
  part.y = window.min.y - header.displayWindow().min.y;
  part.width = window.max.x - window.min.x + 1;
  part.height = window.max.y - window.min.y + 1;
  part.texts = textsIn(header);
  for (auto it = header.channels().begin(); it != header.channels().end(); ++it)
    part.channels.push_back(emptyChannel(it.name(), it.channel(), size_t(part.width) * part.height));
  Imf::FrameBuffer frame;
  for (ExrChannel& channel : part.channels) insertSlice(frame, channel, window);
  Imf::InputPart pixels(input, index);
  pixels.setFrameBuffer(frame);
  pixels.readPixels(window.min.y, window.max.y);
  return part;
}

// Returns the index of the only part to read, or -1 for all parts.
using ChoosePart = std::function<int(const Imf::MultiPartInputFile&)>;

ExrFile decode(const std::string& bytes, const ChoosePart& choose) {
  Imf::StdISStream stream;
  stream.str(bytes);
  Imf::MultiPartInputFile input(stream, 0);
  int chosen = choose(input), first = std::max(chosen, 0);
  ExrFile content;
  static_cast<ExrPart&>(content) = decodedPart(input, first, bytes.size());
  readAttributes(input.header(first), content);
  for (int i = 1; chosen < 0 && i < input.parts(); ++i) content.further.push_back(decodedPart(input, i, bytes.size()));
  return content;
}

std::string oneLine(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  while (!text.empty() && (text.back() == ' ' || text.back() == '.')) text.pop_back();
  return text;
}

std::string layerOf(const std::string& channel) {
  size_t dot = channel.rfind('.');
  return dot == std::string::npos ? "" : channel.substr(0, dot);
}

std::vector<std::string> channelNames(const ExrPart& content) {
  std::vector<std::string> names;
  for (const ExrChannel& channel : content.channels) names.push_back(channel.name);
  return names;
}

const ExrChannel& require(const ExrPart& content, const std::string& name, const Path& file) {
  if (const ExrChannel* channel = content.find(name)) return *channel;
  throw Error(fmt::format("has no channel '{}'{}", name, didYouMean(name, channelNames(content))), {file.string()});
}

void copyInto(Image& image, int c, const ExrChannel& channel) {
  size_t pixels = size_t(image.width) * image.height;
  bool uint = channel.kind == ExrKind::uint;
  for (size_t i = 0; i < pixels; ++i)
    image.values[i * image.channels + c] = uint ? static_cast<float>(channel.ids[i]) : channel.values[i];
}

std::string channelName(const std::string& layer, const std::string& component) {
  return layer.empty() ? component : fmt::format("{}.{}", layer, component);
}

// `values`: the member that holds the values of this kind.
template <class Pixels, class Number>
void addLayer(ExrPart& content, const std::string& layer, const std::vector<std::string>& components,
              const Pixels& image, ExrKind kind, std::vector<Number> ExrChannel::*values) {
  STROBE_ASSERT(int(components.size()) == image.channels, "{} components, {} channels", components.size(),
                image.channels);
  if (content.channels.empty()) content.width = image.width, content.height = image.height;
  STROBE_ASSERT(content.width == image.width && content.height == image.height, "{}x{} is not {}x{}", image.width,
                image.height, content.width, content.height);
  for (int c = 0; c < image.channels; ++c) {
    ExrChannel channel{channelName(layer, components[c]), kind, {}, {}};
    for (size_t i = size_t(c); i < image.values.size(); i += image.channels)
      (channel.*values).push_back(image.values[i]);
    content.channels.push_back(std::move(channel));
  }
}

}  // namespace

const ExrChannel* ExrPart::find(const std::string& channel) const {
  for (const ExrChannel& known : channels)
    if (known.name == channel) return &known;
  return nullptr;
}

// Clamps finite values. Infinite values (the depth of the sky) stay infinite.
static size_t clampToHalf(std::vector<float>& values) {
  constexpr float kLargest = 65504;
  size_t clamped = 0;
  for (float& value : values) {
    if (!std::isfinite(value) || std::abs(value) <= kLargest) continue;
    value = std::copysign(kLargest, value);
    ++clamped;
  }
  return clamped;
}

void ExrPart::add(const std::string& layer, const std::vector<std::string>& components, const Image& image,
                  ExrKind kind) {
  size_t before = channels.size();
  addLayer(*this, layer, components, image, kind, &ExrChannel::values);
  for (size_t i = before; kind == ExrKind::half && i < channels.size(); ++i) clamped += clampToHalf(channels[i].values);
}

void ExrPart::add(const std::string& layer, const std::vector<std::string>& components, const UintImage& image) {
  addLayer(*this, layer, components, image, ExrKind::uint, &ExrChannel::ids);
}

std::vector<const ExrPart*> ExrFile::parts() const& {
  std::vector<const ExrPart*> parts = {this};
  for (const ExrPart& part : further) parts.push_back(&part);
  return parts;
}

const ExrPart* ExrFile::part(const std::string& part_name) const {
  for (const ExrPart* part : parts())
    if (part->name == part_name) return part;
  return nullptr;
}

std::string encodeExr(const ExrFile& content) {
  Imf::StdOSStream stream;
  if (content.further.empty()) {
    PartSource source(content);
    Imf::OutputFile output(stream, headerOf(content, content), 0);
    output.setFrameBuffer(source.frame);
    output.writePixels(content.height);
  } else {
    writeParts(content, stream);
  }
  return stream.str();
}

void writeExr(const Path& file, const ExrFile& content) { writeFileAtomically(file, encodeExr(content)); }

static ExrFile readParts(const Path& file, const ChoosePart& choose) {
  std::string bytes = readText(file);
  if (bytes.size() < 4 || std::memcmp(bytes.data(), "\x76\x2f\x31\x01", 4) != 0)
    throw Error("is not an OpenEXR file", {file.string()});
  try {
    return decode(bytes, choose);
  } catch (const std::exception& failure) {
    throw Error(fmt::format("is not a readable OpenEXR file: {}", oneLine(failure.what())), {file.string()});
  }
}

ExrFile readExr(const Path& file) {
  return readParts(file, [](const Imf::MultiPartInputFile&) { return -1; });
}

ExrFile readExrLayer(const Path& file, const std::string& layer) {
  return readParts(file, [&layer](const Imf::MultiPartInputFile& input) {
    for (int i = 0; i < input.parts(); ++i)
      if (input.header(i).hasName() && input.header(i).name() == layer) return i;
    for (int i = 0; i < input.parts(); ++i) {
      const Imf::ChannelList& channels = input.header(i).channels();
      for (auto it = channels.begin(); it != channels.end(); ++it)
        if (layerOf(it.name()) == layer || it.name() == layer) return i;
    }
    return 0;
  });
}

Image channelsOf(const ExrPart& content, const std::vector<std::string>& names, const Path& file) {
  Image image(content.width, content.height, static_cast<int>(names.size()));
  for (size_t c = 0; c < names.size(); ++c) copyInto(image, static_cast<int>(c), require(content, names[c], file));
  return image;
}

UintImage idsOf(const ExrPart& content, const std::vector<std::string>& names, const Path& file) {
  UintImage image{content.width, content.height, int(names.size()), {}};
  image.values.resize(size_t(image.width) * image.height * names.size());
  for (size_t c = 0; c < names.size(); ++c) {
    const ExrChannel& channel = require(content, names[c], file);
    if (channel.kind != ExrKind::uint)
      throw Error(fmt::format("channel '{}' does not have ids (unsigned integers)", names[c]), {file.string()});
    for (size_t i = 0; i < channel.ids.size(); ++i) image.values[i * names.size() + c] = channel.ids[i];
  }
  return image;
}

// Names of the red, green and blue channels of a layer; empty if the layer has no colour.
static std::vector<std::string> colourChannels(const ExrPart& content, const std::string& layer) {
  std::vector<std::string> colour;
  for (const char* component : {"R", "G", "B"}) colour.push_back(channelName(layer, component));
  auto present = [&](const std::string& name) { return content.find(name) != nullptr; };
  if (std::all_of(colour.begin(), colour.end(), present)) return colour;
  // Y beside X is a direction, not a luminance.
  std::string grey = channelName(layer, "Y");
  if (present(grey) && !present(channelName(layer, "X"))) return {grey, grey, grey};
  std::vector<std::string> own;
  for (const std::string& name : channelNames(content))
    if (layerOf(name) == layer) own.push_back(name);
  if (own.empty() && present(layer)) own = {layer};  // `--layer Z` names a channel
  return own.size() == 1 ? std::vector<std::string>(3, own[0]) : std::vector<std::string>();
}

Image colourOf(const ExrPart& content, const std::string& layer, const Path& file) {
  std::vector<std::string> colour = colourChannels(content, layer);
  if (colour.empty() && !layer.empty() && layer == content.name)
    colour = colourChannels(content, layerOf(content.channels.front().name));
  if (colour.empty()) {
    std::vector<std::string> names = channelNames(content);
    std::string expected = layer.empty() ? "colour (R, G, B)" : fmt::format("colour in a layer '{}'", layer);
    throw Error(fmt::format("has no {}; its channels are {}", expected, fmt::join(names, ", ")), {file.string()});
  }
  return channelsOf(content, colour, file);
}

}  // namespace strobe::image
