// SPDX-License-Identifier: MIT
// Keys, characters and mouse buttons in their order, one batch per frame of the window. A key that may bring the
// keyboard to a text box, or away from it, ends its batch; the keys after it wait for the answer. No letter is lost or
// taken for a command, however long a frame takes. Needs no window.
#pragma once

#include <array>
#include <deque>
#include <set>
#include <utility>
#include <vector>

#include "math/geometry.h"

namespace strobe::live {

struct InputEvent {
  enum class Kind { Key, Text, Button };
  Kind kind = Kind::Key;
  int code = 0;                            // GLFW's key, a code point, or GLFW's button
  int scancode = 0, action = 0, mods = 0;  // as GLFW gives them; nothing for text
  dvec2 at = dvec2(0);                     // pointer of a button, pixels of the window
};

class InputQueue {
 public:
  void add(const InputEvent& event) { events_.push_back(event); }
  bool empty() const { return events_.empty(); }

  // Takes the events of the next frame of the window. `typing`: a text box had the keyboard in the frame before.
  std::vector<InputEvent> take(bool typing);

  // Keys of the last `take` that are commands, as keys.h counts them; once.
  std::vector<int> takePressed() { return std::exchange(pressed_, {}); }
  // Keys that went down as commands and are still down, by GLFW's code.
  bool isHeld(int key) const { return held_.count(key) > 0; }
  // Buttons as of the events taken so far.
  bool isDown(int button) const { return button < int(down_.size()) && down_[size_t(button)]; }
  // Pointer of the last button taken, while events wait behind it; else nothing, and the pointer is where it is now.
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
  int rest_ = 0;           // frames that keys still wait
  bool text_due_ = false;  // a text box is about to get the keyboard, which ends the wait
};

}  // namespace strobe::live
