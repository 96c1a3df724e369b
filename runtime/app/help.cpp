// SPDX-License-Identifier: MIT
#include <cstdio>
#include <memory>
#include <string>

#include "app/commands.h"
#include "lab/reference.h"
#include "study/measures.h"

namespace strobe::app {

// Prints the declarations of all pipelines, passes and measures.
static void printAll(const Home& home) {
  Json json = lab::helpJson(home, "");
  for (const study::Measure& measure : study::measures())
    json["measures"].push_back(
        {{"name", measure.name}, {"title", measure.title}, {"unit", measure.unit}, {"doc", measure.doc}});
  std::printf("%s\n", json.dump(2).c_str());
}

void registerHelp(CLI::App& program, const Home& home) {
  auto topic = std::make_shared<std::string>();
  auto folder = std::make_shared<std::string>();
  CLI::App* command = program.add_subcommand("help", "Describe a pass, a pipeline or a parameter, and where it fails");
  const char* topics = "PASS, PIPELINE, PASS.PARAM, PIPELINE.PARAM or PARAM (default: lists them)";
  CLI::Option* named = command->add_option("topic", *topic, topics);
  command->add_option("--write", *folder, "write every page below this folder")->type_name("DIR")->excludes(named);
  auto json = std::make_shared<bool>(false);
  command->add_flag("--json", *json, "print the declarations of a pass or a pipeline, or of all, as JSON");
  command->callback([topic, folder, json, &home] {
    if (!folder->empty()) return lab::writeReference(home, *folder);
    if (*json && topic->empty()) return printAll(home);
    if (*json) return void(std::printf("%s\n", lab::helpJson(home, *topic).dump(2).c_str()));
    std::string text = topic->empty() ? lab::helpTopics(home) : lab::helpOn(home, *topic);
    std::fputs(text.c_str(), stdout);
  });
}

}  // namespace strobe::app
