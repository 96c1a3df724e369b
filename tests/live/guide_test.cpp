// SPDX-License-Identifier: MIT
// The window's guide lists every key and every command of a drive file, in the words of the program.
#include <gtest/gtest.h>

#include <regex>

#include "base/files.h"
#include "common/home.h"
#include "live/driven_window.h"
#include "live/keys.h"

namespace strobe::live {
namespace guide_test {

// Rows of the guide's tables as "first cell | second cell", without escapes.
std::string guide() {
  return std::regex_replace(readText(home().shipped() / "docs/live.md"), std::regex(R"(\\\|)"), "|");
}

TEST(Guide, HasEveryKey) {
  std::string text = guide();
  for (const KeyBinding& key : keys())
    EXPECT_NE(text.find(fmt::format("| `{}` | {} |", key.shown, key.doc)), std::string::npos) << key.shown;
  for (const HeldKey& key : heldKeys())
    EXPECT_NE(text.find(fmt::format("`{}`", key.shown)), std::string::npos) << key.shown;
}

TEST(Guide, HasEveryCommand) {
  std::string text = guide();
  for (const CommandForm& form : DrivenWindow::kForms) {
    std::string call = form.name + (form.arguments.empty() ? "" : " ") + form.arguments;
    EXPECT_NE(text.find(fmt::format("| `{}` | {} |", call, form.doc)), std::string::npos) << call;
  }
}

}  // namespace guide_test
}  // namespace strobe::live
