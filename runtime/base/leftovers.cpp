// SPDX-License-Identifier: MIT
#include "base/leftovers.h"

#include "base/process_name.h"

namespace strobe {

namespace fs = std::filesystem;

namespace {

// "HOST.12" for "x.png.HOST.12.part", ".inputs.HOST.12" and ".recorded.HOST.12"; "" for other names. libzip appends an
// ending to the name of a part.
std::string processOf(const Path& whole) {
  const Path name = whole.stem().extension() == ".part" ? whole.stem() : whole;
  const std::string text = name.string();
  const bool is_part = name.extension() == ".part";
  if (!is_part && !text.starts_with(".inputs") && !text.starts_with(".recorded.")) return "";
  const Path with_process = is_part ? name.stem() : name;
  return with_process.stem().extension().string().erase(0, 1) + with_process.extension().string();
}

bool isLeftover(const Path& name) { return hasEnded(processOf(name)); }

void removeAll(const std::vector<Path>& paths) {
  std::error_code ignored;
  for (const Path& path : paths) fs::remove_all(path, ignored);
}

}  // namespace

void removeLeftovers(const Path& folder) {
  std::error_code failed;
  std::vector<Path> found;
  for (auto entry = fs::recursive_directory_iterator(folder, failed); entry != fs::end(entry);
       entry.increment(failed)) {
    const Path name = entry->path().filename();
    if (isLeftover(name)) found.push_back(entry->path());
    if (name.string().starts_with(".")) entry.disable_recursion_pending();
  }
  removeAll(found);
}

void removeLeftovers(const Path& folder, const std::string& beginning) {
  std::error_code failed;
  std::vector<Path> found;
  for (auto entry = fs::directory_iterator(folder, failed); entry != fs::end(entry); entry.increment(failed)) {
    const std::string name = entry->path().filename().string();
    if (name.starts_with(beginning) && isLeftover(name)) found.push_back(entry->path());
  }
  removeAll(found);
}

}  // namespace strobe
