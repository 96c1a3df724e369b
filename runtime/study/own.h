// SPDX-License-Identifier: MIT
// What of a frame is the method's own, and what any picture of the scene needs.
#pragma once

#include "lab/batch.h"

namespace strobe::study {

// The nodes of a shot's plan that the pipeline without blur (of the kind `sharp`) has too, under the same name and of
// the same pass: the capture. Throws `Error` where there is no such pipeline.
std::set<std::string> capturedNodes(lab::Batch& batch, const lab::Shot& shot);

// Milliseconds by round of the others.
std::vector<double> ownMs(lab::Batch& batch, const lab::Shot& shot, const lab::Timing& timing);

}  // namespace strobe::study
