// SPDX-License-Identifier: MIT
// Content of scripts and shaders without their comments and help texts.
#include "base/inputs.h"

#include <gtest/gtest.h>

#include "common/temporary_folder.h"

namespace strobe {
namespace inputs_test {

std::string lua(const std::string& text) { return withoutComments(text, Language::lua); }
std::string glsl(const std::string& text) { return withoutComments(text, Language::glsl); }

TEST(Inputs, RemoveLuaComments) {
  EXPECT_EQ(lua("a = 1 -- one\nb"), "a = 1  \nb");
  EXPECT_EQ(lua("a --[[ two\nlines ]] b"), "a   b");
  EXPECT_EQ(lua("a --[=[ ]] ]=] b"), "a   b");
  EXPECT_EQ(lua("a --[ b\nc"), "a  \nc");
  for (const char* strings : {"'--'", "\"--\"", "'\\'--'", "[[--]]", "[=[ ]] -- ]=]", "a[b[1]]", "a // b", "a - -b"})
    EXPECT_EQ(lua(strings), strings);
  EXPECT_EQ(lua("'a' -- 'b'"), "'a'  ");
}

TEST(Inputs, RemoveLuaHelpTexts) {
  EXPECT_EQ(lua("{ doc = \"one\", max = 2 }"), "{  , max = 2 }");
  EXPECT_EQ(lua("{ fails='one' ..\n  [[two]], 3 }"), "{  , 3 }");
  EXPECT_EQ(lua("doc = 'one' .. x"), "  .. x");
  for (const char* kept : {"doc = text", "doc == 'one'", "doc('one')", "undoc = 'one'", "a_doc = 'one'",
                           "\"doc='one'\"", "doc", "doc =", "docs = 'one'"})
    EXPECT_EQ(lua(kept), kept);
}

// A string of three words or more is text for people. Strings joined to it by ".." are removed with it.
TEST(Inputs, RemoveLuaProse) {
  EXPECT_EQ(lua("refuse(path, 'has no name', x)"), "refuse(path,  , x)");
  EXPECT_EQ(lua("{ 'one' ..\n 'two of three' .. x }"), "{   .. x }");
  EXPECT_EQ(lua("values = { sky = \"The sky alone\" }"), "values = { sky =   }");
  for (const char* kept : {"name = 'McGuire 2012'", "{ 'one' .. 'two three' }", "[[ int a = 1; ]]", "a[b .. 'c d']"})
    EXPECT_EQ(lua(kept), kept);
}

TEST(Inputs, RemoveGlslComments) {
  EXPECT_EQ(glsl("a / b; // one\nc"), "a / b;  \nc");
  EXPECT_EQ(glsl("a /* two\nlines */ b"), "a   b");
  EXPECT_EQ(glsl("a -- b"), "a -- b");
}

TEST(Inputs, HashFilesByTheirInputs) {
  testing::TemporaryFolder folder;
  auto hash = [&](const std::string& name, const std::string& text) {
    writeFileAtomically(folder / name, text);
    return inputHash(folder / name);
  };
  const std::string plain = hash("a.glsl", "float a;\nfloat b;\n");
  EXPECT_EQ(hash("b.glsl", "// Two numbers.\n\nfloat a;  // one \t\r\nfloat b;"), plain);
  EXPECT_EQ(hash("b.h", "float a;\n/* */\nfloat b;\n"), plain);
  EXPECT_NE(hash("b.glsl", "float a;\nfloat c;\n"), plain);
  EXPECT_NE(hash("b.glsl", "float a; float b;\n"), plain);
  const std::string call = hash("a.lua", "return f(a, 'one', b)");
  EXPECT_EQ(hash("b.lua", "-- Calls f.\nreturn f(a,  -- one\n         'one',\tb)\n"), call) << "wrapped";
  EXPECT_EQ(hash("b.lua", "return f( a , 'one' ,b)"), call);
  EXPECT_NE(hash("b.lua", "returnf(a, 'one', b)"), call);
  EXPECT_NE(hash("b.lua", "return f(a, 'two', b)"), call);
  EXPECT_EQ(hash("c.txt", "abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad") << "FIPS 180-4";
  EXPECT_NE(hash("c.txt", "abc // d"), hash("c.txt", "abc // e"));
  EXPECT_THROW(inputHash(folder / "missing.lua"), Error);
}

}  // namespace inputs_test
}  // namespace strobe
