// SPDX-License-Identifier: MIT
#include "study/point_files.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include "base/error.h"
#include "base/hash.h"
#include "base/log.h"
#include "base/process_name.h"

namespace strobe::study {

namespace fs = std::filesystem;

Path pointFile(const Path& folder, const std::string& key, const std::string& ending) {
  return folder / "points" / (key + ending);
}

// Lists the packs again if the folder has changed.
void PointFiles::refresh() const {
  std::error_code missing;
  const fs::file_time_type changed = fs::last_write_time(folder_ / kPacks, missing);
  if (missing || changed == listed_) return;
  listed_ = changed;
  for (const std::string& stem : namesIn(folder_ / kPacks, ".zip")) {
    const Path pack = folder_ / kPacks / (stem + ".zip");
    if (!packs_.insert(pack).second) continue;
    try {
      for (const std::string& name : ZipFile(pack).names()) pack_of_.emplace(name, pack);
    } catch (const Error&) {
      damaged_.push_back(pack);
    }
  }
}

// Null if no pack has the name.
const ZipFile* PointFiles::packWith(const std::string& name) const {
  constexpr size_t kMostOpen = 64;
  refresh();
  auto found = pack_of_.find(name);
  if (found == pack_of_.end()) return nullptr;
  if (opened_.size() > kMostOpen) opened_.clear();
  return &opened_.try_emplace(found->second, found->second).first->second;
}

bool PointFiles::has(const std::string& name) const {
  if (fs::is_regular_file(folder_ / name)) return true;
  refresh();
  return pack_of_.count(name) > 0;
}

std::optional<std::string> PointFiles::read(const std::string& name) const {
  try {
    if (fs::is_regular_file(folder_ / name)) return readText(folder_ / name);
  } catch (const Error&) {  // moved into a pack in the meantime
  }
  try {
    if (const ZipFile* pack = packWith(name)) return pack->read(name);
  } catch (const Error&) {  // damaged or removed
  }
  return std::nullopt;
}

std::vector<std::string> PointFiles::keys() const {
  const std::vector<std::string> single = namesIn(folder_ / "points", ".json");
  std::set<std::string> keys(single.begin(), single.end());
  refresh();
  for (const auto& [name, pack] : pack_of_)
    if (hasExtension(name, ".json")) keys.insert(Path(name).stem());
  return {keys.begin(), keys.end()};
}

void PointFiles::pack(const std::set<std::string>& keys) {
  refresh();
  std::vector<std::string> names;
  for (const std::string& key : keys)
    for (const char* ending : {".json", ".png"})
      if (const std::string name = pointFile("", key, ending); !pack_of_.count(name) && fs::exists(folder_ / name))
        names.push_back(name);
  if (names.empty()) return;
  const std::string content = fmt::format("{} {}", processName(), fmt::join(names, " "));
  try {
    writeZip(folder_ / kPacks / (hashText(content) + ".zip"), folder_, names);
  } catch (const Error& error) {
    return warn(fmt::format("points are not packed: {}", error.what()));
  }
  std::error_code ignored;
  for (const std::string& name : names) fs::remove(folder_ / name, ignored);
}

}  // namespace strobe::study
