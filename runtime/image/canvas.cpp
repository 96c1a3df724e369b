// SPDX-License-Identifier: MIT
#include "image/canvas.h"

#include <cairo-ft.h>
#include <cairo-pdf.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <vector>

#include "base/error.h"
#include "image/tone.h"
#include "math/constants.h"

namespace strobe::image {

Path fontFile() {
  for (const char* candidate : {STROBE_FONT_FILE, "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
                                "/usr/share/fonts/dejavu/DejaVuSans.ttf", "/usr/share/fonts/TTF/DejaVuSans.ttf"})
    if (*candidate && std::filesystem::is_regular_file(candidate)) return candidate;
  throw Error("the font DejaVuSans.ttf is not installed (Debian package fonts-dejavu-core)");
}

namespace {

constexpr Colour kBorder = {0.03f, 0.03f, 0.04f};
constexpr double kBorderAlpha = 0.8;
// Creation date of every PDF file. Constant, so that equal figures give equal files.
constexpr const char* kDate = "2000-01-01T00:00:00Z";

// Font face from the font file, independent of fontconfig. Never freed, because cairo keeps text that was drawn with
// the face.
cairo_font_face_t* fontFace() {
  static cairo_font_face_t* const made = [] {
    static std::vector<uint8_t> bytes = readBytes(fontFile());
    FT_Library library = nullptr;
    FT_Face face = nullptr;
    bool good = FT_Init_FreeType(&library) == 0 &&
                FT_New_Memory_Face(library, bytes.data(), FT_Long(bytes.size()), 0, &face) == 0;
    if (!good) throw Error("is not a readable font", {fontFile().string()});
    return cairo_ft_font_face_create_for_ft_face(face, FT_LOAD_NO_HINTING);
  }();
  return made;
}

// Font options without hinting: outlines are not fitted to pixels.
cairo_font_options_t* fontOptions() {
  static cairo_font_options_t* const made = [] {
    cairo_font_options_t* options = cairo_font_options_create();
    cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
    cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
    return options;
  }();
  return made;
}

void useFont(cairo_t* cairo, double size_px) {
  cairo_set_font_face(cairo, fontFace());
  cairo_set_font_options(cairo, fontOptions());
  cairo_set_font_size(cairo, size_px);
}

cairo_surface_t* surfaceOf(const Image& display) {
  STROBE_ASSERT(display.channels == 1 || display.channels >= 3, "{} channels", display.channels);
  cairo_surface_t* surface = cairo_image_surface_create(CAIRO_FORMAT_RGB24, display.width, display.height);
  STROBE_ASSERT(cairo_surface_status(surface) == CAIRO_STATUS_SUCCESS, "{}x{}", display.width, display.height);
  unsigned char* data = cairo_image_surface_get_data(surface);
  int stride = cairo_image_surface_get_stride(surface);
  for (int y = 0; y < display.height; ++y) {
    auto* row = reinterpret_cast<uint32_t*>(data + size_t(y) * size_t(stride));
    for (int x = 0; x < display.width; ++x) {
      const float* pixel = display.pixel(x, y);
      bool grey = display.channels == 1;
      row[x] = uint32_t(levelOf(pixel[0])) << 16 | levelOf(pixel[grey ? 0 : 1]) << 8 | levelOf(pixel[grey ? 0 : 2]);
    }
  }
  cairo_surface_mark_dirty(surface);
  return surface;
}

cairo_status_t append(void* closure, const unsigned char* data, unsigned int length) {
  static_cast<std::string*>(closure)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

cairo_surface_t* pageSurface(std::string* bytes, int width, int height, double points_per_px,
                             const std::string& title) {
  cairo_surface_t* surface =
      cairo_pdf_surface_create_for_stream(append, bytes, width * points_per_px, height * points_per_px);
  cairo_pdf_surface_restrict_to_version(surface, CAIRO_PDF_VERSION_1_4);
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATE_DATE, kDate);
  if (!title.empty()) cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_TITLE, title.c_str());
  return surface;
}

// Cairo context for measuring text.
cairo_t* ruler() {
  static cairo_t* const made = [] {
    cairo_surface_t* surface = cairo_image_surface_create(CAIRO_FORMAT_A8, 1, 1);
    cairo_t* cairo = cairo_create(surface);
    cairo_surface_destroy(surface);
    return cairo;
  }();
  return made;
}

cairo_font_extents_t fontExtents(cairo_t* cairo) {
  cairo_font_extents_t extents;
  cairo_font_extents(cairo, &extents);
  return extents;
}

}  // namespace

