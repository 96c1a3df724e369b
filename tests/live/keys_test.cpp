// SPDX-License-Identifier: MIT
// The table of keys: no key or action occurs twice, and all actions have a key and a description.
#include "live/keys.h"

#include <gtest/gtest.h>

#include <cctype>
#include <set>

#include "base/error.h"

namespace strobe::live {
namespace keys_test {

TEST(Keys, EveryKeyOccursOnce) {
  std::set<int> codes;
  std::set<std::string> shown;
  std::set<Action> actions;
  for (const KeyBinding& key : keys()) {
    EXPECT_TRUE(codes.insert(key.code).second) << key.shown;
    EXPECT_TRUE(shown.insert(key.shown).second) << key.shown;
    EXPECT_TRUE(actions.insert(key.action).second) << key.shown << " has the action of another key";
    EXPECT_NE(std::string(key.doc), "") << key.shown;
  }
  // A held key is identified by its position on the keyboard: case does not matter.
  for (const HeldKey& key : heldKeys()) {
    EXPECT_TRUE(codes.insert(std::tolower(key.code)).second) << key.shown;
    EXPECT_TRUE(shown.insert(key.shown).second) << key.shown;
  }
  EXPECT_EQ(actions.size(), size_t(Action::Quit)) << "every action but None has its key";
}

TEST(Keys, AreFoundByCodeAndName) {
  EXPECT_EQ(actionOf('c'), Action::CameraBack);
  EXPECT_EQ(actionOf('~'), Action::None);
  EXPECT_EQ(actionNamed("Space"), Action::TogglePlay);
  EXPECT_THROW(actionNamed("Spcae"), Error);
}

}  // namespace keys_test
}  // namespace strobe::live
