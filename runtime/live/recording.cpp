// SPDX-License-Identifier: MIT
#include "live/recording.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <set>

#include "base/process.h"
#include "live/shot_text.h"
#include "script/lua_text.h"

namespace strobe::live {

namespace fs = std::filesystem;
using script::field, script::quoted, script::tableOf;

// ---- moments

namespace {

std::map<std::string, plan::Value> settingsOf(const lab::Shot& shot) {
  std::map<std::string, plan::Value> last;
  for (const auto& [name, value] : shot.sets) last[name] = value;
  return last;
}

// Names of options and settings that two shots have differently.
std::set<std::string> differences(const lab::Shot& one, const lab::Shot& other) {
  std::set<std::string> names;
  for (const lab::ShotOption& option : lab::shotOptions())
    if (!option.is(lab::ShotOption::kNoPicture) && lab::jsonOf(option, one) != lab::jsonOf(option, other))
      names.insert(option.name);
  if (one.pipeline != other.pipeline) names.insert("pipeline");
  auto values = settingsOf(one), others = settingsOf(other);
  for (const auto* side : {&values, &others})
    for (const auto& [name, value] : *side) {
      auto a = values.find(name), b = others.find(name);
      if (a == values.end() || b == others.end() || a->second != b->second) names.insert(name);
    }
  return names;
}

std::vector<std::string> differences(const Moment& before, const Moment& now) {
  std::set<std::string> names;
  if (before.shots.size() != now.shots.size()) names.insert("comparison");
  for (size_t i = 0; i < std::min(before.shots.size(), now.shots.size()); ++i)
    names.merge(differences(before.shots[i], now.shots[i]));
  if (before.images != now.images) names.insert("image");
  if (before.files != now.files) names.insert("files");
  return {names.begin(), names.end()};
}

bool isOnly(const Moment& moment, const char* what) { return moment.changed == std::vector<std::string>{what}; }

int frameOf(const Moment& moment) { return moment.shots.front().frame; }

}  // namespace

void Moments::add(Moment now) {
  now.first_frame = frameOf(now);
  if (all_.empty()) return all_.push_back(std::move(now));
  Moment& last = all_.back();
  now.changed = differences(last, now);
  if (now.changed.empty()) {
    last.goes_on = last.goes_on && now.goes_on;
    return;
  }
  if (isOnly(now, "frame") && !last.saved) {
    // Played on by a frame, or anew.
    bool next = frameOf(now) == frameOf(last) + 1;
    if (now.goes_on && frameOf(now) >= last.first_frame && frameOf(now) < frameOf(last)) return;
    if (next && (last.changed.empty() || isOnly(last, "frame") || last.first_frame < frameOf(last))) {
      last.shots = std::move(now.shots);
      return;
    }
  }
  bool drags = now.goes_on && last.goes_on && last.first_frame == frameOf(last);
  bool flies = isOnly(now, "view") || isOnly(now, "image");
  if (!last.saved && all_.size() > 1 && now.changed == last.changed && (drags || flies)) {
    now.changed = differences(all_[all_.size() - 2], now);
    if (now.changed.empty()) return all_.pop_back();
    last = std::move(now);
    return;
  }
  all_.push_back(std::move(now));
}

void Moments::markSaved() {
  if (!all_.empty()) all_.back().saved = true;
}

// ---- what the desk has drawn

Recording::Recording(const Home& home, const Path& folder) : home_(home), folder_(folder) {}

namespace {

void addSide(Moment& moment, const Side& side) {
  moment.shots.push_back(side.session->shot());
  moment.shots.back().taps.clear();
  moment.images.push_back(side.drawn_port.empty() ? "color" : side.drawn_port);
}

// Every side that is looked at.
std::vector<const Side*> sidesShown(const Desk& desk) {
  const Look& look = desk.look();
  if (!desk.b()) return {&desk.sides().a()};
  if (look.mode != Mode::Single) return {&desk.sides().a(), desk.b()};
  return {look.single_b ? desk.b() : &desk.sides().a()};
}

// The newest files run, and the last frame is drawn with them.
bool isDrawn(const Side& side) { return !side.stale && side.problem.empty() && side.session->problems().empty(); }

}  // namespace

size_t Recording::version(const Desk& desk) {
  if (desk.sides().swaps() != swaps_) {
    swaps_ = desk.sides().swaps();
    versions_.push_back(std::make_unique<FrozenHome>(home_, folder_ / std::to_string(versions_.size())));
  }
  return versions_.size() - 1;
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
  const char* editor = std::getenv("STROBE_EDITOR");
  const std::string line = R"(command -v "$0" >/dev/null && setsid "$0" "$1" </dev/null >/dev/null 2>&1 &)";
  run({.arguments = {"sh", "-c", line, editor ? editor : "xdg-open", file.string()}});
}

// ---- as a file

namespace {

// As inputs of a capture are named.
std::string rootName(const Home& home, size_t root) { return root + 1 == home.roots().size() ? "strobe" : "project"; }

// Names of the files that are not the same in all versions, below a root.
std::set<Path> edited(const std::vector<Path>& versions) {
  std::set<Path> all, differing;
  for (const Path& version : versions)
    for (const auto& entry : fs::recursive_directory_iterator(version))
      if (entry.is_regular_file()) all.insert(entry.path().lexically_relative(version));
  for (const Path& name : all) {
    auto content = [&](const Path& version) { return fs::exists(version / name) ? readText(version / name) : ""; };
    for (const Path& version : versions)
      if (content(version) != content(versions.front())) differing.insert(name);
  }
  return differing;
}

}  // namespace

std::string sceneKey(const lab::Shot& shot) { return shot.scene + "\n" + lab::settingsIdentity(shot.sets, true); }

// The name by which any home has a file of a root, else its absolute path.
static std::string portable(const Home& home, const std::string& file) {
  if (!fs::is_regular_file(file)) return file;
  Path path = fs::absolute(file).lexically_normal();
  std::string name = home.nameOf(path).value_or("");
  for (const std::string folder : {"scripts/scenes/", "scenes/", "scripts/pipelines/", "pipelines/"})
    if (name.starts_with(folder) && name.ends_with(".lua"))
      return name.substr(folder.size(), name.size() - folder.size() - 4);
  return path.string();
}

void Recording::write(lab::Workbench& bench, const Path& script) const {
  if (script.extension() != ".lua") throw Error("a capture script's name ends in .lua", {script.string()});
  if (moments_.all().empty()) throw Error("nothing was drawn while it was recorded");
  Recorded recorded{moments_.all(), {}, std::vector<std::string>(versions_.size())};
  for (Moment& moment : recorded.moments)
    for (lab::Shot& shot : moment.shots) {
      // From elsewhere it has to be found as well.
      shot.scene = portable(home_, shot.scene), shot.pipeline = portable(home_, shot.pipeline);
      if (Path(shot.scene).is_absolute() && !home_.nameOf(shot.scene)) shot.allow_outside = true;
      if (!recorded.suggested.count(sceneKey(shot))) recorded.suggested[sceneKey(shot)] = suggestedShot(bench, shot);
    }
  const Path folder = script.parent_path() / script.stem();
  for (size_t i = 0; i < versions_.size(); ++i) fs::remove_all(folder / fmt::format("files_{}", i + 1));
  for (size_t root = 0; root < home_.roots().size(); ++root) {
    std::vector<Path> versions;
    for (const auto& version : versions_) versions.push_back(version->home().roots()[root]);
    for (const Path& name : edited(versions))
      for (size_t i = 0; i < versions.size(); ++i) {
        if (!fs::exists(versions[i] / name)) continue;
        const std::string edit = fmt::format("files_{}", i + 1);
        writeFileAtomically(folder / edit / rootName(home_, root) / name, readText(versions[i] / name));
        recorded.folders[i] = (script.stem() / edit).generic_string();
      }
  }
  writeFileAtomically(script, captureText(recorded));
}

namespace {

// Shots and arms of a script, each once, with the moments that show them.
class Script {
 public:
  explicit Script(const Recorded& recorded) : recorded_(recorded) {
    for (const Moment& moment : recorded.moments)
      for (size_t i = 0; i < moment.shots.size(); ++i) {
        const lab::Shot& shot = moment.shots[i];
        std::string shot_name = nameOf(shot_names_, shots_, "view", shotFields(moment, shot));
        std::string arm_name =
            nameOf(arm_names_, arms_, Path(shot.pipeline).stem().string(), armFields(moment, shot, imageOf(moment, i)));
        pairs_[&shot] = {shot_name, arm_name};
        drawn_by_[arm_name].insert(shot_name);
      }
  }

