// SPDX-License-Identifier: MIT
#include "scene/gltf_file.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>

#include "base/hash.h"
#include "scene/motion.h"

namespace strobe::scene {

namespace {

const Json kNoList = Json::array();
const Json kNoObject = Json::object();

// More elements than any accessor of a sensible file, so that a short file cannot ask for much memory.
constexpr size_t kMostElements = size_t(1) << 26;

uint32_t word(const std::vector<uint8_t>& bytes, size_t at) {
  uint32_t value;  // little endian, as this program's machines are
  std::memcpy(&value, bytes.data() + at, 4);
  return value;
}

template <class T>
double loaded(const uint8_t* at) {
  T value;
  std::memcpy(&value, at, sizeof value);
  return double(value);
}

// A type of the components of an accessor.
struct ComponentType {
  size_t size;
  double (*load)(const uint8_t*);
  double largest = 0;  // what a normalised integer is divided by; 0: never normalised
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

int componentsOf(const std::string& type) {
  static const std::map<std::string, int> counts = {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT4", 16}};
  auto found = counts.find(type);
  return found == counts.end() ? 0 : found->second;
}

std::optional<std::vector<uint8_t>> fromBase64(std::string_view text) {
  std::vector<uint8_t> bytes;
  uint32_t bits = 0;
  int held = 0;
  while (!text.empty() && text.back() == '=') text.remove_suffix(1);
  for (char c : text) {
    static constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    size_t digit = kDigits.find(c);
    if (digit == std::string_view::npos) return std::nullopt;
    bits = bits << 6 | uint32_t(digit);
    held += 6;
    if (held < 8) continue;
    held -= 8;
    bytes.push_back(uint8_t(bits >> held));
  }
  return bytes;
}

std::string percentDecoded(const std::string& uri) {
  std::string text;
  for (size_t i = 0; i < uri.size(); ++i) {
    bool escape =
        uri[i] == '%' && i + 2 < uri.size() && std::isxdigit(uint8_t(uri[i + 1])) && std::isxdigit(uint8_t(uri[i + 2]));
    text += escape ? char(std::stoi(uri.substr(i + 1, 2), nullptr, 16)) : uri[i];
    if (escape) i += 2;
  }
  return text;
}

}  // namespace

GltfFile::GltfFile(const Path& file, const std::vector<std::string>& supported, bool allow_outside)
    : path_(std::filesystem::absolute(file).lexically_normal()), shown_(file), allow_outside_(allow_outside) {
  readContainer();
  checkVersion(supported);
  readBuffers();
}

void GltfFile::refuse(const std::string& where, const std::string& text) const {
  throw Error(where.empty() ? text : where + ": " + text, {shown_.string()});
}

void GltfFile::readContainer() {
  std::string text = readFile(path_);
  std::vector<uint8_t> bytes(text.begin(), text.end());
  size_t json_at = 0, json_size = bytes.size();
  if (bytes.size() >= 4 && std::memcmp(bytes.data(), "glTF", 4) == 0) {
    if (bytes.size() < 20) refuse("", fmt::format("is cut short: {} bytes are no GLB header", bytes.size()));
    if (word(bytes, 4) != 2) refuse("", fmt::format("is GLB version {}, not 2", word(bytes, 4)));
    size_t length = word(bytes, 8);
    if (length > bytes.size()) refuse("", fmt::format("is cut short: {} of {} bytes", bytes.size(), length));
    json_at = 20;
    json_size = word(bytes, 12);
    if (word(bytes, 16) != 0x4E4F534A) refuse("", "its first chunk is not JSON");
    if (length < 20 || json_size > length - 20) refuse("", "its JSON chunk is longer than the file");
    size_t next = json_at + json_size;
    if (next + 8 <= length && word(bytes, next + 4) == 0x004E4942) {
      size_t size = word(bytes, next);
      if (size > length - next - 8) refuse("", "its binary chunk is longer than the file");
      binary_chunk_.assign(bytes.begin() + next + 8, bytes.begin() + next + 8 + size);
      has_binary_chunk_ = true;
    }
  }
  // Nesting is bounded because copying and printing such values recurse.
  auto shallow = [&](int depth, Json::parse_event_t, Json&) {
    if (depth > 200) refuse("", "its JSON is nested deeper than 200");
    return true;
  };
  try {
    json_ = Json::parse(bytes.begin() + json_at, bytes.begin() + json_at + json_size, shallow);
  } catch (const Json::parse_error& error) {
    refuse("", fmt::format("is not valid JSON at byte {} of it", error.byte));
  }
  if (!json_.is_object()) refuse("", "is not a glTF asset: its JSON is no object");
}

void GltfFile::checkVersion(const std::vector<std::string>& supported) const {
  std::string version = text(object(json_, "asset", ""), "version");
  if (version.empty()) refuse("", "is not a glTF asset: asset.version is missing");
  if (!version.starts_with("2.")) refuse("", fmt::format("is glTF {}, not 2.0", version));
  std::string least = text(object(json_, "asset", ""), "minVersion", "asset");
  if (!least.empty() && least != "2.0") refuse("asset", fmt::format("minVersion is {}, above 2.0", least));
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
    if (uri.empty() && !(i == 0 && has_binary_chunk_)) refuse(where, "has no uri and there is no binary chunk");
    buffers_.push_back(uri.empty() ? std::move(binary_chunk_) : uriBytes(uri, where));
    if (buffers_.back().size() < length)
      refuse(where, fmt::format("is cut short: {} of {} bytes", buffers_.back().size(), length));
    buffers_.back().resize(length);
  }
}

std::string GltfFile::readFile(const Path& file) {
  std::string text = readText(file);
  auto known = std::find_if(files_.begin(), files_.end(), [&](const SourceFile& one) { return one.path == file; });
  if (known == files_.end()) files_.push_back({file, hashText(text)});
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
  bool has_scheme = uri.find(':') != std::string::npos;
  if (has_scheme || relative.is_absolute()) refuse(where, fmt::format("'{}' is not a relative path", uri));
  Path file = (path_.parent_path() / relative).lexically_normal();
  if (!mayRead(file))
    refuse(where, fmt::format("'{}' lies outside of the scene's folder; --allow-outside lets it be read", uri));
  try {
    std::string text = readFile(file);
    return {text.begin(), text.end()};
  } catch (const Error& error) {
    refuse(where, fmt::format("'{}' {}", uri, error.message()));
  }
}

GltfFile::View GltfFile::view(int view_index, const std::string& where) const {
  const Json& json = all("bufferViews").at(view_index);
  std::string name = fmt::format("{}: bufferViews[{}]", where, view_index);
  int buffer = index(json, "buffer", "buffers", name);
  if (buffer < 0) refuse(name, "names no buffer");
  size_t offset = size(json, "byteOffset", 0, name), length = size(json, "byteLength", std::nullopt, name);
  size_t available = buffers_[buffer].size();
  if (offset > available || length > available - offset)
    refuse(name, fmt::format("{} bytes at {} do not lie in a buffer of {}", length, offset, available));
  size_t stride = size(json, "byteStride", 0, name);
  if (stride > 252) refuse(name, fmt::format("byteStride is {}, above 252", stride));
  return {buffers_[buffer].data() + offset, length, stride};
}

// The first element of an accessor (or of a part of a sparse one) after checking that all of them lie in the view.
const uint8_t* GltfFile::elements(const Json& json, size_t count, size_t element_size, size_t& stride,
                                  const std::string& where) const {
  View source = view(index(json, "bufferView", "bufferViews", where), where);
  stride = source.stride ? source.stride : element_size;
  size_t offset = size(json, "byteOffset", 0, where);
  if (stride < element_size)
    refuse(where, fmt::format("byteStride {} is below its element's {}", stride, element_size));
  size_t needed = stride * (count - 1) + element_size;
  if (offset > source.size || needed > source.size - offset)
    refuse(where, fmt::format("{} elements do not lie in its buffer view of {} bytes", count, source.size));
  return source.data + offset;
}

Values GltfFile::accessor(int accessor_index, const std::string& asked, const std::vector<std::string>& types) const {
  const Json& json = all("accessors").at(accessor_index);
  std::string where = fmt::format("{}: accessors[{}]", asked, accessor_index), type = text(json, "type");
  int component_type = int(size(json, "componentType", std::nullopt, where));
  size_t component_size = componentSize(component_type);
  if (component_size == 0) refuse(where, fmt::format("componentType {} is unknown", component_type));
  if (std::find(types.begin(), types.end(), type) == types.end())
    refuse(where, fmt::format("type is '{}', not {}", type, fmt::join(types, " or ")));
  if (type == "MAT4" && component_type != 5126) refuse(where, "is a matrix of integers");
  Values values;
  values.width = componentsOf(type);
  values.count = size(json, "count", std::nullopt, where);
  if (values.count == 0 || values.count > kMostElements) refuse(where, fmt::format("count is {}", values.count));

  bool normalized = flag(json, "normalized", where);
  bool has_view = index(json, "bufferView", "bufferViews", where) >= 0;
  size_t stride = 0;
  const uint8_t* at = has_view ? elements(json, values.count, component_size * values.width, stride, where) : nullptr;
  values.numbers.assign(values.count * values.width, 0.0);
  for (size_t i = 0; at && i < values.count; ++i, at += stride)
    for (int c = 0; c < values.width; ++c)
      values.numbers[i * values.width + c] = component(at + c * component_size, component_type, normalized);
  if (json.contains("sparse")) applySparse(json, values, component_type, normalized, where + ".sparse");
  return values;
}

void GltfFile::applySparse(const Json& accessor, Values& values, int component_type, bool normalized,
                           const std::string& where) const {
  const Json& sparse = object(accessor, "sparse", where);
  size_t count = size(sparse, "count", std::nullopt, where);
  if (count == 0 || count > values.count) refuse(where, fmt::format("count is {} of {}", count, values.count));
  const Json &indices = object(sparse, "indices", where), &replacing = object(sparse, "values", where);
  for (const Json* part : {&indices, &replacing})
    if (index(*part, "bufferView", "bufferViews", where) < 0) refuse(where, "names no bufferView");
  int index_type = int(size(indices, "componentType", std::nullopt, where));
  if (index_type != 5121 && index_type != 5123 && index_type != 5125)
    refuse(where, fmt::format("indices have componentType {}", index_type));
  size_t index_stride = 0, stride = 0, width = componentSize(component_type);
  const uint8_t* index_at = elements(indices, count, componentSize(index_type), index_stride, where + ".indices");
  const uint8_t* at = elements(replacing, count, width * values.width, stride, where + ".values");
  double before = -1;
  for (size_t i = 0; i < count; ++i) {
    double element = component(index_at + i * index_stride, index_type, false);
    if (element <= before || element >= double(values.count))
      refuse(where, fmt::format("index {} is out of order or beyond {}", element, values.count));
    before = element;
    for (int c = 0; c < values.width; ++c) {
      double number = component(at + i * stride + c * width, component_type, normalized);
      values.numbers[size_t(element) * values.width + c] = number;
    }
  }
}

std::vector<uint32_t> GltfFile::indices(int accessor_index, const std::string& where) const {
  Values values = accessor(accessor_index, where, {"SCALAR"});
  int type = int(size(all("accessors").at(accessor_index), "componentType", std::nullopt, where));
  if (type != 5121 && type != 5123 && type != 5125)
    refuse(where, fmt::format("indices have componentType {}, not an unsigned integer", type));
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

const Json& GltfFile::list(const Json& object, const std::string& key, const std::string& where) const {
  if (!object.is_object() || !object.contains(key)) return kNoList;
  if (!object[key].is_array()) refuse(where, fmt::format("'{}' is not a list", key));
  return object[key];
}

const Json& GltfFile::object(const Json& object, const std::string& key, const std::string& where) const {
  if (!object.is_object() || !object.contains(key)) return kNoObject;
  if (!object[key].is_object()) refuse(where, fmt::format("'{}' is not an object", key));
  return object[key];
}

const Json& GltfFile::extension(const Json& json, const std::string& name, bool* present) const {
  const Json& extensions = object(json, "extensions", "");
  if (present) *present = extensions.contains(name);
  return object(extensions, name, "extensions");
}

int GltfFile::index(const Json& object, const std::string& key, const std::string& list_name,
                    const std::string& where) const {
  if (!object.is_object() || !object.contains(key)) return -1;
  const Json& value = object[key];
  size_t count = all(list_name).size();
  bool valid = value.is_number_unsigned() && value.get<uint64_t>() < count;
  std::string got = value.is_number() ? value.dump() : value.type_name();
  if (!valid) refuse(where, fmt::format("'{}' is {}, but the file has {} {}", key, got, count, list_name));
  return value.get<int>();
}

double GltfFile::number(const Json& object, const std::string& key, double fallback, const std::string& where) const {
  if (!object.is_object() || !object.contains(key)) return fallback;
  if (!object[key].is_number()) refuse(where, fmt::format("'{}' is not a number", key));
  double value = object[key].get<double>();
  if (!std::isfinite(value)) refuse(where, fmt::format("'{}' is not finite", key));
  return value;
}

std::vector<double> GltfFile::numbers(const Json& object, const std::string& key, std::vector<double> fallback,
                                      const std::string& where) const {
  const Json& values = list(object, key, where);
  if (values.empty()) return fallback;
  if (values.size() != fallback.size()) refuse(where, fmt::format("'{}' has not {} numbers", key, fallback.size()));
  for (size_t i = 0; i < values.size(); ++i) {
    bool finite = values[i].is_number() && std::isfinite(values[i].get<double>());
    if (!finite) refuse(where, fmt::format("'{}' holds what is not a finite number", key));
    fallback[i] = values[i].get<double>();
  }
  return fallback;
}

double GltfFile::numberIn(const Json& object, const std::string& key, std::optional<double> fallback, double low,
                          double high, const std::string& where) const {
  if (!fallback) require(object, key, where);
  if (!object.contains(key)) return *fallback;
  double value = number(object, key, 0, where);
  if (value < low || value > high) refuse(where, fmt::format("'{}' is {}, not from {} to {}", key, value, low, high));
  return value;
}

void GltfFile::require(const Json& object, const std::string& key, const std::string& where) const {
  if (!object.contains(key)) refuse(where, fmt::format("'{}' is missing", key));
}

std::string GltfFile::text(const Json& object, const std::string& key, const std::string& where) const {
  if (!object.is_object() || !object.contains(key)) return "";
  if (!object[key].is_string()) refuse(where, fmt::format("'{}' is not a text", key));
  return object[key].get<std::string>();
}

std::vector<std::string> GltfFile::uniqueNames(const Json& list, const std::string& prefix,
                                               std::set<std::string> reserved) const {
  std::vector<std::string> names;
  std::set<std::string> taken = reserved, stated = std::move(reserved);
  for (const Json& object : list) stated.insert(text(object, "name"));
  auto claim = [&](const std::string& name, bool is_stated) {
    return is_stated == stated.contains(name) && taken.insert(name).second;
  };
  for (const Json& object : list) {
    const std::string own = text(object, "name");
    const std::string base = own.empty() ? fmt::format("{}_{}", prefix, names.size()) : own;
    std::string name = base;
    bool is_free = claim(name, !own.empty());
    for (int i = 2; !is_free; ++i) {
      name = fmt::format("{}#{}", base, i);
      is_free = claim(name, false);
    }
    names.push_back(name);
  }
  return names;
}

bool GltfFile::flag(const Json& object, const std::string& key, const std::string& where) const {
  if (!object.is_object() || !object.contains(key)) return false;
  if (!object[key].is_boolean()) refuse(where, fmt::format("'{}' is neither true nor false", key));
  return object[key].get<bool>();
}

size_t GltfFile::size(const Json& object, const std::string& key, std::optional<size_t> fallback,
                      const std::string& where) const {
  bool present = object.is_object() && object.contains(key);
  if (!present && fallback) return *fallback;
  if (!present) refuse(where, fmt::format("'{}' is missing", key));
  if (!object[key].is_number_unsigned()) refuse(where, fmt::format("'{}' is not a whole number", key));
  uint64_t value = object[key].get<uint64_t>();
  if (value > uint64_t(1) << 40) refuse(where, fmt::format("'{}' is {}", key, value));
  return size_t(value);
}

std::vector<double> sharesOf(const GltfFile& file, const Json& object, const std::string& key,
                             std::vector<double> fallback, const std::string& where) {
  std::vector<double> values = file.numbers(object, key, std::move(fallback), where);
  for (double value : values)
    if (value < 0 || value > 1) file.refuse(where, fmt::format("'{}' has {}, not from 0 to 1", key, value));
  return values;
}

std::vector<double> cutsOf(const GltfFile& file, const Json& object, const std::string& where) {
  if (!object.is_object() || !object.contains("extras")) return {};
  const Json& extras = object["extras"];
  const std::string place = where + ".extras";
  const std::vector<double> none(file.list(extras, "cuts", place).size());
  std::vector<double> cuts = file.numbers(extras, "cuts", none, place);
  if (!increase(cuts)) file.refuse(place, "'cuts' do not increase");
  return cuts;
}

}  // namespace strobe::scene
