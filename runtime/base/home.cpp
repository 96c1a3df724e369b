// SPDX-License-Identifier: MIT
#include "base/home.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <fstream>
#include <memory>
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

Path cacheFolder() {
  if (const char* named = std::getenv("STROBE_CACHE")) return named;  // "": no cache
  if (std::optional<Path> shared = fromVariable("XDG_CACHE_HOME")) return *shared / "strobe";
  std::optional<Path> own = fromVariable("HOME");
  return own ? *own / ".cache/strobe" : Path();
}

bool isThere(const Path& path) {
  std::error_code ignored;
  return fs::exists(path, ignored);
}

bool isFolder(const Path& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

// Path with links followed. realpath takes a tenth of the time, but requires that the path exists.
Path real(const Path& path) {
  if (std::unique_ptr<char, decltype(&std::free)> whole(::realpath(path.c_str(), nullptr), &std::free); whole)
    return whole.get();
  std::error_code failed;
  Path found = fs::weakly_canonical(path, failed);
  return failed ? path : found;
}

// True if `file` lies below `folder`. Both paths are without links.
bool isBelow(const Path& file, const Path& folder) {
  Path relative = file.lexically_relative(folder);
  return !relative.empty() && *relative.begin() != "..";
}

// Folders of a project, by their names in the shipped folder.
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

// Number of the line "replaces = true" among the first comment lines of a file; 0 if the file has no such line.
int lineOfReplaces(const Path& file) {
  std::ifstream lines(file);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    std::erase_if(line, [](unsigned char c) { return std::isspace(c); });
    if (line == "--replaces=true" || line == "//replaces=true") return number;
    if (!line.empty() && !line.starts_with("--") && !line.starts_with("//")) break;
  }
  return 0;
}

// Project that contains a folder.
std::optional<Path> projectAround(Path folder) {
  for (;; folder = folder.parent_path()) {
    if (isThere(folder / Home::kProjectFile)) return folder;
    if (!folder.has_relative_path()) return std::nullopt;
  }
}

}  // namespace

bool liesIn(const Path& file, const Path& folder) { return isBelow(real(file), real(folder)); }

Path copyOf(const Home& home, const Path& file) {
  for (size_t i = 0; i < home.originals.size(); ++i) {
    Path copy = home.roots()[i] / file.lexically_relative(home.originals[i]);
    if (liesIn(file, home.originals[i]) && isThere(copy)) return copy;
  }
  return file;
}

Path Home::shippedWith(const Path& program) {
  Path installed = program.parent_path().parent_path() / "share/strobe", sources = STROBE_SOURCE_DIR;
  return isFolder(installed / "scripts") || !isFolder(sources) ? installed : sources;
}

Home::Home(const std::vector<Path>& roots, std::optional<Path> data, Path program, Path cache)
    : data_(std::move(data)), program_(std::move(program)), cache_(std::move(cache)) {
  STROBE_ASSERT(!roots.empty());
  for (const Path& root : roots) {
    roots_.push_back(fs::absolute(root).lexically_normal());
    real_roots_.push_back(real(roots_.back()));
  }
  if (!data_) data_ = shipped().parent_path() / "shared";
}

Home Home::fromEnvironment() {
  std::vector<Path> roots;
  std::error_code failed;
  Path here = fs::current_path(failed);
  if (std::optional<Path> project = failed ? std::nullopt : projectAround(here)) roots.push_back(*project);
  std::optional<Path> named = fromVariable("STROBE_HOME");
  roots.push_back(named ? *named : shippedWith(fs::read_symlink(kOwnProgram, failed)));
  return Home(roots, fromVariable("STROBE_DATA"), fromVariable("STROBE_PROGRAM").value_or(kOwnProgram), cacheFolder());
}

std::optional<Path> Home::data() const { return isFolder(*data_) ? data_ : std::nullopt; }

std::vector<Path> Home::places(const Path& name) const {
  Path normal = name.lexically_normal();
  std::vector<Path> places;
  if (normal.is_absolute() || normal.empty() || *normal.begin() == "..") return places;
  std::optional<Path> own = hasProject() ? inProject(normal) : std::nullopt;
  if (own) places.push_back(project() / *own);
  places.push_back(shipped() / normal);
  return places;
}

void Home::requireInside(const Path& file) const {
  Path found = real(file);
  bool inside = std::any_of(real_roots_.begin(), real_roots_.end(),
                            [&](const Path& root) { return found == root || isBelow(found, root); });
  if (!inside) throw Error("is a link that leads out of the searched folders", {shown(file)});
}

