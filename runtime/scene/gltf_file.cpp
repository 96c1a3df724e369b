// SPDX-License-Identifier: MIT
#include "scene/gltf_file.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "base/hash.h"
#include "scene/gltf_parts.h"
#include "scene/gltf_uri.h"

namespace strobe::scene {

namespace {

uint32_t word(const std::vector<uint8_t>& bytes, size_t at) {
  uint32_t value;  // little endian, like the supported machines
  std::memcpy(&value, bytes.data() + at, 4);
  return value;
}

template <class T>
double loaded(const uint8_t* at) {
  T value;
  std::memcpy(&value, at, sizeof value);
  return double(value);
}

// Component type of an accessor.
struct ComponentType {
  size_t size;
  double (*load)(const uint8_t*);
  double largest = 0;  // divisor of normalised integers; 0: never normalised
};

const std::map<int, ComponentType> kComponents = {
    {5120, {1, loaded<int8_t>, 127}},     {5121, {1, loaded<uint8_t>, 255}}, {5122, {2, loaded<int16_t>, 32767}},
    {5123, {2, loaded<uint16_t>, 65535}}, {5125, {4, loaded<uint32_t>}},     {5126, {4, loaded<float>}}};

size_t componentSize(int type) { return kComponents.count(type) ? kComponents.at(type).size : 0; }

double component(const uint8_t* at, int type, bool normalized) {
  const ComponentType& component = kComponents.at(type);
  double value = component.load(at);
  return normalized && component.largest > 0 ? std::max(value / component.largest, -1.0) : value;
}

bool isVersion(const std::string& text) {
  const size_t dot = text.find('.');
  auto digits = [](std::string_view part) {
    return !part.empty() && std::all_of(part.begin(), part.end(), [](char c) { return c >= '0' && c <= '9'; });
  };
  return dot != std::string::npos && digits(std::string_view(text).substr(0, dot)) &&
         digits(std::string_view(text).substr(dot + 1));
}

}  // namespace

int AccessorFormat::width() const {
  static const std::map<std::string, int> counts = {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4},
                                                    {"MAT2", 4},   {"MAT3", 9}, {"MAT4", 16}};
  auto found = counts.find(type);
  return found == counts.end() ? 0 : found->second;
}

size_t AccessorFormat::elementSize() const {
  const size_t component = componentSize(component_type);
  if (!type.starts_with("MAT")) return component * size_t(width());
  const size_t columns = size_t(type.back() - '0');  // each column begins at a multiple of four bytes
  return columns * ((columns * component + 3) / 4 * 4);
}

GltfFile::GltfFile(const Path& file, bool allow_outside)
    : GltfJson(file), path_(std::filesystem::absolute(file).lexically_normal()), allow_outside_(allow_outside) {
  readContainer();
  checkVersion();
  requireForm(*this);
  readBuffers();
  requireMemory(*this);
  decodeViews();
  decodePrimitives();
  requireElements();
}

void GltfFile::readContainer() {
  std::string text = readFile(path_);
  std::vector<uint8_t> bytes(text.begin(), text.end());
  size_t json_at = 0, json_size = bytes.size();
  if (bytes.size() >= 4 && std::memcmp(bytes.data(), "glTF", 4) == 0) readChunks(bytes, json_at, json_size);
  // The depth is limited, because copying and printing such values recurse.
  auto shallow = [&](int depth, Json::parse_event_t, Json&) {
    if (depth > 200) refuse("", "its JSON is nested deeper than 200 levels");
    return true;
  };
  try {
    json_ = Json::parse(bytes.begin() + json_at, bytes.begin() + json_at + json_size, shallow);
  } catch (const Json::parse_error& error) {
    refuse("", fmt::format("is not valid JSON: error at byte {}", error.byte));
  } catch (const Json::out_of_range&) {
    refuse("", "has a JSON number outside of the range of double precision");
  }
  if (!json_.is_object()) refuse("", "is not a glTF asset: its JSON is not an object");
}

