// SPDX-License-Identifier: MIT
// Results of a sweep on disk. A sweep can end at any time and continue later: each truth has a file, and each point has
// files or entries of a pack, named by the hash of all its inputs and written atomically. Folders of one experiment
// merge by copying. Several programs, also on several machines, may work in one folder.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <set>

#include "base/lease.h"
#include "lab/workbench.h"
#include "study/point_files.h"
#include "study/results.h"

namespace strobe::study {

// Folder of the claims and of the signs of running programs, in the folder of a sweep.
inline constexpr const char* kWorkers = ".workers";

// A point that failed so often is set aside.
inline constexpr size_t kMostTries = 3;

// Part of a key without the device.
std::string keyWithoutDevice(const std::string& key);

// Fills in the points of `results` that the folder has, and the crops and authors of their shots; other points and
// shots stay as they are. With `of_any_device`, a missing point is taken from another device or driver. Returns the
// damaged files of points: cut short, altered, or of another point.
std::vector<Path> takePoints(Results& results, const Path& folder, bool of_any_device = false);

// Results of an unfinished run, with the points drawn so far on any device. Throws `Error` if the outline is missing or
// damaged.
Results resultsSoFar(const Path& outline);

// Files of the points of `results` that are in the folder and differ from their hash.
std::vector<Path> alteredFiles(const Results& results, const Path& folder);
// Content of a file of the point; nothing if the file is missing or differs from its hash.
std::optional<std::string> checkedFile(const Point& point, const PointFiles& files, const std::string& name);

// Store of one sweep. A damaged file counts as missing: a warning names the file, the file gets the ending ".damaged",
// and its content is made again.
class Store {
 public:
  // Removes files of ended processes of this machine, unless another program works in the folder.
  explicit Store(const Path& folder);
  Store(const Store&) = delete;

  const Path& folder() const { return folder_; }
  // Folder of the claims and of the signs of running programs.
  Path workers() const { return folder_ / kWorkers; }

  // Throws `Error` (exit code 2) if the folder has points of another experiment, by title. Writes a damaged
  // experiment.json again.
  void belongTo(const std::string& title) const;
  // Compares program and inputs with the last run in the folder, after this program has a `Worker`. Warns if they
  // differ; throws `Error` (exit code 2) if another program draws with the earlier version now. `version`: hash of
  // program and inputs.
  void agreeOn(const Inputs& inputs, const std::string& version) const;

  // True: points without a file of linear colour count as missing.
  bool requires_exr = false;

  // File of the outline: the results with every point that can be drawn, but without numbers. "": not kept.
  Path outline;
  std::string command;  // of the results
  void keepOutline(Results results) const;

  // Point in folder/points/KEY.json, if the file exists. `has` is false for a point without values (its picture
  // failed), and for a point with missing or damaged files.
  std::optional<Point> point(const std::string& key) const;
  bool has(const std::string& key) const;
  void keep(const std::string& key, const Point& point) const;
  size_t triesOf(const std::string& key) const;  // failed tries to draw the point

  // Lets complete points move into packs (`PointFiles`). `share`: of this program, "2of8"; "": all points.
  void packPoints(const std::string& share) { packs_ = true, files_.share = share; }
  // Notes that a point is complete. Every `PointFiles::kPerPack` complete points move into a pack.
  void finish(const std::string& key) const;
  // Moves these points, and the complete points that are left, into packs, unless another program does.
  void packAll(const std::vector<std::string>& keys) const;

  // Claims a point, or other work of this name. Null if another program has the claim.
  std::unique_ptr<Lease> claim(const std::string& key) const { return Lease::claim(workers() / (key + ".lock")); }
  // Claims the work when no other program has the claim any more.
  std::unique_ptr<Lease> waitedClaim(const std::string& key) const;

  // True: points that failed `kMostTries` times are drawn again.
  bool retries = false;

  // Truth in folder/truth/KEY.exr: one part per output, and the record. `draw` makes a missing file, in only one of the
  // programs that need the file; the others wait.
  std::shared_ptr<const lab::Picture> truth(const std::string& key,
                                            const std::function<std::shared_ptr<const lab::Picture>()>& draw) const;

 private:
  void discard(const Path& file) const;
  bool hasFiles(const Point& point) const;

  Path folder_;
  mutable PointFiles files_;
  bool packs_ = false;
  mutable std::set<std::string> finished_;  // keys of complete points that are not in a pack
  mutable std::set<std::string> had_;       // keys of points with complete files
};

}  // namespace strobe::study
