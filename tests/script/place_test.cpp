// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "script/locate.h"

namespace strobe::script {
namespace place_test {

static const char* kSource = R"(local pass = require "strobe.pass"
-- reads = { depth = 1 }
return pass.compute {
  name = "x", doc = [[
  reads = { depth = 2 } ]],
  size = { of = "depth" },
  reads = {
    normal = { doc = "n" },
    ["depth"] = { doc = "a = { depth = 3 }" },
  },
  build = function(p)
    if p == 1 then p, params = 1, 2 end
    return { color = p,
             depth = p }
  end,
  params = { a = pass.int { 1,
                            min = 2 } },
}
)";

TEST(Place, FindsTheLineOfAnEntryOfAList) {
  const char* source = R"(return capture {
  arms = {
    { name = "a" },
    { name = "b",
      set = { x = 1 } }, f { 1, 2,
      3 },
    n = 4, 5,
  },
})";
  EXPECT_EQ(LuaSource(source).lineOfKey(1, {"arms", "1"}), 3);
  EXPECT_EQ(LuaSource(source).lineOfKey(1, {"arms", "2"}), 4);
  EXPECT_EQ(LuaSource(source).lineOfKey(1, {"arms", "2", "set", "x"}), 5);
  EXPECT_EQ(LuaSource(source).lineOfKey(1, {"arms", "3"}), 5);
  EXPECT_EQ(LuaSource(source).lineOfKey(1, {"arms", "3", "3"}), 6);
  EXPECT_EQ(LuaSource(source).lineOfKey(1, {"arms", "4"}), 7);
  EXPECT_EQ(LuaSource(source).lineOfKey(1, {"arms", "n"}), 7);
  EXPECT_EQ(LuaSource(source).lineOfKey(1, {"arms", "5"}), 2);
}

TEST(Place, StaysAtTheCallWithoutSuchAField) {
  EXPECT_EQ(LuaSource(kSource).lineOfKey(3, {"reads", "colour"}), 7);
  EXPECT_EQ(LuaSource(kSource).lineOfKey(8, {"doc", "colour"}), 8);
  EXPECT_EQ(LuaSource(kSource).lineOfKey(8, {"colour"}), 8);
  EXPECT_EQ(LuaSource(kSource).lineOfKey(3, {"nothing"}), 3);
  EXPECT_EQ(LuaSource("").lineOfKey(3, {"nothing"}), 3);
  EXPECT_EQ(LuaSource("{ \"unfinished").lineOfKey(1, {"a", "b"}), 1);
  EXPECT_EQ(LuaSource("{ a = ").lineOfKey(1, {"a", "b"}), 1);
  EXPECT_EQ(LuaSource("{ [").lineOfKey(1, {"a"}), 1);
  EXPECT_EQ(LuaSource("--[==[").lineOfKey(1, {"a"}), 1);
}

TEST(Place, DetectsReadsOfAField) {
  EXPECT_TRUE(LuaSource("x = p.tile").readsField("tile"));
  EXPECT_TRUE(LuaSource("x = p . tile()").readsField("tile"));
  EXPECT_FALSE(LuaSource("x = { tile = 1 } -- p.tile").readsField("tile"));
  EXPECT_FALSE(LuaSource("x = a..tile").readsField("tile"));
  EXPECT_FALSE(LuaSource("x = 'p.tile'").readsField("tile"));
  EXPECT_FALSE(LuaSource("x = p.tiles").readsField("tile"));
}

}  // namespace place_test
}  // namespace strobe::script
