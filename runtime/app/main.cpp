// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstring>
#include <exception>
#include <set>

#include "app/commands.h"
#include "base/error.h"
#include "base/interruption.h"
#include "base/log.h"
#include "base/project.h"
#include "base/version.h"
#include "script/evaluate.h"

// Prints a failure to stderr, one line per mistake. Exit code: 1, or 2 for a wrong command line.
static int report(const std::string& text, int exit_code) {
  std::fprintf(stderr, "strobe: %s\n", text.c_str());
  return exit_code;
}

// Names of the commands with this option.
static std::vector<std::string> commandsWith(const std::string& option, const CLI::App& program) {
  std::vector<std::string> names;
  for (const CLI::App* command : program.get_subcommands({}))
    if (command->get_option_no_throw(option)) names.push_back(command->get_name());
  return names;
}

// Message for the first argument that looks like an option and is unknown to the command, or "".
static std::string unknownOption(const CLI::App& program, const CLI::App& command, int argc, char** argv) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
  }
  for (int i = 1; i < argc; ++i) {
    const std::string text = argv[i], name = text.substr(0, text.find('='));
    bool is_option = name.starts_with("--")
                         ? name.size() > 2
                         : name.size() > 1 && name[0] == '-' && !std::isdigit(static_cast<unsigned char>(name[1]));
    if (!is_option || std::find(names.begin(), names.end(), name) != names.end()) continue;
    const std::vector<std::string> others = commandsWith(name, program);
    if (!others.empty())
      return fmt::format("'{}' has no option '{}'; it is an option of {}", command.get_name(), name,
                         fmt::join(others, ", "));
    const std::string nearest = name.size() > 2 ? strobe::didYouMean(name, names) : "";
    return fmt::format("unknown option '{}'{}", name, nearest);
  }
  return "";
}

// Names a misspelt command and the nearest known command. CLI11 only reports a missing command or an unexpected
// argument.
static std::string usageText(const CLI::App& program, const CLI::ParseError& error, int argc, char** argv) {
  const CLI::App* at = &program;
  std::string called = program.get_name();
  for (int i = 1; i < argc && argv[i][0] != '-'; ++i) {
    std::vector<std::string> names;
    for (const CLI::App* command : at->get_subcommands({})) names.push_back(command->get_name());
    if (names.empty()) break;
    auto known = std::find(names.begin(), names.end(), argv[i]);
    std::string of = at == &program ? "" : fmt::format(" of {}", at->get_name());
    if (known == names.end())
      return fmt::format("unknown command '{}'{}{}; there {} {}", argv[i], of, strobe::didYouMean(argv[i], names),
                         names.size() == 1 ? "is" : "are", fmt::join(names, ", "));
    at = at->get_subcommands({})[size_t(known - names.begin())];
    called += " " + at->get_name();
  }
  std::string text = dynamic_cast<const CLI::ExtrasError*>(&error) ? unknownOption(program, *at, argc, argv) : "";
  if (text.empty()) text = error.what();
  return text.ends_with('?') ? text : fmt::format("{}; see {} --help", text, called);
}

// Refuses a project with files under shipped names, even if the command does not need the files. Commands that describe
// or create something still work. `check` lists all mistakes itself.
static void requireNames(const CLI::App& program, const strobe::Home& home) {
  const std::set<std::string> always = {"help", "doctor", "new", "complete", "compare", "check", "status"};
  for (const CLI::App* command : program.get_subcommands())
    if (always.count(command->get_name())) return;
  strobe::throwIfAny(strobe::misnamedInProject(home));
}

int main(int argc, char** argv) {
  if (argc > 1 && std::strcmp(argv[1], "--script-child") == 0) strobe::script::runScriptChild(argc, argv);
  const strobe::Home home = strobe::Home::fromEnvironment();
  CLI::App program("Strobe: a research sandbox for motion blur", "strobe");
  program.set_version_flag("--version", std::string("strobe ") + strobe::kVersion);
  program.set_help_all_flag("--help-all", "print the help of every command");
  strobe::app::registerDemo(program, home);
  strobe::app::registerRender(program, home);
  strobe::app::registerHelp(program, home);
  strobe::app::registerLive(program, home);
  strobe::app::registerCheck(program, home);
  strobe::app::registerPlan(program, home);
  strobe::app::registerCompare(program);
  strobe::app::registerSweep(program, home);
  strobe::app::registerReport(program, home);
  strobe::app::registerStatus(program);
  strobe::app::registerTune(program, home);
  strobe::app::registerCapture(program, home);
  strobe::app::registerBench(program, home);
  strobe::app::registerStability(program, home);
  strobe::app::registerNew(program, home);
  strobe::app::registerDoctor(program, home);
  strobe::app::registerCompletion(program, home);
  program.parse_complete_callback([&] { requireNames(program, home); });
  try {
    program.parse(argc, argv);
    if (program.get_subcommands().empty()) std::fputs(program.help().c_str(), stdout);
    return 0;
  } catch (const CLI::ParseError& error) {
    bool asked_for_help = error.get_exit_code() == 0;
    return asked_for_help ? program.exit(error) : report(usageText(program, error, argc, argv), 2);
  } catch (const strobe::Stopped& stopped) {
    strobe::note(stopped.reason + "; " + stopped.kept);
    return strobe::kTryAgain;
  } catch (const strobe::Error& error) {
    return report(error.what(), error.exitCode());
  } catch (const std::exception& error) {
    return report(error.what(), 1);
  }
}
