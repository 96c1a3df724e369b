// SPDX-License-Identifier: MIT
// Queue of keys, characters and mouse buttons in their order, one batch per window frame. A key that may move the
// keyboard focus to or from a text box ends its batch. The keys after it wait until ImGui reports the focus, so that no
// letter is lost or executed as a command, even if a frame takes long. Does not need a window.
#pragma once

#include <array>
#include <deque>
#include <set>
#include <utility>
#include <vector>

#include "math/geometry.h"

namespace strobe::live {

// One key, character or mouse button event of the window, with the codes of GLFW and the pointer position in pixels of
// the window.
struct InputEvent {
  enum class Kind { Key, Text, Button };
  Kind kind = Kind::Key;
  int code = 0;                            // key or button code of GLFW, or a code point
  int scancode = 0, action = 0, mods = 0;  // as in GLFW's callbacks; 0 for text
  dvec2 at = dvec2(0);                     // pointer at a button event, pixels of the window
};

// Ordered queue of keys, characters and mouse buttons, delivered in one batch per window frame. Delays keys while the
// keyboard focus moves to or from a text box.
class InputQueue {
 public:
  void add(const InputEvent& event) { events_.push_back(event); }
  bool empty() const { return events_.empty(); }

  // Takes the events of the next window frame. `typing`: a text box had the keyboard focus in the previous frame.
  std::vector<InputEvent> take(bool typing);

  // Returns and clears the command keys of the last `take`, with the codes of keys.h.
  std::vector<int> takePressed() { return std::exchange(pressed_, {}); }
  // True if the key (GLFW's code) went down as a command and is still down.
  bool isHeld(int key) const { return held_.count(key) > 0; }
  // True if the button is down after the events taken so far.
  bool isDown(int button) const { return button < int(down_.size()) && down_[size_t(button)]; }
  // Pointer at the last taken button event while later events wait; otherwise null, and the current pointer counts.
  const dvec2* pointer() const { return empty() || !has_pointer_ ? nullptr : &pointer_; }

 private:
  bool waits(const InputEvent& next, bool typing, const std::set<int>& changed) const;
  void note(const InputEvent& event, bool typing);

  std::deque<InputEvent> events_;
  std::vector<int> pressed_;
  std::set<int> held_;
  std::array<bool, 3> down_ = {};
  dvec2 pointer_ = dvec2(0);
  bool has_pointer_ = false;
  int rest_ = 0;           // frames that keys still have to wait
  bool text_due_ = false;  // a text box is about to get the keyboard focus; this ends the wait
};

}  // namespace strobe::live
