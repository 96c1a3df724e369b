// SPDX-License-Identifier: MIT
#include "base/sealed_json.h"

#include "base/hash.h"
#include "base/json.h"

namespace strobe {

static constexpr const char* kSum = "sum";

std::string sealed(Json object) {
  object[kSum] = hashText(object.dump());
  return object.dump(1) + "\n";
}

std::optional<Json> unsealed(const std::string& text) {
  Json object = Json::parse(text, nullptr, false);
  if (!object.is_object() || !object.contains(kSum)) return std::nullopt;
  Json sum = object[kSum];
  object.erase(kSum);
  if (sum != hashText(object.dump())) return std::nullopt;
  return object;
}

}  // namespace strobe
