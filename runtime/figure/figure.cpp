// SPDX-License-Identifier: MIT
#include "figure/figure.h"

#include "image/png.h"

namespace strobe::figure {

Layout layoutOf(const FigureData& figure, const FindTaken& find, const std::string& truth_arm, int step,
                Captions captions) {
  Problems problems;
  std::vector<Block> blocks;
  for (const FigureCell& cell : figure.cells) blocks.push_back(blockOf(figure, cell, find, truth_arm, step, problems));
  problems.throwIfAny();
  return Layout(figure, std::move(blocks), captions);
}

image::Image pixelsOf(const Layout& layout) {
  Canvas canvas(Canvas::Kind::pixels, layout.width(), layout.height());
  layout.draw(canvas);
  return canvas.pixels();
}

std::vector<Path> writeFigure(const Json& data, const FindTaken& find, const std::string& truth_arm,
                              const Path& folder) {
  FigureData figure = figureFrom(data);
  Layout layout = layoutOf(figure, find, truth_arm);
  double points_per_px = figure.width_mm > 0 ? figure.width_mm / 25.4 * 72 / layout.width() : 0.75;
  Canvas page(Canvas::Kind::page, layout.width(), layout.height(), points_per_px,
              figure.title.empty() ? figure.name : figure.title);
  layout.draw(page);
  std::vector<Path> files = {folder / (figure.name + ".png"), folder / (figure.name + ".pdf")};
  image::writePng(files[0], pixelsOf(layout));
  writeFileAtomically(files[1], page.page());
  return files;
}

}  // namespace strobe::figure
