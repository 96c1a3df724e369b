// SPDX-License-Identifier: MIT
// Points of an experiment as JSON for the interactive part of the page (page/assets/explorer_model.js).
#pragma once

#include "study/results.h"

namespace strobe::study {

// JSON: { title, command, software, size: [width, height], measures, regions, arms, shots, axes, front: { x, y, region,
// shot }, groups: [{ shot, at, truth, picture, sigma }], points: [{ n, g, a, v, command, ... }], effects, pictures,
// notices: [text] }. `n` is the number of the point in table.csv. `v` has a number for each measure, or a list by
// region. Pictures are data URLs; other members refer to pictures by index. `most_bytes`: largest size of the text;
// pictures are reduced to fit.
Json explorerData(const Results& results, const Path& folder, size_t most_bytes);

// Initial view of the page: measures of the front's layout, else time and error.
struct FirstView {
  std::string x, y, region;
};
FirstView firstViewOf(const Results& results);

}  // namespace strobe::study
