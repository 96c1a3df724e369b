// SPDX-License-Identifier: MIT
#include "scene/kept_textures.h"

#include <fmt/format.h>
#include <gnu/libc-version.h>

#include "base/hash.h"
#include "base/kept_files.h"

namespace strobe::scene {

namespace {

// Hash of all inputs of a painted texture: sources of the painting code, compiler, math library, pattern.
std::string keyOf(const Pattern& p) {
  std::string key =
      fmt::format("{} {} {} {} {}x{} {:a} {:a} {:a} {:a} {}", STROBE_PAINTING, __VERSION__, ::gnu_get_libc_version(),
                  p.type, p.width, p.height, p.count.x, p.count.y, p.amount, p.line, p.seed);
  for (const vec3& color : p.colors) key += fmt::format(" c{:a},{:a},{:a}", color.x, color.y, color.z);
  for (double width : p.widths) key += fmt::format(" w{:a}", width);
  return hashText(key);
}

std::string bytesOf(const Texture& texture) {
  std::string bytes;
  for (const std::vector<uint8_t>& level : texture.levels) bytes.append(level.begin(), level.end());
  return bytes;
}

Texture textureOf(const Pattern& pattern, const std::string& bytes) {
  Texture texture;
  texture.name = pattern.type;
  texture.width = pattern.width;
  texture.height = pattern.height;
  size_t from = 0;
  for (ivec2 size(pattern.width, pattern.height); from < bytes.size(); size = glm::max(size / 2, ivec2(1))) {
    const size_t count = size_t(size.x) * size.y * 4;
    STROBE_ASSERT(from + count <= bytes.size(), "{} {}", from + count, bytes.size());
    texture.levels.emplace_back(bytes.begin() + from, bytes.begin() + from + count);
    from += count;
  }
  return texture;
}

}  // namespace

Painter keptPainter(const Path& folder) {
  return [kept = KeptFiles(folder.empty() ? folder : folder / "textures")](const Pattern& pattern) {
    const std::string key = keyOf(pattern);
    if (const std::optional<std::string> found = kept.find(key)) return textureOf(pattern, *found);
    Texture texture = paintPattern(pattern);
    kept.keep(key, bytesOf(texture));
    return texture;
  };
}

}  // namespace strobe::scene
