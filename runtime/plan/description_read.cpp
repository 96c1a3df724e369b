// SPDX-License-Identifier: MIT
// The canonical form back to descriptions, trusting nothing.
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "base/strict.h"
#include "plan/description.h"
#include "plan/description_words.h"
#include "plan/formats.h"
#include "plan/without.h"

namespace strobe::plan {

static constexpr int kMaxSide = 32768;
static constexpr int kMostOfEach = 4096;

namespace {

Problems& thrownAtOnce() {
  static Problems problems(Problems::When::at_once);
  return problems;
}

// A table of the canonical form; the first mistake is thrown. `what` names it in errors ("pass 'x'").
class Reader : public Fields {
 public:
  Reader(const Json& json, std::string what, const Place& outer = {})
      : Fields(json, std::move(what), outer, thrownAtOnce()) {}

  const Json& at(const char* key) { return *need(key); }

  std::optional<double> number(const char* key) {
    constexpr double kMost = std::numeric_limits<double>::max();
    return has(key) ? std::optional(Fields::number(key, std::nullopt, -kMost, kMost)) : std::nullopt;
  }

  size_t oneOf(const char* key, const std::vector<std::string>& names) {
    std::string name = choice(key, std::nullopt, names);
    return static_cast<size_t>(std::find(names.begin(), names.end(), name) - names.begin());
  }

