// SPDX-License-Identifier: MIT
// The options of a shot as one table. Command line, run record, command text, a scene's suggestion, an experiment's
// fields, the window's controls, identity and what a change makes anew are derived from it: adding an option is one row
// and its use.
#pragma once

#include <variant>

#include "lab/shot.h"
#include "scene/json_scene.h"

namespace strobe::lab {

// What a change of an option makes anew. `Motion`: the frame, and the scene where options move its nodes.
enum class Concern { Frame, Motion, Plan, Scene, Device };

// Where a value stands in a shot.
using View = std::optional<std::array<double, 6>>;
using ShotMember = std::variant<bool Shot::*, int Shot::*, uint32_t Shot::*, double Shot::*, std::string Shot::*,
                                View Shot::*, std::vector<std::string> Shot::*>;

// A value of an option: what it is, and where it stands. A choice without choices takes any text.
struct ShotField {
  plan::ParamDesc declaration;  // default_value: what holds where neither the shot nor its scene says one
  ShotMember member;
  void (*check)(const std::string& text) = nullptr;  // of a text: throws `Error` (exit code 2) for a wrong one

  // Of numbers, choices and texts alone: as a value. `set` throws `Error` for another type or one out of range.
  bool isValue() const;
  plan::Value get(const Shot& shot) const;
  void set(Shot& shot, const plan::Value& value) const;
  // A number outside of its range, or a view that is not given.
  bool isOpen(const Shot& shot) const;
};

struct ShotOption {
  std::string name;  // with "_"; the command line writes "-"
  std::string doc;
  Concern concern = Concern::Frame;
  std::vector<ShotField> fields;  // one; of `size` two
  // What it takes part in.
  enum Use : uint32_t {
    kSuggested = 1,  // a scene may say it
    kSpelled = 2,    // the command has it even where it is the default
    kControl = 4,    // the window has controls for it
    kNoPicture = 8,  // decides no picture: no part of record, command and identity
  };
  uint32_t uses = 0;

  bool is(Use use) const { return uses & use; }
  bool isGiven(const Shot& shot) const;  // differs from what a shot is without it
};

const std::vector<ShotOption>& shotOptions();
std::string spelled(const ShotOption& option);              // "--rest-frame"
const ShotOption* findShotOption(const std::string& name);  // or null

// What a scene may suggest, for reading its description.
std::vector<scene::Suggestion> suggestions();

// The value as a record and an experiment have it: a number, a text, [width, height], six numbers, a list of texts.
Json jsonOf(const ShotOption& option, const Shot& shot);
// Throws `Error` (exit code 2) naming option and range.
void setFromJson(const ShotOption& option, Shot& shot, const Json& value);

// As on the command line: one text, of lists any number, none where the value is the default.
std::vector<std::string> textsOf(const ShotOption& option, const Shot& shot);
void setFromTexts(const ShotOption& option, Shot& shot, const std::vector<std::string>& texts);

// The table for scripts that name options (`native.known.shot_options`): { name, type, min, max, choices, doc }, `type`
// one of "bool", "number", "integer", "choice", "text", "size", "view", "texts".
Json shotOptionsJson();

// "ex,ey,ez,tx,ty,tz".
std::string viewText(const std::array<double, 6>& view);

// "WxH" in pixels, each 1 to 16384.
std::array<int, 2> parseSize(const std::string& text, const std::string& option = "--size");

}  // namespace strobe::lab
