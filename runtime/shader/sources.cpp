// SPDX-License-Identifier: MIT
#include "shader/sources.h"

namespace strobe::shader {

static bool isFile(const Path& file) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(file, ignored);
}

const std::string& Sources::read(const Path& file) {
  std::lock_guard lock(mutex_);
  auto known = texts_.find(file);
  if (known == texts_.end()) known = texts_.emplace(file, home_.read(file)).first;
  return known->second;
}

Path Sources::included(const std::string& name, const Path& from) {
  std::lock_guard lock(mutex_);
  auto [known, is_new] = includes_.try_emplace({name, from.parent_path()});
  if (is_new) known->second = look(name, from.parent_path());
  return known->second;
}

Path Sources::look(const std::string& name, const Path& from_folder) const {
  Path folder = std::filesystem::absolute(from_folder).lexically_normal();
  Path beside = (folder / name).lexically_normal();
  if (isFile(beside)) {
    if (std::optional<std::string> known = home_.nameOf(beside)) return home_.find(*known).value_or(Path());
    if (liesIn(beside, folder)) return beside;
  }
  Path shared = home_.at(Path("shaders") / name);
  return isFile(shared) && home_.nameOf(shared.lexically_normal()) ? shared.lexically_normal() : Path();
}

}  // namespace strobe::shader
