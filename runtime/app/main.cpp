// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>

#include <cstdio>
#include <cstring>
#include <exception>

#include "app/compare.h"
#include "app/inspect.h"
#include "app/render.h"
#include "base/error.h"
#include "script/evaluate.h"

// Every failure ends here: one line (or one per mistake) on stderr, exit code 1, or 2 for a wrong command line.
static int report(const std::string& text, int exit_code) {
  std::fprintf(stderr, "strobe: %s\n", text.c_str());
  return exit_code;
}

int main(int argc, char** argv) {
  if (argc > 1 && std::strcmp(argv[1], "--script-child") == 0) strobe::script::runScriptChild();
  CLI::App program("Strobe: a research sandbox for motion blur", "strobe");
  program.set_version_flag("--version", "strobe " STROBE_VERSION);
  program.require_subcommand(1);
  program.set_help_all_flag("--help-all", "help of every command");
  strobe::app::registerRender(program);
  strobe::app::registerCheck(program);
  strobe::app::registerPlan(program);
  strobe::app::registerCompare(program);
  strobe::app::registerDoctor(program);
  try {
    program.parse(argc, argv);
    return 0;
  } catch (const CLI::ParseError& error) {
    bool asked_for_help = error.get_exit_code() == 0;
    return asked_for_help ? program.exit(error) : report(error.what(), 2);
  } catch (const strobe::Error& error) {
    return report(error.what(), error.exitCode());
  } catch (const std::exception& error) {
    return report(error.what(), 1);
  }
}
