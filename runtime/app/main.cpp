// SPDX-License-Identifier: MIT
#include <cstring>

#include "script/evaluate.h"

int main(int argc, char** argv) {
  if (argc > 1 && std::strcmp(argv[1], "--script-child") == 0) strobe::script::runScriptChild();
  return 0;
}