  std::string text() const {
    const lab::Shot& first = recorded_.moments.front().shots.front();
    std::string text = "-- Recorded in the window. It began with:\n-- " + lab::commandOf(first) +
                       "\nlocal capture = require \"strobe.capture\"\n\nreturn capture {\n";
    text += fmt::format("  title = {},\n", quoted("recorded: " + Path(first.scene).stem().string()));
    text += fmt::format("  size = {{ {}, {} }},\n  shots = {{\n", first.width, first.height);
    for (const auto& [name, fields] : shots_)
      text += fmt::format("    {{ name = {}, {} }},\n", quoted(name), fmt::join(fields, ", "));
    text += "  },\n  arms = {\n";
    for (const auto& [name, fields] : arms_) {
      std::vector<std::string> shots;
      for (const std::string& shot : drawn_by_.at(name)) shots.push_back(quoted(shot));
      text += fmt::format("    {{ name = {}, {}, {} }},\n", quoted(name), fmt::join(fields, ", "),
                          field("shots", tableOf(shots)));
    }
    return text + "  },\n" + figureText() + "}\n";
  }

 private:
  using Entry = std::pair<std::string, std::vector<std::string>>;

  // Of what has these fields; "NAME_2" where another of the name has others.
  static std::string nameOf(std::map<std::string, std::string>& known, std::vector<Entry>& entries,
                            const std::string& stem, std::vector<std::string> fields) {
    std::string& name = known[stem + "\n" + fmt::format("{}", fmt::join(fields, "\n"))];
    if (!name.empty()) return name;
    auto taken = [&](const std::string& one) {
      return std::any_of(entries.begin(), entries.end(), [&](const Entry& entry) { return entry.first == one; });
    };
    name = stem;
    for (int i = 2; taken(name); ++i) name = fmt::format("{}_{}", stem, i);
    entries.emplace_back(name, std::move(fields));
    return name;
  }

