// SPDX-License-Identifier: MIT
// Figures of a capture: the same drawing as pixels and as a page for LaTeX.
#pragma once

#include "figure/layout.h"

namespace strobe::figure {

// Layout of a figure. `step`: step of the cells that do not set one. Throws `Error` with all mistakes, each at its
// place in the script.
Layout layoutOf(const FigureData& figure, const FindTaken& find, const std::string& truth_arm, int step = 0,
                Captions captions = Captions::wrapped);

// Draws a layout as a display image.
image::Image pixelsOf(const Layout& layout);

// Draws a figure. Writes FOLDER/NAME.png, pixel by pixel, and FOLDER/NAME.pdf with text and lines. Returns the two
// files. `data`: from scripts/strobe/figure.lua, with the capture's `size`, and with `drawn` if the figure is drawn at
// another size. `truth_arm`: arm that captions measure against, or "". Throws `Error`.
std::vector<Path> writeFigure(const Json& data, const FindTaken& find, const std::string& truth_arm,
                              const Path& folder);

}  // namespace strobe::figure
