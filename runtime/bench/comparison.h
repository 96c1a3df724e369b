// SPDX-License-Identifier: MIT
// Comparison of two runs of the same shots by two revisions of the program: the passes whose time changed.
//
// Runs of two sessions also differ in load, clocks and temperature of the machine. On the same device and driver, if
// the device is not software, milliseconds are compared. Otherwise times are first divided by the frame time of the
// base (the first method of the same scene and size) in the same round. The division removes a slowdown common to all
// methods. It does not remove a slowdown of single passes or a change of the base itself: a part has moved only if its
// milliseconds have moved too. The frame of a base has milliseconds only and never counts as moved: a change of the
// base cannot be distinguished from a change of the machine.
//
// Runs that alternate in one session, block by block, are compared in milliseconds: each block with its pair.
#pragma once

#include "bench/times.h"

namespace strobe::bench {

// A frame, or a part of a frame, in both runs.
struct Change {
  const ShotTimes* shot = nullptr;   // of the present run
  std::string pass;                  // "" for the frame; kRest
  double before_ms = 0, now_ms = 0;  // medians; in blocks, medians of the blocks' medians
  Estimate ratio;                    // present time divided by earlier time, in the basis of the comparison
  Estimate ms_ratio;                 // present milliseconds divided by earlier milliseconds
  bool is_base = false;              // frame of a base, with a ratio of milliseconds in every basis
  // Both intervals exclude 1, and both ratios differ from 1 by more than `share` in the same direction.
  bool moved = false;
};

// Changes of frame and pass times between two benchmark runs, as ratios with intervals.
struct TimeComparison {
  enum class Kind { base, milliseconds, blocks };  // basis of the ratios, see above
  Kind kind = Kind::base;
  std::string against;              // file or program
  double share = 0;                 // smallest relative change of a time that counts as moved
  size_t blocks = 0;                // number of alternating blocks
  std::vector<std::string> differ;  // differences besides times: "driver Mesa 25, now Mesa 26"
  std::vector<Change> changes;      // for each shot its frame, then its parts
  // Passes in only one of the runs: "tiles of METHOD, living_room, 320x180".
  std::vector<std::string> gone, added;

  size_t moved() const;
};

// The runs have the same shots (requireSameShots). `now` must outlive the result.
TimeComparison compared(const Run& now, const Run& before, double share);
TimeComparison compared(Run&& now, const Run& before, double share) = delete;

// Comparison of alternating runs, one pair per block. `now` must outlive the result.
TimeComparison compared(const std::vector<Run>& now, const std::vector<Run>& before, double share);

Json toJson(const TimeComparison& comparison);

}  // namespace strobe::bench
