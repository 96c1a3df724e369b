// SPDX-License-Identifier: MIT
// Differences of two manifests and their causes: inputs, parameters and their origins, program, device, and the first
// pass in the order of execution with a different output.
#pragma once

#include "archive/manifest.h"

namespace strobe::archive {

// Differences of `now` from `stated`, as printed by `strobe diff --json`:
// { identical, program, device, missing, added, files, inputs, pictures }. Lines of `program` and `device` have the
// form "name: 'llvmpipe ...', now '...'". `missing` and `added` are names of pictures, `files` figures and films that
// differ. `pictures` lists the pictures with any difference, each with the first pass, in the order of execution, that
// has a different output. Writes a map of the first difference of each picture to `folder`, unless `folder` is empty.
Json differencesOf(const Manifest& stated, const Manifest& now, const Path& folder = {});

// True if no picture is missing and every output of every pass, every layer, figure and film is the same bit for bit.
bool identical(const Json& differences);
// True if no picture is missing and the mean FLIP of every color is at most `most_flip`.
bool within(const Json& differences, double most_flip);

std::string textOf(const Json& differences);

}  // namespace strobe::archive
