// SPDX-License-Identifier: MIT
// Parsing of drive files, which control the window.
#include <gtest/gtest.h>

#include <set>

#include "common/refusal.h"
#include "live/driven_window.h"

namespace strobe::live {
namespace drive_test {

std::string refusalOf(const std::string& text) {
  return testing::refusalOf([&] { parseDrive(text, "a.drive"); });
}

TEST(Drive, LinesBecomeCommandsWithTheirPlaces) {
  auto commands = parseDrive("# a comment\n\n set exposure 0.5 # more\nquit\r\n", "a.drive");
  ASSERT_EQ(commands.size(), 2u);
  EXPECT_EQ(commands[0].name, "set");
  EXPECT_EQ(commands[0].arguments, (std::vector<std::string>{"exposure", "0.5"}));
  EXPECT_EQ(commands[0].place.text(), "a.drive:3");
  EXPECT_EQ(commands[1].name, "quit");
  EXPECT_EQ(commands[1].place.line, 4);
}

TEST(Drive, QuotationMarksJoinWords) {
  auto commands = parseDrive("set scene \"my scene #2.lua\"\nsearch\nset name \"\"\n", "a");
  EXPECT_EQ(commands[0].arguments[1], "my scene #2.lua");
  EXPECT_TRUE(commands[1].arguments.empty());
  EXPECT_EQ(commands[2].arguments[1], "");
}

TEST(Drive, AllMistakesAreNamedWithTheirLine) {
  EXPECT_EQ(refusalOf("viev color\n"), "a.drive:1: unknown command 'viev'; did you mean 'view'?");
  EXPECT_EQ(refusalOf("set exposure\n"), "a.drive:1: 'set' takes NAME VALUE, got 1 argument");
  EXPECT_EQ(refusalOf("quit now\n"), "a.drive:1: 'quit' takes nothing, got 1 argument");
  EXPECT_EQ(refusalOf("search \"a\n"), "a.drive:1: a quotation mark is not closed");
  EXPECT_EQ(refusalOf("wait 3\nnonsense_word\nzoom 1\n"),
            "a.drive:2: unknown command 'nonsense_word'\na.drive:3: 'zoom' takes Z X Y, got 1 argument");
}

TEST(Drive, NumbersAreChecked) {
  auto commands = parseDrive("wait 2.5\nwait x\nwait 3x\nwait 1000\nwait inf\n", "a.drive");
  EXPECT_DOUBLE_EQ(numberOf(commands[0], 0), 2.5);
  EXPECT_THROW(integerOf(commands[0], 0), Error);
  EXPECT_THROW(numberOf(commands[1], 0), Error);
  EXPECT_THROW(numberOf(commands[2], 0), Error);
  EXPECT_EQ(integerOf(commands[3], 0), 1000);
  EXPECT_THROW(numberOf(commands[4], 0), Error);
}

TEST(Drive, EveryCommandIsInTheTableOnce) {
  std::set<std::string> names;
  for (const CommandForm& form : DrivenWindow::kForms) {
    EXPECT_TRUE(names.insert(form.name).second) << form.name;
    EXPECT_NE(form.doc, "");
  }
}

}  // namespace drive_test
}  // namespace strobe::live
