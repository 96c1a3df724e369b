// SPDX-License-Identifier: MIT
#include "live/capture_text.h"

#include <algorithm>
#include <set>

#include "live/shot_text.h"
#include "script/lua_text.h"

namespace strobe::live {

using script::field, script::quoted, script::tableOf;

std::string sceneKey(size_t files, const lab::Shot& shot) {
  return fmt::format("{}\n{}\n{}", files, shot.scene, lab::settingsIdentity(shot.sets, true));
}

namespace {

// Shots and arms of a script, each listed once, with the shots that each arm draws.
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
    std::string text = "-- Recorded in the window. Command of the first picture:\n-- " + lab::commandOf(first) +
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

  // Name of the entry with these fields; "STEM_2" if `stem` names another entry.
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
    for (const std::string& option : optionFields(shot, recorded_.suggested.at(sceneKey(moment.files, shot)), left_out))
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
    // A capture of a sequence keeps only the colour, unless `layers` lists more images.
    bool sequence = moment.first_frame < shot.frame;
    if (sequence && image != "color") fields.push_back(field("layers", tableOf({quoted(image)})));
    return fields;
  }

  // Changes of the moment as text: "samples = 8", "camera", ...
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
    // Captions use braces for placeholders.
    std::replace(caption.begin(), caption.end(), '{', '(');
    std::replace(caption.begin(), caption.end(), '}', ')');
    fields.push_back(field("caption", quoted(caption.empty() ? arm_name : arm_name + ": " + caption)));
    return "      " + tableOf(fields) + ",\n";
  }

  // Figure of the saved moments, or of all moments if no moment was saved.
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
  std::map<std::string, std::string> shot_names_, arm_names_;  // by stem and fields
  std::map<const lab::Shot*, std::pair<std::string, std::string>> pairs_;
  std::map<std::string, std::set<std::string>> drawn_by_;
};

}  // namespace

std::string captureText(const Recorded& recorded) { return Script(recorded).text(); }

}  // namespace strobe::live
