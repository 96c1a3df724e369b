// SPDX-License-Identifier: MIT
// Cases at the limits of numbers, tiles, cameras and scenes, for every pipeline of the registry and each of its
// presets. The expected result comes from a closed form, from truth, or from a picture that must be equal. Every
// picture must be finite.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lab/shot_data.h"
#include "stability/extreme_checks.h"
#include "stability/variants.h"

namespace strobe::stability {

// Every pipeline with its defaults or with each of its presets, in the order of the registry. Throws `Error` if a
// pipeline cannot be evaluated.
std::vector<Variant> methodsOf(const Home& home, const script::Limits& limits);

// An extreme case, such as a very large motion: its requirement as a sentence, and the checks that test it.
struct Extreme {
  std::string name;
  std::string clause;  // subject of the case, one of a few
  std::string says;    // the requirement, a sentence
  std::vector<ExtremeCheck> checks;
};

// All extreme cases, with the two reference methods: the sharp image and ground truth.
struct Extremes {
  lab::Arm sharp;                 // the raster image without blur
  lab::Arm truth;                 // ground truth, for comparison
  script::Settings truth_method;  // additional settings if truth is the tested method
  std::vector<Extreme> cases;
};

// Reads scripts/stability/extreme_cases.lua. Returns all cases; only the cases in `with_checks` have their checks
// (without it: all cases). Throws `Error` if the script fails.
Extremes readExtremes(const Home& home, const script::Limits& limits,
                      const std::optional<std::vector<std::string>>& with_checks = std::nullopt);

// Pictures of one method for a check. Pictures are kept until the next case.
class Probe {
 public:
  using Pictures = std::map<std::string, std::shared_ptr<const lab::Picture>>;
  Probe(lab::Workbench& bench, Pictures& pictures, const Extremes& extremes, const Variant& method)
      : bench_(bench), pictures_(pictures), extremes_(extremes), method_(method) {}

  bool isTruth() const { return method_.pipeline == extremes_.truth.pipeline; }
  bool isSharp() const { return method_.pipeline == extremes_.sharp.pipeline; }
  bool blurs() const { return !isTruth() && !isSharp(); }
  // True for a blur with a maximum displacement.
  bool filters() const { return blurs() && plan::paramOf(*method_.description, plan::Role::Reach); }

  // Picture of the shot by this method, without settings that the pipeline lacks; without blur; ground truth.
  const lab::Picture& picture(const lab::Shot& shot);
  const lab::Picture& sharp(const lab::Shot& shot) { return drawn(by(extremes_.sharp, shot)); }
  const lab::Picture& truth(const lab::Shot& shot) { return drawn(by(extremes_.truth, shot)); }

  // Records the failure `text` unless `holds`.
  void expect(bool holds, const std::string& text);
  const std::vector<std::string>& failures() const { return failures_; }
  const std::string& lastCommand() const { return last_command_; }

 private:
  static lab::Shot by(const lab::Arm& arm, lab::Shot shot);
  const lab::Picture& drawn(const lab::Shot& shot);

  lab::Workbench& bench_;
  Pictures& pictures_;
  const Extremes& extremes_;
  const Variant& method_;
  std::vector<std::string> failures_;
  std::string last_command_;
};

// Result of a case under a method: passed if `failures` is empty.
struct ExtremeOutcome {
  const Extreme* extreme = nullptr;
  std::string method;
  std::vector<std::string> failures;
  std::string command;  // draws the last picture
};

// Runs one case under every method. An `Error` counts as a failure of the method.
std::vector<ExtremeOutcome> runExtreme(lab::Workbench& bench, const std::vector<Variant>& methods,
                                       const Extremes& extremes, const Extreme& extreme);

// Text for the terminal, one line per clause and the failures; the page docs/extreme-cases.md.
std::string textOf(const std::vector<ExtremeOutcome>& outcomes);
std::string pageOf(const std::vector<ExtremeOutcome>& outcomes);

}  // namespace strobe::stability
