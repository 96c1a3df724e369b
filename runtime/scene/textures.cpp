// SPDX-License-Identifier: MIT
#include "scene/textures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "base/cores.h"

namespace strobe::scene {

double linearFromSrgb(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

namespace {

struct SrgbTables {
  std::array<float, 256> linear;
  std::array<float, 255> between;  // linear light halfway (in code) between i and i + 1
  SrgbTables() {
    for (int i = 0; i < 256; ++i) linear[i] = float(linearFromSrgb(i / 255.0));
    for (int i = 0; i < 255; ++i) between[i] = float(linearFromSrgb((i + 0.5) / 255));
  }
  uint8_t encode(float value) const {
    return uint8_t(std::upper_bound(between.begin(), between.end(), value) - between.begin());
  }
};

const SrgbTables& srgb() {
  static const SrgbTables tables;
  return tables;
}

uint8_t encodeUnorm(float value) { return uint8_t(std::lround(std::clamp(value, 0.0f, 1.0f) * 255)); }

std::vector<vec4> decode(const std::vector<uint8_t>& bytes, Texture::Format format) {
  std::vector<vec4> texels(bytes.size() / (format == Texture::Format::Rgba32f ? 16 : 4));
  for (size_t i = 0; i < texels.size(); ++i) {
    if (format == Texture::Format::Rgba32f) {
      std::memcpy(&texels[i], &bytes[16 * i], 16);
      continue;
    }
    for (int c = 0; c < 4; ++c) {
      bool as_srgb = format == Texture::Format::Rgba8Srgb && c < 3;
      texels[i][c] = as_srgb ? srgb().linear[bytes[4 * i + c]] : bytes[4 * i + c] / 255.0f;
    }
  }
  return texels;
}

std::vector<uint8_t> encode(const std::vector<vec4>& texels, Texture::Format format) {
  if (format == Texture::Format::Rgba32f) {
    std::vector<uint8_t> bytes(16 * texels.size());
    std::memcpy(bytes.data(), texels.data(), bytes.size());
    return bytes;
  }
  std::vector<uint8_t> bytes(4 * texels.size());
  for (size_t i = 0; i < texels.size(); ++i) {
    for (int c = 0; c < 4; ++c) {
      bool as_srgb = format == Texture::Format::Rgba8Srgb && c < 3;
      bytes[4 * i + c] = as_srgb ? srgb().encode(texels[i][c]) : encodeUnorm(texels[i][c]);
    }
  }
  return bytes;
}

// One axis of the reduction: source texels of each smaller texel, and their shares (an odd size gives three).
struct Share {
  int from;
  int count;
  float weights[3];
};

std::vector<Share> shares(int size, int smaller) {
  std::vector<Share> result;
  double ratio = double(size) / smaller;
  for (int i = 0; i < smaller; ++i) {
    double low = i * ratio, high = (i + 1) * ratio;
    Share share{int(low), 0, {}};
    for (int k = share.from; k < size && k < high - 1e-9 && share.count < 3; ++k) {
      double overlap = std::min(high, k + 1.0) - std::max(low, double(k));
      share.weights[share.count++] = float(overlap / ratio);
    }
    result.push_back(share);
  }
  return result;
}

// `by_alpha` weights colours with alpha, so that transparent texels do not bleed into opaque texels.
std::vector<vec4> halved(const std::vector<vec4>& texels, ivec2 size, ivec2 smaller, bool by_alpha) {
  std::vector<Share> columns = shares(size.x, smaller.x), lines = shares(size.y, smaller.y);
  std::vector<vec4> result(size_t(smaller.x) * smaller.y);
  for (int y = 0; y < smaller.y; ++y) {
    for (int x = 0; x < smaller.x; ++x) {
      vec4 sum(0), weighted(0);
      for (int j = 0; j < lines[y].count; ++j) {
        for (int i = 0; i < columns[x].count; ++i) {
          float weight = lines[y].weights[j] * columns[x].weights[i];
          const vec4& texel = texels[size_t(lines[y].from + j) * size.x + columns[x].from + i];
          sum += weight * texel;
          weighted += weight * texel.w * texel;
        }
      }
      vec4& out = result[size_t(y) * smaller.x + x];
      out = by_alpha && sum.w > 0 ? vec4(vec3(weighted) / sum.w, sum.w) : sum;
    }
  }
  return result;
}

}  // namespace

void buildLevels(Texture& texture) {
  texture.levels.resize(1);
  std::vector<vec4> texels = decode(texture.levels[0], texture.format);
  ivec2 size(texture.width, texture.height);
  while (size.x > 1 || size.y > 1) {
    ivec2 smaller = glm::max(size / 2, ivec2(1));
    texels = halved(texels, size, smaller, texture.format == Texture::Format::Rgba8Srgb);
    texture.levels.push_back(encode(texels, texture.format));
    size = smaller;
  }
}

vec3 meanColor(const Texture& texture) {
  std::vector<vec4> texels = decode(texture.levels.back(), texture.format);
  dvec3 sum(0);
  for (const vec4& texel : texels) sum += dvec3(texel);
  return vec3(sum / double(texels.size()));
}

Texture paint(int width, int height, int samples, const std::function<vec4(dvec2 uv)>& color_at) {
  std::vector<vec4> texels(size_t(width) * height);
  auto texel = [&](int x, int y) {
    vec4 sum(0);
    for (int j = 0; j < samples; ++j)
      for (int i = 0; i < samples; ++i)
        sum += color_at({(x + (i + 0.5) / samples) / width, (y + (j + 0.5) / samples) / height});
    return sum / float(samples * samples);
  };
  forEachOnAllCores(size_t(height), [&](size_t y) {
    for (int x = 0; x < width; ++x) texels[y * size_t(width) + size_t(x)] = texel(x, int(y));
  });
  Texture texture;
  texture.width = width;
  texture.height = height;
  texture.levels = {encode(texels, texture.format)};
  buildLevels(texture);
  return texture;
}

Texture texelTexture(int width, int height, const std::vector<vec4>& texels) {
  Texture texture;
  texture.format = Texture::Format::Rgba32f;
  texture.width = width;
  texture.height = height;
  texture.magnify = texture.minify = Texture::Filter::Nearest;
  texture.between = Texture::Levels::None;
  texture.levels = {encode(texels, texture.format)};
  return texture;
}

glm::dmat3x2 uvTransform(dvec2 offset, double rotation, dvec2 scale) {
  double c = std::cos(rotation), s = std::sin(rotation);
  return glm::dmat3x2(dvec2(c, -s) * scale.x, dvec2(s, c) * scale.y, offset);
}

}  // namespace strobe::scene
