// SPDX-License-Identifier: MIT
// The table of keys: each key once, each action reachable, nothing undescribed.
#include "live/keys.h"

#include <gtest/gtest.h>

#include <cctype>
#include <set>

#include "base/error.h"

namespace strobe::live {
namespace keys_test {

TEST(Keys, EveryKeyStandsOnce) {
  std::set<int> codes;
  std::set<std::string> shown;
  std::set<Action> actions;
  for (const KeyBinding& key : keys()) {
    EXPECT_TRUE(codes.insert(key.code).second) << key.shown;
    EXPECT_TRUE(shown.insert(key.shown).second) << key.shown;
    EXPECT_TRUE(actions.insert(key.action).second) << key.shown << " does what another key does";
    EXPECT_NE(std::string(key.doc), "") << key.shown;
  }
  // A held key is known by its place on the keyboard, where capitals count.
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
