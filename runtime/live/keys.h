// SPDX-License-Identifier: MIT
// Keys and mouse gestures of the window. The help and the window use the same table.
#pragma once

#include <string>
#include <vector>

namespace strobe::live {

// Action of the window that a single key triggers, for example stepping a frame, switching the comparison or saving the
// picture.
enum class Action {
  None,
  TogglePlay,
  StepBack,
  StepAhead,
  FirstFrame,
  CameraBack,
  FitPicture,
  ShowSingle,
  ShowWipe,
  ShowFlicker,
  ShowDifference,
  ShowError,
  PreviousView,
  NextView,
  ViewColor,
  Unpin,
  Save,
  Screenshot,
  CopyCommand,
  Search,
  Sweep,
  TakePrevious,
  TakeNext,
  SaveExperiment,
  Record,
  TogglePanels,
  ToggleHelp,
  Quit,
};

// Key of the window with its action: name in the help, key code, action and description.
struct KeyBinding {
  const char* shown;  // name in the help
  int code;           // typed character in lower case, or GLFW's key code (256 or more)
  Action action;
  const char* doc;
};
const std::vector<KeyBinding>& keys();

// Key that acts while it is held. `right`, `up`, `ahead`: speed, metres per second for each metre of distance to the
// target.
struct HeldKey {
  const char* shown;
  int code;
  double right, up, ahead;
  const char* doc;
};
const std::vector<HeldKey>& heldKeys();

// Mouse gesture over the picture, for the help.
struct Gesture {
  const char* shown;
  const char* doc;
};
const std::vector<Gesture>& gestures();

// Returns Action::None if the key has no action.
Action actionOf(int code);
// `shown`: name of the key in the help. Throws `Error` with the nearest name.
Action actionNamed(const std::string& shown);

}  // namespace strobe::live
