// SPDX-License-Identifier: MIT
#include "page/templates.h"

#include <algorithm>
#include <kainjow/mustache.hpp>

#include "base/error.h"
#include "base/json.h"
#include "page/markup.h"

namespace strobe::page {

namespace mustache = kainjow::mustache;

std::string_view asset(std::string_view name) {
  for (const auto& [file, content] : embeddedFiles())
    if (file == name) return content;
  assertFailed("asset", __FILE__, __LINE__, std::string(name));
}

namespace {

mustache::data dataOf(const Json& value) {
  if (value.is_object()) {
    mustache::data object;
    for (const auto& [name, member] : value.items()) object.set(name, dataOf(member));
    return object;
  }
  if (value.is_array()) {
    mustache::data list{mustache::data::type::list};
    for (const Json& element : value) list.push_back(dataOf(element));
    return list;
  }
  if (value.is_string() && !value.get_ref<const std::string&>().empty()) return value.get_ref<const std::string&>();
  if (value.is_number_integer()) return std::to_string(value.get<int64_t>());
  if (value.is_number()) return fmt::format("{}", value.get<double>());
  return value.is_boolean() && value.get<bool>();
}

}  // namespace

std::string rendered(std::string_view name, const Json& values) {
  mustache::mustache page{std::string(asset(name))};
  STROBE_ASSERT(page.is_valid(), "{}: {}", name, page.error_message());
  page.set_custom_escape([](const std::string& text) { return escaped(text); });
  std::string text = page.render(dataOf(values));
  STROBE_ASSERT(page.is_valid(), "{}: {}", name, page.error_message());
  return text;
}

}  // namespace strobe::page