double textWidth(const std::string& text, double size_px) {
  useFont(ruler(), size_px);
  cairo_text_extents_t extents;
  cairo_text_extents(ruler(), text.c_str(), &extents);
  return extents.x_advance;
}

double lineHeight(double size_px) {
  useFont(ruler(), size_px);
  cairo_font_extents_t extents = fontExtents(ruler());
  return extents.ascent + extents.descent;
}

void Canvas::Destroy::operator()(cairo_t* cairo) const { cairo_destroy(cairo); }
void Canvas::Destroy::operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }

Canvas::Canvas(Kind kind, int width, int height, double points_per_px, const std::string& title)
    : kind_(kind), width_(width), height_(height), bytes_(std::make_unique<std::string>()) {
  constexpr int kMost = 32767;
  STROBE_ASSERT(width > 0 && height > 0, "{}x{}", width, height);
  if (width > kMost || height > kMost)
    throw Error(fmt::format("a figure of {}x{} pixels is too large: {} a side at most", width, height, kMost));
  surface_.reset(kind == Kind::page ? pageSurface(bytes_.get(), width, height, points_per_px, title)
                                    : cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height));
  cairo_.reset(cairo_create(surface_.get()));
  if (kind == Kind::page) cairo_scale(cairo_.get(), points_per_px, points_per_px);
  fill({0, 0, width, height}, {1, 1, 1});
  check();
}

Canvas::Canvas(const Image& display) : Canvas(Kind::pixels, display.width, display.height) { picture(display, 0, 0); }

void Canvas::check() const {
  cairo_status_t status = cairo_status(cairo_.get());
  if (status == CAIRO_STATUS_SUCCESS) status = cairo_surface_status(surface_.get());
  if (status != CAIRO_STATUS_SUCCESS) throw Error(fmt::format("drawing failed: {}", cairo_status_to_string(status)));
}

void Canvas::ink(const Colour& colour, double alpha) {
  // Colours have 8 bits, as in pictures.
  auto channel = [&](size_t c) { return levelOf(colour[c]) / 255.0; };
  cairo_set_source_rgba(cairo_.get(), channel(0), channel(1), channel(2), alpha);
}

void Canvas::circle(dvec2 centre, double radius) {
  cairo_new_sub_path(cairo_.get());
  cairo_arc(cairo_.get(), centre.x, centre.y, radius, 0, 2 * kPi);
  cairo_close_path(cairo_.get());
}

void Canvas::picture(const Image& display, int x, int y, bool round) {
  std::unique_ptr<cairo_surface_t, Destroy> surface(surfaceOf(display));
  cairo_save(cairo_.get());
  cairo_set_source_surface(cairo_.get(), surface.get(), x, y);
  cairo_pattern_set_filter(cairo_get_source(cairo_.get()), CAIRO_FILTER_NEAREST);
  const int radius = (display.width - 1) / 2;
  if (round) circle(dvec2(x, y) + dvec2(display.width, display.height) / 2.0, radius);
  else cairo_rectangle(cairo_.get(), x, y, display.width, display.height);
  cairo_fill(cairo_.get());
  cairo_restore(cairo_.get());
}

void Canvas::fill(const Rectangle& area, const Colour& colour, double alpha, double radius) {
  ink(colour, alpha);
  for (int corner = 0; radius > 0 && corner < 4; ++corner)  // clockwise from the upper right
    cairo_arc(cairo_.get(), area.x + (corner < 2 ? area.width - radius : radius),
              area.y + (corner % 3 ? area.height - radius : radius), radius, (corner - 1) * kPi / 2, corner * kPi / 2);
  if (!(radius > 0)) cairo_rectangle(cairo_.get(), area.x, area.y, area.width, area.height);
  cairo_fill(cairo_.get());
}

void Canvas::frame(const Rectangle& area, int thickness, const Colour& colour) {
  int t = std::min({thickness, area.width, area.height});
  if (t <= 0) return;
  if (2 * t >= std::min(area.width, area.height)) return fill(area, colour);
  ink(colour);
  cairo_set_line_width(cairo_.get(), t);
  cairo_set_line_join(cairo_.get(), CAIRO_LINE_JOIN_MITER);
  cairo_rectangle(cairo_.get(), area.x + t / 2.0, area.y + t / 2.0, area.width - t, area.height - t);
  cairo_stroke(cairo_.get());
}

