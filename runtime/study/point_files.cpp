// SPDX-License-Identifier: MIT
#include "study/point_files.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include "base/hash.h"
#include "base/lease.h"
#include "base/log.h"
#include "base/process_name.h"

namespace strobe::study {

namespace fs = std::filesystem;

Path pointFile(const Path& folder, const std::string& key, const std::string& ending) {
  return folder / "points" / (key + ending);
}

static bool isFile(const Path& file) {
  std::error_code ignored;
  return fs::is_regular_file(file, ignored);
}

// ---- index

// Packs have the names "SHARE.HASH" and "HASH".
bool PointFiles::isOfAnotherShare(const std::string& stem) const {
  const size_t number = share.find("of");
  const std::string other = stem.substr(0, stem.find('.'));
  return number != std::string::npos && other != share && other.ends_with(share.substr(number));
}

// Lists the packs again if their folder has changed.
void PointFiles::refresh() const {
  const double changed = changedAt(folder_ / kPacks);
  if (changed == listed_) return;
  for (const std::string& stem : namesIn(folder_ / kPacks, ".zip")) {
    const auto [pack, is_new] = packs_.insert(folder_ / kPacks / (stem + ".zip"));
    if (!is_new || isOfAnotherShare(stem)) continue;
    try {
      for (const std::string& name : ZipFile(*pack).names()) pack_of_.emplace(name, &*pack);
    } catch (const DamagedZip&) {
      damaged_.push_back(*pack);
    } catch (const Error&) {  // removed, or opened again at the next change
      packs_.erase(pack);
    }
  }
  listed_ = changed;
}

// Null if no pack has the name.
const ZipFile* PointFiles::packWith(const std::string& name) const {
  constexpr size_t kMostOpen = 64;
  refresh();
  auto found = pack_of_.find(name);
  if (found == pack_of_.end()) return nullptr;
  if (opened_.size() > kMostOpen) opened_.clear();
  return &opened_.try_emplace(*found->second, *found->second).first->second;
}

// ---- reading

bool PointFiles::has(const std::string& name) const {
  if (isFile(folder_ / name)) return true;
  refresh();
  return pack_of_.count(name) > 0;
}

std::optional<std::string> PointFiles::read(const std::string& name) const {
  try {
    if (isFile(folder_ / name)) return readText(folder_ / name);
  } catch (const Error&) {  // moved into a pack in the meantime
  }
  try {
    if (const ZipFile* pack = packWith(name)) return pack->read(name);
  } catch (const Error& error) {
    warn(fmt::format("{}; {} counts as missing", error.what(), name));
    pack_of_.erase(name);
  }
  return std::nullopt;
}

std::vector<std::string> PointFiles::keys() const {
  const std::vector<std::string> single = namesIn(folder_ / "points", ".json");
  std::set<std::string> keys(single.begin(), single.end());
  refresh();
  for (const auto& [name, pack] : pack_of_)
    if (hasExtension(name, ".json")) keys.insert(Path(name).stem());
  std::erase_if(keys, [](const std::string& key) { return key.find('.') != std::string::npos; });  // KEY.record.json
  return {keys.begin(), keys.end()};
}

// ---- packing

void PointFiles::pack(const std::set<std::string>& keys) {
  if (keys.empty()) return;
  refresh();
  std::vector<std::string> names;
  for (const std::string& key : keys)
    for (const char* ending : {".json", ".png"})
      if (const std::string name = pointFile("", key, ending); !pack_of_.count(name) && isFile(folder_ / name))
        names.push_back(name);
  if (names.empty()) return;
  const std::string hash = hashText(fmt::format("{} {}", processName(), fmt::join(names, " ")));
  const Path file = folder_ / kPacks / (share + (share.empty() ? "" : ".") + hash + ".zip");
  try {
    writeZip(file, folder_, names);
  } catch (const Error& error) {
    // Another program packs the same points, or the folder is full.
    return warn(fmt::format("points are not packed: {}", error.what()));
  }
  const Path& pack = *packs_.insert(file).first;
  std::error_code ignored;
  for (const std::string& name : names) {
    pack_of_.emplace(name, &pack);
    fs::remove(folder_ / name, ignored);
  }
}

}  // namespace strobe::study
