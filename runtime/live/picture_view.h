// SPDX-License-Identifier: MIT
// The picture in the middle of the window, and what the mouse and held keys do over it.
#pragma once

#include "live/input_queue.h"
#include "live/panels.h"
#include "live/surface.h"

namespace strobe::live {

class PictureView {
 public:
  // Uploads what `draw` shows beside the picture.
  void prepare(Surface& surface, const Desk& desk);
  // Draws the picture into the area, with what is under the pointer.
  void draw(const Fonts& fonts, Desk& desk, const PanelState& state, const Area& area, const Texture& picture);
  // Camera, wipe, magnification and pinning by the mouse; flying by keys that are held.
  void interact(Desk& desk, PanelState& state, const Area& area, const InputQueue& input);

  // Where a pixel of the picture was drawn, pixels of the window.
  dvec2 inWindow(const dvec2& pixel) const { return placement_.toWindow(pixel); }

 private:
  enum class Grip { None, Wipe, Picture, Orbit, Look, Pan };
  Grip gripAt(const Desk& desk, bool right, bool control, bool shift) const;
  void drag(Desk& desk, PanelState& state, const Area& area, const dvec2& by);
  void fly(Desk& desk, PanelState& state, const InputQueue& input, double seconds);
  void grip(Desk& desk, Grip grip);
  void drawWipe(const Fonts& fonts, const Desk& desk, const Area& area) const;
  void drawLegends(const Fonts& fonts, const Area& area) const;
  void drawNumbers(const Fonts& fonts, const Desk& desk, const PanelState& state, const Area& area) const;
  void drawPointed(const Fonts& fonts, const Desk& desk, const PanelState& state) const;

  Placement placement_;
  int width_ = 1, height_ = 1;
  std::array<lab::Legend, 2> legends_;  // that the textures show
  std::array<std::unique_ptr<Texture>, 2> legend_pictures_;
  Grip grip_ = Grip::None;
  dvec3 pivot_ = dvec3(0);  // of an orbit, world space
  double dragged_ = 0;      // pixels since the button went down
};

}  // namespace strobe::live
