// SPDX-License-Identifier: MIT
// What the window works on, without a window: the sessions, the truth behind them, and what is looked at. Panels, keys
// and drive files change it through the same few verbs.
#pragma once

#include <algorithm>

#include "lab/views.h"
#include "live/gathered_truth.h"
#include "live/pinned_pixel.h"
#include "live/sides.h"
#include "live/widgets.h"

namespace strobe::live {

enum class Mode { Single, Wipe, Flicker, Difference, Error };
const std::vector<std::string>& modeNames();  // in the order of `Mode`
Mode modeNamed(const std::string& name);      // throws `Error` with the nearest
bool comparesWithB(Mode mode);

struct DeskOptions {
  lab::Shot shot;
  std::string versus;            // pipeline of B, or ""
  script::Settings versus_sets;  // of B
  std::string truth;             // what errors are measured against; "" for the pipeline that declares kind = "truth"
  Path out;                      // pictures are saved here
};

// What is looked at and how.
struct Look {
  std::string port = "color";  // an output, or "node.port"
  lab::ViewOptions view;
  Mode mode = Mode::Single;
  bool single_b = false;  // Mode::Single shows B
  double wipe = 0.5;      // of the width
  double gain = 4;        // of differences and errors: full scale at 1 / gain
  bool operator==(const Look&) const = default;
};

// A value of the picture under the pointer, as the pass wrote it.
struct PixelValue {
  std::string port, format;
  int x = 0, y = 0;            // in its image
  std::vector<double> values;  // integers are exact
  bool integers = false;
};

class Desk {
 public:
  // Throws `Error` where the first version cannot run. The bench must outlive it.
  Desk(lab::Workbench& bench, const DeskOptions& options);

  Sides& sides() { return sides_; }
  const Sides& sides() const { return sides_; }
  Side& a() { return sides_.a(); }
  Side* b() { return sides_.b(); }
  const Side* b() const { return sides_.b(); }
  Look& look() { return look_; }
  const Look& look() const { return look_; }
  PinnedPixel& pixel() { return pixel_; }
  const DeskOptions& options() const { return options_; }
  const lab::Shot& shot() const { return sides_.a().session->shot(); }  // of A

  // ---- time
  void goToFrame(int frame);
  bool playing = false;

  // ---- what is looked at
  void viewPort(const std::string& port);     // throws `Error` with the nearest name
  std::vector<std::string> viewable() const;  // outputs, then every port
  void setMode(Mode mode);                    // throws `Error` where there is no B to show
  // The value of what the picture shows at a pixel of the frame; nothing outside of it.
  std::optional<PixelValue> valueAt(int x, int y) const;
  void pin(int x, int y) { pixel_.pin(shot(), x, y); }

  // ---- a turn: looks for edited files, draws what is stale, gathers truth. True where there is something new to show.
  bool turn();
  // Whether the next turn has work without any input.
  bool busy() const;
  // The picture as it is shown, `window_frame` choosing the side that flickers; cached until something changes.
  const image::Image& picture(int window_frame);
  bool pictureChanged(int window_frame) const;

  // So many are gathered in every mode, the more of the two: for who looks, and for the sweep.
  void wantTruth(int samples, bool for_sweep = false) { (for_sweep ? truth_of_sweep_ : truth_wanted_) = samples; }
  const GatheredTruth& truth() const { return truth_; }
  std::vector<std::string> problems() const;

  // ---- results
  std::vector<Path> save();  // A, and B where it is compared, as `render` would; returns the files
  Path freeName(const std::string& ending) const;  // in `out`

 private:
  bool gathersTruth() const {
    return look_.mode == Mode::Error || std::max(truth_wanted_, truth_of_sweep_) > truth_.samples(shot());
  }
  const Side& sideShown(int window_frame) const;
  image::Image shownSide(const Side& side) const;
  image::Image compose(int window_frame) const;

  DeskOptions options_;
  Sides sides_;
  GatheredTruth truth_;
  int truth_wanted_ = 0, truth_of_sweep_ = 0;
  PinnedPixel pixel_;
  Look look_, shown_look_;
  image::Image picture_;
  bool picture_stale_ = true, picture_of_b_ = false;
};

}  // namespace strobe::live
