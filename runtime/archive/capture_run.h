// SPDX-License-Identifier: MIT
// Takes a capture: from its script to a folder with pictures, figures, films, manifest.json, inputs, SHA256SUMS and
// timings.json.
#pragma once

#include "archive/manifest.h"
#include "archive/taker.h"

namespace strobe::archive {

// Request to take a capture: script, output folder, selection of pictures, size and Vulkan device.
struct Order {
  std::string file;              // capture script
  Path folder;                   // output folder
  std::string only;              // "", the beginning of picture names, or a figure
  std::array<int, 2> size = {};  // pixels; {0, 0}: from the script
  bool bundle = false;           // copy every used file to FOLDER/inputs, not only texts
  std::string device;            // index or part of the name of a Vulkan device
  bool validation = false;
};

// Result of a completed capture: its manifest and the paths of the written figures, films and pictures.
struct Captured {
  Manifest manifest;
  std::vector<Path> figures, pictures;  // written files: figures and films; PNG pictures
};

using Report = std::function<void(const std::string&)>;

// A capture in progress. Pictures of an earlier capture with the same inputs are kept. A file under its final name is
// complete. Inputs are frozen at the start: later edits do not count. `report` gets a line for each picture that
// `finish` takes, and for each figure. All functions may throw `Error`. The home must outlive the object.
class Capturing {
 public:
  Capturing(const Home& home, const Order& order, Report report = {});
  Capturing(const Capturing&) = delete;

  const FrozenHome& inputs() const { return frozen_; }
  lab::Workbench& bench() { return *bench_; }  // draws the pictures

  // Requested pictures, in order.
  const std::vector<CapturedFrame>& frames() const { return frames_; }
  lab::Shot shot(const CapturedFrame& frame) const { return shotOf(capture_, *frame.shot, *frame.arm, frame.step); }
  // Takes a picture before its turn, as `Taker::draw`.
  std::shared_ptr<const lab::Picture> draw(const CapturedFrame& frame, const Taker::Progress& progress) {
    return taker_.draw(frame, progress);
  }

  // Takes the remaining pictures, draws figures and films, and writes manifest, inputs, timings and sums.
  Captured finish();

 private:
  bool isFigure(const std::string& name) const;
  void addFiles(const Path& folder);
  std::vector<const CapturedShot*> shotsOf(const Json& figure) const;
  void drawFigures();
  void collect(const CapturedFrame& frame);
  Json captureJson(const std::string& name) const;

  const Order order_;
  const Home& home_;
  const Report report_;
  const FrozenHome frozen_;
  const CaptureFile capture_;
  const std::unique_ptr<lab::Workbench> bench_;
  Taker taker_;
  const std::vector<CapturedFrame> frames_;
  Inputs used_;
  Json pictures_ = Json::array(), files_ = Json::object();
  std::vector<Path> figure_files_, picture_files_;
};

inline Captured runCapture(const Home& home, const Order& order, const Report& report = {}) {
  return Capturing(home, order, report).finish();
}

// Folder of the copied inputs, with a folder for each root ("inputs/strobe/passes/x.lua").
inline constexpr const char* kInputsFolder = "inputs";
Path inputCopy(const std::string& name);

}  // namespace strobe::archive