// Reads the JSON chunk, then the binary chunk. Chunks of other kinds are skipped.
void GltfFile::readChunks(const std::vector<uint8_t>& bytes, size_t& json_at, size_t& json_size) {
  constexpr uint32_t kJson = 0x4E4F534A, kBinary = 0x004E4942;
  if (bytes.size() < 20)
    refuse("", fmt::format("is cut short: {} bytes are fewer than a GLB header needs", bytes.size()));
  if (word(bytes, 4) != 2) refuse("", fmt::format("is GLB version {}, not 2", word(bytes, 4)));
  const size_t length = word(bytes, 8);
  if (length > bytes.size()) refuse("", fmt::format("is cut short: {} of {} bytes", bytes.size(), length));
  size_t at = 12;
  for (size_t i = 0; at < length; ++i) {
    if (length - at < 8)
      refuse("", fmt::format("chunk {} is cut short: {} bytes are fewer than a header needs", i, length - at));
    const size_t size = word(bytes, at);
    const uint32_t kind = word(bytes, at + 4);
    if (size > length - at - 8)
      refuse("", fmt::format("chunk {} has {} bytes, but the file has only {} more", i, size, length - at - 8));
    if (size % 4 != 0) refuse("", fmt::format("chunk {} has {} bytes, not a multiple of 4", i, size));
    at += 8;
    if ((i == 0) != (kind == kJson)) refuse("", i == 0 ? "its first chunk is not JSON" : "has two JSON chunks");
    if (kind == kBinary && i != 1) refuse("", fmt::format("its binary chunk is chunk {}, not 1", i));
    if (kind == kJson) json_at = at, json_size = size;
    if (kind == kBinary) {
      binary_chunk_.assign(bytes.begin() + std::ptrdiff_t(at), bytes.begin() + std::ptrdiff_t(at + size));
      has_binary_chunk_ = true;
    }
    at += size;
  }
  if (json_at == 0) refuse("", "has no JSON chunk");
}

void GltfFile::checkVersion() const {
  std::string version = text(object(json_, "asset", ""), "version", "asset");
  if (version.empty()) refuse("", "is not a glTF asset: asset.version is missing");
  if (!isVersion(version)) refuse("asset", fmt::format("'{}' is not a version number", version));
  if (!version.starts_with("2.")) refuse("", fmt::format("is glTF {}, not 2.0", version));
  std::string least = text(object(json_, "asset", ""), "minVersion", "asset");
  if (!least.empty() && least != "2.0") refuse("asset", fmt::format("minVersion is {}, above 2.0", least));
  const std::vector<std::string>& supported = supportedExtensions();
  std::vector<std::string> missing;
  for (const Json& name : all("extensionsRequired")) {
    std::string extension = name.is_string() ? name.get<std::string>() : name.dump();
    if (std::find(supported.begin(), supported.end(), extension) == supported.end()) missing.push_back(extension);
  }
  if (!missing.empty()) refuse("", fmt::format("requires {}, which is not supported", fmt::join(missing, ", ")));
}

void GltfFile::readBuffers() {
  const Json& buffers = all("buffers");
  for (size_t i = 0; i < buffers.size(); ++i) {
    std::string where = fmt::format("buffers[{}]", i), uri = text(buffers[i], "uri");
    size_t length = size(buffers[i], "byteLength", std::nullopt, where);
    if (isFallback(buffers[i])) {
      buffers_.emplace_back();
      continue;
    }
    if (uri.empty() && !(i == 0 && has_binary_chunk_)) refuse(where, "has neither a uri nor a binary chunk");
    buffers_.push_back(uri.empty() ? std::move(binary_chunk_) : uriBytes(uri, where));
    if (buffers_.back().size() < length)
      refuse(where, fmt::format("is cut short: {} of {} bytes", buffers_.back().size(), length));
    buffers_.back().resize(length);
  }
}

// True for a buffer with views that are all read from compressed bytes. The bytes of the buffer are not needed.
bool GltfFile::isFallback(const Json& buffer) const {
  return flag(extension(buffer, "EXT_meshopt_compression"), "fallback", "");
}

std::string GltfFile::readFile(const Path& file) {
  std::string text = readText(file);
  auto known = std::find_if(files_.begin(), files_.end(), [&](const SourceFile& one) { return one.path == file; });
  if (known == files_.end()) {
    files_.push_back({file, hashText(text)});
    bytes_read_ += text.size();
  }
  return text;
}

