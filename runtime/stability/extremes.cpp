// SPDX-License-Identifier: MIT
#include "stability/extremes.h"

#include <algorithm>
#include <cmath>

#include "base/json.h"
#include "base/lists.h"
#include "page/table.h"

namespace strobe::stability {

// True for a parameter of the pipeline, and for NODE.PARAM if it has the node.
static bool has(const plan::PipelineDesc& pipeline, const std::string& param) {
  std::string name = param.substr(0, param.find('.'));
  auto lists = [&](const auto& all) {
    return std::any_of(all.begin(), all.end(), [&](const auto& one) { return one.name == name; });
  };
  return name.size() < param.size() ? lists(pipeline.nodes) : lists(pipeline.params);
}

std::vector<Variant> methodsOf(const Home& home, const script::Limits& limits) {
  std::vector<Variant> methods;
  auto evaluate = [&](const std::string& name, const script::Settings& sets) {
    return std::make_shared<const plan::PipelineDesc>(script::evaluatePipeline(home, {name, sets}, nullptr, limits));
  };
  for (const std::string& name : script::pipelineNames(home)) {
    auto described = evaluate(name, {});
    if (described->presets.empty()) methods.push_back({name, {}, described});
    for (const auto& preset : described->presets) {
      script::Settings sets = {{plan::kPresetSetting, preset.name}};
      methods.push_back({name, sets, evaluate(name, sets)});
    }
  }
  return methods;
}

void Probe::expect(bool holds, const std::string& text) {
  if (!holds) failures_.push_back(text);
}

static bool isFinite(const image::Image& image) {
  return std::all_of(image.values.begin(), image.values.end(), [](float v) { return std::isfinite(v); });
}

const lab::Picture& Probe::drawn(const lab::Shot& shot) {
  last_command_ = lab::commandOf(shot);
  std::shared_ptr<const lab::Picture>& known = pictures_[last_command_];
  if (known) return *known;
  known = std::make_shared<const lab::Picture>(bench_.render(shot));
  for (const char* output : {"color", "velocity", "normal"})
    expect(isFinite(known->frame.outputs.at(output).floats), fmt::format("'{}' is not finite", output));
  for (const std::string& message : bench_.device().takeMessages()) expect(false, "validation: " + message);
  return *known;
}

lab::Shot Probe::by(const lab::Arm& arm, lab::Shot shot) {
  shot.sets = lab::sceneSettings(shot.sets);
  shot.pipeline = arm.pipeline;
  shot.sets.insert(shot.sets.end(), arm.sets.begin(), arm.sets.end());
  return shot;
}

const lab::Picture& Probe::picture(const lab::Shot& shot) {
  lab::Shot own = shot;
  own.pipeline = method_.pipeline;
  own.sets = method_.sets;
  if (isTruth()) own.sets.insert(own.sets.end(), extremes_.truth_method.begin(), extremes_.truth_method.end());
  for (const auto& [name, value] : shot.sets)
    if (name.starts_with("scene.") || has(*method_.description, name)) lab::putSetting(own.sets, name, value);
  return drawn(own);
}

// ---- the cases

static lab::Arm readArm(const Json& json) {
  lab::Arm arm{"", json.at("pipeline"), {}};
  if (json.contains("set")) readSettings(json.at("set"), "", arm.sets);
  return arm;
}

static Extreme readExtreme(const Json& json) {
  Extreme extreme{json.at("name"), json.at("clause"), json.at("says"), {}};
  for (const Json& check : json.value("checks", Json::array())) extreme.checks.push_back(readCheck(check));
  return extreme;
}

Extremes readExtremes(const Home& home, const script::Limits& limits,
                      const std::optional<std::vector<std::string>>& with_checks) {
  Json arguments = Json::object();
  if (with_checks) arguments["cases"] = *with_checks;
  const Json data =
      script::evaluateData(home, home.at("scripts/stability/extreme_cases.lua"), arguments, nullptr, limits);
  Extremes extremes{readArm(data.at("sharp")), readArm(data.at("truth")), {}, {}};
  readSettings(data.at("truth_method"), "", extremes.truth_method);
  for (const Json& one : data.at("cases")) extremes.cases.push_back(readExtreme(one));
  return extremes;
}

std::vector<ExtremeOutcome> runExtreme(lab::Workbench& bench, const std::vector<Variant>& methods,
                                       const Extremes& extremes, const Extreme& extreme) {
  Probe::Pictures pictures;
  std::vector<ExtremeOutcome> outcomes;
  for (const Variant& method : methods) {
    Probe probe(bench, pictures, extremes, method);
    ExtremeOutcome outcome{&extreme, method.method(), {}, ""};
    try {
      for (const ExtremeCheck& check : extreme.checks) apply(check, probe);
      outcome.failures = probe.failures();
    } catch (const Error& error) {
      outcome.failures = probe.failures();
      outcome.failures.push_back(error.what());
    }
    outcome.command = probe.lastCommand();
    outcomes.push_back(std::move(outcome));
  }
  return outcomes;
}

static page::Table countsOf(const std::vector<ExtremeOutcome>& outcomes) {
  struct Count {
    std::string clause;
    std::vector<std::string> cases;
    int checks = 0, failed = 0;
  };
  std::vector<Count> clauses;
  Count all{"all", {}};
  for (const ExtremeOutcome& outcome : outcomes) {
    auto is_clause = [&](const Count& count) { return count.clause == outcome.extreme->clause; };
    auto clause = std::find_if(clauses.begin(), clauses.end(), is_clause);
    if (clause == clauses.end()) clause = clauses.insert(clauses.end(), {outcome.extreme->clause, {}});
    for (Count* count : {&*clause, &all}) {
      addOnce(count->cases, outcome.extreme->name);
      ++count->checks;
      count->failed += !outcome.failures.empty();
    }
  }
  page::Table table{"", {"clause", {"cases", true}, {"cases x methods", true}, {"failed", true}, "names"}};
  auto add = [&](const Count& count, const std::string& which) {
    table.add({count.clause,
               std::to_string(count.cases.size()),
               std::to_string(count.checks),
               {std::to_string(count.failed), count.failed ? page::Emphasis::bad : page::Emphasis::none},
               which});
  };
  for (const Count& clause : clauses) add(clause, fmt::format("{}", fmt::join(clause.cases, ", ")));
  add(all, "");
  return table;
}

static std::string failuresOf(const std::vector<ExtremeOutcome>& outcomes) {
  std::string text;
  for (const ExtremeOutcome& outcome : outcomes)
    for (const std::string& failure : outcome.failures)
      text += fmt::format("\n{} by {}: {}\n    {}\n", outcome.extreme->name, outcome.method, failure, outcome.command);
  return text;
}

std::string textOf(const std::vector<ExtremeOutcome>& outcomes) {
  page::Table counts = countsOf(outcomes);
  for (page::Row& row : counts.rows) row.pop_back();
  counts.columns.pop_back();
  return page::textOf(counts) + failuresOf(outcomes);
}

std::string pageOf(const std::vector<ExtremeOutcome>& outcomes) {
  page::Table cases{"", {"case", "expected result"}};
  const Extreme* last = nullptr;
  for (const ExtremeOutcome& outcome : outcomes) {
    if (outcome.extreme != last) cases.add({outcome.extreme->name, outcome.extreme->says});
    last = outcome.extreme;
  }
  return "<!-- Written by `strobe stability --extremes --write docs/extreme-cases.md`; do not edit. -->\n\n"
         "# Extreme cases\n\n"
         "An extreme case is a small scene with an input at the limit of its range, for example a displacement of ten "
         "million pixels or a picture of one pixel. Every pipeline draws each case with each of its presets, on "
         "pictures of at most 64 x 64 px. The expected result follows from a closed form, from ground truth, or from "
         "another picture that must be equal. Every picture must be finite.\n\nThe first table counts the cases by "
         "subject. A method is a pipeline with a preset. Pairs of a case and a method with another result than "
         "expected count as failed. Most cases show a bright bar that moves over a static background; the raster image "
         "is the picture without blur.\n\n" +
         page::markdownOf(countsOf(outcomes)) + failuresOf(outcomes) + "\n## The cases\n\n" + page::markdownOf(cases);
}

}  // namespace strobe::stability
