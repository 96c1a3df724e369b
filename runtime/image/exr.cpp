// SPDX-License-Identifier: MIT
#include "image/exr.h"

#include <ImfChannelList.h>
#include <ImfFloatAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfMatrixAttribute.h>
#include <ImfOutputFile.h>
#include <ImfRationalAttribute.h>
#include <ImfStdIO.h>
#include <ImfStringAttribute.h>

#include <algorithm>
#include <cstring>
#include <glm/gtc/type_ptr.hpp>
#include <set>
#include <stdexcept>

#include "base/error.h"

namespace strobe::image {
namespace {

// OpenEXR multiplies row vectors from the left; its matrices therefore lie in memory as ours do.
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

Imf::Header headerOf(const ExrFile& content) {
  Imf::Header header(content.width, content.height);
  header.compression() = Imf::ZIP_COMPRESSION;
  for (const ExrChannel& channel : content.channels)
    header.channels().insert(channel.name, Imf::Channel(pixelType(channel.kind)));
  for (const auto& [name, text] : content.texts) header.insert(name, Imf::StringAttribute(text));
  if (content.frames_per_second) {
    auto [numerator, denominator] = *content.frames_per_second;
    header.insert("framesPerSecond", Imf::RationalAttribute(Imf::Rational(numerator, unsigned(denominator))));
  }
  if (content.shutter_angle) header.insert("shutterAngle", Imf::FloatAttribute(*content.shutter_angle));
  if (content.exposure_s) header.insert("expTime", Imf::FloatAttribute(*content.exposure_s));
  if (content.camera_from_world) header.insert("worldToCamera", Imf::M44fAttribute(toExr(*content.camera_from_world)));
  if (content.ndc_from_world) header.insert("worldToNDC", Imf::M44fAttribute(toExr(*content.ndc_from_world)));
  return header;
}

void readAttributes(const Imf::Header& header, ExrFile& content) {
  for (auto it = header.begin(); it != header.end(); ++it) {
    auto* text = dynamic_cast<const Imf::StringAttribute*>(&it.attribute());
    if (text) content.texts[it.name()] = text->value();
  }
  if (auto* rate = header.findTypedAttribute<Imf::RationalAttribute>("framesPerSecond"))
    content.frames_per_second = {rate->value().n, static_cast<int>(rate->value().d)};
  if (auto* angle = header.findTypedAttribute<Imf::FloatAttribute>("shutterAngle"))
    content.shutter_angle = angle->value();
  if (auto* time = header.findTypedAttribute<Imf::FloatAttribute>("expTime")) content.exposure_s = time->value();
  if (auto* matrix = header.findTypedAttribute<Imf::M44fAttribute>("worldToCamera"))
    content.camera_from_world = fromExr(matrix->value());
  if (auto* matrix = header.findTypedAttribute<Imf::M44fAttribute>("worldToNDC"))
    content.ndc_from_world = fromExr(matrix->value());
}

// A file's header may claim any size; refuse before memory is allocated. Even a constant image in OpenEXR's densest
// compression (256 lines to a block) stays below a factor of 65536.
void checkSize(const Imath::Box2i& window, size_t channel_count, size_t file_bytes) {
  int64_t width = int64_t(window.max.x) - window.min.x + 1;
  int64_t height = int64_t(window.max.y) - window.min.y + 1;
  constexpr int64_t kMaxSide = 65536, kMaxBytes = int64_t(16) << 30, kMaxFactor = 65536;
  if (width < 1 || height < 1 || width > kMaxSide || height > kMaxSide)
    throw std::runtime_error(fmt::format("its size is {}x{}", width, height));
  int64_t bytes = width * height * 4 * int64_t(channel_count);
  if (bytes > kMaxBytes) throw std::runtime_error("it holds more than 16 GiB of pixels");
  if (bytes / kMaxFactor > int64_t(file_bytes))
    throw std::runtime_error(fmt::format("its size of {}x{} does not fit in {} bytes", width, height, file_bytes));
}

ExrChannel emptyChannel(const std::string& name, const Imf::Channel& described, size_t pixels) {
  if (described.xSampling != 1 || described.ySampling != 1)
    throw std::runtime_error(fmt::format("channel '{}' is subsampled", name));
  ExrChannel channel{name, ExrKind::real, {}, {}};
  if (described.type == Imf::UINT) channel.kind = ExrKind::uint;
  if (described.type == Imf::HALF) channel.kind = ExrKind::half;
  if (channel.kind == ExrKind::uint) channel.ids.resize(pixels);
  else channel.values.resize(pixels);
  return channel;
}

// Points OpenEXR at the memory of `channel`. Halfs are converted on the way in, never on the way out (see encodeExr).
void insertSlice(Imf::FrameBuffer& frame, ExrChannel& channel, const Imath::Box2i& window) {
  size_t width = static_cast<size_t>(window.max.x - window.min.x + 1);
  bool uint = channel.kind == ExrKind::uint;
  char* data = uint ? reinterpret_cast<char*>(channel.ids.data()) : reinterpret_cast<char*>(channel.values.data());
  frame.insert(channel.name, Imf::Slice::Make(uint ? Imf::UINT : Imf::FLOAT, data, window, 4, 4 * width));
}

ExrFile decode(const std::string& bytes) {
  Imf::StdISStream stream;
  stream.str(bytes);
  Imf::InputFile input(stream, 0);
  const Imf::Header& header = input.header();
  Imath::Box2i window = header.dataWindow();
  size_t channel_count = 0;
  for (auto it = header.channels().begin(); it != header.channels().end(); ++it) ++channel_count;
  checkSize(window, channel_count, bytes.size());

  ExrFile content;
  content.width = window.max.x - window.min.x + 1;
  content.height = window.max.y - window.min.y + 1;
  readAttributes(header, content);
  for (auto it = header.channels().begin(); it != header.channels().end(); ++it)
    content.channels.push_back(emptyChannel(it.name(), it.channel(), size_t(content.width) * content.height));
  Imf::FrameBuffer frame;
  for (ExrChannel& channel : content.channels) insertSlice(frame, channel, window);
  input.setFrameBuffer(frame);
  input.readPixels(window.min.y, window.max.y);
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

std::vector<std::string> channelNames(const ExrFile& content) {
  std::vector<std::string> names;
  for (const ExrChannel& channel : content.channels) names.push_back(channel.name);
  return names;
}

const ExrChannel& require(const ExrFile& content, const std::string& name, const Path& file) {
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

// `values`: where a channel of this kind keeps them.
template <class Pixels, class Number>
void addLayer(ExrFile& content, const std::string& layer, const std::vector<std::string>& components,
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

const ExrChannel* ExrFile::find(const std::string& name) const {
  for (const ExrChannel& channel : channels)
    if (channel.name == name) return &channel;
  return nullptr;
}

void ExrFile::add(const std::string& layer, const std::vector<std::string>& components, const Image& image,
                  ExrKind kind) {
  addLayer(*this, layer, components, image, kind, &ExrChannel::values);
}

void ExrFile::add(const std::string& layer, const std::vector<std::string>& components, const UintImage& image) {
  addLayer(*this, layer, components, image, ExrKind::uint, &ExrChannel::ids);
}

std::string encodeExr(const ExrFile& content) {
  STROBE_ASSERT(content.width > 0 && content.height > 0 && !content.channels.empty(), "{}x{}, {} channels",
                content.width, content.height, content.channels.size());
  size_t pixels = size_t(content.width) * content.height;
  std::set<std::string> names;
  std::vector<std::vector<half>> halfs;  // outlive the frame buffer that points into them
  halfs.reserve(content.channels.size());
  Imf::Header header = headerOf(content);
  Imf::FrameBuffer frame;
  for (const ExrChannel& channel : content.channels) {
    bool uint = channel.kind == ExrKind::uint;
    STROBE_ASSERT((uint ? channel.ids.size() : channel.values.size()) == pixels, "channel {}", channel.name);
    STROBE_ASSERT(names.insert(channel.name).second, "two channels are named {}", channel.name);
    size_t bytes = 4;
    const void* data = uint ? static_cast<const void*>(channel.ids.data()) : channel.values.data();
    if (channel.kind == ExrKind::half) {
      data = halfs.emplace_back(channel.values.begin(), channel.values.end()).data();
      bytes = sizeof(half);
    }
    char* start = const_cast<char*>(static_cast<const char*>(data));  // OpenEXR only reads it
    frame.insert(channel.name, Imf::Slice(pixelType(channel.kind), start, bytes, bytes * content.width));
  }
  Imf::StdOSStream stream;
  {
    Imf::OutputFile output(stream, header, 0);
    output.setFrameBuffer(frame);
    output.writePixels(content.height);
  }
  return stream.str();
}

void writeExr(const Path& file, const ExrFile& content) { writeFileAtomically(file, encodeExr(content)); }

ExrFile readExr(const Path& file) {
  std::string bytes = readText(file);
  if (bytes.size() < 4 || std::memcmp(bytes.data(), "\x76\x2f\x31\x01", 4) != 0)
    throw Error("is not an OpenEXR file", {file.string()});
  try {
    return decode(bytes);
  } catch (const std::exception& failure) {
    throw Error(fmt::format("is not a readable OpenEXR file: {}", oneLine(failure.what())), {file.string()});
  }
}

Image channelsOf(const ExrFile& content, const std::vector<std::string>& names, const Path& file) {
  Image image(content.width, content.height, static_cast<int>(names.size()));
  for (size_t c = 0; c < names.size(); ++c) copyInto(image, static_cast<int>(c), require(content, names[c], file));
  return image;
}

UintImage idsOf(const ExrFile& content, const std::vector<std::string>& names, const Path& file) {
  UintImage image{content.width, content.height, int(names.size()), {}};
  image.values.resize(size_t(image.width) * image.height * names.size());
  for (size_t c = 0; c < names.size(); ++c) {
    const ExrChannel& channel = require(content, names[c], file);
    if (channel.kind != ExrKind::uint) throw Error(fmt::format("channel '{}' holds no ids", names[c]), {file.string()});
    for (size_t i = 0; i < channel.ids.size(); ++i) image.values[i * names.size() + c] = channel.ids[i];
  }
  return image;
}

// The channels that make the red, green and blue of a layer; empty when it has no colour.
static std::vector<std::string> colourChannels(const ExrFile& content, const std::string& layer) {
  std::vector<std::string> colour;
  for (const char* component : {"R", "G", "B"}) colour.push_back(channelName(layer, component));
  auto present = [&](const std::string& name) { return content.find(name) != nullptr; };
  if (std::all_of(colour.begin(), colour.end(), present)) return colour;
  // With an X beside it, Y is a direction, not a luminance.
  std::string grey = channelName(layer, "Y");
  if (present(grey) && !present(channelName(layer, "X"))) return {grey, grey, grey};
  std::vector<std::string> own;
  for (const std::string& name : channelNames(content))
    if (layerOf(name) == layer) own.push_back(name);
  if (own.empty() && present(layer)) own = {layer};  // `--layer Z` names a channel
  return own.size() == 1 ? std::vector<std::string>(3, own[0]) : std::vector<std::string>();
}

Image colourOf(const ExrFile& content, const std::string& layer, const Path& file) {
  std::vector<std::string> colour = colourChannels(content, layer);
  if (colour.empty()) {
    std::vector<std::string> names = channelNames(content);
    std::string expected = layer.empty() ? "colour (R, G, B)" : fmt::format("colour in a layer '{}'", layer);
    throw Error(fmt::format("has no {}; its channels are {}", expected, fmt::join(names, ", ")), {file.string()});
  }
  return channelsOf(content, colour, file);
}

}  // namespace strobe::image
