// SPDX-License-Identifier: MIT
// Everything around the picture: controls from their declarations, views, comparison, a pixel's trail, pass times.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "live/desk.h"
#include "live/keys.h"
#include "live/placement.h"
#include "live/style.h"

namespace strobe::live {

constexpr int kSettleFrames = 3;  // of the window, that panels need to come to rest after an event

// What belongs to the window rather than to the picture.
struct PanelState {
  bool panels = true, help = false;
  bool controls_of_b = false;
  bool focus_search = false;
  std::string search;
  std::string pointed_control, changed_control;  // under the pointer; changed last. Of the side that is shown
  std::string swept_control;                     // of which a sweep was asked for, for the window to begin
  Magnification magnification;
  int window_frame = 0;
  std::vector<Action> requests;  // buttons pressed, for the window to carry out
  std::string message;           // the last thing that happened
  bool message_is_bad = false;
  std::optional<size_t> recorded;  // moments, while it is recorded
  double message_until_s = 0;

  void say(const std::string& text, bool bad = false);
  bool speaks() const;  // the message is to be seen
};

// Begins a panel that fills its place; `ImGui::End` ends it. `tabs`: Tab goes from field to field.
void beginPanel(const char* name, float x, float y, float width, float height, bool tabs = false);

// Carries out a change; what is refused becomes the message.
void attempt(PanelState& state, const std::function<void()>& change);

// The panels at the sides of a window; returns the area they leave for the picture.
Area drawPanels(const Fonts& fonts, Desk& desk, PanelState& state);

// What lies over the picture: problems, help, the last message.
void drawOverlays(const Fonts& fonts, const Desk& desk, PanelState& state, const Area& area);

}  // namespace strobe::live
