// SPDX-License-Identifier: MIT
// Sweep below the picture: a row of thumbnails above a chart of error and time, or a grid of thumbnails for two
// controls.
#pragma once

#include "live/panels.h"
#include "live/surface.h"
#include "live/sweeper.h"

namespace strobe::live {

// Panel of a parameter sweep below the picture. Shows thumbnails above a chart of error and time for one control, or a
// grid of thumbnails for two controls.
class SweepPanel {
 public:
  // Uploads new thumbnails. Call before a frame of the panels begins.
  void prepare(Surface& surface, const Sweeper& sweeper, double stops);
  // Gives the keyboard focus to the first field.
  void focus() { focus_ = true; }
  // Draws an open sweep at the bottom of an area. Returns the remaining area for the picture.
  WindowArea draw(const Fonts& fonts, Desk& desk, Sweeper& sweeper, PanelState& state, const WindowArea& area);

  struct Mark {
    bool current = false, hovered = false;
  };
  // Layout of a strip, pixels of the window: columns with pictures, and the chart below them.
  struct Strip {
    ImVec2 at;
    float column = 0, wide = 0, tall = 0, chart_y = 0, chart = 0;
    float height() const { return chart_y + chart + 34 - at.y; }
  };
  // Layout of a grid, pixels of the window. `across`: axis with a column for each value.
  struct Grid {
    size_t across = 0, columns = 1, rows = 1;
    float wide = 0, tall = 0, line = 0;  // `line`: height of the number under a picture
    double worst = 0;                    // largest error of all points
  };

 private:
  // State that a thumbnail was made from.
  struct Made {
    int serial = 0;
    double stops = 0;
    const SweepPoint* worst = nullptr;
    image::Rectangle crop;  // of `worst`
    bool operator==(const Made&) const = default;
  };
  // Thumbnail of a point on the device.
  struct Thumbnail {
    std::optional<Made> made;
    std::unique_ptr<PanelTexture> texture;
  };

  void drawHead(const Fonts& fonts, Desk& desk, Sweeper& sweeper, PanelState& state);
  void drawStrip(const Fonts& fonts, Desk& desk, Sweeper& sweeper, PanelState& state);
  void drawGrid(const Fonts& fonts, Desk& desk, Sweeper& sweeper, PanelState& state);
  void drawColumn(const Fonts& fonts, const Sweep& sweep, const Strip& strip, size_t point, Mark mark) const;
  void drawCell(const Fonts& fonts, const Sweep& sweep, const Grid& grid, size_t point, ImVec2 low, Mark mark) const;
  void drawPicture(const Sweep& sweep, size_t point, ImVec2 at, ImVec2 size) const;
  void describe(const Fonts& fonts, const Sweep& sweep, size_t point) const;

  std::vector<Thumbnail> thumbnails_;  // by point
  bool focus_ = false;
};

}  // namespace strobe::live
