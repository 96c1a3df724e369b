// SPDX-License-Identifier: MIT
// Text of draw.h, rasterised by stb_truetype.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <vector>

#include "base/error.h"
#include "base/files.h"
#include "base/utf8.h"
#include "image/draw.h"

#define STBTT_STATIC
#define STB_TRUETYPE_IMPLEMENTATION
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb_truetype.h>
#pragma GCC diagnostic pop

namespace strobe::image {

Path fontFile() {
  for (const char* candidate : {STROBE_FONT_FILE, "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
                                "/usr/share/fonts/dejavu/DejaVuSans.ttf", "/usr/share/fonts/TTF/DejaVuSans.ttf"})
    if (*candidate && std::filesystem::is_regular_file(candidate)) return candidate;
  throw Error("the font DejaVuSans.ttf is not installed (Debian package fonts-dejavu-core)");
}

namespace {

struct Font {
  std::vector<uint8_t> bytes;
  stbtt_fontinfo info{};

  Font() : bytes(readBytes(fontFile())) {
    if (!stbtt_InitFont(&info, bytes.data(), 0)) throw Error("is not a readable font", {fontFile().string()});
  }
};

const Font& font() {
  static const Font loaded;
  return loaded;
}

struct Glyph {
  int point;
  float x;  // pen position, px
};

// Pen positions from 0. `end` is the pen position after the last glyph.
std::vector<Glyph> layOut(const std::string& text, float scale, float& end) {
  std::vector<Glyph> glyphs;
  std::vector<int> points;
  for (char32_t point : codePoints(text)) points.push_back(static_cast<int>(point));
  end = 0;
  for (size_t i = 0; i < points.size(); ++i) {
    glyphs.push_back({points[i], end});
    int advance = 0, bearing = 0;
    stbtt_GetCodepointHMetrics(&font().info, points[i], &advance, &bearing);
    if (i + 1 < points.size()) advance += stbtt_GetCodepointKernAdvance(&font().info, points[i], points[i + 1]);
    end += scale * advance;
  }
  return glyphs;
}

void drawGlyph(Image& onto, const Glyph& glyph, float scale, int x, int baseline, const Colour& colour) {
  float pen = x + glyph.x, fraction = pen - std::floor(pen);
  int width = 0, height = 0, left = 0, top = 0;
  unsigned char* coverage = stbtt_GetCodepointBitmapSubpixel(&font().info, scale, scale, fraction, 0, glyph.point,
                                                             &width, &height, &left, &top);
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column)
      blend(onto, static_cast<int>(std::floor(pen)) + left + column, baseline + top + row, colour,
            coverage[row * width + column] / 255.0f);
  stbtt_FreeBitmap(coverage, nullptr);
}

}  // namespace

void drawText(Image& onto, int x, int y, const std::string& text, float size_px, const Colour& colour) {
  STROBE_ASSERT(onto.channels == 3, "{} channels", onto.channels);
  float scale = stbtt_ScaleForPixelHeight(&font().info, size_px);
  int ascent = 0, descent = 0, gap = 0;
  stbtt_GetFontVMetrics(&font().info, &ascent, &descent, &gap);
  int baseline = y + static_cast<int>(std::lround(scale * ascent));
  float end = 0;
  for (const Glyph& glyph : layOut(text, scale, end)) drawGlyph(onto, glyph, scale, x, baseline, colour);
}

int textWidth(const std::string& text, float size_px) {
  float end = 0;
  layOut(text, stbtt_ScaleForPixelHeight(&font().info, size_px), end);
  return static_cast<int>(std::ceil(end));
}

}  // namespace strobe::image
