// SPDX-License-Identifier: MIT
// Checked reading of a pass in the canonical form.
#include <algorithm>

#include "base/json.h"
#include "plan/description_reader.h"
#include "plan/description_words.h"
#include "plan/formats.h"
#include "plan/without.h"

namespace strobe::plan {

static constexpr int kMaxSide = 32768;
static constexpr int kMostOfEach = 4096;

namespace {

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
  if (reader.has("absent") && reader.at("absent").is_string()) port.absent_read = reader.text("absent");
  else if (reader.has("absent")) port.absent = reader.at("absent").get<std::vector<double>>();
  reader.finish();
  return port;
}

void checkAbsent(const PortDesc& read, const PassDesc& pass, const Reader& reader) {
  const bool is_given = !read.absent.empty() || !read.absent_read.empty();
  if (is_given && (!read.optional || read.buffer))
    reader.fail(fmt::format("read '{}' has 'absent', but is not an optional image", read.name));
  if (!read.absent.empty() && read.absent.size() != 4)
    reader.fail(fmt::format("'absent' of read '{}' is not four numbers", read.name));
  const PortDesc* other = find(pass.reads, read.absent_read);
  if (read.absent_read.empty()) return;
  if (!other || other == &read || other->buffer || other->uint != read.uint || (other->optional && !hasAbsent(*other)))
    reader.fail(
        fmt::format("'absent' of read '{}' is '{}', which cannot stand in for it", read.name, read.absent_read));
}

void checkNeeds(const PortDesc& read, const PassDesc& pass, const Reader& reader) {
  if (!read.needs.empty() && !read.optional)
    reader.fail(fmt::format("read '{}' has 'needs', but is always wired", read.name));
  for (const std::string& needed : read.needs)
    if (!find(pass.reads, needed))
      reader.fail(fmt::format("read '{}' needs '{}', which is not a read", read.name, needed));
}

PortDesc readWrite(const Json& json) {
  Reader reader(json, "write");
  PortDesc port;
  port.place = reader.place();
  port.name = nameOf(reader);
  port.doc = reader.text("doc");
  port.format = formatNames()[reader.oneOf("format", formatNames())];
  port.format_by = reader.text("format_by");
  port.formats = choiceTexts(reader, "formats");
  port.each = reader.integer("each", 1, 1, kMostOfEach);
  port.cleared = reader.boolean("cleared", false);
  port.history = reader.boolean("history", false);
  reader.finish();
  return port;
}

// Checks a port with `format_by`: it needs a format for each choice, all of the same kind of texels.
void checkFormats(const Reader& reader, const PortDesc& port, const PassDesc& pass) {
  if (port.format_by.empty() && port.formats.empty()) return;
  auto wrong = [&](const std::string& reason) {
    reader.fail(fmt::format("the format of '{}' is chosen by '{}', {}", port.name, port.format_by, reason));
  };
  const ParamDesc* by = find(pass.params, port.format_by);
  if (!by || by->type != ParamDesc::Type::Choice) wrong("which is not a choice parameter of the pass");
  if (by->choices.size() != port.formats.size()) wrong("but 'formats' does not have one format for each choice");
  for (const auto& [choice, format] : port.formats) {
    bool is_choice = std::find(by->choices.begin(), by->choices.end(), choice) != by->choices.end();
    if (!is_choice) wrong(fmt::format("which has no choice '{}'{}", choice, didYouMean(choice, by->choices)));
    bool known = std::find(formatNames().begin(), formatNames().end(), format) != formatNames().end();
    if (!known) wrong(fmt::format("but format '{}' is unknown{}", format, didYouMean(format, formatNames())));
    if (isUint(format) != isUint(port.format)) wrong("but the formats mix unsigned integers and numbers");
    if (isBuffer(format)) wrong("but the format of a buffer cannot be chosen");
    bool is_default = Value(choice) == by->default_value;
    if (is_default && format != port.format) wrong(fmt::format("but the format of the default is not {}", port.format));
  }
}

CounterDesc readCounter(const Json& json) {
  Reader reader(json, "counter");
  CounterDesc counter{nameOf(reader), reader.text("doc"), reader.text("limit")};
  reader.finish();
  return counter;
}

SizeDesc readSize(const Json& json, const PassDesc& pass) {
  Reader reader(json, fmt::format("size of pass '{}'", pass.name), pass.place);
  for (const char* key : {"kind", "port", "divide", "width", "height"}) reader.allow(key);  // keys depend on the kind
  reader.finish();
  SizeDesc size;
  size.kind = static_cast<SizeDesc::Kind>(reader.oneOf("kind", kSizeKinds));
  size.place = reader.place();
  if (size.kind == SizeDesc::Kind::Fixed) {
    size.width = reader.integer("width", std::nullopt, 1, kMaxSide);
    size.height = reader.integer("height", std::nullopt, 1, kMaxSide);
  }
  if (size.kind != SizeDesc::Kind::Port) return size;

  size.port = reader.text("port", std::nullopt);
  const PortDesc* port = find(pass.reads, size.port);
  if (!port || port->optional) reader.fail(fmt::format("'{}' is not a read that is always wired", size.port));
  size.divide = reader.text("divide");
  if (size.divide.empty()) return size;
  const ParamDesc* divide = find(pass.params, size.divide);
  bool positive = divide && divide->type == ParamDesc::Type::Int && divide->min && *divide->min >= 1;
  if (!positive) reader.fail(fmt::format("'{}' is not an integer parameter of at least 1", size.divide));
  return size;
}

// Checks the conditions on a pass that runs over the entries of a buffer.
void checkOver(const Reader& reader, const PassDesc& pass) {
  if (pass.over.empty()) return;
  const PortDesc* list = find(pass.reads, pass.over);
  if (!list || !list->buffer)
    reader.fail(fmt::format("it runs over '{}', which is not a read with a buffer", pass.over));
  if (pass.kind == PassDesc::Kind::Raster) reader.fail("a raster pass runs over triangles, so it cannot have 'over'");
  for (const PortDesc& write : pass.writes)
    if (!isCleared(write))
      reader.fail(fmt::format("it runs over '{}', but its write '{}' is not cleared", pass.over, write.name));
}

// Checks the conditions on a pass with one work group per pixel.
void checkGroup(const Reader& reader, const PassDesc& pass) {
  if (!pass.group) return;
  if (pass.kind != PassDesc::Kind::Compute) reader.fail("only compute passes can have a group for each pixel");
  if (!pass.over.empty())
    reader.fail(fmt::format("a pass with a group for each pixel cannot run over '{}'", pass.over));
  for (const ParamDesc& param : pass.params)
    if (param.role == Role::StillOnce)
      reader.fail("a pass with a group for each pixel cannot have a parameter with the role 'static_once'");
}

// Checks buffers: compute and trace passes write them, and their contents are not kept from frame to frame.
void checkBuffers(const Reader& reader, const PassDesc& pass) {
  for (const PortDesc& read : pass.reads)
    if (read.buffer && !read.uint)
      reader.fail(fmt::format("read '{}' is a buffer, but not of unsigned integers", read.name));
  for (const auto* ports : {&pass.writes, &pass.updates})
    for (const PortDesc& port : *ports) {
      if (!isBuffer(port.format)) {
        if (port.each != 1) reader.fail(fmt::format("'{}' is an image, so 'each' must be 1", port.name));
        continue;
      }
      if (pass.kind == PassDesc::Kind::Raster)
        reader.fail(fmt::format("a raster pass writes images; '{}' is a buffer", port.name));
      if (port.history) reader.fail(fmt::format("'{}' is a buffer, which is not kept from frame to frame", port.name));
    }
}

void checkShaderPath(const Reader& reader, const std::string& shader) {
  const char* allowed = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./";
  bool plain = !shader.empty() && shader[0] != '/' && shader.find_first_not_of(allowed) == std::string::npos;
  bool climbs = shader.find("..") != std::string::npos;
  if (!plain || climbs) reader.fail(fmt::format("'{}' is not a path below shaders/", shader));
}

}  // namespace

