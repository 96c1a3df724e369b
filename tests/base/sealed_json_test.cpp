// SPDX-License-Identifier: MIT
// Damage to a sealed file never yields another object.
#include "base/sealed_json.h"

#include <gtest/gtest.h>

#include "base/json.h"

namespace strobe {
namespace sealed_json_test {

TEST(SealedJson, YieldsTheObjectOrNothing) {
  const Json object = {
      {"title", "A \"title\", ä"}, {"values", {{"rmse", 0.1}, {"n", -3}}}, {"list", {1.5, nullptr, true}}};
  const std::string text = sealed(object);
  ASSERT_TRUE(unsealed(text));
  EXPECT_EQ(unsealed(text)->dump(), object.dump());
  for (size_t i = 0; i < text.size(); ++i) {
    EXPECT_FALSE(i + 1 < text.size() && unsealed(text.substr(0, i))) << "cut at " << i;
    for (int bit = 0; bit < 8; ++bit) {
      std::string altered = text;
      altered[i] = char(altered[i] ^ 1 << bit);
      std::optional<Json> read = unsealed(altered);
      EXPECT_TRUE(!read || read->dump() == object.dump()) << "byte " << i << ", bit " << bit;
    }
  }
  for (const char* other : {"", "[]", "{}", "null", "3", "{\"sum\": 3}", "{\"sum\": \"\"}"})
    EXPECT_FALSE(unsealed(other)) << other;
}

}  // namespace sealed_json_test
}  // namespace strobe
