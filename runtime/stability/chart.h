// SPDX-License-Identifier: MIT
// Curves as inline SVG: no script, no font, no colour of its own (classes; the page says which). What a line is can be
// told without colour too, by its dashes, its marks and the label at its end.
#pragma once

#include <string>
#include <vector>

namespace strobe::stability::curves {

struct Tick {
  double at = 0;      // 0 to 1 along the axis
  std::string label;  // "" for a small tick
};

// Where a value lies along an axis, 0 to 1. On a logarithmic one, 0 has a place of its own before a gap.
class Scale {
 public:
  enum class Kind { log, linear, even };
  // By the smallest and largest of `values`, or (even) each as far from the next. With `rounded`, a logarithmic scale
  // reaches to 1, 3 or 10 times a power of ten on both sides.
  Scale(Kind kind, const std::vector<double>& values, bool rounded = false);

  double at(double value) const;  // clamped to the axis
  std::vector<Tick> ticks() const;
  bool hasZero() const { return zero_; }
  // Where what is above zero begins.
  double gap() const;

 private:
  std::vector<Tick> logTicks() const;
  std::vector<Tick> linearTicks() const;

  Kind kind_;
  std::vector<double> values_;  // of an even scale
  double low_ = 0, high_ = 1;   // powers of ten for a logarithmic scale
  bool zero_ = false;
};

// "0.01", "1000", "10⁻⁶".
std::string shownNumber(double value);

struct ChartPoint {
  double x = 0, y = 0;  // y: NaN leaves a gap
  std::string tip;      // shown where the pointer rests
  bool hollow = false;  // a limit was met
  bool faint = false;   // not to be trusted, nor what leads to it
};

struct ChartLine {
  std::string label;
  int style = 0;  // of the methods, in order; beside: kFloorStyle, kErrorStyle
  std::vector<ChartPoint> points;
};
inline constexpr int kFloorStyle = -1, kErrorStyle = -2;
inline constexpr int kStyles = 8;  // that differ in marks and dashes; later ones repeat

struct Chart {
  std::string about;  // for people who cannot see it
  std::string x_title, y_title;
  Scale::Kind x_scale = Scale::Kind::log;
  double benign = 0;
  double band = 0;  // shaded: below so many times the floor's line; 0: nothing
  std::vector<ChartLine> lines;
};

// `width` x `height` in pixels of the page. The vertical axis is logarithmic and reaches over four powers of ten at
// most: what is smaller lies on its lower border.
std::string svgOf(const Chart& chart, int width = 940, int height = 430);

// Colours and widths of the classes, for light and dark.
extern const char* const kChartStyle;

}  // namespace strobe::stability::curves
