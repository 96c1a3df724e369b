// SPDX-License-Identifier: MIT
#include "app/files.h"

#include <unistd.h>

#include "base/error.h"

namespace strobe::app {

std::string hereOrAtHome(const Home& home, const std::string& file) {
  if (std::filesystem::exists(file) || Path(file).is_absolute()) return file;
  std::optional<Path> found = home.find(file);
  return found ? found->string() : file;
}

void requireWritable(const Path& folder, const std::string& option) {
  Path existing = std::filesystem::absolute(folder).lexically_normal();
  std::error_code ignored;
  while (!std::filesystem::exists(existing, ignored) && existing.has_relative_path()) existing = existing.parent_path();
  if (!std::filesystem::is_directory(existing, ignored))
    throw Error(fmt::format("{} '{}': '{}' is not a folder", option, folder.string(), existing.string()), {}, 2);
  if (::access(existing.c_str(), W_OK | X_OK) != 0)
    throw Error(fmt::format("{} '{}': no permission to write to '{}'", option, folder.string(), existing.string()), {},
                2);
}

bool isPreset(const Home& home, const Path& file) {
  return home.read(file).find("require \"strobe.preset\"") != std::string::npos;
}

}  // namespace strobe::app
