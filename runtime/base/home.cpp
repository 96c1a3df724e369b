// SPDX-License-Identifier: MIT
#include "base/home.h"

#include <algorithm>
#include <cstdlib>
#include <set>

#include "base/error.h"

namespace strobe {

namespace fs = std::filesystem;

namespace {

std::optional<Path> fromVariable(const char* name) {
  const char* value = std::getenv(name);
  if (!value || !*value) return std::nullopt;
  return Path(value);
}

bool isThere(const Path& path) {
  std::error_code ignored;
  return fs::exists(path, ignored);
}

bool isFolder(const Path& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

}  // namespace

Path Home::ownProgram() { return "/proc/self/exe"; }

Home::Home(const std::vector<Path>& roots, std::optional<Path> data, Path program)
    : data_(std::move(data)), program_(std::move(program)) {
  for (const Path& root : roots) roots_.push_back(fs::absolute(root).lexically_normal());
  STROBE_ASSERT(!roots_.empty());
  if (!data_) data_ = shipped().parent_path() / "shared";
}

Home Home::fromEnvironment() {
  return Home({fromVariable("STROBE_HOME").value_or(STROBE_SOURCE_DIR)}, fromVariable("STROBE_DATA"),
              fromVariable("STROBE_PROGRAM").value_or(ownProgram()));
}

std::optional<Path> Home::data() const { return isFolder(*data_) ? data_ : std::nullopt; }

std::optional<Path> Home::find(const Path& name) const {
  for (const Path& root : roots_)
    if (isThere(root / name)) return root / name;
  return std::nullopt;
}

Path Home::at(const Path& name) const { return find(name).value_or(shipped() / name); }

std::vector<Path> Home::folders(const Path& name) const {
  std::vector<Path> found;
  for (const Path& root : roots_)
    if (isFolder(root / name)) found.push_back(root / name);
  return found;
}

std::vector<std::string> Home::namesIn(const Path& folder, std::string_view extension) const {
  std::set<std::string> names;
  for (const Path& one : folders(folder))
    for (std::string& name : strobe::namesIn(one, extension)) names.insert(std::move(name));
  return {names.begin(), names.end()};
}

std::vector<std::string> Home::namesBelow(const Path& folder, std::string_view extension) const {
  std::set<std::string> names;
  std::error_code ignored;
  for (const Path& one : folders(folder))
    for (const auto& entry : fs::recursive_directory_iterator(one, ignored))
      if (entry.path().extension() == extension && entry.is_regular_file(ignored))
        names.insert(entry.path().lexically_relative(one).replace_extension());
  return {names.begin(), names.end()};
}

std::optional<std::string> Home::nameOf(const Path& file) const {
  for (const Path& root : roots_) {
    Path relative = file.lexically_relative(root);
    if (!relative.empty() && *relative.begin() != "..") return relative.string();
  }
  return std::nullopt;
}

std::string Home::shown(const Path& file) const {
  for (const Path& root : roots_) {
    std::error_code failed;
    Path relative = fs::relative(file, root, failed);
    if (!failed && !relative.empty() && *relative.begin() != "..") return relative.string();
  }
  return file.string();
}

std::string Home::read(const Path& file) const {
  try {
    return readText(file);
  } catch (const Error& error) {
    throw Error(error.message(), {shown(file)});
  }
}

}  // namespace strobe