// Strokes the path twice: first wider and dark, then in `colour`.
void Canvas::outlined(double width, const Colour& colour) {
  double border = std::clamp(0.4 * width, 0.6, 2.0);
  ink(kBorder, kBorderAlpha);
  cairo_set_line_width(cairo_.get(), width + 2 * border);
  cairo_stroke_preserve(cairo_.get());
  ink(colour);
  cairo_set_line_width(cairo_.get(), width);
  cairo_stroke(cairo_.get());
}

void Canvas::line(dvec2 from, dvec2 to, double width, const Colour& colour) {
  cairo_set_line_cap(cairo_.get(), CAIRO_LINE_CAP_ROUND);
  cairo_move_to(cairo_.get(), from.x, from.y);
  cairo_line_to(cairo_.get(), to.x, to.y);
  outlined(width, colour);
}

void Canvas::arrow(dvec2 from, dvec2 to, double width, const Colour& colour) {
  double length = glm::length(to - from);
  if (!(length > 0) || !std::isfinite(length)) return;
  dvec2 along = (to - from) / length, across(-along.y, along.x);
  double head = std::min(4.2 * width, length), half = 0.5 * std::min(width, head);
  dvec2 neck = to - along * head * 0.85, barb = to - along * head;
  const dvec2 corners[] = {to,
                           barb + across * head * 0.46,
                           neck + across * half,
                           from + across * half,
                           from - across * half,
                           neck - across * half,
                           barb - across * head * 0.46};
  for (const dvec2& corner : corners) cairo_line_to(cairo_.get(), corner.x, corner.y);
  cairo_close_path(cairo_.get());
  cairo_set_line_join(cairo_.get(), CAIRO_LINE_JOIN_ROUND);
  ink(kBorder, kBorderAlpha);
  cairo_set_line_width(cairo_.get(), 2 * std::clamp(0.35 * width, 0.6, 2.0));
  cairo_stroke_preserve(cairo_.get());
  ink(colour);
  cairo_fill(cairo_.get());
}

void Canvas::ring(dvec2 centre, double radius, double width, const Colour& colour) {
  circle(centre, radius);
  outlined(width, colour);
}

void Canvas::disc(dvec2 centre, double radius, const Colour& colour) {
  ink(kBorder, kBorderAlpha);
  circle(centre, radius + std::clamp(0.35 * radius, 0.5, 1.5));
  cairo_fill(cairo_.get());
  ink(colour);
  circle(centre, radius);
  cairo_fill(cairo_.get());
}

void Canvas::text(double x, double y, const std::string& text, double size_px, const Colour& colour) {
  useFont(cairo_.get(), size_px);
  ink(colour);
  cairo_move_to(cairo_.get(), x, y + fontExtents(cairo_.get()).ascent);
  cairo_show_text(cairo_.get(), text.c_str());
  cairo_new_path(cairo_.get());
}

void Canvas::turnedText(double x, double y, const std::string& text, double size_px, const Colour& colour) {
  cairo_save(cairo_.get());
  cairo_translate(cairo_.get(), x, y);
  cairo_rotate(cairo_.get(), -kPi / 2);
  this->text(0, 0, text, size_px, colour);
  cairo_restore(cairo_.get());
}

void Canvas::clip(const Rectangle& area) {
  cairo_save(cairo_.get());
  cairo_rectangle(cairo_.get(), area.x, area.y, area.width, area.height);
  cairo_clip(cairo_.get());
}

void Canvas::unclip() { cairo_restore(cairo_.get()); }

Image Canvas::pixels() {
  STROBE_ASSERT(kind_ == Kind::pixels);
  check();
  cairo_surface_flush(surface_.get());
  const unsigned char* data = cairo_image_surface_get_data(surface_.get());
  int stride = cairo_image_surface_get_stride(surface_.get());
  Image display(width_, height_, 3);
  for (int y = 0; y < height_; ++y) {
    const auto* row = reinterpret_cast<const uint32_t*>(data + size_t(y) * size_t(stride));
    for (int x = 0; x < width_; ++x)
      for (int c = 0; c < 3; ++c) display.at(x, y, c) = float(row[x] >> (16 - 8 * c) & 0xff) / 255.0f;
  }
  return display;
}

std::string Canvas::page() {
  STROBE_ASSERT(kind_ == Kind::page);
  check();
  cairo_.reset();
  cairo_surface_finish(surface_.get());
  cairo_status_t status = cairo_surface_status(surface_.get());
  if (status != CAIRO_STATUS_SUCCESS) throw Error(fmt::format("drawing failed: {}", cairo_status_to_string(status)));
  return std::move(*bytes_);
}

}  // namespace strobe::image
