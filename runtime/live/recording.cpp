// SPDX-License-Identifier: MIT
#include "live/recording.h"

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <set>
#include <sstream>

#include "base/process.h"
#include "live/capture_text.h"
#include "live/shot_text.h"

namespace strobe::live {

namespace fs = std::filesystem;

// ---- drawn states

Recording::Recording(const Home& home, const Path& folder) : home_(home), folder_(folder) {
  for (const Path& root : home.roots())
    for (const char* part : FrozenHome::kParts) watch_.add(root / part);
}

namespace {

void addSide(Moment& moment, const Side& side) {
  moment.shots.push_back(side.session->shot());
  moment.shots.back().taps.clear();
  moment.images.push_back(side.drawn_port.empty() ? "color" : side.drawn_port);
}

// Sides that are displayed.
std::vector<const Side*> sidesShown(const Desk& desk) {
  const Look& look = desk.look();
  if (!desk.b()) return {&desk.sides().a()};
  if (look.mode != Mode::Single) return {&desk.sides().a(), desk.b()};
  return {look.single_b ? desk.b() : &desk.sides().a()};
}

// True if the last frame was drawn with the newest files.
bool isDrawn(const Side& side) { return !side.stale && side.problem.empty() && side.session->problems().empty(); }

}  // namespace

// Folder of one root in each version.
static std::vector<Path> rootsOf(const std::vector<std::unique_ptr<FrozenHome>>& versions, size_t root) {
  std::vector<Path> folders;
  for (const auto& version : versions) folders.push_back(version->home().roots()[root]);
  return folders;
}

// Names of the files that differ between versions, relative to the root.
static std::set<Path> edited(const std::vector<Path>& versions) {
  std::set<Path> all, differing;
  for (const Path& version : versions)
    for (const auto& entry : fs::recursive_directory_iterator(version))
      if (entry.is_regular_file()) all.insert(entry.path().lexically_relative(version));
  for (const Path& name : all) {
    auto content = [&](const Path& version) {
      return fs::exists(version / name) ? std::optional(readText(version / name)) : std::nullopt;
    };
    for (const Path& version : versions)
      if (content(version) != content(versions.front())) differing.insert(name);
  }
  return differing;
}

// A changed file begins a version as soon as the desk has read the scripts, even if the picture stays the same. A new
// file can be chosen from then on.
size_t Recording::version(const Desk& desk) {
  const bool swapped = desk.sides().swaps() != swaps_, read = changed_ && !desk.sides().evaluate();
  if (!swapped && !read) return versions_.size() - 1;
  swaps_ = desk.sides().swaps();
  changed_ = false;
  versions_.push_back(std::make_unique<FrozenHome>(home_, folder_ / std::to_string(versions_.size())));
  if (swapped || isNew()) return versions_.size() - 1;
  versions_.pop_back();
  return versions_.size() - 1;
}

// True if the last version differs from the previous one.
bool Recording::isNew() const {
  for (size_t root = 0; root < home_.roots().size(); ++root) {
    std::vector<Path> folders = rootsOf(versions_, root);
    if (!edited({folders[folders.size() - 2], folders.back()}).empty()) return true;
  }
  return false;
}

void Recording::look(const Desk& desk, bool goes_on) {
  Moment now;
  for (const Side* side : sidesShown(desk)) {
    if (!isDrawn(*side)) return;
    addSide(now, *side);
  }
  now.files = version(desk);
  now.goes_on = goes_on;
  moments_.add(std::move(now));
}

void Recording::markSaved(const Desk& desk) {
  Moment saved;
  addSide(saved, desk.sides().a());
  if (desk.b() && comparesWithB(desk.look().mode)) addSide(saved, *desk.b());
  saved.files = version(desk);
  moments_.add(std::move(saved));
  moments_.markSaved();
}

Recording::~Recording() {
  versions_.clear();
  std::error_code ignored;
  fs::remove(folder_, ignored);
}

void openInEditor(const Path& file) {
  const std::string line = R"(command -v "$1" >/dev/null && setsid "$@" </dev/null >/dev/null 2>&1 &)";
  std::vector<std::string> arguments = {"sh", "-c", line, "sh"};
  const char* editor = std::getenv("STROBE_EDITOR");
  std::istringstream words(editor ? editor : "");
  for (std::string word; words >> word;) arguments.push_back(word);
  if (arguments.size() == 4) arguments.push_back("xdg-open");
  arguments.push_back(file.string());
  run({.arguments = arguments});
}

// ---- writing

namespace {

// Name of a root, as in the inputs of a capture.
std::string rootName(const Home& home, size_t root) { return root + 1 == home.roots().size() ? "strobe" : "project"; }

}  // namespace

// Name of a scene or pipeline that is valid in every home, otherwise the absolute path.
static std::string portable(const Home& home, const std::string& file) {
  if (!fs::is_regular_file(file)) return file;
  Path path = fs::absolute(file).lexically_normal();
  std::string name = home.nameOf(path).value_or("");
  for (const std::string folder : {"scripts/scenes/", "scenes/", "scripts/pipelines/", "pipelines/"})
    if (name.starts_with(folder) && name.ends_with(".lua"))
      return name.substr(folder.size(), name.size() - folder.size() - 4);
  return path.string();
}

// Shot with the options that the scene suggests. Without suggestions if the scene no longer runs; the script then lists
// all options.
static lab::Shot suggestedIn(const Home& home, const lab::Shot& shot, const script::Limits& limits) {
  try {
    return suggestedShot(home, shot, limits);
  } catch (const Error&) {
    lab::Shot nothing;
    nothing.scene = shot.scene;
    return nothing;
  }
}

void Recording::write(const Path& script, const script::Limits& limits) const {
  if (script.extension() != ".lua") throw Error("the name of a capture script must end in .lua", {script.string()});
  if (moments_.all().empty()) throw Error("no picture was drawn during the recording");
  Recorded recorded{moments_.all(), {}, std::vector<std::string>(versions_.size())};
  for (Moment& moment : recorded.moments)
    for (lab::Shot& shot : moment.shots) {
      // Make the names valid from any folder.
      shot.scene = portable(home_, shot.scene), shot.pipeline = portable(home_, shot.pipeline);
      if (Path(shot.scene).is_absolute() && !home_.nameOf(shot.scene)) shot.allow_outside = true;
      const std::string key = sceneKey(moment.files, shot);
      if (!recorded.suggested.count(key))
        recorded.suggested[key] = suggestedIn(versions_[moment.files]->home(), shot, limits);
    }
  const Path folder = script.parent_path() / script.stem();
  for (size_t i = 0; i < versions_.size(); ++i) fs::remove_all(folder / fmt::format("files_{}", i + 1));
  std::vector<std::string> absent(versions_.size());
  auto place = [&](size_t i) {
    const std::string edit = fmt::format("files_{}", i + 1);
    recorded.folders[i] = (script.stem() / edit).generic_string();
    return folder / edit;
  };
  for (size_t root = 0; root < home_.roots().size(); ++root) {
    std::vector<Path> versions = rootsOf(versions_, root);
    for (const Path& file : edited(versions))
      for (size_t i = 0; i < versions.size(); ++i) {
        const Path name = rootName(home_, root) / file;
        if (fs::exists(versions[i] / file)) writeFileAtomically(place(i) / name, readText(versions[i] / file));
        else absent[i] += name.generic_string() + "\n";
      }
  }
  for (size_t i = 0; i < absent.size(); ++i)
    if (!absent[i].empty()) writeFileAtomically(place(i) / FrozenHome::kAbsent, absent[i]);
  writeFileAtomically(script, captureText(recorded));
}

}  // namespace strobe::live
