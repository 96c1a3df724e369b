// SPDX-License-Identifier: MIT
#include "live/input_queue.h"

#include <cctype>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "live/keys.h"

namespace strobe::live {

namespace {

// Frames until ImGui reports whether a text box has the keyboard focus. The focus changes in one frame; the next frame
// reports the change.
constexpr int kAnswer = 3;
// Maximum number of frames between a command and the text box that it opens.
constexpr int kTextDue = 6;

bool hasModifier(const InputEvent& event) { return event.mods & (GLFW_MOD_CONTROL | GLFW_MOD_ALT | GLFW_MOD_SUPER); }

// True if the key also produces a character, in any keyboard layout.
bool prints(const InputEvent& event) { return event.code < GLFW_KEY_ESCAPE && !hasModifier(event); }

// True if the key may take the keyboard focus from a text box or move it to the next one.
bool leavesText(int key) {
  return key == GLFW_KEY_ESCAPE || key == GLFW_KEY_ENTER || key == GLFW_KEY_KP_ENTER || key == GLFW_KEY_TAB;
}

bool givesText(int command) {
  Action action = actionOf(command);
  return action == Action::Search || action == Action::Sweep;
}

}  // namespace

// True if the event has to wait for a later frame. A key or button changes at most once per frame. Printing keys in a
// text box need not wait, because their characters are used instead.
bool InputQueue::waits(const InputEvent& next, bool typing, const std::set<int>& changed) const {
  if (next.kind != InputEvent::Kind::Button && rest_ > 0) return true;
  if (next.kind == InputEvent::Kind::Text || next.action == GLFW_REPEAT) return false;
  bool button = next.kind == InputEvent::Kind::Button;
  if (!button && typing && prints(next)) return false;
  return changed.count(button ? -1 - next.code : next.code) > 0;
}

void InputQueue::note(const InputEvent& event, bool typing) {
  if (event.kind == InputEvent::Kind::Button) {
    pointer_ = event.at, has_pointer_ = true;
    if (event.code < int(down_.size())) down_[size_t(event.code)] = event.action != GLFW_RELEASE;
    if (event.action == GLFW_PRESS) rest_ = kAnswer, text_due_ = false;
    return;
  }
  if (event.kind == InputEvent::Kind::Text) {
    if (typing) return;
    pressed_.push_back(event.code < 128 ? std::tolower(event.code) : event.code);
    if (givesText(pressed_.back())) rest_ = kTextDue, text_due_ = true;
    return;
  }
  if (event.action == GLFW_RELEASE) held_.erase(event.code);
  if (event.action == GLFW_RELEASE) return;
  if (leavesText(event.code)) rest_ = kAnswer, text_due_ = false;
  if (typing) return;
  if (event.action == GLFW_PRESS && !hasModifier(event)) held_.insert(event.code);
  if (event.code >= GLFW_KEY_ESCAPE) pressed_.push_back(event.code);
}

std::vector<InputEvent> InputQueue::take(bool typing) {
  pressed_.clear();
  if (typing) held_.clear();
  if (rest_ > 0) --rest_;
  if (typing && std::exchange(text_due_, false)) rest_ = 0;
  std::vector<InputEvent> taken;
  std::set<int> changed;
  while (!events_.empty() && !waits(events_.front(), typing, changed)) {
    taken.push_back(events_.front());
    events_.pop_front();
    const InputEvent& event = taken.back();
    bool button = event.kind == InputEvent::Kind::Button;
    if (event.kind != InputEvent::Kind::Text) changed.insert(button ? -1 - event.code : event.code);
    note(event, typing);
  }
  return taken;
}

}  // namespace strobe::live
