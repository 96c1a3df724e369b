// SPDX-License-Identifier: MIT
// Colour primaries stated by files, and their conversion to Rec. 709, the primaries of all linear colour here.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <string>

#include "image/image.h"

namespace strobe::image {

// CIE 1931 chromaticities. The defaults are Rec. 709 with D65, also the default of OpenEXR files.
struct Primaries {
  glm::dvec2 red = {0.64, 0.33}, green = {0.3, 0.6}, blue = {0.15, 0.06}, white = {0.3127, 0.329};

  // True within a tolerance of 0.0005, because standards state three decimals.
  bool areRec709() const;
  // True if red, green and blue span a triangle around white, so that a conversion exists.
  bool areValid() const;
  std::string text() const;  // "red 0.713 0.293, green ..., blue ..., white ..."
};

// Matrix from linear RGB of `primaries` to Rec. 709. White stays white by Bradford's adaptation.
glm::dmat3 rec709From(const Primaries& primaries);

// Converts three linear channels and returns a note about the conversion. Colours outside of Rec. 709 keep their
// negative values. Primaries without a triangle around white are not used, and the note states this.
std::string convertStated(Image& linear, const Primaries& primaries);

}  // namespace strobe::image
