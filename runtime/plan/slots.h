// SPDX-License-Identifier: MIT
// Assignment of images to shared memory.
#pragma once

#include "plan/plan.h"

namespace strobe::plan {

// Fills the lifetimes of `plan.images` from the uses of `plan.steps`, then `plan.slots` and the slots of the images.
// Images share a slot if they have the same format and size and their lifetimes do not overlap. Outputs, taps and
// updated images never share a slot. A loop is one position: an image that a loop uses lives during the whole loop.
void assignSlots(Plan& plan);

}  // namespace strobe::plan
