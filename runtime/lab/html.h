// SPDX-License-Identifier: MIT
// The page of an exhibition: one self-contained HTML file that opens from disk, without a network, in light and dark,
// on screen and on paper. Every method can be wiped over or flickered against truth.
#pragma once

#include "lab/exhibit.h"

namespace strobe::lab {

// Pictures are embedded at full size while the page stays below `most_bytes`, else smaller by whole factors (crops
// never); the page says so.
std::string pageOf(const Exhibition& exhibition, size_t most_bytes = 11'500'000);

// <, >, &, " as entities.
std::string escaped(const std::string& text);

std::string base64(const std::string& bytes);

}  // namespace strobe::lab