  std::vector<std::string> shotFields(const Moment& moment, const lab::Shot& shot) const {
    const lab::Shot& first = recorded_.moments.front().shots.front();
    bool sequence = moment.first_frame < shot.frame;
    std::vector<std::string> fields = {field("scene", quoted(shot.scene))};
    if (shot.width != first.width || shot.height != first.height)
      fields.push_back(fmt::format("size = {{ {}, {} }}", shot.width, shot.height));
    if (sequence) fields.push_back(fmt::format("frames = {{ {}, {}, 1 }}", moment.first_frame, shot.frame));
    auto left_out = [&](const std::string& name) { return sequence && name == "frame"; };
    for (const std::string& option : optionFields(shot, recorded_.suggested.at(sceneKey(shot)), left_out))
      fields.push_back(option);
    for (const std::string& set : settingFields(shot.sets, true, {})) fields.push_back(set);
    return fields;
  }

  static std::string imageOf(const Moment& moment, size_t i) {
    return i < moment.images.size() ? moment.images[i] : "color";
  }

  std::vector<std::string> armFields(const Moment& moment, const lab::Shot& shot, const std::string& image) const {
    std::vector<std::string> fields = {field("pipeline", quoted(shot.pipeline))};
    std::vector<std::string> sets = settingFields(shot.sets, false, {});
    if (!sets.empty()) fields.push_back(field("set", tableOf(sets)));
    const std::string& folder = recorded_.folders[moment.files];
    if (!folder.empty()) fields.push_back(field("files", quoted(folder)));
    // Of a sequence the colour alone is kept, unless more is asked for.
    bool sequence = moment.first_frame < shot.frame;
    if (sequence && image != "color") fields.push_back(field("layers", tableOf({quoted(image)})));
    return fields;
  }

