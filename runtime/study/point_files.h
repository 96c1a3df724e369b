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

// Reads files by their names below the folder of a sweep: "points/KEY.json". A name that is not a file there is
// searched in packs/*.zip, which have entries of the same names: `unzip` in the folder makes single files again. A
// single file precedes an entry of the same name.
class PointFiles {
 public:
  static constexpr size_t kPerPack = 500;  // points

  explicit PointFiles(const Path& folder) : folder_(folder) {}

  // Content of a file, or nothing if it is missing or damaged.
  std::optional<std::string> read(const std::string& name) const;
  bool has(const std::string& name) const;
  // Keys of all points, sorted.
  std::vector<std::string> keys() const;
  // Damaged packs that were found since the last call. Their points count as missing.
  std::vector<Path> takeDamaged() const { return std::exchange(damaged_, {}); }

  // Moves points/KEY.json and points/KEY.png of these points into one pack. Points that another pack has stay single
  // files. If the pack cannot be written, a warning says why, and all points stay single files.
  void pack(const std::set<std::string>& keys);

 private:
  void refresh() const;
  const ZipFile* packWith(const std::string& name) const;

  Path folder_;
  // State of the packs that were listed; later packs are found when they are needed.
  mutable std::filesystem::file_time_type listed_{};  // last change of the folder of packs
  mutable std::set<Path> packs_;
  mutable std::unordered_map<std::string, Path> pack_of_;  // by the name of an entry
  mutable std::map<Path, ZipFile> opened_;
  mutable std::vector<Path> damaged_;
};

}  // namespace strobe::study
