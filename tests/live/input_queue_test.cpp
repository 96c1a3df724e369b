// SPDX-License-Identifier: MIT
// Key events keep their order at any frame rate.
#include "live/input_queue.h"

#include <gtest/gtest.h>

#include <cctype>
#include <string>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace strobe::live {
namespace input_queue_test {

using Kind = InputEvent::Kind;

class InputQueueTest : public ::testing::Test {
 protected:
  void key(int code, int action, int mods = 0) { queue_.add({Kind::Key, code, 0, action, mods}); }
  // Presses and releases a printing key for each character.
  void type(const std::string& text) {
    for (char c : text) {
      int code = std::toupper(c);
      key(code, GLFW_PRESS);
      queue_.add({Kind::Text, c});
      key(code, GLFW_RELEASE);
    }
  }
  // Takes a frame's events; returns the text typed into the box if the box has the keyboard focus.
  std::string frame() {
    std::string text;
    for (const InputEvent& event : queue_.take(typing_))
      if (event.kind == Kind::Text && typing_) text += char(event.code);
    return text;
  }

  InputQueue queue_;
  bool typing_ = false;
};

// All events arrive in one long frame; the box gets the keyboard focus some frames after its request.
TEST_F(InputQueueTest, TextAfterASearchGoesToItsBox) {
  type("/edge");
  EXPECT_EQ(frame(), "");
  EXPECT_EQ(queue_.takePressed(), std::vector<int>{'/'});
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(frame(), "");
    EXPECT_TRUE(queue_.takePressed().empty());
    EXPECT_FALSE(queue_.isHeld('E') || queue_.isHeld('D'));
  }
  typing_ = true;
  EXPECT_EQ(frame(), "edge") << "in the first frame with the focus";
  EXPECT_TRUE(queue_.takePressed().empty());
  EXPECT_TRUE(queue_.empty());
}

TEST_F(InputQueueTest, WithoutABoxKeysAreCommandsAgain) {
  type("/5");
  std::vector<int> commands;
  for (int i = 0; i < 10; ++i) {
    frame();
    for (int command : queue_.takePressed()) commands.push_back(command);
  }
  EXPECT_EQ(commands, (std::vector<int>{'/', '5'}));
}

// Escape leaves the box, Tab moves to the next box, a click moves the keyboard focus: the result is known frames later.
TEST_F(InputQueueTest, KeysWaitForTheKeyboardFocus) {
  for (int leaving : {GLFW_KEY_ESCAPE, GLFW_KEY_ENTER, GLFW_KEY_TAB}) {
    typing_ = true;
    type("a");
    key(leaving, GLFW_PRESS);
    key(leaving, GLFW_RELEASE);
    type("5");
    EXPECT_EQ(frame(), "a");
    EXPECT_EQ(frame(), "");
    typing_ = leaving == GLFW_KEY_TAB;
    std::string text;
    std::vector<int> commands;
    for (int i = 0; i < 5; ++i) {
      text += frame();
      for (int command : queue_.takePressed()) commands.push_back(command);
    }
    EXPECT_EQ(text, typing_ ? "5" : "") << leaving;
    EXPECT_EQ(commands, typing_ ? std::vector<int>() : std::vector<int>{'5'}) << leaving;
  }
  typing_ = false;
  queue_.add({Kind::Button, 0, 0, GLFW_PRESS, 0, dvec2(3, 4)});
  queue_.add({Kind::Button, 0, 0, GLFW_RELEASE, 0, dvec2(5, 6)});
  type("x");
  frame();
  EXPECT_TRUE(queue_.isDown(0)) << "for at least one frame";
  ASSERT_TRUE(queue_.pointer());
  EXPECT_EQ(*queue_.pointer(), dvec2(3, 4)) << "position of the press";
  frame();
  EXPECT_FALSE(queue_.isDown(0));
  typing_ = true;
  EXPECT_EQ(frame() + frame(), "x");
  EXPECT_FALSE(queue_.pointer());
}

// Control, A and both releases in one frame: the box reads A as pressed while Control is down.
TEST_F(InputQueueTest, ShortcutReachesTheBox) {
  typing_ = true;
  key(GLFW_KEY_LEFT_CONTROL, GLFW_PRESS, GLFW_MOD_CONTROL);
  key('A', GLFW_PRESS, GLFW_MOD_CONTROL);
  key('A', GLFW_RELEASE, GLFW_MOD_CONTROL);
  key(GLFW_KEY_LEFT_CONTROL, GLFW_RELEASE);
  EXPECT_EQ(queue_.take(true).size(), 2u);
  EXPECT_EQ(queue_.take(true).size(), 2u);
}

TEST_F(InputQueueTest, OnlyCommandKeysAreHeld) {
  key('W', GLFW_PRESS);
  frame();
  EXPECT_TRUE(queue_.isHeld('W'));
  frame();
  EXPECT_TRUE(queue_.isHeld('W'));
  key('W', GLFW_RELEASE);
  frame();
  EXPECT_FALSE(queue_.isHeld('W'));
  key('A', GLFW_PRESS, GLFW_MOD_CONTROL);
  frame();
  EXPECT_FALSE(queue_.isHeld('A')) << "part of a shortcut";
  typing_ = true;
  key('D', GLFW_PRESS);
  frame();
  typing_ = false;
  frame();
  EXPECT_FALSE(queue_.isHeld('D')) << "part of typed text";
}

// A key pressed and released within one long frame is down for one frame; repeats are delivered at once.
TEST_F(InputQueueTest, ShortPressIsNotLost) {
  key('W', GLFW_PRESS);
  key('W', GLFW_RELEASE);
  frame();
  EXPECT_TRUE(queue_.isHeld('W'));
  frame();
  EXPECT_FALSE(queue_.isHeld('W'));
  key(GLFW_KEY_RIGHT, GLFW_PRESS);
  for (int i = 0; i < 3; ++i) key(GLFW_KEY_RIGHT, GLFW_REPEAT);
  frame();
  EXPECT_EQ(queue_.takePressed().size(), 4u);
  EXPECT_TRUE(queue_.takePressed().empty()) << "once";
}

}  // namespace input_queue_test
}  // namespace strobe::live
