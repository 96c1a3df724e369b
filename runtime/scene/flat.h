// SPDX-License-Identifier: MIT
// Transforms that flatten an object to a sheet. A sheet has no object space that a ray could be transformed to, so the
// vertices of the object are transformed to world space instead (`scene/bend.h`).
#pragma once

#include "scene/scene.h"

namespace strobe::scene {

// True if the transform leaves an area but no volume: no inverse exists, or single precision rounds it visibly.
bool isFlat(const dmat3& transform);

// Per node: true if the transform of the node or of an ancestor may be flat at some time.
std::vector<bool> flatteningNodes(const Scene& scene);

}  // namespace strobe::scene
