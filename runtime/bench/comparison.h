// SPDX-License-Identifier: MIT
// Two runs of the same shots by two revisions of the program: which pass takes another time.
//
// Runs of two sessions differ in more than the program: load, clocks and temperature of the machine. On one device that
// is no software device, milliseconds are compared. Otherwise times are first divided by the frame time of the base
// (the first method of the same scene and size) in the same round, which takes away what slows all methods alike. What
// slows some passes more than others stays, and so does what the base itself gained or lost: a part has moved only
// where its milliseconds say so too. The frame of a base has milliseconds alone and never counts as moved: nobody can
// tell a base that changed from a machine that did.
//
// Runs that alternate in one session, block by block, are compared in milliseconds: each block with the one beside it.
#pragma once

#include "bench/times.h"

namespace strobe::bench {

// A part of a frame, or a frame, in both runs.
struct Change {
  const ShotTimes* shot = nullptr;   // of the present run
  std::string pass;                  // "" for the frame; kRest
  double before_ms = 0, now_ms = 0;  // medians, of blocks those of their medians
  Estimate ratio;                    // of the present time to the earlier one, as they are compared
  Estimate ms_ratio;                 // in milliseconds
  bool is_base = false;              // the frame of a base, whose ratio is one of milliseconds in any case
  bool moved = false;                // intervals exclude 1, and ratios are further from it than the share
};

struct Comparison {
  enum class Kind { base, milliseconds, blocks };  // how times are compared: see above
  Kind kind = Kind::base;
  std::string against;              // the file or program
  double share = 0;                 // of a time by which it has to change to have moved
  size_t blocks = 0;                // that alternated
  std::vector<std::string> differ;  // in what the runs differ besides times: "driver Mesa 25, now Mesa 26"
  std::vector<Change> changes;      // of each shot its frame, then its parts
  // Passes that one of the runs alone has: "tiles of METHOD, living_room, 320x180".
  std::vector<std::string> gone, added;

  size_t moved() const;
};

// `now` must outlive what is returned, and the runs have the same shots (requireSameShots).
Comparison compared(const Run& now, const Run& before, double share);

// Runs that alternated, one of each at a time. `now` must outlive what is returned.
Comparison compared(const std::vector<Run>& now, const std::vector<Run>& before, double share);

Json toJson(const Comparison& comparison);

}  // namespace strobe::bench
