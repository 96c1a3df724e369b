// SPDX-License-Identifier: MIT
// A capture script (scripts/strobe/capture.lua) as values: shots, drawn by arms, each at one step or at a sequence of
// steps.
#pragma once

#include "image/tone.h"
#include "lab/shot_data.h"

namespace strobe::archive {

// Options and settings of one step of a sequence.
struct SequenceStep {
  std::string label;  // "frame 3", "exposure = 0.5"; "" of a shot without a sequence
  Json options;       // of the shot, for lab::setOptions
  script::Settings sets;
};

// A shot of a capture script: scene, options and settings, with its sequence steps, its tone mapping and its captions.
struct CapturedShot {
  std::string name, title, attribution;
  lab::Shot shot;          // without pipeline; settings of the scene only
  script::Settings truth;  // added to the settings of the truth arm
  std::vector<SequenceStep> steps = {SequenceStep()};
  image::ToneMap tone;
  std::string scene_name;  // as in the script
  std::string missing;     // reason why the scene is missing; "": not missing

  bool isSequence() const { return steps.size() > 1 || !steps.front().label.empty(); }
};

// Layers of a picture besides its colour.
struct Layers {
  bool all = false;  // all outputs, and the images that every pass wrote
  std::vector<std::string> names;
};

// A rendering method of a capture script: a pipeline with settings, and the shots to draw with it.
struct CapturedArm : lab::Arm {
  std::vector<std::string> shots;  // shots that the arm draws; empty: all
  std::optional<Layers> layers;
  Path files;  // folder beside the script with replacements for the home's files (FrozenHome); or ""

  bool draws(const std::string& shot) const;
};

// Contents of a capture script: shots, arms (rendering methods), image sizes in pixels, layers, figures and films.
struct CaptureFile {
  std::string file;  // as given
  std::string title, note, truth;
  int file_width = 0, file_height = 0, width = 0, height = 0;  // pixels: in the file; as drawn
  bool measured = false;                                       // also an experiment
  double most_flip = 0.005;  // largest mean FLIP of a picture from another device that counts as the same
  std::vector<CapturedShot> shots;
  std::vector<CapturedArm> arms;
  std::optional<Layers> layers;
  std::vector<Json> figures, films;         // from scripts/strobe/figure.lua, with the sizes of the capture
  std::vector<script::Dependency> scripts;  // scripts that were read

  const CapturedShot& shot(const std::string& name) const;  // throws `Error` for an unknown name
  const CapturedArm& arm(const std::string& name) const;
};

// Reads and checks the file. Throws one `Error` with all mistakes, each with its place. A scene "shared:FILE" is
// looked up in the shared data. `size`: pixels; {0, 0}: from the file.
CaptureFile readCapture(const Home& home, const std::string& file, std::array<int, 2> size = {});

// Shot of a picture, with its settings. `step` is an index of the captured shot's steps.
lab::Shot shotOf(const CaptureFile& capture, const CapturedShot& shot, const CapturedArm& arm, size_t step);

// Layers of a picture: from the arm, else from the capture. By default a single picture has all layers, and a picture
// of a sequence has no layers.
Layers layersOf(const CaptureFile& capture, const CapturedShot& shot, const CapturedArm& arm);

}  // namespace strobe::archive
