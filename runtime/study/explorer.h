// SPDX-License-Identifier: MIT
// The points of an experiment as the interactive part of the page reads them (page/assets/explorer_model.js).
#pragma once

#include "study/results.h"

namespace strobe::study {

// { title, command, software, size: [width, height], measures, regions, arms, shots, axes, front: { x, y, region, shot
// }, groups: [{ shot, at, truth, picture, sigma }], points: [{ n, g, a, v, command, ... }], effects, pictures, notices:
// [text] }. A point's `n` is its number in table.csv; `v` has a number for each measure, or a list by region; pictures
// are data URLs, other members name them by number. `most_bytes`: of all of it, as text; pictures are reduced to fit.
Json explorerData(const Results& results, const Path& folder, size_t most_bytes);

// What the page shows first: measures of the front's layout, else time and error.
struct FirstView {
  std::string x, y, region;
};
FirstView firstViewOf(const Results& results);

}  // namespace strobe::study
