// SPDX-License-Identifier: MIT
// Captions. Their numbers are measured or read from the run record; no number is typed.
#pragma once

#include <string>
#include <vector>

#include "base/strict.h"
#include "figure/figure_data.h"
#include "figure/taken.h"

namespace strobe::figure {

// Mask of a region of ground truth, as from lab::maskOf. Throws `Error`.
image::Image regionOf(const Taken& truth, const std::string& region);

// Caption of a picture. `truth` returns the picture that errors are measured against; called only when needed. Errors
// are of the whole picture, even if the figure shows a part. A problem is added to `problems` at `place` for each part
// that cannot be filled in.
std::string captionOf(const std::vector<CaptionPart>& parts, const Taken& taken,
                      const std::function<const Taken*()>& truth, const Place& place, Problems& problems);

}  // namespace strobe::figure
