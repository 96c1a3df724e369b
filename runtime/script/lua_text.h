// SPDX-License-Identifier: MIT
// Values in the syntax of Lua, for scripts that the program writes.
#pragma once

#include <string>
#include <vector>

#include "base/json_fwd.h"
#include "plan/description.h"

namespace strobe::script {

std::string quoted(const std::string& text);
std::string luaOf(const plan::Value& value);
std::string luaOf(const Json& json);  // numbers, texts and lists of both

// "NAME = TEXT"; the name is in brackets if Lua needs them.
std::string field(const std::string& name, const std::string& text);
// "{ a = 1, b = 2 }".
std::string tableOf(const std::vector<std::string>& fields);

}  // namespace strobe::script
