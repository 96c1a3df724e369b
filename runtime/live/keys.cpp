// SPDX-License-Identifier: MIT
#include "live/keys.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "base/error.h"

namespace strobe::live {

const std::vector<KeyBinding>& keys() {
  static const std::vector<KeyBinding> table = {
      {"Space", ' ', Action::TogglePlay, "play or pause"},
      {"Left", GLFW_KEY_LEFT, Action::StepBack, "one frame back"},
      {"Right", GLFW_KEY_RIGHT, Action::StepAhead, "one frame ahead"},
      {"Home", GLFW_KEY_HOME, Action::FirstFrame, "the frame the window was opened with"},
      {"C", 'c', Action::CameraBack, "reset the camera to the scene"},
      {"F", 'f', Action::FitPicture, "fit the picture into the window"},
      {"1", '1', Action::ShowSingle, "the picture alone"},
      {"2", '2', Action::ShowWipe, "wipe between A and B"},
      {"3", '3', Action::ShowFlicker, "A and B alternately"},
      {"4", '4', Action::ShowDifference, "difference of A and B"},
      {"5", '5', Action::ShowError, "error against truth, which is sampled in the background"},
      {"Up", GLFW_KEY_UP, Action::PreviousView, "view the previous image of the frame"},
      {"Down", GLFW_KEY_DOWN, Action::NextView, "view the next image of the frame"},
      {"V", 'v', Action::ViewColor, "view the colour again"},
      {"Escape", GLFW_KEY_ESCAPE, Action::Unpin, "close the help or the sweep, or unpin the pixel"},
      {"F2", GLFW_KEY_F2, Action::Save, "save the picture with its run record"},
      {"F3", GLFW_KEY_F3, Action::Screenshot, "save a screenshot of the window"},
      {"F4", GLFW_KEY_F4, Action::CopyCommand, "copy the command that makes this picture"},
      {"/", '/', Action::Search, "find a control"},
      {"R", 'r', Action::Sweep,
       "sweep the control under the pointer, else the first search result, else the last changed control"},
      {",", ',', Action::TakePrevious, "take the previous value from the sweep"},
      {".", '.', Action::TakeNext, "take the next value from the sweep"},
      {"F5", GLFW_KEY_F5, Action::SaveExperiment, "save the sweep as an experiment"},
      {"F6", GLFW_KEY_F6, Action::Record, "start a recording; again: write it as a capture script"},
      {"Tab", GLFW_KEY_TAB, Action::TogglePanels, "show or hide the panels"},
      {"?", '?', Action::ToggleHelp, "this help"},
      {"F10", GLFW_KEY_F10, Action::Quit, "close the window"},
  };
  return table;
}

const std::vector<HeldKey>& heldKeys() {
  static const std::vector<HeldKey> table = {
      {"W", GLFW_KEY_W, 0, 0, 0.5, "fly ahead (with Shift four times as fast)"},
      {"S", GLFW_KEY_S, 0, 0, -0.5, "fly back"},
      {"A", GLFW_KEY_A, -0.5, 0, 0, "fly to the left"},
      {"D", GLFW_KEY_D, 0.5, 0, 0, "fly to the right"},
      {"E", GLFW_KEY_E, 0, 0.5, 0, "fly up"},
      {"Q", GLFW_KEY_Q, 0, -0.5, 0, "fly down"},
  };
  return table;
}

const std::vector<Gesture>& gestures() {
  static const std::vector<Gesture> table = {
      {"drag", "orbit around the point under the pointer; move the line of a wipe"},
      {"right drag", "look around"},
      {"Shift + drag", "move the camera sideways"},
      {"wheel", "move nearer or farther"},
      {"Ctrl + drag", "move the picture in the window"},
      {"Ctrl + wheel", "magnify the picture at the pointer"},
      {"click", "pin the trail of a pixel"},
  };
  return table;
}

Action actionOf(int code) {
  for (const KeyBinding& key : keys())
    if (key.code == code) return key.action;
  return Action::None;
}

Action actionNamed(const std::string& shown) {
  std::vector<std::string> names;
  for (const KeyBinding& key : keys()) {
    if (shown == key.shown) return key.action;
    names.push_back(key.shown);
  }
  throw Error(fmt::format("no key is called '{}'{}", shown, didYouMean(shown, names)));
}

}  // namespace strobe::live
