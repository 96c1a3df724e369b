// SPDX-License-Identifier: MIT
// Figures of a capture for people: the same drawing as pixels and as a page for LaTeX.
#pragma once

#include "figure/layout.h"

namespace strobe::figure {

// What its cells show, laid out. `step`: of cells that name none. Throws `Error`, all mistakes at once, each at its
// place in the script.
Layout layoutOf(const FigureData& figure, const FindTaken& find, const std::string& truth_arm, int step = 0,
                Captions captions = Captions::wrapped);

// A display image.
image::Image pixelsOf(const Layout& layout);

// Draws figure `data` (as scripts/strobe/figure.lua leaves it, with the capture's `size`, and as `drawn` the size at
// which it is drawn where that is another) and writes FOLDER/NAME.png, pixel by pixel, and FOLDER/NAME.pdf with text
// and lines. Returns them. `truth_arm` ("": none) is what captions measure against. Throws `Error`.
std::vector<Path> writeFigure(const Json& data, const FindTaken& find, const std::string& truth_arm,
                              const Path& folder);

}  // namespace strobe::figure
