// SPDX-License-Identifier: MIT
#include "scene/scene_files.h"

#include <algorithm>
#include <filesystem>

#include "base/hash.h"
#include "base/home.h"
#include "scene/image_decode.h"

namespace strobe::scene {

std::optional<Path> SceneFiles::find(const std::string& name, SceneFields& fields) const {
  const Path folder = std::filesystem::absolute(places_.folder);
  const Path file = (folder / name).lexically_normal();
  std::error_code missing;
  std::string mistake;
  if (name.empty() || Path(name).is_absolute()) mistake = "is not a relative path";
  else if (!std::filesystem::is_regular_file(file, missing)) mistake = "is not a file in the scene's folder";
  else if (!places_.allow_outside && !liesIn(file, places_.root.empty() ? folder : places_.root))
    mistake = fmt::format("is outside of the scene's {}; use --allow-outside to read it",
                          places_.root.empty() ? "folder" : "project");
  if (mistake.empty()) return file;
  fields.problem(fmt::format("'{}' {}", name, mistake));
  return std::nullopt;
}

std::optional<Texture> SceneFiles::image(const std::string& name, SceneFields& fields) {
  const std::optional<Path> file = find(name, fields);
  if (!file) return std::nullopt;
  const std::string bytes = readText(*file);
  add({*file, hashText(bytes)});
  std::optional<DecodedImage> decoded = decodeImage(reinterpret_cast<const uint8_t*>(bytes.data()), bytes.size());
  if (!decoded) {
    fields.problem(fmt::format("'{}' is not a readable PNG or JPEG", name));
    return std::nullopt;
  }
  Texture texture;
  texture.width = decoded->width;
  texture.height = decoded->height;
  texture.levels = {std::move(decoded->rgba)};
  return texture;
}

void SceneFiles::add(const SourceFile& file) {
  const bool known = std::any_of(read_.begin(), read_.end(), [&](const auto& one) { return one.path == file.path; });
  if (!known) read_.push_back(file);
}

}  // namespace strobe::scene
