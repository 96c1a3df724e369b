// SPDX-License-Identifier: MIT
// Panels around the picture: controls from their declarations, views, comparison, trail of a pixel, pass times.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "live/desk.h"
#include "live/keys.h"
#include "live/placement.h"
#include "live/style.h"
#include "live/widgets.h"

namespace strobe::live {

constexpr int kSettleFrames = 3;  // frames of the window until the panels settle after an event

// State of the window that does not belong to the picture.
struct PanelState {
  bool panels = true, help = false;
  bool controls_of_b = false;
  bool focus_search = false;
  std::string search;
  // Control under the pointer, and control that was changed last; both of the side in the control panel.
  std::string pointed_control, changed_control;
  std::string swept_control;  // control to sweep; the window begins the sweep
  Magnification magnification;
  int window_frame = 0;
  std::vector<Action> requests;  // pressed buttons; the window executes them
  std::string message;           // last message to the user
  bool message_is_bad = false;
  std::optional<size_t> recorded;  // number of recorded moments; empty without a recording
  double message_until_s = 0;

  void say(const std::string& text, bool bad = false);
  bool speaks() const;  // true while the message is displayed
};

// Begins a panel at a fixed place and size; `ImGui::End` ends it. `tabs`: the Tab key moves between fields.
void beginPanel(const char* name, float x, float y, float width, float height, bool tabs = false);

// Calls `change`. An `Error` becomes the message.
void attempt(PanelState& state, const std::function<void()>& change);

// Draws the value of the last slider as a bar along the slider's lower edge, so that the bar does not cover the text.
void slidePlace(const Widget& slider, double value);

// Draws the panel of controls: one widget per declaration, in groups that can be folded and searched.
void drawControls(const Fonts& fonts, Desk& desk, PanelState& state);

// Draws the panels at the sides of the window. Returns the remaining area for the picture.
WindowArea drawPanels(const Fonts& fonts, Desk& desk, PanelState& state);

// Draws over the picture: problems, help, last message.
void drawOverlays(const Fonts& fonts, const Desk& desk, PanelState& state, const WindowArea& area);

}  // namespace strobe::live
