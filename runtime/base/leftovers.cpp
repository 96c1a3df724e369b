// SPDX-License-Identifier: MIT
#include "base/leftovers.h"

#include <signal.h>
#include <sys/types.h>

#include <algorithm>
#include <cctype>
#include <cerrno>

namespace strobe {

namespace fs = std::filesystem;

namespace {

bool isNumber(const std::string& text) {
  return !text.empty() && text.size() < 10 &&
         std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isdigit(c); });
}

// "12" for "x.png.12.part" and ".recorded.12"; "" for other names.
std::string processOf(const Path& name) {
  if (name.extension() != ".part" && name.stem() != ".recorded") return "";
  const Path with_number = name.extension() == ".part" ? name.stem() : name;
  const std::string number = with_number.extension().string();
  return number.size() > 1 && isNumber(number.substr(1)) ? number.substr(1) : "";
}

bool isGone(const std::string& process) {
  return !process.empty() && ::kill(pid_t(std::stol(process)), 0) != 0 && errno == ESRCH;
}

bool isLeftover(const Path& name) {
  const std::string text = name.string(), inputs = ".inputs_";
  return isGone(processOf(name)) || (text.starts_with(inputs) && isNumber(text.substr(inputs.size())));
}

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
    if (name.starts_with(beginning) && isGone(processOf(name))) found.push_back(entry->path());
  }
  removeAll(found);
}

}  // namespace strobe