std::vector<uint8_t> GltfFile::uriBytes(const std::string& uri, const std::string& where) {
  if (uri.starts_with("data:")) {
    size_t comma = uri.find(";base64,");
    if (comma == std::string::npos) refuse(where, "its data URI is not base64");
    auto bytes = fromBase64(std::string_view(uri).substr(comma + 8));
    if (!bytes) refuse(where, "its data URI is not valid base64");
    return *bytes;
  }
  Path relative = percentDecoded(uri);
  if (hasScheme(uri) || relative.is_absolute()) refuse(where, fmt::format("'{}' is not a relative path", uri));
  Path file = (path_.parent_path() / relative).lexically_normal();
  if (!mayRead(file))
    refuse(where, fmt::format("'{}' is outside of the scene's folder; use --allow-outside to read it", uri));
  try {
    std::string text = readFile(file);
    return {text.begin(), text.end()};
  } catch (const Error& error) {
    refuse(where, fmt::format("'{}' {}", uri, error.message()));
  }
}

GltfFile::View GltfFile::view(int view_index, const std::string& where) const {
  const Json& json = all("bufferViews").at(view_index);
  std::string name = where.empty() ? "" : where + ": ";
  name += fmt::format("bufferViews[{}]", view_index);
  auto decoded = decoded_views_.find(view_index);
  if (decoded == decoded_views_.end()) return stored(json, name);
  return {decoded->second.data(), decoded->second.size(), size(json, "byteStride", 0, name)};
}

// Part of a buffer, as stated by a buffer view or by its compression extension.
GltfFile::View GltfFile::stored(const Json& json, const std::string& name) const {
  int buffer = index(json, "buffer", "buffers", name);
  if (isFallback(all("buffers")[size_t(buffer)])) refuse(name, "is not compressed, but its buffer is a fallback");
  size_t offset = size(json, "byteOffset", 0, name), length = size(json, "byteLength", std::nullopt, name);
  size_t available = buffers_[buffer].size();
  if (offset > available || length > available - offset)
    refuse(name, fmt::format("{} bytes at byte {} do not fit in a buffer of {} bytes", length, offset, available));
  size_t stride = size(json, "byteStride", 0, name);
  if (stride % 4 != 0 && !json.contains("mode"))
    refuse(name, fmt::format("byteStride {} is not a multiple of 4", stride));
  return {buffers_[buffer].data() + offset, length, stride};
}

// First element of an accessor, or of a part of a sparse accessor. Throws if an element is outside of the view.
const uint8_t* GltfFile::elements(const Json& json, size_t count, size_t element_size, size_t& stride,
                                  const std::string& where) const {
  View source = view(index(json, "bufferView", "bufferViews", where), where);
  stride = source.stride ? source.stride : element_size;
  size_t offset = size(json, "byteOffset", 0, where);
  if (stride < element_size)
    refuse(where, fmt::format("byteStride {} is below the size of an element, {}", stride, element_size));
  size_t needed = stride * (count - 1) + element_size;
  if (offset > source.size || needed > source.size - offset)
    refuse(where, fmt::format("{} elements do not fit in its buffer view of {} bytes", count, source.size));
  return source.data + offset;
}

AccessorFormat GltfFile::format(int accessor) const {
  const Json& json = all("accessors").at(size_t(accessor));
  const std::string where = fmt::format("accessors[{}]", accessor);
  return {text(json, "type", where), int(size(json, "componentType", std::nullopt, where)),
          flag(json, "normalized", where), size(json, "count", std::nullopt, where)};
}

Values GltfFile::accessor(int accessor_index, const std::string& asked, const std::vector<std::string>& types) const {
  const Json& json = all("accessors").at(accessor_index);
  std::string where = fmt::format("{}: accessors[{}]", asked, accessor_index);
  const AccessorFormat stored = format(accessor_index);
  if (std::find(types.begin(), types.end(), stored.type) == types.end())
    refuse(where, fmt::format("type is '{}', not {}", stored.type, fmt::join(types, " or ")));
  if (stored.type == "MAT4" && stored.component_type != 5126) refuse(where, "is a matrix of integers, not of floats");
  Values values;
  values.width = stored.width();
  values.count = stored.count;

  const size_t component_size = componentSize(stored.component_type);
  size_t stride = component_size * size_t(values.width);
  const uint8_t* at = nullptr;
  auto decoded = decoded_accessors_.find(accessor_index);
  if (decoded != decoded_accessors_.end()) at = decoded->second.data();
  else if (json.contains("bufferView")) at = elements(json, values.count, stride, stride, where);
  values.numbers.assign(values.count * values.width, 0.0);
  for (size_t i = 0; at && i < values.count; ++i, at += stride)
    for (int c = 0; c < values.width; ++c)
      values.numbers[i * values.width + c] =
          component(at + c * component_size, stored.component_type, stored.normalized);
  if (json.contains("sparse")) applySparse(json, values, stored.component_type, stored.normalized, where + ".sparse");
  return values;
}

