// SPDX-License-Identifier: MIT
#include "base/json_text.h"

#include <gtest/gtest.h>

#include "base/json.h"

namespace strobe {
namespace json_text_test {

TEST(JsonText, EqualsTheLibrarysParse) {
  const char* texts[] = {"{}",
                         "[]",
                         "null",
                         " -1.5e3 ",
                         "18446744073709551615",
                         R"({"b": [1, -2, [], {"a": null}, {}], "a": {"z": "\u00e9\n", "y": [true, false]}, "": 0.1})",
                         R"([[[[{"deep": [{"er": []}]}]]]])"};
  for (const char* text : texts) {
    EXPECT_EQ(jsonFromText(text).dump(), Json::parse(text).dump()) << text;
    EXPECT_EQ(jsonFromText(text), Json::parse(text)) << text;
  }
}

TEST(JsonText, InvalidTextIsDiscarded) {
  for (const char* text : {"", "{", "[1,", "{\"a\" 1}", "[] []", "nul", "\"\xff\"", "1e999", "{\"a\": 1}}"})
    EXPECT_TRUE(jsonFromText(text).is_discarded()) << text;
}

TEST(JsonText, FirstOfTwoEqualKeysCounts) { EXPECT_EQ(jsonFromText(R"({"a": 1, "a": 2})").at("a"), 1); }

}  // namespace json_text_test
}  // namespace strobe
