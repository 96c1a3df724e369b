// SPDX-License-Identifier: MIT
// Cases at the edge of what numbers, tiles, cameras and scenes can hold, each for every pipeline of the registry and
// each of its presets. What must come out is known otherwise: from a closed form, from truth, or from a picture that
// must be the same. Finite it must be always.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lab/workbench.h"
#include "stability/extreme_checks.h"

namespace strobe::stability {

// A pipeline with its defaults or with a preset.
struct Method {
  std::string pipeline;
  script::Settings sets;  // the preset, or none
  std::shared_ptr<const plan::PipelineDesc> description;

  std::string name() const;  // "pipeline preset=x"
  bool has(const std::string& param) const;
};

// In the order of the registry. Throws `Error` where one cannot be evaluated.
std::vector<Method> methodsOf(const Home& home, const script::Limits& limits);

struct Extreme {
  std::string name;
  std::string clause;  // what it is a case of, one of a few
  std::string says;    // what must hold
  std::vector<ExtremeCheck> checks;
};

// A pipeline with settings.
struct Arm {
  std::string pipeline;
  script::Settings sets;
};

struct Extremes {
  Arm sharp;                      // the capture as it is
  Arm truth;                      // that others are compared with
  script::Settings truth_method;  // of truth where it is the method
  std::vector<Extreme> cases;
};

// scripts/stability/extreme_cases.lua. All cases; only those `with_checks` have their checks (without it: all). Throws
// `Error` naming all mistakes.
Extremes readExtremes(const Home& home, const script::Limits& limits,
                      const std::optional<std::vector<std::string>>& with_checks = std::nullopt);

// What a check may ask of one method. Pictures are kept until the next case.
class Probe {
 public:
  using Pictures = std::map<std::string, std::shared_ptr<const lab::Picture>>;
  Probe(lab::Workbench& bench, Pictures& pictures, const Extremes& extremes, const Method& method)
      : bench_(bench), pictures_(pictures), extremes_(extremes), method_(method) {}

  bool isTruth() const { return method_.pipeline == extremes_.truth.pipeline; }
  bool isSharp() const { return method_.pipeline == extremes_.sharp.pipeline; }
  bool blurs() const { return !isTruth() && !isSharp(); }
  // Is it a blur that looks as far as displacements reach?
  bool filters() const { return blurs() && plan::paramOf(*method_.description, plan::Role::Reach); }

  // The shot by this method: settings of the pipeline that it does not have are left out. By name: without blur; truth.
  const lab::Picture& picture(const lab::Shot& shot);
  const lab::Picture& sharp(const lab::Shot& shot) { return drawn(by(extremes_.sharp, shot)); }
  const lab::Picture& truth(const lab::Shot& shot) { return drawn(by(extremes_.truth, shot)); }

  // `text` says what is wrong where `holds` does not.
  void expect(bool holds, const std::string& text);
  const std::vector<std::string>& failures() const { return failures_; }
  const std::string& lastCommand() const { return last_command_; }

 private:
  static lab::Shot by(const Arm& arm, lab::Shot shot);
  const lab::Picture& drawn(const lab::Shot& shot);

  lab::Workbench& bench_;
  Pictures& pictures_;
  const Extremes& extremes_;
  const Method& method_;
  std::vector<std::string> failures_;
  std::string last_command_;
};

// What became of a case under a method: it passes where `failures` is empty.
struct ExtremeOutcome {
  const Extreme* extreme = nullptr;
  std::string method;
  std::vector<std::string> failures;
  std::string command;  // of the picture that was drawn last
};

// One of the cases under every method. What a method throws is a failure of it.
std::vector<ExtremeOutcome> runExtreme(lab::Workbench& bench, const std::vector<Method>& methods,
                                       const Extremes& extremes, const Extreme& extreme);

// For the terminal, a line per clause and what failed; the page docs/extreme-cases.md.
std::string textOf(const std::vector<ExtremeOutcome>& outcomes);
std::string pageOf(const std::vector<ExtremeOutcome>& outcomes);

}  // namespace strobe::stability
