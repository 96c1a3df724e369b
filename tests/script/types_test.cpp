// SPDX-License-Identifier: MIT
// The editor's declarations name exactly the fields that the checks accept.
#include <gtest/gtest.h>

#include <map>
#include <set>
#include <sstream>

#include "common/source.h"
#include "home.h"
#include "plan/facts.h"
#include "plan/formats.h"
#include "plan/named.h"
#include "script/evaluate.h"

namespace strobe::script {
namespace types_test {

// Fields by class, from lines like "---@field name? type"; "[1]?" is "1".
static std::map<std::string, std::set<std::string>> declaredFields() {
  std::map<std::string, std::set<std::string>> fields;
  std::istringstream lines(readText(sourceFolder() / "scripts/types.lua"));
  std::string line, owner;
  while (std::getline(lines, line)) {
    std::istringstream words(line);
    std::string tag, name;
    words >> tag >> name;
    if (tag == "---@class") owner = name;
    if (tag != "---@field") continue;
    std::erase_if(name, [](char c) { return c == '?' || c == '[' || c == ']'; });
    fields[owner].insert(name);
  }
  return fields;
}

TEST(Types, NameTheFieldsThatTheChecksAccept) {
  TestHome home;
  home.write("x/keys.lua", R"(
local param, pass, pipeline = require "strobe.param", require "strobe.pass", require "strobe.pipeline"
local keys = { ParamTable = param.keys.float, ChoiceTable = param.keys.choice, Read = pass.read_keys,
               Write = pass.write_keys, Update = pass.update_keys, Size = pass.size_keys, Counter = pass.counter_keys,
               ChosenFormat = pass.format_keys, PassTable = pass.keys, CallTable = pass.call_keys,
               PipelineTable = pipeline.keys, LoopTable = pipeline.loop_keys, EqualTable = pipeline.equal_keys,
               PartsTable = require("strobe.parts").loop_keys, Preset = require("strobe.preset").keys }
local result = {}
for class, list in pairs(keys) do
  local names = {}
  for i, key in ipairs(list) do names[i] = tostring(key) end
  result[class] = names
end
return result
)");
  Json accepted = evaluateData(home.home(), (home.folder() / "x/keys.lua").string());
  std::map<std::string, std::set<std::string>> declared = declaredFields();
  for (const auto& [name, keys] : accepted.items()) {
    std::set<std::string> fields = declared["strobe." + name];
    fields.erase("integer");  // [integer] and [string] stand for lists and for names of the user's own
    fields.erase("string");
    EXPECT_EQ(fields, keys.get<std::set<std::string>>()) << name;
  }
}

TEST(Types, NameInvariantsFactsRolesAndFormats) {
  std::string types = readText(sourceFolder() / "scripts/types.lua");
  for (const auto& names :
       {plan::invariantNames(), plan::namesOf(plan::facts()), plan::roleNames(), plan::namesOf(plan::portFormats())})
    for (const std::string& name : names) EXPECT_NE(types.find("\"" + name + "\""), std::string::npos) << name;
}

}  // namespace types_test
}  // namespace strobe::script
