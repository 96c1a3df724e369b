// SPDX-License-Identifier: MIT
// Table of the options of a shot. Command line, run record, command text, scene suggestions, experiment fields, window
// controls, identity and invalidation derive from it. A new option needs one row and its use.
#pragma once

#include <variant>

#include "lab/shot.h"
#include "scene/json_scene.h"

namespace strobe::lab {

// Part that a change of an option invalidates. `Motion`: the frame, and also the scene if options move its nodes.
enum class Concern { Frame, Motion, Plan, Scene, Device };

// Member of `Shot` that holds a value.
using View = std::optional<std::array<double, 6>>;
using ShotMember = std::variant<bool Shot::*, int Shot::*, uint32_t Shot::*, double Shot::*, std::string Shot::*,
                                View Shot::*, std::vector<std::string> Shot::*>;

// A value of an option: its declaration and its member of `Shot`. A choice without choices accepts any text.
struct ShotField {
  plan::ParamDesc declaration;  // default_value: used if neither the shot nor its scene sets a value
  ShotMember member;
  void (*check)(const std::string& text) = nullptr;  // throws `Error` (exit code 2) for an invalid text

  // True if the field is a single value, not a view or a list. `get` and `set` are valid only for such fields. `set`
  // throws `Error` for a wrong type or a value out of range.
  bool isValue() const;
  plan::Value get(const Shot& shot) const;
  void set(Shot& shot, const plan::Value& value) const;
  // True if unset: a number that still has the initial value of `Shot` below its range, or an empty view.
  bool isOpen(const Shot& shot) const;
};

// Option of a shot, one row of the option table: name, description, values, uses, and the part of the renderer that a
// change invalidates.
struct ShotOption {
  std::string name;  // with "_"; "-" on the command line
  std::string doc;
  Concern concern = Concern::Frame;
  std::vector<ShotField> fields;  // one field; two for `size`
  // Uses of an option, bits of `uses`.
  enum Use : uint32_t {
    kSuggested = 1,  // a scene may suggest it
    kSpelled = 2,    // the command contains it even with its default
    kControl = 4,    // the window has a control for it
    kNoPicture = 8,  // does not affect the picture; excluded from record, command and identity
  };
  uint32_t uses = 0;

  bool is(Use use) const { return uses & use; }
  bool isGiven(const Shot& shot) const;  // true if it differs from the default
};

const std::vector<ShotOption>& shotOptions();
std::string spelled(const ShotOption& option);              // "--rest-frame"
const ShotOption* findShotOption(const std::string& name);  // null if unknown

// Options that a scene may suggest, to parse its description.
std::vector<scene::Suggestion> suggestions();

// Value in the format of records and experiments: number, text, [width, height], six numbers, or list of texts.
Json jsonOf(const ShotOption& option, const Shot& shot);
// Sets an option. Throws `Error` (exit code 2) with option and range for an invalid value.
void setFromJson(const ShotOption& option, Shot& shot, const Json& value);

// Texts in the format of the command line: one text, any number for a list, empty for the default.
std::vector<std::string> textsOf(const ShotOption& option, const Shot& shot);
void setFromTexts(const ShotOption& option, Shot& shot, const std::vector<std::string>& texts);

// Table for scripts that name options (`native.known.shot_options`): { name, type, min, max, choices, doc }, `type` one
// of "bool", "number", "integer", "choice", "text", "size", "view", "texts".
Json shotOptionsJson();

// Text of a view: "ex,ey,ez,tx,ty,tz".
std::string viewText(const std::array<double, 6>& view);

// Parses "WxH", pixels, each 1 to 16384. Throws `Error` (exit code 2) with `option`.
std::array<int, 2> parseSize(const std::string& text, const std::string& option = "--size");

}  // namespace strobe::lab
