// SPDX-License-Identifier: MIT
#include "base/strict.h"

#include <gtest/gtest.h>

#include "base/json.h"
#include "common/refusal.h"

namespace strobe {
namespace strict_test {

const Place kOuter{"a.lua", 1};

std::string problemsOf(const Json& json, void (*read)(Fields& fields)) {
  Problems problems;
  return testing::refusalOf([&] {
    Fields fields(json, "lamp", kOuter, problems);
    read(fields);
    fields.finish();
    problems.throwIfAny();
  });
}

TEST(Strict, ReadsEachKindOnce) {
  Json json = {{"n", 2.5}, {"i", 3}, {"b", true}, {"t", "x"}, {"c", "red"}, {"l", {1, 2}}, {"place", {{"line", 7}}}};
  Problems problems;
  Fields fields(json, "lamp", kOuter, problems);
  EXPECT_EQ(fields.number("n", std::nullopt), 2.5);
  EXPECT_EQ(fields.integer("i", 0, 0, 9), 3);
  EXPECT_TRUE(fields.boolean("b", false));
  EXPECT_EQ(fields.text("t"), "x");
  EXPECT_EQ(fields.choice("c", "red", {"red", "blue"}), "red");
  EXPECT_EQ(fields.list("l").size(), 2u);
  EXPECT_EQ(fields.number("absent", 4), 4);
  EXPECT_EQ(fields.place().text(), "a.lua:7");
  fields.finish();
  EXPECT_TRUE(problems.empty());
}

TEST(Strict, AllMistakesAreNamedWithTheirPlace) {
  Json json = {{"n", "2"}, {"i", 2.5}, {"c", "rad"}, {"l", {{"a", 1}}}, {"colour", 1}, {"place", {{"line", 7}}}};
  EXPECT_EQ(problemsOf(json,
                       [](Fields& fields) {
                         fields.number("n", 0);
                         fields.integer("i", 0, 0, 9);
                         fields.choice("c", "red", {"red", "blue"});
                         fields.list("l");
                         fields.text("name", std::nullopt);
                         fields.number("color", 0);
                       }),
            "a.lua:7: lamp: 'n' is string, not a number\n"
            "a.lua:7: lamp: 'i' = 2.5 is not a whole number\n"
            "a.lua:7: lamp: 'c' = 'rad' is not one of red, blue; did you mean 'red'?\n"
            "a.lua:7: lamp: 'l' is object, not a list\n"
            "a.lua:7: lamp: needs 'name'\n"
            "a.lua:7: lamp: unknown key 'colour'; did you mean 'color'?");
}

TEST(Strict, InvalidPlacesAreMistakes) {
  for (const Json& place : {Json(3), Json({{"line", "x"}}), Json({{"line", -1}}), Json({{"line", 1}, {"file", 2}})})
    EXPECT_EQ(problemsOf({{"place", place}}, [](Fields&) {}), "a.lua:1: lamp: 'place' is not a file and a line");
}

TEST(Strict, AtOnceThrowsTheFirstMistake) {
  Problems problems(Problems::When::at_once);
  Json json = {{"n", "2"}};
  Fields fields(json, "lamp", kOuter, problems);
  try {
    fields.number("n", 0);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.place().text(), "a.lua:1");
    EXPECT_EQ(error.message(), "lamp: 'n' is string, not a number");
  }
}

}  // namespace strict_test
}  // namespace strobe
