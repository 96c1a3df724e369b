// SPDX-License-Identifier: MIT
// What the window works on, without a window: the sessions, the truth behind them, and what is looked at. Panels, keys
// and drive files change it through the same few verbs.
#pragma once

#include <algorithm>
#include <array>

#include "live/budget_keeper.h"
#include "live/pinned_pixel.h"
#include "live/shown.h"
#include "live/widgets.h"

namespace strobe::live {

struct DeskOptions {
  lab::Shot shot;
  std::string versus;            // pipeline of B, or ""
  script::Settings versus_sets;  // of B
  std::string truth;             // what errors are measured against; "" for the pipeline that declares kind = "truth"
  Path out;                      // pictures are saved here
  double budget_ms = 0;          // of a frame of A; 0: none
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
  BudgetKeeper& budget() { return budget_; }
  const DeskOptions& options() const { return options_; }
  const lab::Shot& shot() const { return sides_.a().session->shot(); }  // of A

  // ---- time
  void goToFrame(int frame);
  bool playing = false;

  // ---- what is looked at
  void viewPort(const std::string& port);     // throws `Error` with the nearest name
  std::vector<std::string> viewable() const;  // outputs, then every port
  void setMode(Mode mode);                    // throws `Error` where there is no B to show
  // The value that the picture shows at a pixel, of the side that it shows there; after a difference or an error, the
  // colours behind it. Empty outside of the frame.
  std::vector<PixelValue> valuesAt(int x, int y, int window_frame) const;
  void pin(int x, int y) { pixel_.pin(shot(), x, y); }

  // ---- a turn: looks for edited files, draws what is stale, gathers truth. True where there is something new to show.
  // `felt` (may be empty) is true if input waits; it ends a step of truth early.
  bool turn(const std::function<bool()>& felt = {});
  // Whether the next turn has work without any input.
  bool busy() const;
  // The picture as it is shown, `window_frame` choosing the side that flickers; cached until something changes.
  const image::Image& picture(int window_frame);
  // Its legends: of A or of both sides; of B if that is another one.
  const std::array<lab::Legend, 2>& legends() const { return legends_; }
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
  Shown shown(int window_frame) const;

  DeskOptions options_;
  Sides sides_;
  BudgetKeeper budget_;
  GatheredTruth truth_;
  int truth_wanted_ = 0, truth_of_sweep_ = 0;
  PinnedPixel pixel_;
  Look look_, shown_look_;
  image::Image picture_;
  std::array<lab::Legend, 2> legends_;
  bool picture_stale_ = true, picture_of_b_ = false;
};

}  // namespace strobe::live
