// SPDX-License-Identifier: MIT
#include "script/lua_text.h"

#include <algorithm>
#include <cctype>
#include <set>

#include "base/json.h"

namespace strobe::script {

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (char c : text) {
    if (c == '"' || c == '\\' || c == '\n') result += '\\';  // a newline after a backslash stays a newline
    if (c == '\r') result += "\\r";
    else result += c;
  }
  return result + "\"";
}

std::string luaOf(const plan::Value& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return quoted(*text);
  return plan::textOf(value);
}

std::string luaOf(const Json& json) {
  if (json.is_string()) return quoted(json.get<std::string>());
  if (!json.is_array()) return json.dump();
  std::string list;
  for (const Json& one : json) list += fmt::format("{}{}", list.empty() ? "" : ", ", luaOf(one));
  return fmt::format("{{ {} }}", list);
}

static std::string keyOf(const std::string& name) {
  static const std::set<std::string> words = {"and",      "break",  "do",   "else", "elseif", "end",  "false", "for",
                                              "function", "goto",   "if",   "in",   "local",  "nil",  "not",   "or",
                                              "repeat",   "return", "then", "true", "until",  "while"};
  bool plain = !name.empty() && !words.count(name) && !std::isdigit(static_cast<unsigned char>(name[0])) &&
               std::all_of(name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) || c == '_'; });
  return plain ? name : fmt::format("[{}]", quoted(name));
}

std::string tableOf(const std::vector<std::string>& fields) { return fmt::format("{{ {} }}", fmt::join(fields, ", ")); }

std::string field(const std::string& name, const std::string& text) { return keyOf(name) + " = " + text; }

}  // namespace strobe::script
