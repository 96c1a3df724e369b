// SPDX-License-Identifier: MIT
// Writer of inline SVG without script, font or colour. A class names the role of a shape; assets/chart.css has the
// styles for light, dark and print. Coordinates are pixels of the page, x right and y down.
#pragma once

#include <string>

namespace strobe::page {

// Number of styles with different colours and dashes. Later styles repeat them, with the mark of the next
// colour for each repetition. Styles below 0 have no marks.
inline constexpr int kStyles = 8;
inline constexpr int kReferenceStyle = -1;    // thin, text colour: reference of the other series
inline constexpr int kUncertaintyStyle = -2;  // grey dots: uncertainty
inline constexpr int kFrontStyle = -3;        // thick and grey: Pareto front

// Class of a style: "s0" to "s7", "reference", "uncertainty", "front".
std::string classOf(int style);

// Writer of one SVG drawing: groups, paths, rectangles, texts and marks, appended in drawing order.
class Svg {
 public:
  // `about`: alternative text.
  Svg(int width, int height, const std::string& about);

  // Opens a group with these classes; `close` ends the group.
  void open(const std::string& classes);
  void close();

  void path(const std::string& classes, const std::string& d, const std::string& tip = "");
  void rectangle(const std::string& classes, double x, double y, double width, double height,
                 const std::string& tip = "");
  enum class Anchor { start, middle, end };
  void text(const std::string& classes, double x, double y, const std::string& text, Anchor anchor = Anchor::start);
  void upwardText(const std::string& classes, double x, double y, const std::string& text);  // centred at (x, y)
  // Mark of `style`, centred at (x, y).
  void mark(int style, double x, double y, bool hollow = false, const std::string& tip = "");

  std::string finished() const { return text_ + "</svg>\n"; }

 private:
  std::string text_;
};

// Estimated width of a text in a chart, pixels.
double estimatedWidth(const std::string& text);

}  // namespace strobe::page
