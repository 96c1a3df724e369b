// SPDX-License-Identifier: MIT
// Captions with numbers that are measured or read from the run record: none is typed.
#pragma once

#include <string>
#include <vector>

#include "base/strict.h"
#include "figure/figure_data.h"
#include "figure/taken.h"

namespace strobe::figure {

// Pixels of a region of truth, as lab::maskOf. Throws `Error`.
image::Image regionOf(const Taken& truth, const std::string& region);

// The caption of a picture. `truth` gives the picture that errors are against, when it is first needed: whole pictures,
// whatever part of them a figure shows. What cannot be said is added to `problems` with the place.
std::string captionOf(const std::vector<CaptionPart>& parts, const Taken& taken,
                      const std::function<const Taken*()>& truth, const Place& place, Problems& problems);

}  // namespace strobe::figure
