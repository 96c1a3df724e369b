// SPDX-License-Identifier: MIT
#include "base/frozen_home.h"

#include <filesystem>
#include <set>

#include "base/error.h"
#include "base/files.h"

namespace strobe {

namespace fs = std::filesystem;

namespace {

const std::set<std::string> kTexts = {".lua", ".glsl", ".h"};
const std::set<std::string> kData = {".glb", ".gltf", ".bin", ".png", ".jpg", ".jpeg"};

// The same file under another name where the file system can do that.
void link(const Path& from, const Path& to) {
  std::error_code failed;
  fs::create_hard_link(from, to, failed);
  if (failed) fs::copy_file(from, to);
}

// As deep as they lie, but for hidden folders.
void copyFolder(const Path& from, const Path& to, bool with_data) {
  for (auto entries = fs::recursive_directory_iterator(from); entries != fs::end(entries); ++entries) {
    const fs::directory_entry& entry = *entries;
    if (entry.is_directory() && entry.path().filename().string().starts_with(".")) entries.disable_recursion_pending();
    bool is_text = kTexts.count(entry.path().extension()), is_data = with_data && kData.count(entry.path().extension());
    if (!entry.is_regular_file() || (!is_text && !is_data)) continue;
    Path copy = to / entry.path().lexically_relative(from);
    fs::create_directories(copy.parent_path());
    if (is_text) fs::copy_file(entry.path(), copy, fs::copy_options::overwrite_existing);
    else link(entry.path(), copy);
  }
}

Home copy(const Home& home, const Path& folder, const Path& other) {
  fs::remove_all(folder);
  std::vector<Path> roots;
  for (const Path& root : home.roots()) {
    roots.push_back(folder / std::to_string(roots.size()));
    fs::create_directories(roots.back());
    if (fs::exists(root / Home::kProjectFile))
      fs::copy_file(root / Home::kProjectFile, roots.back() / Home::kProjectFile);
    // An experiment's folder has its results as well.
    for (const std::string part : {"passes", "shaders", "scripts", "pipelines", "scenes", "captures", "experiments"})
      if (fs::is_directory(root / part)) copyFolder(root / part, roots.back() / part, part != "experiments");
    Path others = other / (root == home.shipped() ? "strobe" : "project");
    if (!other.empty() && fs::is_directory(others)) copyFolder(others, roots.back(), false);
  }
  return Home(roots, home.data(), home.program());
}

Home copied(const Home& home, const Path& folder, const Path& other) {
  try {
    return copy(home, folder, other);
  } catch (const fs::filesystem_error& error) {
    std::error_code ignored;
    fs::remove_all(folder, ignored);
    const Path& file = error.path2().empty() ? error.path1() : error.path2();
    throw WriteError(fmt::format("cannot be written: {}", error.code().message()), {file.string()});
  }
}

}  // namespace

FrozenHome::FrozenHome(const Home& home, const Path& folder, const Path& other)
    : original_(home), folder_(folder), home_(copied(home, folder, other)) {}

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
