// SPDX-License-Identifier: MIT
// Inline SVG in the making: no script, no font, no colour of its own. Classes say what a shape is; assets/chart.css
// says how it looks in light, in dark and in print. Coordinates are pixels of the page, x right and y down.
#pragma once

#include <string>

namespace strobe::page {

// Colours, dashes and hatches differ in this many styles; later ones repeat, with the marks of the next colour each
// time. Below 0 are styles without marks.
inline constexpr int kStyles = 8;
inline constexpr int kReferenceStyle = -1;    // thin, the colour of text: what others are held against
inline constexpr int kUncertaintyStyle = -2;  // grey dots: what is not known better
inline constexpr int kFrontStyle = -3;        // thick and grey: the border of what others are dominated by

// "s0" to "s7", "reference", "uncertainty", "front".
std::string classOf(int style);

class Svg {
 public:
  // `about` is for people who cannot see it.
  Svg(int width, int height, const std::string& about);

  // Until `close`, what follows is of this class.
  void open(const std::string& classes);
  void close();

  void path(const std::string& classes, const std::string& d, const std::string& tip = "");
  void rectangle(const std::string& classes, double x, double y, double width, double height,
                 const std::string& tip = "");
  enum class Anchor { start, middle, end };
  void text(const std::string& classes, double x, double y, const std::string& text, Anchor anchor = Anchor::start);
  void upwardText(const std::string& classes, double x, double y, const std::string& text);  // middle at (x, y)
  // The shape of `style`, about (x, y).
  void mark(int style, double x, double y, bool hollow = false, const std::string& tip = "");
  // Lines across a rectangle that set a style apart without colour; style 0 has none.
  void hatch(int style, double x, double y, double width, double height);

  std::string finished() const { return text_ + "</svg>\n"; }

 private:
  std::string text_;
};

// Pixels that a text of the size used in charts takes, about.
double estimatedWidth(const std::string& text);

}  // namespace strobe::page
