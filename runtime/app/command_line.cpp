// SPDX-License-Identifier: MIT
#include "app/command_line.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <cstdio>
#include <exception>
#include <set>

#include "app/commands.h"
#include "base/error.h"
#include "base/interruption.h"
#include "base/log.h"
#include "base/version.h"

namespace strobe::app {

// Names of the commands with this option.
static std::vector<std::string> commandsWith(const std::string& option, const CLI::App& program) {
  std::vector<std::string> names;
  for (const CLI::App* command : program.get_subcommands({}))
    if (command->get_option_no_throw(option)) names.push_back(command->get_name());
  return names;
}

// Message for the first argument that looks like an option and is unknown to the command, or "".
static std::string unknownOption(const CLI::App& program, const CLI::App& command,
                                 const std::vector<std::string>& words) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
  }
  for (const std::string& text : words) {
    const std::string name = text.substr(0, text.find('='));
    bool is_option = name.starts_with("--")
                         ? name.size() > 2
                         : name.size() > 1 && name[0] == '-' && !std::isdigit(static_cast<unsigned char>(name[1]));
    if (!is_option || std::find(names.begin(), names.end(), name) != names.end()) continue;
    const std::vector<std::string> others = commandsWith(name, program);
    if (!others.empty())
      return fmt::format("'{}' has no option '{}'; it is an option of {}", command.get_name(), name,
                         fmt::join(others, ", "));
    const std::string nearest = name.size() > 2 ? didYouMean(name, names) : "";
    return fmt::format("unknown option '{}'{}", name, nearest);
  }
  return "";
}

// Names a misspelt command and the nearest known command. CLI11 only reports a missing command or an unexpected
// argument.
static std::string usageText(const CLI::App& program, const CLI::ParseError& error,
                             const std::vector<std::string>& words) {
  const CLI::App* at = &program;
  std::string called = program.get_name();
  for (const std::string& word : words) {
    if (word.starts_with('-')) break;
    std::vector<std::string> names;
    for (const CLI::App* command : at->get_subcommands({})) names.push_back(command->get_name());
    if (names.empty()) break;
    auto known = std::find(names.begin(), names.end(), word);
    std::string of = at == &program ? "" : fmt::format(" of {}", at->get_name());
    if (known == names.end())
      return fmt::format("unknown command '{}'{}{}; there {} {}", word, of, didYouMean(word, names),
                         names.size() == 1 ? "is" : "are", fmt::join(names, ", "));
    at = at->get_subcommands({})[size_t(known - names.begin())];
    called += " " + at->get_name();
  }
  std::string text = dynamic_cast<const CLI::ExtrasError*>(&error) ? unknownOption(program, *at, words) : "";
  if (text.empty()) text = error.what();
  return text.ends_with('?') ? text : fmt::format("{}; see {} --help", text, called);
}

// Refuses a project with files under shipped names, even if the command does not need the files. Commands that describe
// or create something still work. `check` lists all mistakes itself.
static void requireNames(const CLI::App& program, const Home& home) {
  const std::set<std::string> always = {"help", "doctor", "new", "complete", "compare", "check", "status"};
  for (const CLI::App* command : program.get_subcommands())
    if (always.count(command->get_name())) return;
  throwIfAny(home.mistakesOfProject());
}

static void registerAll(CLI::App& program, const Home& home, KeptBench& bench) {
  registerDemo(program, home);
  registerRender(program, home, bench);
  registerHelp(program, home);
  registerLive(program, home);
  registerCheck(program, home);
  registerPlan(program, home);
  registerCompare(program);
  registerSweep(program, home);
  registerReport(program, home);
  registerStatus(program);
  registerTune(program, home);
  registerCapture(program, home);
  registerBench(program, home);
  registerStability(program, home);
  registerNew(program, home);
  registerDoctor(program, home);
  registerServe(program, home, bench);
  registerCompletion(program, home);
}

// Parses the words, runs the command, and returns the exit code of a help text or 0.
static int parse(CLI::App& program, const std::vector<std::string>& words) {
  try {
    program.parse(std::vector<std::string>(words.rbegin(), words.rend()));
    if (program.get_subcommands().empty()) std::fputs(program.help().c_str(), stdout);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0) throw Error(usageText(program, error, words), {}, 2);
    return program.exit(error);
  }
  return 0;
}

CommandEnd runCommand(const Home& home, KeptBench& bench, const std::vector<std::string>& words,
                      const std::function<void(const std::string&)>& accept) {
  CLI::App program("Strobe: a research sandbox for motion blur", "strobe");
  program.set_version_flag("--version", std::string("strobe ") + kVersion);
  program.set_help_all_flag("--help-all", "print the help of every command");
  registerAll(program, home, bench);
  program.parse_complete_callback([&] {
    for (const CLI::App* command : program.get_subcommands())
      if (accept) accept(command->get_name());
    requireNames(program, home);
  });
  try {
    return {parse(program, words), "", false};
  } catch (const Stopped& stopped) {
    note(stopped.reason + "; " + stopped.kept);
    return {kTryAgain, "", false};
  } catch (const Error& error) {
    return {error.exitCode(), error.what(), false};
  } catch (const std::exception& error) {
    return {1, error.what(), true};
  }
}

}  // namespace strobe::app
