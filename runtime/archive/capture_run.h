// SPDX-License-Identifier: MIT
// A capture from its script to a folder: pictures, figures, films, manifest.json, ro-crate-metadata.json, inputs,
// SHA256SUMS, timings.json.
#pragma once

#include "archive/manifest.h"
#include "archive/taker.h"

namespace strobe::archive {

struct Order {
  std::string file;              // the capture script
  Path folder;                   // where everything is written
  std::string only;              // "", or the beginning of names of pictures
  std::array<int, 2> size = {};  // pixels; {0, 0}: the script's
  bool bundle = false;           // every file that was used goes into FOLDER/inputs, not texts alone
  std::string device;            // index or part of the name of a Vulkan device
  bool validation = false;
};

struct Captured {
  Manifest manifest;
  std::vector<Path> figures, pictures;  // written for people: figures and films, pictures
};

using Report = std::function<void(const std::string&)>;

// A capture in the making. What was taken by an earlier one with the same inputs stays; a file that is there under its
// final name is whole. Inputs are frozen at the start: what is edited meanwhile does not count. `report` gets a line
// for each picture that `finish` takes, and for each figure. All throw `Error`. The home must outlive it.
class Capturing {
 public:
  Capturing(const Home& home, const Order& order, Report report = {});
  Capturing(const Capturing&) = delete;

  const FrozenHome& inputs() const { return frozen_; }
  lab::Workbench& bench() { return *bench_; }  // its pictures are drawn on it

  // The pictures that are asked for, in order.
  const std::vector<Frame>& frames() const { return frames_; }
  lab::Shot shot(const Frame& frame) const { return shotOf(capture_, *frame.shot, *frame.arm, frame.step); }
  // Takes one of them before its turn; as `Taker::draw`.
  std::shared_ptr<const lab::Picture> draw(const Frame& frame, const Taker::Progress& progress) {
    return taker_.draw(frame, progress);
  }

  // Takes what is left, draws figures and films, writes the manifest and what belongs to it.
  Captured finish();

 private:
  bool isFigure(const std::string& name) const;
  void addFiles(const Path& folder);
  std::vector<const CapturedShot*> shotsOf(const Json& figure) const;
  void drawFigures();
  void collect(const Frame& frame);
  Json captureJson(const std::string& name) const;

  const Order order_;
  const Home& home_;
  const Report report_;
  const std::string date_;
  const FrozenHome frozen_;
  const CaptureFile capture_;
  const std::unique_ptr<lab::Workbench> bench_;
  Taker taker_;
  const std::vector<Frame> frames_;
  Inputs used_;
  Json pictures_ = Json::array(), files_ = Json::object();
  std::vector<Path> figure_files_, picture_files_;
};

inline Captured runCapture(const Home& home, const Order& order, const Report& report = {}) {
  return Capturing(home, order, report).finish();
}

// Folder of the copies of inputs, and the roots in it ("inputs/strobe/passes/x.lua").
inline constexpr const char* kInputsFolder = "inputs";
Path inputCopy(const std::string& name);

}  // namespace strobe::archive