  // "samples = 8", "camera", ...: what was changed.
  static std::string captionOf(const Moment& moment, const lab::Shot& shot) {
    std::vector<std::string> parts;
    std::map<std::string, plan::Value> settings = settingsOf(shot);
    for (const std::string& name : moment.changed) {
      const lab::ShotOption* option = lab::findShotOption(name);
      auto set = settings.find(name);
      bool is_value = option && option->fields.size() == 1 && option->fields[0].isValue();
      if (name == "view") parts.push_back("camera");
      else if (name == "files") parts.push_back("files edited");
      else if (set != settings.end()) parts.push_back(name + " = " + lab::plainText(set->second));
      else if (is_value) parts.push_back(name + " = " + lab::plainText(option->fields[0].get(shot)));
      else if (option) parts.push_back(name);
    }
    return fmt::format("{}", fmt::join(parts, ", "));
  }

  std::string cellText(const Moment& moment, size_t i, int row, int column) const {
    const lab::Shot& shot = moment.shots[i];
    const std::string image = imageOf(moment, i);
    const auto& [shot_name, arm_name] = pairs_.at(&shot);
    std::vector<std::string> fields = {fmt::format("row = {}, column = {}", row, column),
                                       field("shot", quoted(shot_name)), field("arm", quoted(arm_name))};
    if (shot.frame > moment.first_frame) fields.push_back(fmt::format("step = {}", shot.frame - moment.first_frame));
    if (image != "color") fields.push_back(field("view", quoted(image)));
    std::string caption = captionOf(moment, shot);
    // What stands in braces would be filled in.
    std::replace(caption.begin(), caption.end(), '{', '(');
    std::replace(caption.begin(), caption.end(), '}', ')');
    fields.push_back(field("caption", quoted(caption.empty() ? arm_name : arm_name + ": " + caption)));
    return "      " + tableOf(fields) + ",\n";
  }

  // The moments that were saved, else all of them.
  std::string figureText() const {
    bool any_saved =
        std::any_of(recorded_.moments.begin(), recorded_.moments.end(), [](const Moment& one) { return one.saved; });
    std::string cells;
    int count = 0;
    constexpr int kColumns = 3;
    for (const Moment& moment : recorded_.moments)
      for (size_t i = 0; i < moment.shots.size(); ++i) {
        if (any_saved && !moment.saved) continue;
        cells += cellText(moment, i, count / kColumns + 1, count % kColumns + 1);
        ++count;
      }
    const int columns = std::min(count, kColumns), rows = (count + kColumns - 1) / kColumns;
    for (int i = count; i < rows * columns; ++i)
      cells += fmt::format("      {{ row = {}, column = {}, empty = true }},\n", i / columns + 1, i % columns + 1);
    auto lines = [](int number) {
      std::string text;
      for (int i = 0; i < number; ++i) text += i ? ", { label = \"\" }" : "{ label = \"\" }";
      return "{ " + text + " }";
    };
    return fmt::format(
        "  figures = {{ {{ name = \"recorded\", border = 1, columns = {}, rows = {},\n    cells = {{\n{}    }} }} "
        "}},\n",
        lines(columns), lines(rows), cells);
  }

  const Recorded& recorded_;
  std::vector<Entry> shots_, arms_;
  std::map<std::string, std::string> shot_names_, arm_names_;  // by the fields
  std::map<const lab::Shot*, std::pair<std::string, std::string>> pairs_;
  std::map<std::string, std::set<std::string>> drawn_by_;
};

}  // namespace

std::string captureText(const Recorded& recorded) { return Script(recorded).text(); }

}  // namespace strobe::live
