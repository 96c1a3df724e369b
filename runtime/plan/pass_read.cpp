// SPDX-License-Identifier: MIT
// Checked reading of a pass in the canonical form.
#include <algorithm>

#include "base/json.h"
#include "base/lists.h"
#include "plan/description_reader.h"
#include "plan/facts.h"
#include "plan/formats.h"

namespace strobe::plan {

static constexpr int kMostOfEach = 4096;

namespace {

// ---- reading

PortDesc readRead(const Json& json) {
  Reader reader(json, "read");
  PortDesc port;
  port.place = reader.place();
  port.name = nameOf(reader);
  port.doc = reader.text("doc");
  port.uint = reader.boolean("uint", false);
  port.optional = reader.boolean("optional", false);
  port.linear = reader.boolean("linear", false);
  port.buffer = reader.boolean("buffer", false);
  port.pointwise = reader.boolean("pointwise", false);
  port.needs = reader.texts("needs");
  const Json* absent = reader.find("absent");
  if (absent && absent->is_string()) port.absent_read = reader.text("absent");
  for (const Json& number : port.absent_read.empty() ? reader.list("absent") : Json::array()) {
    if (!number.is_number()) reader.fail("'absent' has an entry that is not a number");
    port.absent.push_back(number.get<double>());
  }
  reader.finish();
  return port;
}

PortDesc readWrite(const Json& json) {
  const std::vector<std::string> formats = namesOf(portFormats());
  Reader reader(json, "write");
  PortDesc port;
  port.place = reader.place();
  port.name = nameOf(reader);
  port.doc = reader.text("doc");
  port.format = formats[reader.oneOf("format", formats)];
  port.format_by = reader.text("format_by");
  port.formats = textsByName(reader, "formats");
  port.each = reader.integer("each", 1, 1, kMostOfEach);
  port.cleared = reader.boolean("cleared", false);
  port.history = reader.boolean("history", false);
  reader.finish();
  return port;
}

CounterDesc readCounter(const Json& json) {
  Reader reader(json, "counter");
  CounterDesc counter{nameOf(reader), reader.text("doc"), reader.text("limit")};
  reader.finish();
  return counter;
}

SizeDesc readSize(const Json& json, const PassDesc& pass) {
  Reader reader(json, fmt::format("size of pass '{}'", pass.name), pass.place);
  SizeDesc size;
  size.kind = static_cast<SizeDesc::Kind>(reader.oneOf("kind", kSizeKinds));
  size.place = reader.place();
  size.port = reader.text("port");
  size.divide = reader.text("divide");
  const auto absent = size.kind == SizeDesc::Kind::Fixed ? std::nullopt : std::optional(0);
  size.width = reader.integer("width", absent, 1, kMaxSide);
  size.height = reader.integer("height", absent, 1, kMaxSide);
  reader.finish();
  return size;
}

WithoutDesc readWithout(const Json& json, const PassDesc& pass) {
  Reader reader(json, fmt::format("pass '{}' if_no", pass.name), pass.place);
  WithoutDesc without;
  without.place = reader.place();
  without.name = reader.text("name", std::nullopt);
  const Json& writes = reader.table("writes");
  for (const PortDesc& write : pass.writes) {
    if (!writes.contains(write.name)) reader.fail(fmt::format("'{}' is missing", write.name));
    const Json& read = writes[write.name];
    const bool zeros = read.is_number() && read == 0;
    if (!zeros && !read.is_string()) reader.fail(fmt::format("'{}' is neither 0 nor a read", write.name));
    without.writes.emplace_back(write.name, zeros ? "" : read.get<std::string>());
  }
  if (writes.size() != pass.writes.size()) reader.fail("'writes' has unknown writes");
  reader.finish();
  return without;
}

// ---- checks

template <class... Args>
[[noreturn]] void fail(const PassDesc& pass, const Place& place, fmt::format_string<Args...> format, Args&&... args) {
  throw Error(fmt::format("pass '{}': {}", pass.name, fmt::format(format, std::forward<Args>(args)...)), place);
}

void refuseTwins(const PassDesc& pass, const std::vector<std::string>& names, const char* what) {
  for (const std::string& name : names)
    if (std::count(names.begin(), names.end(), name) > 1) fail(pass, pass.place, "two {} are named '{}'", what, name);
}

void checkRead(const PassDesc& pass, const PortDesc& read) {
  auto wrong = [&](const std::string& mistake) { fail(pass, read.place, "read '{}' {}", read.name, mistake); };
  if (!read.needs.empty() && !read.optional) wrong("has 'needs', but is always wired");
  for (const std::string& needed : read.needs)
    if (!find(pass.reads, needed)) wrong(fmt::format("needs '{}', which is not a read", needed));
  if (hasAbsent(read) && (!read.optional || read.buffer)) wrong("has 'absent', but is not an optional image");
  if (!read.absent.empty() && read.absent.size() != 4) wrong("has 'absent', which is not four numbers");
  if (read.linear && (read.uint || read.pointwise))
    wrong(fmt::format("is both {} and linear", read.uint ? "uint" : "pointwise"));
  if (read.buffer && !read.uint) wrong("is a buffer, but not of unsigned integers");
  if (read.absent_read.empty()) return;
  const PortDesc* other = find(pass.reads, read.absent_read);
  const bool fits = other && other != &read && !other->buffer && other->uint == read.uint;
  if (!fits || (other->optional && !hasAbsent(*other)))
    wrong(fmt::format("has 'absent' = '{}', which cannot stand in for it", read.absent_read));
}

// Checks a port with `format_by`: it needs a format for each choice, all of the same kind of texels.
void checkFormats(const PassDesc& pass, const PortDesc& port) {
  if (port.format_by.empty() && port.formats.empty()) return;
  auto wrong = [&](const std::string& reason) {
    fail(pass, port.place, "the format of '{}' is chosen by '{}', {}", port.name, port.format_by, reason);
  };
  const ParamDesc* by = find(pass.params, port.format_by);
  if (!by) wrong("which is not a parameter of the pass" + didYouMean(port.format_by, namesOf(pass.params)));
  if (by->type != ParamDesc::Type::Choice) wrong("which is not a choice parameter of the pass");
  if (by->choices.size() != port.formats.size()) wrong("but 'formats' does not have one format for each choice");
  const std::vector<std::string> known = namesOf(portFormats());
  for (const auto& [choice, format] : port.formats) {
    if (!contains(by->choices, choice))
      wrong(fmt::format("which has no choice '{}'{}", choice, didYouMean(choice, by->choices)));
    if (!contains(known, format)) wrong(fmt::format("but format '{}' is unknown{}", format, didYouMean(format, known)));
    if (isUint(format) != isUint(port.format)) wrong("but the formats mix unsigned integers and numbers");
    if (isBuffer(format)) wrong("but the format of a buffer cannot be chosen");
    const bool is_default = Value(choice) == by->default_value;
    if (is_default && format != port.format) wrong(fmt::format("but the format of the default is not {}", port.format));
  }
}

// Checks a write or update. Compute and trace passes write buffers, and buffers are not kept from frame to frame.
void checkOutput(const PassDesc& pass, const PortDesc& port) {
  const bool raster = pass.kind == PassDesc::Kind::Raster;
  checkFormats(pass, port);
  if (port.cleared && raster)
    fail(pass, port.place, "a raster pass writes all of its pixels, so '{}' cannot be 'cleared'", port.name);
  if (isBuffer(port.format)) {
    if (raster) fail(pass, port.place, "a raster pass writes images; '{}' is a buffer", port.name);
    if (port.history) fail(pass, port.place, "'{}' is a buffer, which is not kept from frame to frame", port.name);
  } else if (port.each != 1) {
    fail(pass, port.place, "'{}' is an image, so 'each' must be 1", port.name);
  }
}

void checkSize(const PassDesc& pass) {
  const SizeDesc& size = pass.size;
  if (size.kind != SizeDesc::Kind::Port) return;
  const PortDesc* port = find(pass.reads, size.port);
  if (!port || port->optional)
    fail(pass, size.place, "its size is of '{}', which is not a read that is always wired", size.port);
  if (size.divide.empty()) return;
  const ParamDesc* divide = find(pass.params, size.divide);
  const bool positive = divide && divide->type == ParamDesc::Type::Int && divide->min && *divide->min >= 1;
  if (!positive)
    fail(pass, size.place, "its size is divided by '{}', which is not an integer parameter of at least 1", size.divide);
}

// Checks the conditions on a pass that runs over the entries of a buffer.
void checkOver(const PassDesc& pass) {
  if (pass.over.empty()) return;
  const PortDesc* list = find(pass.reads, pass.over);
  if (!list || !list->buffer) fail(pass, pass.place, "it runs over '{}', which is not a read with a buffer", pass.over);
  if (pass.kind == PassDesc::Kind::Raster)
    fail(pass, pass.place, "a raster pass runs over triangles, so it cannot have 'over'");
  for (const PortDesc& write : pass.writes)
    if (!isCleared(write))
      fail(pass, write.place, "it runs over '{}', but its write '{}' is not cleared", pass.over, write.name);
}

// Checks the conditions on a pass with one work group per pixel.
void checkGroup(const PassDesc& pass) {
  if (!pass.group) return;
  if (pass.kind != PassDesc::Kind::Compute)
    fail(pass, pass.place, "only compute passes can have a group for each pixel");
  if (!pass.over.empty()) fail(pass, pass.place, "a pass with a group for each pixel cannot run over '{}'", pass.over);
  for (const ParamDesc& param : pass.params)
    if (param.role == Role::StillOnce)
      fail(pass, param.place, "a pass with a group for each pixel cannot have a parameter with the role 'static_once'");
}

void checkWithout(const PassDesc& pass, const WithoutDesc& without) {
  auto wrong = [&](const std::string& mistake) {
    throw Error(fmt::format("pass '{}' if_no: {}", pass.name, mistake), without.place);
  };
  if (!pass.updates.empty()) wrong("a pass with updates cannot have stand-ins");
  const bool is_fact = findFact(without.name) || without.name == kMovingRect;
  if (is_fact == (find(pass.reads, without.name) != nullptr))
    wrong(fmt::format("'{}' must be either a fact or a read", without.name));
  for (size_t i = 0; i < pass.writes.size(); ++i) {
    const PortDesc& write = pass.writes[i];
    if (i >= without.writes.size() || without.writes[i].first != write.name)
      wrong(fmt::format("'{}' is missing", write.name));
    const std::string& name = without.writes[i].second;
    if (name.empty()) continue;
    const PortDesc* read = find(pass.reads, name);
    if (!read || read->optional) wrong(fmt::format("'{}' is not a read that is always wired", name));
    if (read->uint != isUint(write.format) || read->buffer != isBuffer(write.format))
      wrong(fmt::format("'{}' and '{}' hold different numbers", write.name, name));
  }
}

bool isShaderPath(const std::string& shader) {
  const char* allowed = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./";
  bool plain = !shader.empty() && shader[0] != '/' && shader.find_first_not_of(allowed) == std::string::npos;
  return plain && shader.find("..") == std::string::npos;
}

}  // namespace

void checkPass(const PassDesc& pass) {
  if (!isShaderPath(pass.shader)) fail(pass, pass.place, "'{}' is not a path below shaders/", pass.shader);
  if (outputsOf(pass).empty()) fail(pass, pass.place, "it writes nothing");
  if (!pass.updates.empty() && pass.kind == PassDesc::Kind::Raster)
    fail(pass, pass.place, "a raster pass has updates; only compute and trace passes can");
  refuseTwins(pass, outputsOf(pass), "writes");
  refuseTwins(pass, namesOf(pass.reads), "reads");
  refuseTwins(pass, namesOf(pass.params), "parameters");
  refuseTwins(pass, namesOf(pass.counters), "counters");
  for (const PortDesc& read : pass.reads) checkRead(pass, read);
  checkOver(pass);
  checkGroup(pass);
  for (const auto* ports : {&pass.writes, &pass.updates})
    for (const PortDesc& port : *ports) checkOutput(pass, port);
  checkSize(pass);
  for (const WithoutDesc& without : pass.without) checkWithout(pass, without);
}

PassDesc passFromJson(const Json& json) {
  Reader reader(json, "pass");
  PassDesc pass;
  pass.place = reader.place();
  pass.name = reader.text("name", std::nullopt);
  if (!isPath(pass.name)) reader.fail(fmt::format("'{}' is not the name of a pass", pass.name));
  pass.kind = static_cast<PassDesc::Kind>(reader.oneOf("kind", kPassKinds));
  pass.shader = reader.text("shader", std::nullopt);
  pass.doc = reader.text("doc");
  pass.fails = reader.text("fails");
  if (reader.has("breaks")) pass.breaks = breaksOf(reader, reader.table("breaks"));
  pass.size = readSize(reader.at("size"), pass);
  pass.over = reader.text("over");
  pass.group = reader.boolean("group", false);
  pass.scene = reader.boolean("scene", false);
  pass.reads = itemsOf(reader.list("reads"), readRead);
  pass.writes = itemsOf(reader.list("writes"), readWrite);
  pass.updates = itemsOf(reader.list("updates"), readWrite);
  pass.params = itemsOf(reader.list("params"), readParam);
  pass.counters = itemsOf(reader.list("counters"), readCounter);
  pass.without = itemsOf(reader.list("without"), [&](const Json& without) { return readWithout(without, pass); });
  reader.finish();
  checkPass(pass);
  return pass;
}

}  // namespace strobe::plan
