// SPDX-License-Identifier: MIT
// Takes the pictures of a capture: each is drawn once, written whole or not at all, and read back for figures and
// films.
#pragma once

#include <list>

#include "archive/capture_file.h"
#include "archive/inputs.h"
#include "base/frozen_home.h"
#include "figure/taken.h"

namespace strobe::archive {

// One picture of a capture.
struct Frame {
  const CapturedShot* shot = nullptr;
  const CapturedArm* arm = nullptr;
  size_t step = 0;

  // "SHOT.ARM", of a sequence "SHOT.ARM.0012": as files have it.
  std::string name() const;
};
// Shots in their order, then arms, then steps; without those whose scene is not there. `only`: "", or the beginning of
// names; throws `Error` (exit code 2) where none begins so.
std::vector<Frame> framesOf(const CaptureFile& capture, const std::string& only = "");

class Taker {
 public:
  using Progress = std::function<void(int done, int of)>;
  // Makes the bench for arms with files of their own.
  using MakeBench = std::function<std::unique_ptr<lab::Workbench>(const Home& home)>;

  // Files go to FOLDER/pictures. `original`: the home that the bench's is a copy of. All must outlive it.
  Taker(lab::Workbench& bench, const Home& original, const CaptureFile& capture, const Path& folder, MakeBench make);

  // Draws a picture, and writes its files, unless the folder has it as it would be. Gives it, without taps, where it
  // was drawn now.
  std::shared_ptr<const lab::Picture> draw(const Frame& frame, const Progress& progress = {});
  // The entry of a picture in a manifest (docs/captures.md); drawn where it was not.
  Json entry(const Frame& frame);
  // Whether a picture was asked for, by itself or by a figure.
  bool has(const std::string& name) const { return entries_.count(name) > 0; }
  // As it was taken; valid as `figure::FindTaken` says.
  const figure::Taken& find(const std::string& shot, const std::string& arm, int step);
  int drawn() const { return drawn_; }  // pictures drawn by this taker; the others were there
  const InputNames& names() const { return own_.names; }
  // Throws `Error` with what validation said of any bench.
  void refuseMessages() const;
  // Milliseconds of each picture drawn, by name.
  const Json& timings() const { return timings_; }

 private:
  // What arms draw on, and the names of the files there.
  struct Place {
    lab::Workbench& bench;
    InputNames names;
  };
  struct OwnPlace {
    std::unique_ptr<FrozenHome> home;
    std::unique_ptr<lab::Workbench> bench;
    Place place;
  };

  const Place& placeOf(const CapturedArm& arm);
  std::unique_ptr<lab::Drawing> drawingOf(lab::Workbench& bench, lab::Shot& shot);
  std::string keyOf(const Frame& frame, const lab::Drawing& drawing, const lab::Shot& shot) const;
  Json take(const Frame& frame, const lab::Shot& shot, lab::Drawing& drawing, const lab::Picture& picture,
            uint64_t runs);
  // Whether files named as inputs have the content now that they had then.
  bool areCurrent(const Json& inputs);
  figure::Taken readBack(const Json& entry) const;

  const CaptureFile& capture_;
  const Path folder_;
  MakeBench make_bench_;
  Place own_;
  std::map<Path, std::unique_ptr<OwnPlace>> others_;  // by the folder of an arm's files
  std::map<std::string, std::string> sums_;           // SHA-256 of inputs as they are, by name
  std::map<std::string, Json> entries_;               // of pictures asked for, by name
  std::list<figure::Taken> kept_;                     // the used last first, kPicturesFound of them
  int drawn_ = 0;
  Json timings_ = Json::object();
};

}  // namespace strobe::archive
