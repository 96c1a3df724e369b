// SPDX-License-Identifier: MIT
// Work in the window, without a window: sessions, ground truth, displayed image. Panels, keys and drive files change
// the desk through its member functions.
#pragma once

#include <algorithm>
#include <array>

#include "live/budget_keeper.h"
#include "live/pinned_pixel.h"
#include "live/shown.h"
#include "live/widgets.h"

namespace strobe::live {

// Start values of the interactive window: the shot (A), the pipeline to compare it with (B), the ground truth, the
// folder of saved pictures and the GPU time budget in milliseconds.
struct DeskOptions {
  lab::Shot shot;
  std::string versus;            // pipeline of B; "" for no B
  script::Settings versus_sets;  // values for B
  std::string truth;             // pipeline of the ground truth; "" for the pipeline that declares kind = "truth"
  Path out;                      // folder of saved pictures
  double budget_ms = 0;          // GPU time of a frame of A, ms; 0 for no budget
};

// State of the interactive window, without its user interface: the compared pipelines A and B, their ground truth, the
// playback and the displayed picture.
class Desk {
 public:
  // Throws `Error` if A or B cannot run. `bench` must outlive the desk.
  Desk(lab::Workbench& bench, const DeskOptions& options);

  Sides& sides() { return sides_; }
  const Sides& sides() const { return sides_; }
  Side& a() { return sides_.a(); }
  Side* b() { return sides_.b(); }
  const Side* b() const { return sides_.b(); }
  Look& look() { return look_; }
  const Look& look() const { return look_; }
  PinnedPixel& pixel() { return pixel_; }
  BudgetKeeper& budget() { return budget_; }
  const DeskOptions& options() const { return options_; }
  const lab::Shot& shot() const { return sides_.a().session->shot(); }  // shot of A

  // ---- time
  void goToFrame(int frame);
  bool playing = false;

  // ---- displayed image
  void viewPort(const std::string& port);     // throws `Error` with the nearest name
  std::vector<std::string> viewable() const;  // outputs, then every port
  void setMode(Mode mode);                    // throws `Error` if the mode needs B and B is not open
  // Value of the displayed image at a pixel, from the side that is displayed there. A difference or an error is
  // followed by the colours that it compares. Empty outside of the frame.
  std::vector<PixelValue> valuesAt(int x, int y, int window_frame) const;
  void pin(int x, int y) { pixel_.pin(shot(), x, y); }

  // ---- turns
  // Reloads edited files, draws stale sides, accumulates ground truth. Returns true if anything new can be displayed.
  // `felt` (may be empty) returns true if input waits; this ends a step of ground truth early.
  bool turn(const std::function<bool()>& felt = {});
  // True if the next turn has work without input.
  bool busy() const;
  // Returns the displayed picture; cached until anything changes. `window_frame` selects the side in flicker mode.
  const image::Image& picture(int window_frame);
  // Legends of the picture. In a divided picture, the first is A's and the second is B's, or empty if both are equal.
  const std::array<image::Legend, 2>& legends() const { return legends_; }
  bool pictureChanged(int window_frame) const;

  // Requests ground truth with this many samples in every mode. There are two requests, the sweep's and the other one;
  // the larger one counts.
  void wantTruth(int samples, bool for_sweep = false) { (for_sweep ? truth_of_sweep_ : truth_wanted_) = samples; }
  const GatheredTruth& truth() const { return truth_; }
  std::vector<std::string> problems() const;

  // ---- results
  // Saves A, and B if the mode compares with B, as `render` does. Returns the files.
  std::vector<Path> save();
  Path freeName(const std::string& ending) const;  // a new file in `out`

 private:
  bool gathersTruth() const {
    return look_.mode == Mode::Error || std::max(truth_wanted_, truth_of_sweep_) > truth_.samples(shot());
  }
  Shown shown(int window_frame) const;

  DeskOptions options_;
  Sides sides_;
  BudgetKeeper budget_;
  GatheredTruth truth_;
  int truth_wanted_ = 0, truth_of_sweep_ = 0;
  PinnedPixel pixel_;
  Look look_, shown_look_;
  image::Image picture_;
  std::array<image::Legend, 2> legends_;
  bool picture_stale_ = true, picture_of_b_ = false;
};

}  // namespace strobe::live
