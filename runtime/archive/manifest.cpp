// SPDX-License-Identifier: MIT
#include "archive/manifest.h"

#include <OpenEXR/OpenEXRConfig.h>
#include <cairo.h>
#include <png.h>

#include <filesystem>
#include <regex>
#include <sstream>

#include "base/hash.h"
#include "base/process.h"
#include "base/version.h"
#include "lab/capture.h"
#include "lab/record.h"

namespace strobe::archive {

namespace fs = std::filesystem;

// Output of a git command in a folder; nothing if the folder is not in a repository, or if git is not installed.
static std::optional<std::string> git(const Path& folder, const std::vector<std::string>& arguments) {
  std::vector<std::string> line = {"git", "--no-optional-locks", "-C", folder.string()};
  line.insert(line.end(), arguments.begin(), arguments.end());
  try {
    ProgramEnd end = run({.arguments = line, .wall_s = 20});
    if (end.code() != 0) return {};
    return end.output.substr(0, end.output.find_last_not_of('\n') + 1);
  } catch (const Error&) {
    return {};
  }
}

Json programJson(const Home& home) {
  Json json = {{"version", kVersion}, {"program", lab::programHash()}};
  if (std::optional<std::string> revision = git(home.shipped(), {"rev-parse", "HEAD"})) {
    json["revision"] = *revision;
    json["modified"] = !git(home.shipped(), {"status", "--porcelain"}).value_or("").empty();
  }
  json["libraries"] = {{"OpenEXR", OPENEXR_VERSION_STRING},
                       {"libpng", PNG_LIBPNG_VER_STRING},
                       {"cairo", cairo_version_string()},
                       {"compiler", __VERSION__}};
  return json;
}

Json deviceJson(const gpu::DeviceInfo& device) {
  Json json = {{"name", device.name}, {"driver", device.driver}, {"api", device.api}, {"software", device.software}};
  std::smatch found;
  const std::string text = device.name + " " + device.driver;
  if (std::regex_search(text, found, std::regex("LLVM ([0-9][0-9.]*)"))) json["llvm"] = found[1].str();
  if (std::regex_search(text, found, std::regex("([0-9]+) bits"))) json["vector_bits"] = std::stoi(found[1].str());
  return json;
}

// Sum of a file in the SHA256SUMS beside it; "" if SHA256SUMS does not list the file.
static std::string statedSum(const Path& file) {
  Path sums = file.parent_path() / kSumsFile;
  if (!fs::is_regular_file(sums)) return "";
  std::istringstream lines(readText(sums));
  for (std::string sum, name; lines >> sum >> name;)
    if (name == file.filename()) return sum;
  return "";
}

Manifest readManifest(const Path& given) {
  Path file = fs::is_directory(given) ? given / kManifestFile : given;
  Place place{file.string()};
  std::string text = readText(file);
  Json json = Json::parse(text, nullptr, false);
  bool has_format = json.is_object() && json.contains("format") && json.contains("format_version");
  if (!has_format || json["format"] != kManifestFormat || !json["format_version"].is_number_integer())
    throw Error("is not a manifest of a capture, or it is cut short", place);
  int version = json["format_version"];
  if (version > kManifestVersion)
    throw Error(fmt::format("is a manifest of format {}; this program reads up to {}", version, kManifestVersion),
                place);
  for (const char* part : {"capture", "program", "device", "inputs", "pictures", "files"})
    if (!json.contains(part)) throw Error(fmt::format("is a manifest without '{}'", part), place);
  std::string stated = statedSum(file);
  if (!stated.empty() && stated != sha256(text))
    throw Error(fmt::format("differs from its checksum in {}: one of the two is damaged or was edited", kSumsFile),
                place);
  return {file.parent_path(), std::move(json)};
}

Json fileEntry(const Path& file) {
  std::string bytes = readText(file);
  return {{"sha256", sha256(bytes)}, {"bytes", bytes.size()}};
}

std::string sumsOf(const Path& folder, const std::set<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += sha256(readText(folder / name)) + "  " + name + "\n";
  return text;
}

// ---- images of a picture

Json layersJson(const Images& images) {
  Json json = Json::object();
  for (const auto& [name, image] : images) {
    Json size = {image.width(), image.height()};
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
