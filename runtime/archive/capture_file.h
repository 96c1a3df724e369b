// SPDX-License-Identifier: MIT
// A capture script (scripts/strobe/capture.lua) as values: shots, drawn by arms, each at one step or at a sequence of
// them.
#pragma once

#include "image/tone.h"
#include "lab/shot.h"

namespace strobe::archive {

// What a step of a sequence sets.
struct Step {
  std::string label;  // "frame 3", "exposure = 0.5"; "" of a shot without a sequence
  Json options;       // of the shot, as lab::setOptions takes them
  script::Settings sets;
};

struct CapturedShot {
  std::string name, title, attribution;
  lab::Shot shot;          // without pipeline; settings of the scene alone
  script::Settings truth;  // on top of those of the truth arm
  std::vector<Step> steps = {Step()};
  image::ToneMap tone;
  std::string scene_name;  // as the script has it
  std::string missing;     // why its scene is not there; "": it is

  bool isSequence() const { return steps.size() > 1 || !steps.front().label.empty(); }
};

// Layers of a picture besides its colour.
struct Layers {
  bool all = false;  // every output, and what every pass wrote
  std::vector<std::string> names;
};

struct CapturedArm {
  std::string name, pipeline;
  script::Settings sets;
  std::vector<std::string> shots;  // those that it draws; empty: all
  std::optional<Layers> layers;
  Path files;  // a folder beside the script, whose files take the place of the home's own (FrozenHome); or ""

  bool draws(const std::string& shot) const;
};

struct CaptureFile {
  std::string file;  // as it was given
  std::string title, note, truth;
  int file_width = 0, file_height = 0, width = 0, height = 0;  // pixels: as the file says; as it is drawn
  bool measured = false;                                       // it is an experiment too
  double most_flip = 0.005;  // mean FLIP up to which a picture of another device counts as the same
  std::vector<CapturedShot> shots;
  std::vector<CapturedArm> arms;
  std::optional<Layers> layers;
  std::vector<Json> figures, films;         // as scripts/strobe/figure.lua leaves them, with the sizes of the capture
  std::vector<script::Dependency> scripts;  // that were read

  const CapturedShot& shot(const std::string& name) const;  // throws `Error` for one that there is not
  const CapturedArm& arm(const std::string& name) const;
};

// The file, checked: throws `Error`, all mistakes at once, each at its place. A scene "shared:FILE" is looked for in
// the shared data. `size` {0, 0}: the file's own.
CaptureFile readCapture(const Home& home, const std::string& file, std::array<int, 2> size = {});

// What is drawn, with its settings; `step` is one of the shot's.
lab::Shot shotOf(const CaptureFile& capture, const CapturedShot& shot, const CapturedArm& arm, size_t step);

// Those of a picture: the arm's, else the capture's, else all of a single picture and none of a sequence's.
Layers layersOf(const CaptureFile& capture, const CapturedShot& shot, const CapturedArm& arm);

}  // namespace strobe::archive
