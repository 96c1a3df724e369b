// SPDX-License-Identifier: MIT
#include "base/frozen_home.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <sstream>

#include "base/error.h"
#include "base/files.h"

namespace strobe {

namespace fs = std::filesystem;

namespace {

const std::set<std::string> kTexts = {".lua", ".glsl", ".h"};
const std::vector<std::string> kData = {".glb", ".gltf", ".bin", ".png", ".jpg", ".jpeg"};

// Hard link, or a copy if the file system cannot link.
void link(const Path& from, const Path& to) {
  std::error_code failed;
  fs::create_hard_link(from, to, failed);
  if (failed) fs::copy_file(from, to);
}

// Copies recursively, without hidden folders.
void copyFolder(const Path& from, const Path& to, bool with_data) {
  for (auto entries = fs::recursive_directory_iterator(from); entries != fs::end(entries); ++entries) {
    const fs::directory_entry& entry = *entries;
    if (entry.is_directory() && entry.path().filename().string().starts_with(".")) entries.disable_recursion_pending();
    bool is_text = kTexts.count(entry.path().extension()) || entry.path().filename() == FrozenHome::kAbsent;
    bool is_data = with_data && std::any_of(kData.begin(), kData.end(), [&](const std::string& extension) {
                     return hasExtension(entry.path().string(), extension);
                   });
    if (!entry.is_regular_file() || (!is_text && !is_data)) continue;
    Path copy = to / entry.path().lexically_relative(from);
    fs::create_directories(copy.parent_path());
    if (is_text) fs::copy_file(entry.path(), copy, fs::copy_options::overwrite_existing);
    else link(entry.path(), copy);
  }
}

std::string rootName(const Home& home, const Path& root) { return root == home.shipped() ? "strobe" : "project"; }

// Removes the files named in a list from the copies of the roots.
void leaveOut(const Home& home, const std::vector<Path>& copies, const Path& list) {
  std::istringstream lines(readText(list));
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    const Path name = Path(line).lexically_normal();
    if (name.empty()) continue;
    const std::string first = name.begin()->string();
    if ((first != "strobe" && first != "project") || std::next(name.begin()) == name.end())
      throw Error(fmt::format("'{}' must begin with strobe/ or project/", line), {list.string(), number});
    for (size_t i = 0; i < copies.size(); ++i)
      if (rootName(home, home.roots()[i]) == first) fs::remove(copies[i] / name.lexically_relative(first));
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
    // No data from experiments: the folder also holds results.
    for (const std::string part : FrozenHome::kParts)
      if (fs::is_directory(root / part)) copyFolder(root / part, roots.back() / part, part != "experiments");
    Path others = other / rootName(home, root);
    if (!other.empty() && fs::is_directory(others)) copyFolder(others, roots.back(), false);
  }
  if (!other.empty() && fs::exists(other / FrozenHome::kAbsent)) leaveOut(home, roots, other / FrozenHome::kAbsent);
  Home result(home, roots, home.data());
  if (other.empty()) result.originals = home.roots();
  return result;
}

Home copied(const Home& home, const Path& folder, const Path& other) {
  try {
    return copy(home, folder, other);
  } catch (const Error&) {
    std::error_code ignored;
    fs::remove_all(folder, ignored);
    throw;
  } catch (const fs::filesystem_error& error) {
    std::error_code ignored;
    fs::remove_all(folder, ignored);
    const Path& file = error.path2().empty() ? error.path1() : error.path2();
    throw WriteError(fmt::format("cannot be written: {}", error.code().message()), {file.string()});
  }
}

}  // namespace

FrozenHome::FrozenHome(const Home& home, const Path& folder, const Path& other)
    : folder_(folder), home_(copied(home, folder, other)) {}

FrozenHome::~FrozenHome() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

std::string FrozenHome::at(const std::string& file) const {
  const Path original = fs::absolute(file).lexically_normal(), copy = copyOf(home_, original);
  return copy == original ? file : copy.string();
}

}  // namespace strobe
