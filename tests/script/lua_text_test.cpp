// SPDX-License-Identifier: MIT
// Text that the program writes into scripts: Lua reads it back unchanged.
#include "script/lua_text.h"

#include <gtest/gtest.h>

#include "home.h"
#include "script/evaluate.h"

namespace strobe::script {
namespace lua_text_test {

// Value of a Lua expression.
Json readBack(const std::string& expression) {
  TestHome home;
  home.write("x/text.lua", "return { " + field("it", expression) + " }\n");
  return evaluateData(home.home(), (home.folder() / "x/text.lua").string()).at("it");
}

TEST(LuaText, TextRoundTrips) {
  for (const std::string text : {"", "plain", "\"quoted\" and 'so'", "back\\slash", "\\n", "two\nlines", "a\rb\r\n",
                                 "tab\t bell\a escape\x1b[0m", "Ω × µ", "--[[ no comment ]]", "{{error}}"})
    EXPECT_EQ(readBack(quoted(text)), Json(text)) << text;
}

TEST(LuaText, ValuesRoundTrip) {
  for (const plan::Value& value : std::vector<plan::Value>{true, int64_t(-3), 0.1, 2.0, 1e-30, std::string("a \"b\"")})
    EXPECT_EQ(readBack(luaOf(value)), plan::toJson(value));
  EXPECT_EQ(readBack(luaOf(Json({1, "two", {0.5, 3}}))), Json({1, "two", {0.5, 3}}));
}

TEST(LuaText, NamesAreBracketedIfLuaNeedsIt) {
  EXPECT_EQ(field("tile_2", "1"), "tile_2 = 1");
  for (const std::string name : {"gather.samples", "2d", "end", "a b", "", "say \"x\""})
    EXPECT_EQ(readBack(tableOf({field(name, "1")})), Json({{name, 1}})) << name;
}

}  // namespace lua_text_test
}  // namespace strobe::script
