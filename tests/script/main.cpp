// SPDX-License-Identifier: MIT
// The tests start script processes; without STROBE_PROGRAM they start themselves.
#include <gtest/gtest.h>

#include <cstring>

#include "script/evaluate.h"

int main(int argc, char** argv) {
  if (argc > 1 && std::strcmp(argv[1], "--script-child") == 0) strobe::script::runScriptChild(argc, argv);
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
