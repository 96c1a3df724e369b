// SPDX-License-Identifier: MIT
// Takes the pictures of a capture. Each picture is drawn once, written completely or not at all, and read back for
// figures and films.
#pragma once

#include <list>

#include "archive/capture_file.h"
#include "archive/inputs.h"
#include "base/frozen_home.h"
#include "figure/taken.h"

namespace strobe::archive {

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

// Draws the pictures of one capture, writes their files, and keeps the pictures used last in memory.
class Taker {
 public:
  using Progress = std::function<void(int done, int of)>;
  // Creates the bench for an arm with files of its own.
  using MakeBench = std::function<std::unique_ptr<lab::Workbench>(const Home& home)>;

  // Files go to FOLDER/pictures. `original`: the home that the bench's home is a copy of, or the same home. All
  // references must outlive the taker.
  Taker(lab::Workbench& bench, const Home& original, const CaptureFile& capture, const Path& folder, MakeBench make);

  // Draws a picture and writes its files, unless the folder has the same picture. Returns the picture, without taps, if
  // it was drawn, else null.
  std::shared_ptr<const lab::Picture> draw(const CapturedFrame& frame, const Progress& progress = {});
  // Entry of a picture in a manifest (docs/captures.md). Draws the picture if necessary.
  Json entry(const CapturedFrame& frame);
  // True if the picture was requested, directly or by a figure.
  bool has(const std::string& name) const { return entries_.count(name) > 0; }
  // The picture as taken. Valid as stated at `figure::FindTaken`.
  const figure::Taken& find(const std::string& shot, const std::string& arm, int step);
  int drawn() const { return drawn_; }  // pictures drawn by this taker, without pictures that were in the folder
  const InputNames& names() const { return own_.names; }
  // Throws `Error` with the validation messages of all benches.
  void refuseMessages() const;
  // Milliseconds of each picture drawn, by name.
  const Json& timings() const { return timings_; }

 private:
  // Bench of an arm, and the names of the arm's files. An arm with files of its own has a home and a bench of its own.
  struct Place {
    lab::Workbench& bench;
    InputNames names;
    std::unique_ptr<FrozenHome> own_home = {};
    std::unique_ptr<lab::Workbench> own_bench = {};
  };

  const Place& placeOf(const CapturedArm& arm);
  std::unique_ptr<lab::Drawing> drawingOf(lab::Workbench& bench, lab::Shot& shot);
  std::string keyOf(const CapturedFrame& frame, const lab::Drawing& drawing, const lab::Shot& shot) const;
  Json take(const CapturedFrame& frame, const lab::Shot& shot, lab::Drawing& drawing, const lab::Picture& picture,
            uint64_t runs);
  // True if the inputs still have the content that was recorded.
  bool areCurrent(const Json& inputs);
  figure::Taken readBack(const Json& entry) const;

  const CaptureFile& capture_;
  const Path folder_;
  MakeBench make_bench_;
  Place own_;
  std::map<Path, Place> others_;             // by the folder of an arm's files
  std::map<std::string, std::string> sums_;  // SHA-256 of the current inputs, by name
  std::map<std::string, Json> entries_;      // of requested pictures, by name
  std::list<figure::Taken> kept_;            // last used first, at most kPicturesFound
  int drawn_ = 0;
  Json timings_ = Json::object();
};

}  // namespace strobe::archive
