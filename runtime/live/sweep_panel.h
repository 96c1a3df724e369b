// SPDX-License-Identifier: MIT
// The sweep under the picture: thumbnails in a row over a chart of error and time, or a grid of them for two controls.
#pragma once

#include "live/panels.h"
#include "live/surface.h"
#include "live/sweeper.h"
#include "live/thumbnails.h"

namespace strobe::live {

class SweepPanel {
 public:
  // Brings the thumbnails to the device, where there are new ones; before a frame of the panels begins.
  void prepare(Surface& surface, const Sweeper& sweeper, double stops);
  // The first field gets the keyboard.
  void focus() { focus_ = true; }
  // Draws it, while it is open, at the bottom of an area; returns what is left for the picture.
  Area draw(const Fonts& fonts, Desk& desk, Sweeper& sweeper, PanelState& state, const Area& area);

  struct Mark {
    bool current = false, hovered = false;
  };
  // Pixels of the window: columns with pictures, below them the chart.
  struct Strip {
    ImVec2 at;
    float column = 0, wide = 0, tall = 0, chart_y = 0, chart = 0;
    float height() const { return chart_y + chart + 34 - at.y; }
  };
  // Cells in pixels of the window; `across`: the axis whose values are columns.
  struct Grid {
    size_t across = 0, columns = 1, rows = 1;
    float wide = 0, tall = 0, line = 0;  // `line`: height of the number under a picture
    double worst = 0;                    // error of all points
  };

 private:
  // What the thumbnails were made of.
  struct Made {
    int serial = 0;
    size_t drawn = 0;
    double stops = 0;
    const SweepPoint* worst = nullptr;
    int x = 0, y = 0;  // of its crop
    bool operator==(const Made&) const = default;
  };

  void drawHead(const Fonts& fonts, Desk& desk, Sweeper& sweeper, PanelState& state);
  void drawStrip(const Fonts& fonts, Desk& desk, Sweeper& sweeper, PanelState& state);
  void drawGrid(const Fonts& fonts, Desk& desk, Sweeper& sweeper, PanelState& state);
  void drawColumn(const Fonts& fonts, const Sweep& sweep, const Strip& strip, size_t point, Mark mark) const;
  void drawCell(const Fonts& fonts, const Sweep& sweep, const Grid& grid, size_t point, ImVec2 low, Mark mark) const;
  void drawPicture(const Sweep& sweep, size_t point, ImVec2 at, ImVec2 size) const;
  void describe(const Fonts& fonts, const Sweep& sweep, size_t point) const;

  std::unique_ptr<Texture> sheet_;
  Thumbnails thumbnails_;
  std::optional<Made> made_;
  bool focus_ = false;
};

}  // namespace strobe::live