PassDesc passFromJson(const Json& json) {
  Reader reader(json, "pass");
  PassDesc pass;
  pass.place = reader.place();
  pass.name = reader.text("name", std::nullopt);
  if (!isPath(pass.name)) reader.fail(fmt::format("'{}' is not the name of a pass", pass.name));
  pass.kind = static_cast<PassDesc::Kind>(reader.oneOf("kind", kPassKinds));
  pass.shader = reader.text("shader", std::nullopt);
  checkShaderPath(reader, pass.shader);
  pass.doc = reader.text("doc");
  pass.fails = reader.text("fails");
  if (reader.has("breaks")) pass.breaks = breaksOf(reader, reader.table("breaks"));
  pass.scene = reader.boolean("scene", false);
  pass.reads = itemsOf(reader.list("reads"), readRead);
  for (const PortDesc& read : pass.reads) checkNeeds(read, pass, reader), checkAbsent(read, pass, reader);
  pass.writes = itemsOf(reader.list("writes"), readWrite);
  pass.updates = itemsOf(reader.list("updates"), readWrite);
  bool cleared = std::any_of(pass.writes.begin(), pass.writes.end(), [](const PortDesc& port) { return port.cleared; });
  if (cleared && pass.kind == PassDesc::Kind::Raster)
    reader.fail("a raster pass writes all of its pixels, so its writes cannot be 'cleared'");
  pass.params = itemsOf(reader.list("params"), readParam);
  pass.counters = itemsOf(reader.list("counters"), readCounter);
  pass.size = readSize(reader.at("size"), pass);
  pass.over = reader.text("over");
  checkOver(reader, pass);
  pass.group = reader.boolean("group", false);
  checkGroup(reader, pass);
  checkBuffers(reader, pass);

  std::vector<PortDesc> outputs = pass.writes;
  outputs.insert(outputs.end(), pass.updates.begin(), pass.updates.end());
  if (outputs.empty()) reader.fail(fmt::format("'{}' writes nothing", pass.name));
  refuseTwins(outputs, reader, "writes");
  for (const PortDesc& port : outputs) checkFormats(reader, port, pass);
  refuseTwins(pass.reads, reader, "reads");
  refuseTwins(pass.params, reader, "parameters");
  refuseTwins(pass.counters, reader, "counters");
  pass.without = withoutFromJson(reader.list("without"), pass);
  reader.finish();
  return pass;
}

}  // namespace strobe::plan