// Throws if a buffer view is outside of its buffer, or an accessor outside of its view, used or not.
void GltfFile::requireElements() const {
  for (size_t i = 0; i < all("bufferViews").size(); ++i) view(int(i), "");
  const Json& accessors = all("accessors");
  size_t stride = 0;
  for (size_t i = 0; i < accessors.size(); ++i) {
    const AccessorFormat stored = format(int(i));
    const std::string where = fmt::format("accessors[{}]", i), place = where + ".sparse";
    if (stored.normalized && (stored.component_type == 5125 || stored.component_type == 5126))
      refuse(where, fmt::format("componentType {} cannot be normalized", stored.component_type));
    const size_t width = size_t(stored.width());
    for (const char* bound : {"min", "max"})
      if (accessors[i].contains(bound) && accessors[i][bound].size() != width)
        refuse(where, fmt::format("'{}' does not have {} numbers", bound, width));
    const bool has_view = accessors[i].contains("bufferView");
    if (accessors[i].contains("byteOffset") && !has_view) refuse(where, "has a byteOffset but no bufferView");
    if (has_view && !decoded_accessors_.count(int(i)))
      elements(accessors[i], stored.count, stored.elementSize(), stride, where);
    if (!accessors[i].contains("sparse")) continue;
    const Json& sparse = accessors[i]["sparse"];
    const size_t count = size(sparse, "count", std::nullopt, place);
    if (count > stored.count)
      refuse(place, fmt::format("count is {}, but the accessor has {} elements", count, stored.count));
    const int index_type = int(size(sparse["indices"], "componentType", std::nullopt, place + ".indices"));
    elements(sparse["indices"], count, componentSize(index_type), stride, place + ".indices");
    elements(sparse["values"], count, stored.elementSize(), stride, place + ".values");
  }
}

void GltfFile::applySparse(const Json& accessor, Values& values, int component_type, bool normalized,
                           const std::string& where) const {
  const Json& sparse = object(accessor, "sparse", where);
  size_t count = size(sparse, "count", std::nullopt, where);
  const Json &indices = object(sparse, "indices", where), &replacing = object(sparse, "values", where);
  int index_type = int(size(indices, "componentType", std::nullopt, where));
  size_t index_stride = 0, stride = 0, width = componentSize(component_type);
  const uint8_t* index_at = elements(indices, count, componentSize(index_type), index_stride, where + ".indices");
  const uint8_t* at = elements(replacing, count, width * values.width, stride, where + ".values");
  double before = -1;
  for (size_t i = 0; i < count; ++i) {
    double element = component(index_at + i * index_stride, index_type, false);
    if (element <= before || element >= double(values.count))
      refuse(where, fmt::format("index {} is out of order or not below {}", element, values.count));
    before = element;
    for (int c = 0; c < values.width; ++c) {
      double number = component(at + i * stride + c * width, component_type, normalized);
      values.numbers[size_t(element) * values.width + c] = number;
    }
  }
}

std::vector<uint32_t> GltfFile::indices(int accessor_index, const std::string& where) const {
  const Values values = accessor(accessor_index, where, {"SCALAR"});
  const double restart = std::pow(256.0, double(componentSize(format(accessor_index).component_type))) - 1;
  for (size_t i = 0; i < values.count; ++i)
    if (values.numbers[i] == restart)
      refuse(where, fmt::format("index {} is {}, the value for primitive restart", i, restart));
  return {values.numbers.begin(), values.numbers.end()};
}

std::vector<uint8_t> GltfFile::imageBytes(int image_index) {
  const Json& json = all("images").at(image_index);
  std::string where = fmt::format("images[{}]", image_index), uri = text(json, "uri");
  int view_index = index(json, "bufferView", "bufferViews", where);
  if (uri.empty() && view_index < 0) refuse(where, "has neither uri nor bufferView");
  if (view_index < 0) return uriBytes(uri, where);
  View source = view(view_index, where);
  return {source.data, source.data + source.size};
}

}  // namespace strobe::scene
