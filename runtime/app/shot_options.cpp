// SPDX-License-Identifier: MIT
#include "app/shot_options.h"

#include <cstdlib>

#include "app/numbers.h"
#include "base/log.h"

namespace strobe::app {

void ShotOptions::addWithPipeline(CLI::App& command) {
  command.add_option("pipeline", pipeline, "name of a pipeline of scripts/pipelines, or a .lua file");
  addTo(command);
  command.add_option("--record", record, "run record: use its shot instead of the defaults; other options override it");
}

// Help text of an option, with its default.
static std::string helpOf(const lab::ShotOption& option) {
  std::vector<std::string> otherwise;
  for (const lab::ShotField& field : option.fields)
    if (const auto* number = std::get_if<double>(&field.declaration.default_value))
      otherwise.push_back(fmt::format("{}", *number));
    else if (field.isValue()) otherwise.push_back(plan::textOf(field.declaration.default_value));
  std::string text = option.doc;
  if (option.is(lab::ShotOption::kSuggested))
    text += fmt::format(" (default: the scene's, else {})", fmt::join(otherwise, "x"));
  return text;
}

void ShotOptions::addTo(CLI::App& command, const std::set<std::string>& several) {
  const lab::Shot fresh;
  for (const lab::ShotOption& option : lab::shotOptions()) {
    if (option.fields.front().declaration.type == plan::ParamDesc::Type::Bool) {
      command.add_flag_callback(
          spelled(option), [this, &option] { given_[option.name] = {"true"}; }, helpOf(option));
      continue;
    }
    CLI::Option* added = command.add_option(spelled(option), given_[option.name], helpOf(option));
    bool list = !option.fields.front().isValue() && jsonOf(option, fresh).is_array();
    if (list || several.count(option.name)) added->allow_extra_args(false);
    else added->expected(1)->allow_extra_args(false);  // the next word is the pipeline
    bool stated = option.fields.front().isValue() && !option.fields.front().isOpen(fresh);
    std::string otherwise = stated ? plan::textOf(option.fields.front().get(fresh)) : "";
    if (!otherwise.empty()) added->default_str(otherwise);
    const plan::ParamDesc& declaration = option.fields.front().declaration;
    bool number = option.fields.size() == 1 && declaration.min;
    std::string choices = fmt::format("{}", fmt::join(declaration.choices, "|"));
    added->type_name(!choices.empty() ? choices : number ? "NUMBER" : "TEXT");
  }
  command.add_option("--samples", samples, "short for --set samples=N");
  command.add_option("--shading", shading, "short for --set shading=...")->type_name("frozen|full");
  command.add_option("--set", sets, "PARAM=VALUE of the pipeline, NODE.PARAM=VALUE of a pass, scene.PARAM=VALUE")
      ->allow_extra_args(false);
}

// Warns of an exposure of more frame intervals than usual: the number may be the shutter angle in degrees.
static void warnOfLongExposure(const lab::Shot& shot) {
  constexpr double kLongest = 4;
  if (shot.exposure <= kLongest) return;
  warn(fmt::format("--exposure {:g} is {:g} frame intervals; a shutter of {:g} degrees is --exposure {:g}",
                   shot.exposure, shot.exposure, shot.exposure, shot.exposure / 360));
}

lab::Shot ShotOptions::resolve() const {
  lab::Shot shot;
  if (!record.empty()) shot = lab::shotFromRecord(record);
  if (!pipeline.empty()) shot.pipeline = pipeline;
  if (shot.pipeline.empty()) throw Error("a pipeline is required, or --record FILE", {}, 2);
  for (const lab::ShotOption& option : lab::shotOptions()) {
    auto given = given_.find(option.name);
    if (given != given_.end() && !given->second.empty()) setFromTexts(option, shot, given->second);
  }
  if (!given("exposure").empty() && !given("exposure_time").empty())
    throw Error("--exposure and --exposure-time exclude one another", {}, 2);
  if (!given("exposure").empty()) warnOfLongExposure(shot);
  if (samples) shot.sets.push_back({"samples", int64_t(samples)});
  if (!shading.empty()) shot.sets.push_back({"shading", shading});
  for (const std::string& set : sets) shot.sets.push_back(script::settingFromText(set));
  return shot;
}

std::vector<std::string> ShotOptions::given(const std::string& option) const {
  auto found = given_.find(option);
  return found == given_.end() ? std::vector<std::string>() : found->second;
}

std::vector<std::string> ShotOptions::words(const std::set<std::string>& without) const {
  std::vector<std::string> words;
  for (const lab::ShotOption& option : lab::shotOptions()) {
    if (without.count(option.name)) continue;
    bool is_flag = option.fields.front().declaration.type == plan::ParamDesc::Type::Bool;
    for (const std::string& text : given(option.name)) words.push_back(spelled(option) + (is_flag ? "" : "=" + text));
  }
  if (samples) words.push_back(fmt::format("--samples={}", samples));
  if (!shading.empty()) words.push_back("--shading=" + shading);
  for (const std::string& set : sets) words.push_back("--set=" + set);
  return words;
}

void addTev(CLI::App& command, std::string& address) {
  CLI::callback_t take = [&address](const std::vector<std::string>& given) {
    bool bare = given.empty() || given[0].empty();
    address = bare ? "localhost:14158" : given[0];
    return true;
  };
  command.add_option("--tev", take, "send outputs and taps to the viewer tev, if it runs (default: localhost:14158)")
      ->expected(0, 1)
      ->type_name("[HOST:PORT]");
}

void addTimeLimit(CLI::App& command, double& seconds) {
  command
      .add_option("--time-limit", seconds,
                  "maximum device time of one pass, or of all passes between two loops, seconds; 0: no limit")
      ->type_name("S")
      ->check(CLI::Range(0.0, 86400.0))
      ->capture_default_str();
}

void addBudget(CLI::App& command, double& ms) {
  command
      .add_option("--budget-ms", ms,
                  "maximum time of a frame, milliseconds: the times of drawn frames choose the parameter with the role "
                  "'quality'; --set with the chosen value draws the same picture")
      ->type_name("B")
      ->check(aboveZero());
}

bool validationWanted() {
  const char* value = std::getenv("STROBE_VALIDATION");
  return value && *value && std::string(value) != "0";
}

}  // namespace strobe::app
