// SPDX-License-Identifier: MIT
// Separates the method's own passes of a frame from the passes that any picture of the scene needs.
#pragma once

#include "lab/batch.h"

namespace strobe::study {

// Nodes of a shot's plan that the pipeline without blur (kind `Sharp`) also has, with the same name and pass: the
// raster passes. Throws `Error` without such a pipeline.
std::set<std::string> capturedNodes(lab::Batch& batch, const lab::Shot& shot);

// Milliseconds of all other nodes, by round.
std::vector<double> ownMs(lab::Batch& batch, const lab::Shot& shot, const lab::Timing& timing);

}  // namespace strobe::study
