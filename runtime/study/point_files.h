// SPDX-License-Identifier: MIT
// Files of the points of a sweep, single or in packs. A sweep of many points packs them, because file servers, copies
// and quotas count files.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "base/zip.h"

namespace strobe::study {

// Folder of the packs, in the folder of a sweep.
inline constexpr const char* kPacks = "packs";

// Path of a file of a point: points/KEY.json, points/KEY.png (as shown), points/KEY.exr (linear, on request).
Path pointFile(const Path& folder, const std::string& key, const std::string& ending);

// Reads files by their names below the folder of a sweep, such as "points/KEY.json". A file of this name counts;
// without one, an entry of this name in an archive packs/*.zip. A folder that cannot be read counts as empty. Not
// thread-safe.
class PointFiles {
 public:
  static constexpr size_t kPerPack = 500;  // points

  explicit PointFiles(const Path& folder) : folder_(folder) {}

  // Share of the program, "2of8"; "": all points. Packs of other shares of the same number are not opened.
  std::string share;

  // Content of a file, or nothing if it is missing or damaged.
  std::optional<std::string> read(const std::string& name) const;
  bool has(const std::string& name) const;
  // Keys of all points, sorted.
  std::vector<std::string> keys() const;
  // Damaged packs that were found since the last call. Their points count as missing.
  std::vector<Path> takeDamaged() const { return std::exchange(damaged_, {}); }

  // Moves points/KEY.json and points/KEY.png of these points into one pack. A file that a pack already has stays
  // single. If the pack cannot be written, a warning gives the reason, and all files stay single.
  void pack(const std::set<std::string>& keys);

 private:
  bool isOfAnotherShare(const std::string& stem) const;
  void refresh() const;
  const ZipFile* packWith(const std::string& name) const;

  Path folder_;
  // Index of the packs that were listed. A file that is not found lists later packs.
  mutable double listed_ = 0;  // last change of the folder of packs
  mutable std::set<Path> packs_;
  mutable std::unordered_map<std::string, const Path*> pack_of_;  // by the name of an entry
  mutable std::map<Path, ZipFile> opened_;
  mutable std::vector<Path> damaged_;
};

}  // namespace strobe::study
