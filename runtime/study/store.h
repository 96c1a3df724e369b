// SPDX-License-Identifier: MIT
// What a sweep has done, on disk, so that it can end at any moment and go on: a file per point and per truth, each
// named by the content of all that made it, written whole or not at all. Folders of one experiment merge by copying.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <set>

#include "lab/workbench.h"
#include "study/results.h"

namespace strobe::study {

// Files of a folder of results: points/KEY.json, points/KEY.png (as shown), points/KEY.exr (linear, on request).
Path pointFile(const Path& folder, const std::string& key, const std::string& ending);

// Fills in the points of `results` that the folder has; the others stay as they are. Needs no lock. Returns the files
// of points that are damaged: cut short, altered, or of another point.
std::vector<Path> takePoints(Results& results, const Path& folder);

// Files of the points of `results` that are in the folder and differ from their hash.
std::vector<Path> alteredFiles(const Results& results, const Path& folder);
// True if a file of the point is in the folder as it was written.
bool isAsWritten(const Point& point, const Path& folder, const std::string& name);

// A damaged file counts as missing: it is named in a warning, gets the ending ".damaged", and is made again.
class Store {
 public:
  // Throws `Error` (exit code 2) where another process is at work in the folder.
  explicit Store(const Path& folder);
  Store(const Store&) = delete;
  ~Store();

  const Path& folder() const { return folder_; }

  // Throws `Error` (exit code 2) where the folder has points of another experiment, by its title. A damaged
  // experiment.json is written again.
  void belongTo(const std::string& title) const;

  // Points without the file of linear colour are not had.
  bool requires_exr = false;

  // folder/points/KEY.json, if it is there. `has` is false for a point that failed, or that lacks a whole file.
  std::optional<Point> point(const std::string& key) const;
  bool has(const std::string& key) const;
  void keep(const std::string& key, const Point& point) const;

  // folder/truth/KEY.exr: the outputs, a part each, and the record. A missing file is drawn by `draw`, in one
  // of the processes that need it.
  std::shared_ptr<const lab::Picture> truth(const std::string& key,
                                            const std::function<std::shared_ptr<const lab::Picture>()>& draw) const;

 private:
  void discard(const Path& file) const;
  bool hasFiles(const Point& point) const;

  Path folder_;
  int lock_ = -1;
  mutable std::set<std::string> had_;  // points whose files were found whole
};

}  // namespace strobe::study
