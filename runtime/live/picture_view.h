// SPDX-License-Identifier: MIT
// Picture in the middle of the window, with the actions of the mouse and of held keys over it.
#pragma once

#include "live/input_queue.h"
#include "live/panels.h"
#include "live/surface.h"

namespace strobe::live {

// Picture in the middle of the window with its legends and pixel values, and the mouse and key handling over it:
// camera, wipe, magnification and pinning.
class PictureView {
 public:
  // Uploads changed legends for `draw`.
  void prepare(Surface& surface, const Desk& desk);
  // Draws the picture into the area, and the values under the pointer.
  void draw(const Fonts& fonts, Desk& desk, const PanelState& state, const WindowArea& area,
            const PanelTexture& picture);
  // Handles the mouse (camera, wipe, magnification, pinning) and held keys (flying).
  void interact(Desk& desk, PanelState& state, const WindowArea& area, const InputQueue& input);

  // Position of a picture's pixel in the window, pixels, as last drawn.
  dvec2 inWindow(const dvec2& pixel) const { return placement_.toWindow(pixel); }

 private:
  enum class Grip { None, Wipe, Picture, Orbit, Look, Pan };
  Grip gripAt(const Desk& desk, bool right, bool control, bool shift) const;
  void drag(Desk& desk, PanelState& state, const WindowArea& area, const dvec2& by);
  void fly(Desk& desk, PanelState& state, const InputQueue& input, double seconds);
  void grip(Desk& desk, Grip grip);
  void drawWipe(const Fonts& fonts, const Desk& desk, const WindowArea& area) const;
  void drawLegends(const Fonts& fonts, const WindowArea& area) const;
  void drawNumbers(const Fonts& fonts, const Desk& desk, const PanelState& state, const WindowArea& area) const;
  void drawPointed(const Fonts& fonts, const Desk& desk, const PanelState& state) const;

  PicturePlacement placement_;
  int width_ = 1, height_ = 1;
  std::array<image::Legend, 2> legends_;  // legends in the textures
  std::array<std::unique_ptr<PanelTexture>, 2> legend_pictures_;
  Grip grip_ = Grip::None;
  dvec3 pivot_ = dvec3(0);  // of an orbit, world space
  double dragged_ = 0;      // pixels since the button went down
};

}  // namespace strobe::live
