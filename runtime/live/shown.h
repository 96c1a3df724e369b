// SPDX-License-Identifier: MIT
// Picture in the middle of the window, of one side or of a comparison, with its values.
#pragma once

#include <array>

#include "lab/views.h"
#include "live/gathered_truth.h"
#include "live/sides.h"

namespace strobe::live {

// Comparison mode of the displayed picture: a single side, A and B divided by a wipe line, A and B in alternation,
// their difference, or the error against ground truth.
enum class Mode { Single, Wipe, Flicker, Difference, Error };
const std::vector<std::string>& modeNames();  // in the order of `Mode`
Mode modeNamed(const std::string& name);      // throws `Error` with the nearest name
bool comparesWithB(Mode mode);

// Image, view and comparison mode of the window.
struct Look {
  std::string port = "color";  // an output, or "node.port"
  lab::ViewOptions view;
  Mode mode = Mode::Single;
  bool single_b = false;  // Mode::Single shows B
  double wipe = 0.5;      // position of the line, fraction of the width
  double gain = 4;        // of differences and errors; full scale is 1 / gain
  // True if errors or differences are shown. Both are of the colour, whatever `port` is.
  bool isOfColour() const { return mode == Mode::Error || mode == Mode::Difference; }
  bool operator==(const Look&) const = default;
};

// Value of the picture at a pixel: output of a pass, or a difference.
struct PixelValue {
  char side = 'A';             // 'A' or 'B'; ' ' for a difference of both
  std::string port, format;    // format: "" for a difference
  int x = 0, y = 0;            // texel in its image
  std::vector<double> values;  // integers are exact
  bool integers = false;
};

// Picture of a window frame. Refers to the constructor's arguments, which must outlive it.
class Shown {
 public:
  // `b` may be null. `window_frame` selects the side in flicker mode.
  Shown(const Side& a, const Side* b, const Look& look, const GatheredTruth& truth, int window_frame)
      : a_(a), b_(b), look_(look), truth_(truth), window_frame_(window_frame) {}

  // Side that an undivided picture shows.
  const Side& side() const;
  // Value of the displayed image at a pixel, from the side that is displayed there. A difference or an error is
  // followed by the colours that it compares. Empty outside of the frame.
  std::vector<PixelValue> valuesAt(int x, int y) const;
  // Returns the picture. `legends`: A's and B's in a divided picture, the second one empty if both are equal; otherwise
  // only the first one is set.
  image::Image compose(std::array<image::Legend, 2>& legends) const;

 private:
  bool isDivided() const;
  bool isDifference() const;
  bool hasError(const Side& side) const;
  const Side& sideAt(int x) const;
  PixelValue colourAt(const Side& side, int x, int y) const;
  std::optional<PixelValue> imageAt(const Side& side, int x, int y) const;
  image::Image shown(const Side& side, image::Legend& legend) const;

  const Side& a_;
  const Side* b_;
  const Look& look_;
  const GatheredTruth& truth_;
  int window_frame_;
};

}  // namespace strobe::live
