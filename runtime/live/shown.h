// SPDX-License-Identifier: MIT
// The picture in the middle of the window, of one side or of a comparison of both, and the values in it.
#pragma once

#include <array>

#include "lab/views.h"
#include "live/gathered_truth.h"
#include "live/sides.h"

namespace strobe::live {

enum class Mode { Single, Wipe, Flicker, Difference, Error };
const std::vector<std::string>& modeNames();  // in the order of `Mode`
Mode modeNamed(const std::string& name);      // throws `Error` with the nearest
bool comparesWithB(Mode mode);

// Image, view and comparison that the window shows.
struct Look {
  std::string port = "color";  // an output, or "node.port"
  lab::ViewOptions view;
  Mode mode = Mode::Single;
  bool single_b = false;  // Mode::Single shows B
  double wipe = 0.5;      // of the width
  double gain = 4;        // of differences and errors: full scale at 1 / gain
  // True if errors or differences are shown: they are of the colour, whatever image is chosen.
  bool isOfColour() const { return mode == Mode::Error || mode == Mode::Difference; }
  bool operator==(const Look&) const = default;
};

// A value of the picture under the pointer: as the pass wrote it, or a difference.
struct PixelValue {
  char side = 'A';             // whose; ' ' for a difference of both
  std::string port, format;    // format: "" for what no pass wrote
  int x = 0, y = 0;            // in its image
  std::vector<double> values;  // integers are exact
  bool integers = false;
};

// The picture of a frame of the window. Refers to its parts, which must outlive it.
class Shown {
 public:
  // `b` may be null. `window_frame` chooses the side that flickers.
  Shown(const Side& a, const Side* b, const Look& look, const GatheredTruth& truth, int window_frame)
      : a_(a), b_(b), look_(look), truth_(truth), window_frame_(window_frame) {}

  // The side of a picture that is not divided.
  const Side& side() const;
  // The value that the picture shows at a pixel, of the side that it shows there; after a difference or an error, the
  // colours behind it. Empty outside of the frame.
  std::vector<PixelValue> valuesAt(int x, int y) const;
  // The picture. `legends`: of A or of both sides; of B if that is another one.
  image::Image compose(std::array<lab::Legend, 2>& legends) const;

 private:
  bool isDivided() const;
  bool isDifference() const;
  bool hasError(const Side& side) const;
  const Side& sideAt(int x) const;
  PixelValue colourAt(const Side& side, int x, int y) const;
  std::optional<PixelValue> imageAt(const Side& side, int x, int y) const;
  image::Image shown(const Side& side, lab::Legend& legend) const;

  const Side& a_;
  const Side* b_;
  const Look& look_;
  const GatheredTruth& truth_;
  int window_frame_;
};

}  // namespace strobe::live
