// SPDX-License-Identifier: MIT
// Outputs of a picture as NumPy arrays in files.
#pragma once

#include "lab/workbench.h"

namespace strobe::lab {

// Writes each output and tap as NAME.npy in the folder, without waiting for the disk. Returns the files written.
// Format: NumPy 1.0, rows x columns x channels, rows from the top; 32-bit floats, or unsigned integers of 32 bits.
// Colours are linear.
std::vector<Path> writeArrays(const Picture& picture, const Path& folder);

}  // namespace strobe::lab
