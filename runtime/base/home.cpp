// SPDX-License-Identifier: MIT
#include "base/home.h"

#include <algorithm>
#include <cstdlib>
#include <regex>
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

Path real(const Path& path) {
  std::error_code failed;
  Path found = fs::weakly_canonical(path, failed);
  return failed ? path : found;
}

// Both without links.
bool isBelow(const Path& file, const Path& folder) {
  Path relative = file.lexically_relative(folder);
  return !relative.empty() && *relative.begin() != "..";
}

// What a project has, by the name of it in the shipped folder.
constexpr std::pair<const char*, const char*> kProjectFolders[] = {
    {"passes", "passes"},         {"shaders", "shaders"},           {"scripts/pipelines", "pipelines"},
    {"scripts/scenes", "scenes"}, {"scripts/captures", "captures"}, {"experiments", "experiments"}};

std::optional<Path> inProject(const Path& name) {
  for (const auto& [shipped, own] : kProjectFolders) {
    Path rest = name.lexically_relative(shipped);
    if (rest == ".") return own;
    if (!rest.empty() && *rest.begin() != "..") return own / rest;
  }
  return std::nullopt;
}

// "replaces = true" at the beginning of a line, behind "--" or "//" or not.
bool declaresReplaces(const Path& file) {
  static const std::regex declared("(^|\n)[ \t]*(--|//)?[ \t]*replaces[ \t]*=[ \t]*true\\b");
  return std::regex_search(readText(file), declared);
}

// The project that a folder lies in.
std::optional<Path> projectAround(Path folder) {
  for (;; folder = folder.parent_path()) {
    if (isThere(folder / Home::kProjectFile)) return folder;
    if (!folder.has_relative_path()) return std::nullopt;
  }
}

}  // namespace

bool liesIn(const Path& file, const Path& folder) { return isBelow(real(file), real(folder)); }

Path Home::ownProgram() { return "/proc/self/exe"; }

Path Home::shippedWith(const Path& program) {
  Path installed = program.parent_path().parent_path() / "share/strobe", sources = STROBE_SOURCE_DIR;
  return isFolder(installed / "scripts") || !isFolder(sources) ? installed : sources;
}

Home::Home(const std::vector<Path>& roots, std::optional<Path> data, Path program)
    : data_(std::move(data)), program_(std::move(program)) {
  STROBE_ASSERT(!roots.empty());
  for (const Path& root : roots) {
    roots_.push_back(fs::absolute(root).lexically_normal());
    real_roots_.push_back(real(roots_.back()));
    is_project_.push_back(isThere(roots_.back() / kProjectFile));
  }
  is_project_.back() = false;
  if (!data_) data_ = shipped().parent_path() / "shared";
}

Home Home::fromEnvironment() {
  std::vector<Path> roots;
  std::error_code failed;
  Path here = fs::current_path(failed);
  if (std::optional<Path> project = failed ? std::nullopt : projectAround(here)) roots.push_back(*project);
  std::optional<Path> named = fromVariable("STROBE_HOME");
  roots.push_back(named ? *named : shippedWith(fs::read_symlink(ownProgram(), failed)));
  return Home(roots, fromVariable("STROBE_DATA"), fromVariable("STROBE_PROGRAM").value_or(ownProgram()));
}

std::optional<Path> Home::data() const { return isFolder(*data_) ? data_ : std::nullopt; }

std::optional<Path> Home::placeIn(size_t root, const Path& name) const {
  if (!is_project_[root]) return roots_[root] / name;
  std::optional<Path> own = inProject(name);
  return own ? std::optional<Path>(roots_[root] / *own) : std::nullopt;
}

std::vector<Path> Home::places(const Path& name) const {
  Path normal = name.lexically_normal();
  std::vector<Path> places;
  if (normal.is_absolute() || normal.empty() || *normal.begin() == "..") return places;
  for (size_t root = 0; root < roots_.size(); ++root)
    if (std::optional<Path> place = placeIn(root, normal)) places.push_back(*place);
  return places;
}

void Home::requireInside(const Path& file) const {
  Path found = real(file);
  bool inside = std::any_of(real_roots_.begin(), real_roots_.end(),
                            [&](const Path& root) { return found == root || isBelow(found, root); });
  if (!inside) throw Error("is a link that leads out of the folders in which files are looked for", {shown(file)});
}

std::optional<Path> Home::find(const Path& name) const {
  std::vector<Path> found;
  for (const Path& place : places(name))
    if (isThere(place)) found.push_back(place);
  if (found.empty()) return std::nullopt;
  requireInside(found.front());
  if (found.size() > 1 && !isFolder(found.front()) && !declaresReplaces(found.front()))
    throw Error(fmt::format("has the name of a shipped file, {}; give it another, or say 'replaces = true' in it",
                            found.back().string()),
                {found.front().string()});
  return found.front();
}

Path Home::at(const Path& name) const { return find(name).value_or(shipped() / name); }

std::vector<Path> Home::folders(const Path& name) const {
  std::vector<Path> found;
  for (const Path& place : places(name)) {
    if (!isFolder(place)) continue;
    requireInside(place);
    found.push_back(place);
  }
  return found;
}

// A name in two lists is looked for, which finds out whether it may be.
std::vector<std::string> Home::joined(const Path& folder, std::string_view extension,
                                      const std::vector<std::vector<std::string>>& lists) const {
  std::set<std::string> names;
  for (const auto& list : lists)
    for (const std::string& name : list)
      if (!names.insert(name).second) find(folder / (name + std::string(extension)));
  return {names.begin(), names.end()};
}

std::vector<std::string> Home::namesIn(const Path& folder, std::string_view extension) const {
  std::vector<std::vector<std::string>> lists;
  for (const Path& one : folders(folder)) lists.push_back(strobe::namesIn(one, extension));
  return joined(folder, extension, lists);
}

std::vector<std::string> Home::namesBelow(const Path& folder, std::string_view extension) const {
  std::vector<std::vector<std::string>> lists;
  std::error_code ignored;
  for (const Path& one : folders(folder)) {
    lists.emplace_back();
    for (const auto& entry : fs::recursive_directory_iterator(one, ignored))
      if (entry.path().extension() == extension && entry.is_regular_file(ignored))
        lists.back().push_back(entry.path().lexically_relative(one).replace_extension());
  }
  return joined(folder, extension, lists);
}

std::optional<std::string> Home::nameOf(const Path& file) const {
  for (const Path& root : roots_)
    if (isBelow(file, root)) return file.lexically_relative(root).string();
  return std::nullopt;
}

std::string Home::shown(const Path& file) const {
  Path found = real(fs::absolute(file));
  for (const Path& root : real_roots_)
    if (isBelow(found, root)) return found.lexically_relative(root).string();
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