// Throws `Error` if a project's file has a shipped name without the declaration, or the declaration without a shipped
// name.
void Home::requireDeclared(const Path& own, const Path& shipped) const {
  int line = lineOfReplaces(own);
  bool replaces = isThere(shipped);
  const char* comment = own.extension() == ".lua" ? "--" : "//";
  if (replaces && !line)
    throw Error(fmt::format("has the name of a shipped file, {}; rename it, or begin it with the line '{} replaces = "
                            "true'",
                            this->shown(shipped), comment),
                {this->shown(own)});
  if (line && !replaces)
    throw Error(fmt::format("'replaces = true', but {} is not a shipped file", this->shown(shipped)),
                {this->shown(own), line});
}

std::optional<Path> Home::find(const Path& name) const {
  std::vector<Path> all = places(name);
  auto found = std::find_if(all.begin(), all.end(), isThere);
  if (found == all.end()) return std::nullopt;
  requireInside(*found);
  bool own = all.size() > 1 && found == all.begin();
  if (own && !isFolder(*found)) requireDeclared(*found, all.back());
  return *found;
}

// Skips links that lead out of the project: their readers report them.
std::vector<std::string> Home::mistakesOfProject() const {
  std::vector<std::string> mistakes;
  std::error_code ignored;
  for (const auto& [name, folder] : kProjectFolders) {
    if (!hasProject()) break;
    for (const auto& entry : fs::recursive_directory_iterator(project() / folder, ignored)) try {
        const Path& file = entry.path();
        bool is_read = file.extension() == ".lua" || file.extension() == ".glsl";
        if (is_read && liesIn(file, project())) find(Path(name) / file.lexically_relative(project() / folder));
      } catch (const Error& error) {
        mistakes.push_back(error.what());
      }
  }
  return mistakes;
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

// Union of the lists. `find` refuses a name in two lists without the declaration.
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

// Innermost root of a file. One root may lie in the other.
std::optional<size_t> Home::rootOf(const Path& file, const std::vector<Path>& roots) {
  std::optional<size_t> found;
  for (size_t i = 0; i < roots.size(); ++i)
    if (isBelow(file, roots[i]) && (!found || isBelow(roots[i], roots[*found]))) found = i;
  return found;
}

std::optional<std::string> Home::nameOf(const Path& file) const {
  std::optional<size_t> root = rootOf(file, roots_);
  return root ? std::optional<std::string>(file.lexically_relative(roots_[*root]).string()) : std::nullopt;
}

// Name with the prefix of its root, except for the root `bare`.
std::optional<std::string> Home::named(const Path& file, std::optional<size_t> bare) const {
  Path path = fs::absolute(file).lexically_normal();
  const std::vector<Path>* roots = &roots_;
  std::optional<size_t> root = rootOf(path, roots_);
  if (!root) roots = &real_roots_, path = real(path), root = rootOf(path, real_roots_);
  if (!root) return std::nullopt;
  std::string prefix = root == bare ? "" : *root + 1 == roots_.size() ? kShippedPrefix : kProjectPrefix;
  return prefix + path.lexically_relative((*roots)[*root]).string();
}

std::string Home::recorded(const Path& file, const std::string& outside) const {
  if (std::optional<std::string> name = named(file, std::nullopt)) return *name;
  std::optional<Path> shared = data();
  if (!shared || !liesIn(file, *shared)) return outside;
  return kSharedPrefix + real(file).lexically_relative(real(*shared)).string();
}

std::string Home::shown(const Path& file) const { return named(file, 0).value_or(file.string()); }

Path Home::fileShown(const std::string& name) const {
  bool shipped = name.starts_with(kShippedPrefix);
  return shipped ? this->shipped() / withoutRoot(name) : roots_.front() / name;
}

std::string Home::withoutRoot(const std::string& name) {
  return name.starts_with(kShippedPrefix) ? name.substr(std::string_view(kShippedPrefix).size()) : name;
}

std::string Home::read(const Path& file) const {
  try {
    return readText(file);
  } catch (const Error& error) {
    throw Error(error.message(), {shown(file)});
  }
}

std::string placesText(const Home& home, const Path& folder) {
  std::vector<std::string> texts;
  for (const Path& place : home.places(folder)) texts.push_back(place.string());
  return fmt::format("{}", fmt::join(texts, " or "));
}

}  // namespace strobe
