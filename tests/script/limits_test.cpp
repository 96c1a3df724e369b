// SPDX-License-Identifier: MIT
// A hostile or broken script ends with an error, soon, and has no other effect.
#include <gtest/gtest.h>

#include <algorithm>
#include <future>

#include "base/log.h"
#include "home.h"
#include "script/evaluate.h"

namespace strobe::script {
namespace limits_test {

static const Limits kShort{.cpu_s = 0.3, .wall_s = 4, .memory_mb = 64};
static const Limits kSmall{.cpu_s = 10, .wall_s = 30, .memory_mb = 64};

static std::string failureOf(const TestHome& home, const std::string& name, const std::string& text,
                             const Limits& limits = kShort) {
  home.write("scripts/scenes/" + name + ".lua", text);
  try {
    return "none: " + evaluateScene(home.home(), name, {}, nullptr, limits).dump();
  } catch (const Error& error) {
    return error.what();
  }
}

TEST(Limits, EndlessLoopIsStoppedAtItsLine) {
  TestHome home;
  EXPECT_EQ(failureOf(home, "a", "local x = 1\nwhile true do x = x + 1 end\nreturn {}"),
            "scripts/scenes/a.lua:2: stopped: more than 0.3 s of processor time (the limit for a script); "
            "endless loop?");
  EXPECT_EQ(failureOf(home, "b", "local function f() return f() end\n\nreturn f()").substr(0, 30),
            "scripts/scenes/b.lua:1: stoppe");
}

// No call here returns to a Lua instruction where a count or a hook could stop it.
TEST(Limits, EndlessNativeCallsAreStopped) {
  const char* endless[] = {
      "string.rep('', 1 << 62)",
      "table.move({}, 1, 1 << 60, 2)",
      "string.rep('a', 40000):find(('a*'):rep(30) .. 'b')",
      "table.insert(setmetatable({}, { __len = function() return 1 << 60 end }), 1, 1)",
      "while true do pcall(error) end",
      "local function f() pcall(f) f() end f()",
      "table.concat(setmetatable({}, { __index = function() return '' end }), '', 1, 1 << 60)",
      "while true do pcall(string.rep, 'x', 1 << 30) end",
      ("local m = {} m.__index = function(t, k) return t[k + 1] end local t = setmetatable({}, m) "
       "while true do pcall(function() return t[1] end) end"),
  };
  TestHome home;
  std::vector<std::future<std::string>> answers;
  double begin_s = clockSeconds();
  int number = 0;
  for (const char* text : endless) {
    std::string name = "loop" + std::to_string(number++);
    answers.push_back(std::async(
        std::launch::async, [&home, name, text] { return failureOf(home, name, std::string(text) + "\nreturn {}"); }));
  }
  for (size_t i = 0; i < answers.size(); ++i) {
    std::string answer = answers[i].get();
    std::string file = "scripts/scenes/loop" + std::to_string(i) + ".lua";
    EXPECT_EQ(answer.substr(0, file.size()), file) << endless[i];
    EXPECT_NE(answer.find("(the limit for a script)"), std::string::npos) << endless[i] << " -> " << answer;
    EXPECT_EQ(answer.find('\n'), std::string::npos) << answer;
  }
  EXPECT_LT(clockSeconds() - begin_s, 10);
}

TEST(Limits, MemoryBombIsStopped) {
  TestHome home;
  const char* bombs[] = {
      "local t = {} for i = 1, 1 << 40 do t[i] = { i } end return t",
      "local s = 'x' while true do s = s .. s end",
      "return { string.rep('x', 1 << 30) }",
  };
  int number = 0;
  for (const char* text : bombs) {
    std::string name = "bomb" + std::to_string(number++);
    EXPECT_EQ(failureOf(home, name, text, kSmall),
              "scripts/scenes/" + name + ".lua: stopped: more than 64 MB of memory (the limit for a script)");
  }
#ifndef __SANITIZE_ADDRESS__  // which needs an unlimited address space
  // Converted to data, the nested copies exceed the address space before the script exceeds its heap.
  std::string wide = failureOf(home, "wide", "local a = {} for i = 1, 20 do a = { a, a } end return a", kSmall);
  EXPECT_NE(wide.find("scripts/scenes/wide.lua: "), std::string::npos) << wide;
#endif
}

TEST(Limits, GarbageIsCollectedAtTheLimitWithoutFinalizers) {
  TestHome home;
  const char* text =
      "local ran = 0 setmetatable({}, { __gc = function() ran = ran + 1 end }) "
      "for i = 1, 4e6 do local t = { i } end return { ran = ran }";
  EXPECT_EQ(failureOf(home, "garbage", text, kSmall), "none: {\"ran\":0}");
}

TEST(Limits, DeepRecursionIsAnError) {
  TestHome home;
  std::string deep = failureOf(home, "deep", "local function f() return 1 + f() end\nreturn f()", Limits{});
  EXPECT_EQ(deep.substr(0, 29), "scripts/scenes/deep.lua:1: st") << deep;
  std::string nested = "return " + std::string(300, '{') + std::string(300, '}');
  EXPECT_EQ(failureOf(home, "nested", nested).substr(0, 26), "scripts/scenes/nested.lua:");
}

TEST(Sandbox, HasNoEscape) {
  TestHome home;
  home.write("secret.lua", "return { secret = true }");
  home.write("passes/bytecode.lua", std::string("\x1bLua") + "T");
  struct Attempt {
    const char* text;
    const char* error;
  };
  const Attempt attempts[] = {
      {"return { os.time() }", "unknown global 'os'"},
      {"return { io.open('x') }", "unknown global 'io'"},
      {"return { debug.getinfo(1) }", "unknown global 'debug'"},
      {"return { package.path }", "unknown global 'package'"},
      {"return { load('return 1')() }", "unknown global 'load'"},
      {"return { loadfile('x') }", "unknown global 'loadfile'"},
      {"return { dofile('x') }", "unknown global 'dofile'"},
      {"return { collectgarbage('count') }", "unknown global 'collectgarbage'"},
      {"return { coroutine.create(print) }", "unknown global 'coroutine'"},
      {"return { _G.os }", "unknown global '_G'"},
      {"return { _ENV.os }", "unknown global 'os'"},
      {"return { string.dump(function() end) }", "attempt to call a nil value (field 'dump')"},
      {"return { ('').dump(print) }", "attempt to call a nil value (field 'dump')"},
      {"return { require('../secret') }", "is not the name of a module"},
      {"return { require('secret') }", "unknown module 'secret'"},
      {"return { require('scripts...secret') }", "is not the name of a module"},
      {"return { require('/etc/passwd') }", "is not the name of a module"},
      {"return { require('passes/../secret') }", "is not the name of a module"},
      {"return { require('passes.bytecode') }", "attempt to load a binary chunk"},
      {"return { require('') }", "is not the name of a module"},
      {"x = 1", "global 'x' is assigned but not declared"},
      {"function f() end", "global 'f' is assigned but not declared"},
      {"_ENV.x = 1", "global 'x' is assigned but not declared"},
      {"rawset(_ENV, 'x', 1)", "a global cannot be set"},
      {"setmetatable(_ENV, nil)", "cannot change a protected metatable"},
      {"return { string.format('%p', {}) }", "%p would print an address"},
      {"math.randomseed()", "math.randomseed needs a number"},
      {"for k in pairs({ [{}] = 1 }) do end", "keys of type table have no fixed order"},
      {"error({})", "the error is a table instead of a text"},
      {"error()", "the error is a nil instead of a text"},
      {"error({ problems = 3 })", "the error is a table with a wrong form"},
      {"error({ problems = { { place = 3 } } })", "the error is a table with a wrong form"},
      {"error('two\\nlines\\27[31m')", "two lines [31m"},
  };
  for (const Attempt& attempt : attempts) {
    std::string error = failureOf(home, "escape", attempt.text);
    EXPECT_NE(error.find(attempt.error), std::string::npos) << attempt.text << " -> " << error;
    EXPECT_EQ(error.find("none"), std::string::npos) << attempt.text;
  }
}

TEST(Sandbox, ResultsDoNotDependOnTheProcess) {
  TestHome home;
  home.write("scripts/scenes/order.lua", R"(
local t, seen = {}, {}
for i = 1, 200 do t["k" .. (i * 7919) % 1000] = i end
t[3], t[1.5], t[true] = 1, 2, 3
for k, v in pairs(t) do seen[#seen + 1] = tostring(k) .. "=" .. v end
return { seen = seen, random = { math.random(), math.random(1000) }, address = tostring({}) .. tostring(print),
         text = string.format("%s %s %d", {}, nil, 3), first = next(t), empty = next({}) == nil,
         from = string.format("%5.2f", 1 / 3) }
)");
  std::string first = evaluateScene(home.home(), "order", {}).dump();
  EXPECT_NE(first.find("\"address\":\"tablefunction\""), std::string::npos) << first;
  for (int i = 0; i < 10; ++i) ASSERT_EQ(evaluateScene(home.home(), "order", {}).dump(), first);
}

// Order: false, true, integers and floats by value, texts by bytes. A key removed before its turn is left out.
TEST(Sandbox, PairsHaveAFixedOrder) {
  TestHome home;
  home.write("scripts/scenes/order.lua", R"(
local t = { b = 1, a = 1, B = 1, ["a\0b"] = 1, [true] = 1, [false] = 1, [2] = 1, [1.5] = 1, [-1] = 1,
            [9007199254740993] = 1, [9007199254740992.0] = 1, [math.huge] = 1 }
local seen, gone = {}, { a = 1, b = 2, c = 3 }
for key in pairs(t) do seen[#seen + 1] = type(key) == "string" and #key .. key:sub(1, 1) or tostring(key) end
for key in pairs(gone) do seen[#seen + 1] = key gone.b = nil end
local named = setmetatable({}, { __pairs = function(of) return function(_, i) if i < 2 then return i + 1, "n" end end, of, 0 end })
for i, n in pairs(named) do seen[#seen + 1] = i .. n end
local key, value = next { z = 5, y = 4 }
return { seen = table.concat(seen, " "), first = key .. value }
)");
  Json scene = evaluateScene(home.home(), "order", {});
  EXPECT_EQ(scene["seen"], "false true -1 1.5 2 9007199254740992 9007199254740993 inf 1B 1a 3a 1b a c 1n 2n");
  EXPECT_EQ(scene["first"], "y4");
  EXPECT_EQ(failureOf(home, "none", "pairs(3)"), "scripts/scenes/none.lua:1: pairs needs a table, got number");
  EXPECT_EQ(failureOf(home, "none", "next(3)"), "scripts/scenes/none.lua:1: next needs a table, got number");
}

TEST(Sandbox, ErrorsInsideTheLibraryPointAtTheUsersLine) {
  TestHome home;
  home.write("scripts/pipelines/odd.lua", R"(local pipeline = require "strobe.pipeline"
return pipeline {
  doc = "odd", build = function() local t = setmetatable({}, { __index = function() error("inner", 2) end })
    return t.x
  end,
}
)");
  try {
    evaluatePipeline(home.home(), {"odd", {}});
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "scripts/pipelines/odd.lua:4: inner");
  }
}

TEST(Sandbox, LongFileNamesAreNotShortened) {
  TestHome home;
  std::string folder = "mine/" + std::string(80, 'x');
  home.write(folder + "/scene.lua", "local a = 1\nreturn a.b.c");
  try {
    evaluateScene(home.home(), (home.folder() / folder / "scene.lua").string(), {});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.place().file, folder + "/scene.lua");
    EXPECT_EQ(error.place().line, 2);
  }
}

TEST(Sandbox, ModulesMayNotRequireThemselves) {
  TestHome home;
  home.write("scripts/a.lua", "return require 'scripts.b'");
  home.write("scripts/b.lua", "return require 'scripts.a'");
  EXPECT_EQ(failureOf(home, "x", "return require 'scripts.a'"), "scripts/b.lua:1: module 'scripts.a' requires itself");
}

TEST(Sandbox, OtherProgramsAreRefused) {
  TestHome home;
  home.write("scripts/scenes/x.lua", "return {}");
  for (const char* program : {"/bin/true", "/bin/false", "/bin/echo", "/nonexistent"})
    EXPECT_THROW(evaluateScene(home.home(program), "x", {}), Error) << program;
}

}  // namespace limits_test
}  // namespace strobe::script
