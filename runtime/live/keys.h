// SPDX-License-Identifier: MIT
// What keys and the mouse do in the window: one table that the help shows and the window obeys.
#pragma once

#include <string>
#include <vector>

namespace strobe::live {

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

struct Key {
  const char* shown;  // how the help spells it
  int code;           // the character typed, in lower case, or GLFW's code (from 256 on)
  Action action;
  const char* doc;
};
const std::vector<Key>& keys();

// Keys that act while they are held: metres per second to the right, up and ahead for one metre of distance.
struct HeldKey {
  const char* shown;
  int code;
  double right, up, ahead;
  const char* doc;
};
const std::vector<HeldKey>& heldKeys();

// What the mouse does over the picture, for the help.
struct Gesture {
  const char* shown;
  const char* doc;
};
const std::vector<Gesture>& gestures();

// Action::None where the key does nothing.
Action actionOf(int code);
// By how the help spells it; throws `Error` with the nearest name.
Action actionNamed(const std::string& shown);

}  // namespace strobe::live
