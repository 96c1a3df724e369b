// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdio>
#include <map>
#include <memory>
#include <sstream>

#include "app/commands.h"
#include "app/files.h"
#include "script/evaluate.h"

namespace strobe::app {

namespace {

using Names = std::vector<std::string>;

// Command line up to the cursor, after the program's name: the complete words, and the unfinished last word.
struct TypedLine {
  Names before;
  std::string word;
};

Names pipelines(const Home& home, const TypedLine&) { return script::pipelineNames(home); }
Names scenes(const Home& home, const TypedLine&) { return script::sceneNames(home); }
Names invariants(const Home&, const TypedLine&) { return plan::invariantNames(); }

Names topics(const Home& home, const TypedLine&) {
  Names names = script::pipelineNames(home);
  for (const plan::PassDesc& pass : script::evaluateAllPasses(home)) names.push_back(pass.name);
  return names;
}

// Presets below experiments/.
Names presetFiles(const Home& home) {
  Names files;
  for (const std::string& name : home.namesBelow("experiments", ".lua")) {
    std::string file = fmt::format("experiments/{}.lua", name);
    if (isPreset(home, home.at(file))) files.push_back(file);
  }
  return files;
}

// "PARAM=" of the pipeline named on the line. After the "=", "PARAM=CHOICE".
Names settings(const Home& home, const TypedLine& line) {
  Names known = script::pipelineNames(home), names;
  auto named = std::find_if(line.before.begin(), line.before.end(), [&](const std::string& word) {
    return word.ends_with(".lua") || std::find(known.begin(), known.end(), word) != known.end();
  });
  if (named == line.before.end()) return {};
  plan::PipelineDesc pipeline = script::evaluatePipeline(home, {*named, {}});
  bool has_name = line.word.find('=') != std::string::npos;
  auto add = [&](const std::string& name, const Names& choices) {
    if (!has_name) names.push_back(name + "=");
    for (const std::string& choice : has_name ? choices : Names()) names.push_back(name + "=" + choice);
  };
  Names presets = presetFiles(home);
  for (const plan::PresetDesc& preset : pipeline.presets) presets.push_back(preset.name);
  if (!presets.empty()) add(plan::kPresetSetting, presets);
  for (const plan::ParamDesc& param : pipeline.params)
    add(param.name, param.type == plan::ParamDesc::Type::Bool ? Names{"true", "false"} : param.choices);
  return names;
}

// Options with a list of known names as values. Other options list their choices in their type ("end|centre|start").
const std::map<std::string, Names (*)(const Home&, const TypedLine&)> kNamesOf = {
    {"pipeline", pipelines}, {"pipelines", pipelines}, {"base", pipelines},
    {"vs", pipelines},       {"truth", pipelines},     {"topic", topics},
    {"scene", scenes},       {"set", settings},        {"invariant", invariants}};

Names choicesOf(const CLI::Option& option) {
  Names choices;
  std::istringstream type(option.get_type_name());
  for (std::string choice; std::getline(type, choice, '|');) choices.push_back(choice);
  bool literal = choices.size() > 1 && std::islower(choices.front().front());
  return literal ? choices : Names();
}

Names optionsOf(const CLI::App& command) {
  Names names;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

Names commandsOf(const CLI::App& command) {
  Names names;
  for (const CLI::App* below : command.get_subcommands({})) names.push_back(below->get_name());
  return names;
}

// All candidates for the last word; {} if the word is a file or free text.
Names candidates(const CLI::App& program, const Home& home, const TypedLine& line) {
  const CLI::App* command = &program;
  const CLI::Option* awaits = nullptr;  // option whose value comes next
  size_t given = 0;
  for (const std::string& word : line.before) {
    if (awaits) {
      awaits = nullptr;
    } else if (word.starts_with("-")) {
      awaits = command->get_option_no_throw(word);
      if (awaits && awaits->get_items_expected_min() == 0) awaits = nullptr;
    } else {
      auto below = command->get_subcommands([&](const CLI::App* one) { return one->get_name() == word; });
      if (below.empty()) ++given;
      else command = below.front();
    }
  }
  if (!awaits && line.word.starts_with("-")) return optionsOf(*command);
  auto places = command->get_options([](const CLI::Option* option) { return option->get_positional(); });
  if (!awaits && places.empty()) return commandsOf(*command);
  const CLI::Option& option = awaits ? *awaits : *places[std::min(given, places.size() - 1)];
  if (!awaits && given >= places.size() && option.get_items_expected_max() == 1) return {};
  auto names = kNamesOf.find(option.get_single_name());
  return names == kNamesOf.end() ? choicesOf(option) : names->second(home, line);
}

TypedLine lineOf(const std::string& text) {
  TypedLine line;
  std::istringstream words(text);
  for (std::string word; words >> word;) line.before.push_back(word);
  if (!line.before.empty()) line.before.erase(line.before.begin());  // strobe
  bool begun = !text.empty() && !std::isspace(static_cast<unsigned char>(text.back())) && !line.before.empty();
  if (begun) line.word = line.before.back(), line.before.pop_back();
  return line;
}

}  // namespace

void registerCompletion(CLI::App& program, const Home& home) {
  auto text = std::make_shared<std::string>();
  CLI::App* command =
      program.add_subcommand("complete", "List completions of the last word of a command line, for shells");
  command->add_option("line", *text, "the command line up to the cursor, as one argument")->required();
  command->callback([text, &program, &home] {
    TypedLine line = lineOf(*text);
    for (const std::string& name : candidates(program, home, line))
      if (name.starts_with(line.word)) std::printf("%s\n", name.c_str());
  });
}

}  // namespace strobe::app