  [[noreturn]] void fail(const std::string& message) const { throw Error(what() + ": " + message, place()); }
};

bool isName(const std::string& name) {
  bool starts = !name.empty() && name.size() <= 64 && name[0] >= 'a' && name[0] <= 'z';
  return starts && name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") == std::string::npos;
}

std::string nameOf(Reader& reader) {
  std::string name = reader.text("name", std::nullopt);
  if (!isName(name)) reader.fail(fmt::format("'{}' is not a name (a-z, then a-z, 0-9 and _)", name));
  return name;
}

template <class Item>
std::vector<std::string> namesOf(const std::vector<Item>& items) {
  std::vector<std::string> names;
  for (const Item& item : items) names.push_back(item.name);
  return names;
}

template <class Item>
const Item* find(const std::vector<Item>& items, const std::string& name) {
  auto found = std::find_if(items.begin(), items.end(), [&](const Item& item) { return item.name == name; });
  return found == items.end() ? nullptr : &*found;
}

template <class Item>
void refuseTwins(const std::vector<Item>& items, const Reader& reader, const char* what) {
  std::set<std::string> seen;
  for (const Item& item : items) {
    if (!seen.insert(item.name).second) reader.fail(fmt::format("two {} are named '{}'", what, item.name));
  }
}

// `json` holds no other kind of entry than `read` accepts.
template <class Read>
auto itemsOf(const Json& json, Read read) {
  std::vector<decltype(read(json))> items;
  for (const Json& entry : json) items.push_back(read(entry));
  return items;
}

// A text for each of some choices.
std::vector<std::pair<std::string, std::string>> choiceTexts(Reader& reader, const char* key) {
  std::vector<std::pair<std::string, std::string>> texts;
  for (const auto& [name, text] : reader.table(key).items()) {
    if (!text.is_string()) reader.fail(fmt::format("'{}' has something else than a text for a choice", key));
    texts.emplace_back(name, text.get<std::string>());
  }
  return texts;
}

Breaks breaksOf(const Reader& reader, const Json& json) {
  if (!json.is_object()) reader.fail("'breaks' is no table of invariants");
  Breaks breaks;
  for (const auto& [invariant, reason] : json.items()) {
    const auto& known = invariantNames();
    bool is_known = std::find(known.begin(), known.end(), invariant) != known.end();
    if (!is_known) reader.fail(fmt::format("there is no invariant '{}'{}", invariant, didYouMean(invariant, known)));
    if (!reason.is_string()) reader.fail(fmt::format("the reason that '{}' is broken is not a text", invariant));
    breaks.emplace_back(invariant, reason.get<std::string>());
  }
  return breaks;
}

// By value of a parameter.
std::vector<std::pair<std::string, Breaks>> valueBreaks(Reader& reader, const ParamDesc& param) {
  std::vector<std::pair<std::string, Breaks>> result;
  if (!reader.has("breaks")) return result;
  for (const auto& [value, breaks] : reader.table("breaks").items()) {
    bool is_number = param.type == ParamDesc::Type::Int || param.type == ParamDesc::Type::Float;
    if (is_number && value != kOtherNumbers)
      reader.fail(fmt::format("'breaks' of '{}' is about '{}'; of a number it is about '{}'", param.name, value,
                              kOtherNumbers));
    if (!is_number) checkValue(param, Value(value), param.place);
    result.emplace_back(value, breaksOf(reader, breaks));
  }
  return result;
}

ParamDesc readParam(const Json& json) {
  Reader reader(json, "parameter");
  ParamDesc param;
  param.place = reader.place();
  param.name = nameOf(reader);
  param.type = static_cast<ParamDesc::Type>(reader.oneOf("type", kParamTypes));
  param.min = reader.number("min");
  param.max = reader.number("max");
  bool crossed = param.min && param.max && *param.min > *param.max;
  if (crossed) reader.fail(fmt::format("min of '{}' is above max", param.name));
  param.choices = reader.texts("choices");
  param.values = choiceTexts(reader, "values");
  param.unit = reader.text("unit");
  param.doc = reader.text("doc");
  if (reader.has("role")) param.role = static_cast<Role>(reader.oneOf("role", roleNames()) + 1);
  param.has_auto = reader.boolean("auto", false);
  bool may_have = param.type == ParamDesc::Type::Float && param.min && *param.min > kAuto;
  if (param.has_auto && !may_have)
    reader.fail(fmt::format("'auto' of '{}' needs a float that is never negative", param.name));
  param.wired = reader.boolean("wired", false);
  param.variant = reader.boolean("variant", false);
  param.variant = isCompiledIn(param);
  param.breaks = valueBreaks(reader, param);
  param.default_value = checkValue(param, valueFromJson(reader.at("default")), param.place);
  reader.finish();
  return param;
}

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
  port.needs = reader.texts("needs");
  reader.finish();
  return port;
}

void checkNeeds(const PortDesc& read, const PassDesc& pass, const Reader& reader) {
  if (!read.needs.empty() && !read.optional) reader.fail(fmt::format("read '{}' is always wired", read.name));
  for (const std::string& needed : read.needs)
    if (!find(pass.reads, needed))
      reader.fail(fmt::format("read '{}' needs '{}', which is no read", read.name, needed));
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

bool isUint(const std::string& format) { return format.ends_with("ui"); }

// A port whose format a parameter decides has one for each choice, of one kind of texels.
void checkFormats(const Reader& reader, const PortDesc& port, const PassDesc& pass) {
  if (port.format_by.empty() && port.formats.empty()) return;
  auto wrong = [&](const std::string& reason) {
    reader.fail(fmt::format("the format of '{}' is chosen by '{}', {}", port.name, port.format_by, reason));
  };
  const ParamDesc* by = find(pass.params, port.format_by);
  if (!by || by->type != ParamDesc::Type::Choice) wrong("which is no choice parameter of it");
  if (by->choices.size() != port.formats.size()) wrong("but there is not one format for each of its choices");
  for (const auto& [choice, format] : port.formats) {
    bool is_choice = std::find(by->choices.begin(), by->choices.end(), choice) != by->choices.end();
    if (!is_choice) wrong(fmt::format("which has no choice '{}'{}", choice, didYouMean(choice, by->choices)));
    bool known = std::find(formatNames().begin(), formatNames().end(), format) != formatNames().end();
    if (!known) wrong(fmt::format("but there is no format '{}'{}", format, didYouMean(format, formatNames())));
    if (isUint(format) != isUint(port.format)) wrong("but mixes unsigned integers and numbers");
    if (isBuffer(format)) wrong("but a buffer is one whatever is chosen");
    bool is_default = Value(choice) == by->default_value;
    if (is_default && format != port.format) wrong(fmt::format("whose default is not {}", port.format));
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
  for (const char* key : {"kind", "port", "divide", "width", "height"}) reader.allow(key);  // which depend on the kind
  reader.finish();
  SizeDesc size;
  size.kind = static_cast<SizeDesc::Kind>(reader.oneOf("kind", kSizeKinds));
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

// What a pass that runs over the entries of a buffer must be like.
void checkOver(const Reader& reader, const PassDesc& pass) {
  if (pass.over.empty()) return;
  const PortDesc* list = find(pass.reads, pass.over);
  if (!list || !list->buffer)
    reader.fail(fmt::format("it runs over '{}', which is no read that is a buffer", pass.over));
  if (pass.kind == PassDesc::Kind::Raster) reader.fail("a raster pass runs over triangles");
  for (const PortDesc& write : pass.writes)
    if (!isCleared(write))
      reader.fail(fmt::format("it runs over '{}', but its write '{}' is not cleared", pass.over, write.name));
}

// What a pass that has a group for each pixel must be like.
void checkGroup(const Reader& reader, const PassDesc& pass) {
  if (!pass.group) return;
  if (pass.kind != PassDesc::Kind::Compute) reader.fail("compute passes alone have a group for each pixel");
  if (!pass.over.empty()) reader.fail(fmt::format("it has a group for each pixel and runs over '{}'", pass.over));
  for (const ParamDesc& param : pass.params)
    if (param.role == Role::StillOnce) reader.fail("it has a group for each pixel and a parameter that is still_once");
}

// Buffers are of compute and trace passes, and of one frame.
void checkBuffers(const Reader& reader, const PassDesc& pass) {
  for (const PortDesc& read : pass.reads)
    if (read.buffer && !read.uint)
      reader.fail(fmt::format("read '{}' is a buffer, but not of unsigned integers", read.name));
  for (const auto* ports : {&pass.writes, &pass.updates})
    for (const PortDesc& port : *ports) {
      if (!isBuffer(port.format)) {
        if (port.each != 1) reader.fail(fmt::format("'{}' is an image, which has one texel for each pixel", port.name));
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
  pass.name = nameOf(reader);
  pass.kind = static_cast<PassDesc::Kind>(reader.oneOf("kind", kPassKinds));
  pass.shader = reader.text("shader", std::nullopt);
  checkShaderPath(reader, pass.shader);
  pass.doc = reader.text("doc");
  pass.fails = reader.text("fails");
  if (reader.has("breaks")) pass.breaks = breaksOf(reader, reader.table("breaks"));
  pass.scene = reader.boolean("scene", false);
  pass.reads = itemsOf(reader.list("reads"), readRead);
  for (const PortDesc& read : pass.reads) checkNeeds(read, pass, reader);
  pass.writes = itemsOf(reader.list("writes"), readWrite);
  pass.updates = itemsOf(reader.list("updates"), readWrite);
  bool cleared = std::any_of(pass.writes.begin(), pass.writes.end(), [](const PortDesc& port) { return port.cleared; });
  if (cleared && pass.kind == PassDesc::Kind::Raster) reader.fail("a raster pass writes all of its pixels");
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

namespace {

const ParamDesc* checkFollows(const PipelineDesc& pipeline, const ParamDesc& param, const Binding& binding) {
  const ParamDesc* source = find(pipeline.params, binding.follows);
  if (!source) {
    std::string near = didYouMean(binding.follows, namesOf(pipeline.params));
    throw Error(fmt::format("the pipeline has no parameter '{}'{}", binding.follows, near), binding.place);
  }
  auto held = std::find_if(pipeline.values.begin(), pipeline.values.end(),
                           [&](const auto& entry) { return entry.first == source->name; });
  checkValue(param, held->second, binding.place);
  return source;
}

Binding readBinding(const Json& json, const PipelineDesc& pipeline, const ParamDesc& param) {
  Reader reader(json, fmt::format("parameter '{}'", param.name));
  Binding binding;
  binding.place = reader.place();
  if (reader.has("value") == reader.has("follows")) reader.fail("wants either 'value' or 'follows'");
  if (reader.has("value")) binding.value = checkValue(param, valueFromJson(reader.at("value")), binding.place);
  if (reader.has("follows")) binding.follows = reader.text("follows", std::nullopt);
  if (reader.has("follows")) checkFollows(pipeline, param, binding);
  reader.finish();
  return binding;
}

// The write or update that "node.port" names, or null.
const PortDesc* sourcePort(const PipelineDesc& pipeline, const std::string& source) {
  size_t dot = source.find('.');
  if (dot == std::string::npos) return nullptr;
  const NodeDesc* node = find(pipeline.nodes, source.substr(0, dot));
  const PassDesc* pass = node ? find(pipeline.passes, node->pass) : nullptr;
  if (!pass) return nullptr;
  const PortDesc* port = find(pass->writes, source.substr(dot + 1));
  return port ? port : find(pass->updates, source.substr(dot + 1));
}

const PortDesc& checkSource(const PipelineDesc& pipeline, const Json& source, const Place& place) {
  const PortDesc* port = source.is_string() ? sourcePort(pipeline, source.get<std::string>()) : nullptr;
  if (!port) throw Error(fmt::format("{} is no port of an earlier node", source.dump()), place);
  return *port;
}

void readInputs(const Json& json, const PipelineDesc& pipeline, const PassDesc& pass, NodeDesc& node) {
  for (const auto& [name, source] : json.items()) {
    const PortDesc* read = find(pass.reads, name);
    if (!read) throw Error(fmt::format("pass '{}' has no read '{}'", pass.name, name), node.place);
    const PortDesc& port = checkSource(pipeline, source, node.place);
    if (isUint(port.format) != read->uint || isBuffer(port.format) != read->buffer) {
      throw Error(fmt::format("'{}' of '{}' cannot read {}", name, node.name, port.format), node.place);
    }
    node.inputs.emplace_back(name, source.get<std::string>());
  }
  for (const PortDesc& read : pass.reads) {
    if (read.optional || json.contains(read.name)) continue;
    throw Error(fmt::format("'{}' of '{}' is not wired", read.name, node.name), node.place);
  }
}

void readNodeParams(const Json& json, const PipelineDesc& pipeline, const PassDesc& pass, NodeDesc& node) {
  for (const auto& [name, binding] : json.items()) {
    const ParamDesc* param = find(pass.params, name);
    if (!param) throw Error(fmt::format("pass '{}' has no parameter '{}'", pass.name, name), node.place);
    node.params.emplace_back(name, readBinding(binding, pipeline, *param));
  }
  for (const ParamDesc& param : pass.params) {
    if (!json.contains(param.name)) {
      throw Error(fmt::format("parameter '{}' of '{}' has no value", param.name, node.name), node.place);
    }
  }
}

NodeDesc readNode(const Json& json, const PipelineDesc& pipeline) {
  Reader reader(json, "node");
  NodeDesc node;
  node.place = reader.place();
  node.name = nameOf(reader);
  node.pass = reader.text("pass", std::nullopt);
  if (find(pipeline.nodes, node.name)) reader.fail(fmt::format("two nodes are named '{}'", node.name));
  const PassDesc* pass = find(pipeline.passes, node.pass);
  if (!pass) reader.fail(fmt::format("there is no pass '{}'", node.pass));
  readInputs(reader.table("inputs"), pipeline, *pass, node);
  readNodeParams(reader.table("params"), pipeline, *pass, node);
  node.time = kNodeTimes[reader.oneOf("time", kNodeTimes)];
  node.loop = reader.text("loop");
  bool in_loop = !node.loop.empty();
  if (in_loop && !find(pipeline.loops, node.loop)) reader.fail(fmt::format("there is no loop '{}'", node.loop));
  if (node.time == "sample" && !in_loop) reader.fail("time 'sample' exists inside a loop only");
  reader.finish();
  return node;
}

ParamDesc countParam(const char* name, double max) {
  ParamDesc param;
  param.name = name;
  param.type = ParamDesc::Type::Int;
  param.min = 1;
  param.max = max;
  return param;
}

LoopDesc readLoop(const Json& json, const PipelineDesc& pipeline) {
  Reader reader(json, "loop");
  LoopDesc loop;
  loop.place = reader.place();
  loop.name = nameOf(reader);
  ParamDesc times;
  times.name = "times";
  times.type = ParamDesc::Type::Choice;
  times.choices = kSampleTimes;
  loop.count = readBinding(reader.at("count"), pipeline, countParam("count", 1 << 20));
  loop.times = readBinding(reader.at("times"), pipeline, times);
  loop.slices = readBinding(reader.at("slices"), pipeline, countParam("slices", 1024));
  loop.until = reader.text("until");
  if (json.contains("parts")) {
    loop.first = reader.integer("first", std::nullopt, 0, 1 << 20);
    loop.parts = reader.integer("parts", std::nullopt, 1, 1 << 20);
  }
  reader.finish();
  return loop;
}

void checkUntil(const PipelineDesc& pipeline, const LoopDesc& loop) {
  if (loop.until.empty()) return;
  const PortDesc& port = checkSource(pipeline, loop.until, loop.place);
  const NodeDesc* node = find(pipeline.nodes, loop.until.substr(0, loop.until.find('.')));
  bool fits = port.format == "r32f";
  for (const auto& [choice, format] : port.formats) fits &= format == "r32f";
  bool inside = node->loop == loop.name && fits;
  if (inside) return;
  throw Error(fmt::format("'{}' is no r32f image written in loop '{}'", loop.until, loop.name), loop.place);
}

std::vector<std::string> namesIn(const Json& json, const PipelineDesc& pipeline) {
  std::vector<std::string> names;
  for (const Json& name : json) {
    bool known = name.is_string() && find(pipeline.params, name.get<std::string>());
    if (!known) throw Error(fmt::format("{} is no parameter", name.dump()), {pipeline.file});
    names.push_back(name.get<std::string>());
  }
  std::sort(names.begin(), names.end());
  return names;
}

void readValues(const Json& json, PipelineDesc& pipeline) {
  for (const ParamDesc& param : pipeline.params) {
    if (!json.contains(param.name)) throw Error(fmt::format("parameter '{}' has no value", param.name), param.place);
    pipeline.values.emplace_back(param.name, checkValue(param, valueFromJson(json[param.name]), param.place));
  }
  if (json.size() != pipeline.params.size()) throw Error("there are values of unknown parameters", {pipeline.file});
}

std::vector<std::pair<std::string, Value>> settingsOf(const Json& json) {
  std::vector<std::pair<std::string, Value>> settings;
  for (const auto& [name, value] : json.items()) settings.emplace_back(name, valueFromJson(value));
  return settings;
}

// The other pipeline is known once it is evaluated; so are its parameters.
EqualDesc readEqual(const Json& json, const PipelineDesc& pipeline) {
  Reader reader(json, "equal", {pipeline.file});
  EqualDesc equal{settingsOf(reader.table("when")), settingsOf(reader.table("set")),
                  reader.text("pipeline", std::nullopt)};
  for (const auto& [name, value] : equal.when) {
    const ParamDesc* param = find(pipeline.params, name);
    if (!param) reader.fail(fmt::format("there is no parameter '{}'", name));
    checkValue(*param, value, {pipeline.file});
  }
  reader.finish();
  return equal;
}

PresetDesc readPreset(const Json& json, const PipelineDesc& pipeline) {
  Reader reader(json, "preset", {pipeline.file});
  std::string name = reader.text("name", std::nullopt);
  if (!isName(name) && !name.ends_with(".lua")) reader.fail(fmt::format("'{}' is no name of a preset", name));
  PresetDesc preset{name, reader.text("doc"), {}, reader.boolean("default", false)};
  for (const auto& [name, value] : settingsOf(reader.table("values"))) {
    const ParamDesc* param = paramNamed(pipeline, name);
    if (!param) reader.fail(fmt::format("'{}' sets '{}', which is no parameter", preset.name, name));
    preset.values.emplace_back(name, checkValue(*param, value, {pipeline.file}));
  }
  reader.finish();
  return preset;
}

// One preset is the default, and one was taken.
void readPresets(Reader& reader, PipelineDesc& pipeline) {
  pipeline.presets = itemsOf(reader.list("presets"), [&](const Json& preset) { return readPreset(preset, pipeline); });
  refuseTwins(pipeline.presets, reader, "presets");
  pipeline.preset = reader.text("preset");
  const auto& presets = pipeline.presets;
  auto defaults = std::count_if(presets.begin(), presets.end(), [](const auto& preset) { return preset.is_default; });
  if (defaults != (presets.empty() ? 0 : 1)) reader.fail(fmt::format("{} presets are the default", defaults));
  bool taken = presets.empty() ? pipeline.preset.empty() : find(presets, pipeline.preset) != nullptr;
  if (!taken) reader.fail(fmt::format("there is no preset '{}'", pipeline.preset));
}

RegionDesc readRegion(const Json& json, const PipelineDesc& pipeline) {
  Reader reader(json, "region", {pipeline.file});
  RegionDesc region{nameOf(reader), reader.text("doc")};
  reader.finish();
  bool is_output = std::any_of(pipeline.outputs.begin(), pipeline.outputs.end(),
                               [&](const auto& output) { return output.first == region.name; });
  if (!is_output) reader.fail(fmt::format("there is no output '{}'", region.name));
  return region;
}

void refuseTwinRoles(const Reader& reader, const std::vector<ParamDesc>& params) {
  std::set<Role> seen;
  for (const ParamDesc& param : params) {
    bool is_new = param.role == Role::None || seen.insert(param.role).second;
    if (!is_new) reader.fail(fmt::format("two parameters have the role '{}'", roleName(param.role)));
  }
}

PassDesc passOf(const Reader& reader, const Json& json, const Known& known) {
  if (!json.is_number_integer()) return passFromJson(json);
  const int64_t number = json.get<int64_t>();
  if (number < 1 || uint64_t(number) > known.passes.size())
    reader.fail(fmt::format("there is no pass number {}", number));
  return known.passes[size_t(number) - 1];
}

}  // namespace

Known knownFromJson(const Json& json) {
  Reader reader(json, "what is known");
  Known known;
  known.params = itemsOf(reader.list("params"), readParam);
  for (const Json& pass : reader.list("passes")) known.passes.push_back(passFromJson(pass));
  reader.finish();
  return known;
}

PipelineDesc pipelineFromJson(const Json& json, const Known& known) {
  Reader reader(json, "pipeline");
  PipelineDesc pipeline;
  pipeline.name = reader.text("name", std::nullopt);
  pipeline.file = reader.text("file", std::nullopt);
  pipeline.doc = reader.text("doc");
  reader.setPlace({pipeline.file});
  if (reader.has("kind")) pipeline.kind = static_cast<PipelineDesc::Kind>(reader.oneOf("kind", pipelineKindNames()));
  pipeline.params = reader.has("params") ? itemsOf(reader.list("params"), readParam) : known.params;
  refuseTwins(pipeline.params, reader, "parameters");
  pipeline.graph_params = namesIn(reader.list("graph_params"), pipeline);
  refuseTwinRoles(reader, pipeline.params);
  readPresets(reader, pipeline);
  readValues(reader.table("values"), pipeline);
  if (reader.has("breaks")) pipeline.breaks = breaksOf(reader, reader.table("breaks"));
  pipeline.compare_with = reader.text("compare_with");
  pipeline.equals = itemsOf(reader.list("equals"), [&](const Json& equal) { return readEqual(equal, pipeline); });
  pipeline.passes = itemsOf(reader.list("passes"), [&](const Json& pass) { return passOf(reader, pass, known); });
  refuseTwins(pipeline.passes, reader, "passes");
  pipeline.loops = itemsOf(reader.list("loops"), [&](const Json& loop) { return readLoop(loop, pipeline); });
  refuseTwins(pipeline.loops, reader, "loops");
  for (const Json& node : reader.list("nodes")) pipeline.nodes.push_back(readNode(node, pipeline));
  for (const LoopDesc& loop : pipeline.loops) checkUntil(pipeline, loop);

  for (const auto& [name, source] : reader.table("outputs").items()) {
    if (!isName(name)) reader.fail(fmt::format("'{}' is not the name of an output", name));
    checkSource(pipeline, source, {pipeline.file});
    pipeline.outputs.emplace_back(name, source.get<std::string>());
  }
  if (!reader.table("outputs").contains("color")) reader.fail("output 'color' is missing");
  pipeline.regions = itemsOf(reader.list("regions"), [&](const Json& region) { return readRegion(region, pipeline); });
  refuseTwins(pipeline.regions, reader, "regions");
  reader.finish();
  return pipeline;
}

}  // namespace strobe::plan
