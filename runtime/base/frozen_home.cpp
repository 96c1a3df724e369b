// SPDX-License-Identifier: MIT
#include "base/frozen_home.h"

#include <filesystem>
#include <set>

#include "base/error.h"

namespace strobe {

namespace fs = std::filesystem;

namespace {

// As deep as they lie, but for hidden folders.
void copyTexts(const Path& from, const Path& to) {
  static const std::set<std::string> kinds = {".lua", ".glsl", ".h"};
  for (auto entries = fs::recursive_directory_iterator(from); entries != fs::end(entries); ++entries) {
    const fs::directory_entry& entry = *entries;
    if (entry.is_directory() && entry.path().filename().string().starts_with(".")) entries.disable_recursion_pending();
    if (!entry.is_regular_file() || !kinds.count(entry.path().extension())) continue;
    Path copy = to / entry.path().lexically_relative(from);
    fs::create_directories(copy.parent_path());
    fs::copy_file(entry.path(), copy);
  }
}

Home copied(const Home& home, const Path& folder) {
  fs::remove_all(folder);
  std::vector<Path> roots;
  for (const Path& root : home.roots()) {
    roots.push_back(folder / std::to_string(roots.size()));
    fs::create_directories(roots.back());
    if (fs::exists(root / Home::kProjectFile))
      fs::copy_file(root / Home::kProjectFile, roots.back() / Home::kProjectFile);
    for (const char* part : {"passes", "shaders", "scripts", "pipelines", "scenes", "captures", "experiments"})
      if (fs::is_directory(root / part)) copyTexts(root / part, roots.back() / part);
  }
  return Home(roots, home.data(), home.program());
}

}  // namespace

FrozenHome::FrozenHome(const Home& home, const Path& folder)
    : original_(home), folder_(folder), home_(copied(home, folder)) {}

FrozenHome::~FrozenHome() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

std::string FrozenHome::at(const std::string& file) const {
  Path path = fs::absolute(file).lexically_normal();
  const std::vector<Path>& roots = original_.roots();
  for (size_t i = 0; i < roots.size(); ++i)
    if (liesIn(path, roots[i]) && fs::exists(home_.roots()[i] / path.lexically_relative(roots[i])))
      return (home_.roots()[i] / path.lexically_relative(roots[i])).string();
  return file;
}

}  // namespace strobe
