// SPDX-License-Identifier: MIT
// Which images share memory.
#pragma once

#include "plan/plan.h"

namespace strobe::plan {

// Fills the lifetimes of `plan.images` from the uses of `plan.steps`, then `plan.slots` and the images' slots.
// Images share a slot if they have the same format and size and one is dead before the other begins; outputs, taps and
// updated images never do. A loop is one moment: what it touches lives through all of it.
void assignSlots(Plan& plan);

}  // namespace strobe::plan
