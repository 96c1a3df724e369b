// SPDX-License-Identifier: MIT
#include "plan/without.h"

#include <algorithm>

#include "base/json.h"
#include "base/strict.h"
#include "plan/facts.h"
#include "plan/formats.h"

namespace strobe::plan {
namespace {

const PortDesc* portNamed(const std::vector<PortDesc>& ports, const std::string& name) {
  auto found = std::find_if(ports.begin(), ports.end(), [&](const PortDesc& port) { return port.name == name; });
  return found == ports.end() ? nullptr : &*found;
}

[[noreturn]] void fail(const PassDesc& pass, const Place& place, const std::string& message) {
  throw Error(fmt::format("pass '{}' if_no: {}", pass.name, message), place);
}

// The read that stands in for a write; "" for zeros.
std::string standInOf(const Json& given, const PortDesc& write, const PassDesc& pass, const Place& place) {
  if (given.is_number() && given == 0) return "";
  if (!given.is_string()) fail(pass, place, fmt::format("'{}' is neither 0 nor a read", write.name));
  std::string name = given.get<std::string>();
  const PortDesc* read = portNamed(pass.reads, name);
  if (!read || read->optional) fail(pass, place, fmt::format("'{}' is not a read that is always wired", name));
  bool alike = read->uint == findFormat(write.format)->uint && read->buffer == isBuffer(write.format);
  if (!alike) fail(pass, place, fmt::format("'{}' and '{}' hold different numbers", write.name, name));
  return name;
}

WithoutDesc readOne(const Json& json, const PassDesc& pass) {
  Problems problems(Problems::When::at_once);
  Fields fields(json, fmt::format("pass '{}' if_no", pass.name), pass.place, problems);
  WithoutDesc without;
  without.place = fields.place();
  without.name = fields.text("name", std::nullopt);
  bool known = findFact(without.name) != nullptr || without.name == kReached;
  if (known == (portNamed(pass.reads, without.name) != nullptr))
    fail(pass, without.place, fmt::format("'{}' must be either a fact or a read", without.name));
  const Json& writes = fields.table("writes");
  for (const PortDesc& write : pass.writes) {
    if (!writes.contains(write.name)) fail(pass, without.place, fmt::format("'{}' is missing", write.name));
    without.writes.emplace_back(write.name, standInOf(writes[write.name], write, pass, without.place));
  }
  if (writes.size() != pass.writes.size()) fail(pass, without.place, "'writes' has unknown writes");
  fields.finish();
  return without;
}

}  // namespace

std::vector<WithoutDesc> withoutFromJson(const Json& json, const PassDesc& pass) {
  std::vector<WithoutDesc> all;
  for (const Json& one : json) {
    if (!pass.updates.empty()) fail(pass, pass.place, "a pass with updates cannot have stand-ins");
    all.push_back(readOne(one, pass));
  }
  return all;
}

Json toJson(const WithoutDesc& without) {
  Json json = {{"name", without.name}, {"place", {{"file", without.place.file}, {"line", without.place.line}}}};
  for (const auto& [write, read] : without.writes) json["writes"][write] = read.empty() ? Json(0) : Json(read);
  return json;
}

std::string reasonOf(const WithoutDesc& without) {
  const Fact* fact = findFact(without.name);
  std::vector<std::string> ports;
  for (const auto& [write, read] : without.writes)
    ports.push_back(fmt::format("{} = {}", write, read.empty() ? "0" : read));
  std::string why = fact ? fact->absent : fmt::format("'{}' is 0 everywhere", without.name);
  return fmt::format("{}: {}", why, fmt::join(ports, ", "));
}

}  // namespace strobe::plan
