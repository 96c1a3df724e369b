// SPDX-License-Identifier: MIT
#include <cstdio>
#include <cstring>

#include "app/command_line.h"
#include "script/evaluate.h"

int main(int argc, char** argv) {
  if (argc > 1 && std::strcmp(argv[1], "--script-child") == 0) strobe::script::runScriptChild(argc, argv);
  const strobe::Home home = strobe::Home::fromEnvironment();
  strobe::app::KeptBench bench(home);
  const strobe::app::CommandEnd end = strobe::app::runCommand(home, bench, {argv + 1, argv + argc});
  if (!end.error.empty()) std::fprintf(stderr, "strobe: %s\n", end.error.c_str());
  return end.exit_code;
}
