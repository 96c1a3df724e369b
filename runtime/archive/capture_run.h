// SPDX-License-Identifier: MIT
// Takes a capture: from its script to a folder with pictures, figures, films, manifest.json, inputs, SHA256SUMS and
// timings.json.
#pragma once

#include <list>

#include "archive/manifest.h"
#include "base/frozen_home.h"
#include "base/lease.h"
#include "figure/taken.h"

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

// One picture of a capture.
struct CapturedFrame {
  const CapturedShot* shot = nullptr;
  const CapturedArm* arm = nullptr;
  size_t step = 0;

  // "SHOT.ARM", or "SHOT.ARM.0012" in a sequence. The names of the files begin with it.
  std::string name() const;
};
// Pictures by shot, then by arm, then by step, without shots with a missing scene. `only`: "", or the beginning of
// names. Throws `Error` (exit code 2) if no name begins so.
std::vector<CapturedFrame> framesOf(const CaptureFile& capture, const std::string& only = "");

// A capture in progress. Each picture is drawn once, written completely or not at all, and read back for figures and
// films. Pictures of an earlier capture with the same inputs are kept. A file under its final name is
// complete. Inputs are frozen at the start: later edits do not count. The folder is claimed: a second capture throws
// `Error` (exit code 2). `report` gets a line for each picture that
// `finish` takes, and for each figure. All functions may throw `Error`. The home must outlive the object.
class Capturing {
 public:
  Capturing(const Home& home, const Order& order, Report report = {});
  Capturing(const Capturing&) = delete;

  using Progress = std::function<void(int done, int of)>;

  const FrozenHome& inputs() const { return *main().home; }
  lab::Workbench& bench() { return *main().bench; }  // draws the pictures

  // Requested pictures, in order.
  const std::vector<CapturedFrame>& frames() const { return frames_; }
  lab::Shot shot(const CapturedFrame& frame) const { return shotOf(capture_, *frame.shot, *frame.arm, frame.step); }
  // Draws a picture and writes its files, unless the folder has the same picture. Returns the picture, without taps, if
  // it was drawn, else null.
  std::shared_ptr<const lab::Picture> draw(const CapturedFrame& frame, const Progress& progress = {});

  // Takes the remaining pictures, draws figures and films, and writes manifest, inputs, timings and sums.
  Captured finish();

 private:
  // Home and bench of the pictures, and the names of the files.
  struct Place {
    std::unique_ptr<FrozenHome> home;
    std::unique_ptr<lab::Workbench> bench;
    InputNames names;
  };
  using Places = std::map<Path, Place>;

  static Places mainPlace(const Home& home, const Order& order);
  const Place& main() const { return places_.at(""); }
  const Place& placeOf(const Path& files);
  std::string keyOf(const CapturedFrame& frame, const lab::Drawing& drawing, const lab::Shot& shot) const;
  Json take(const CapturedFrame& frame, const lab::Shot& shot, lab::Drawing& drawing, const lab::Picture& picture,
            uint64_t runs);
  figure::Taken readBack(const Json& entry) const;
  // The picture as taken. Valid as stated at `figure::FindTaken`.
  const figure::Taken& find(const std::string& shot, const std::string& arm, int step);

  bool isFigure(const std::string& name) const;
  void addFiles(const Path& folder);
  std::vector<const CapturedShot*> shotsOf(const Json& figure) const;
  void drawFigures();
  void collect(Json entry);
  Json captureJson(const std::string& name) const;

  const Order order_;
  const Home& home_;
  const Report report_;
  std::unique_ptr<Lease> lease_;
  Places places_;  // by the folder of an arm's own files; "": of all other arms
  const CaptureFile capture_;
  const std::vector<CapturedFrame> frames_;
  std::map<std::string, Json> entries_;  // of requested pictures, by name, as in the manifest (docs/captures.md)
  std::list<figure::Taken> kept_;        // last used first, at most kPicturesFound
  int drawn_ = 0;                        // pictures drawn, without pictures that were in the folder
  Json timings_ = Json::object();        // milliseconds of each picture drawn, by name
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
