// SPDX-License-Identifier: MIT
#include <cstdio>
#include <memory>
#include <string>

#include "app/commands.h"
#include "lab/reference.h"

namespace strobe::app {

void registerHelp(CLI::App& program, const Home& home) {
  auto topic = std::make_shared<std::string>();
  auto folder = std::make_shared<std::string>();
  CLI::App* command = program.add_subcommand("help", "Describe a pass, a pipeline or a parameter, and where it fails");
  const char* topics = "PASS, PIPELINE, PASS.PARAM, PIPELINE.PARAM or PARAM (default: lists them)";
  CLI::Option* named = command->add_option("topic", *topic, topics);
  command->add_option("--write", *folder, "write every page below this folder")->type_name("DIR")->excludes(named);
  command->callback([topic, folder, &home] {
    if (!folder->empty()) return lab::writeReference(home, *folder);
    std::string text = topic->empty() ? lab::helpTopics(home) : lab::helpOn(home, *topic);
    std::fputs(text.c_str(), stdout);
  });
}

}  // namespace strobe::app
