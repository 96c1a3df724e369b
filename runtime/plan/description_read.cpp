// SPDX-License-Identifier: MIT
// The canonical form back to descriptions, believing nothing.
#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <set>

#include "plan/description.h"
#include "plan/description_words.h"

namespace strobe::plan {

static constexpr size_t kMaxItems = 100000;
static constexpr int kMaxSide = 32768;

namespace {

// An object whose keys are read one by one; `what` names it in errors ("pass 'x'").
class Reader {
 public:
  Reader(const Json& json, std::string what, std::initializer_list<const char*> keys)
      : json_(json), what_(std::move(what)) {
    if (!json.is_object()) throw Error(fmt::format("{} is not an object", what_));
    std::vector<std::string> known(keys.begin(), keys.end());
    for (const auto& [key, value] : json.items()) {
      if (std::find(known.begin(), known.end(), key) != known.end()) continue;
      fail(fmt::format("unknown key '{}'{}", key, didYouMean(key, known)));
    }
  }

  bool has(const char* key) const { return json_.contains(key); }

  const Json& at(const char* key) const {
    if (!has(key)) fail(fmt::format("'{}' is missing", key));
    return json_[key];
  }

  std::string text(const char* key, const char* otherwise = nullptr) const {
    if (!has(key) && otherwise) return otherwise;
    const Json& json = at(key);
    if (!json.is_string()) fail(fmt::format("'{}' is not a text", key));
    return json.get<std::string>();
  }

  bool flag(const char* key) const {
    if (!has(key)) return false;
    if (!json_[key].is_boolean()) fail(fmt::format("'{}' is not true or false", key));
    return json_[key].get<bool>();
  }

  int whole(const char* key, int min, int max) const {
    const Json& json = at(key);
    bool fits = json.is_number_integer() && json.get<int64_t>() >= min && json.get<int64_t>() <= max;
    if (!fits) fail(fmt::format("'{}' is not an integer from {} to {}", key, min, max));
    return json.get<int>();
  }

  std::optional<double> number(const char* key) const {
    if (!has(key)) return std::nullopt;
    bool finite = json_[key].is_number() && std::isfinite(json_[key].get<double>());
    if (!finite) fail(fmt::format("'{}' is not a number", key));
    return json_[key].get<double>();
  }

  size_t oneOf(const char* key, const std::vector<std::string>& names) const {
    std::string name = text(key);
    auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) fail(fmt::format("'{}' = '{}' is not one of {}", key, name, listed(names)));
    return static_cast<size_t>(found - names.begin());
  }

  // A list may be absent; an empty table of Lua, which has no kind, may arrive as an empty object.
  const Json& list(const char* key) const { return collection(key, &Json::is_array); }
  const Json& object(const char* key) const { return collection(key, &Json::is_object); }

  Place place() const {
    if (!has("place")) return {};
    Reader reader(json_["place"], what_ + ": 'place'", {"file", "line"});
    return {reader.text("file"), reader.whole("line", 0, 1 << 30)};
  }

  const std::string& what() const { return what_; }
  [[noreturn]] void fail(const std::string& message) const {
    throw Error(fmt::format("{}: {}", what_, message), what_place_);
  }
  void setPlace(const Place& place) { what_place_ = place; }

 private:
  const Json& collection(const char* key, bool (Json::*right)() const noexcept) const {
    static const Json empty = Json::array();
    if (!has(key)) return empty;
    const Json& json = json_[key];
    if (!json.is_structured() || (!json.empty() && !(json.*right)())) fail(fmt::format("'{}' is of a wrong kind", key));
    if (json.size() > kMaxItems) fail(fmt::format("'{}' has too many entries", key));
    return json;
  }

  const Json& json_;
  std::string what_;
  Place what_place_;
};

bool isName(const std::string& name) {
  bool starts = !name.empty() && name.size() <= 64 && name[0] >= 'a' && name[0] <= 'z';
  return starts && name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") == std::string::npos;
}

std::string nameOf(const Reader& reader) {
  std::string name = reader.text("name");
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

std::vector<std::string> choicesOf(const Reader& reader) {
  std::vector<std::string> choices;
  for (const Json& choice : reader.list("choices")) {
    if (!choice.is_string()) reader.fail("a choice is not a text");
    choices.push_back(choice.get<std::string>());
  }
  return choices;
}

// A text for each of some choices.
std::vector<std::pair<std::string, std::string>> choiceTexts(const Reader& reader, const Json& json, const char* key) {
  std::vector<std::pair<std::string, std::string>> texts;
  auto found = json.find(key);
  if (found == json.end() || found->empty()) return texts;
  if (!found->is_object()) reader.fail(fmt::format("'{}' is no table of texts", key));
  for (const auto& [name, text] : found->items()) {
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
std::vector<std::pair<std::string, Breaks>> valueBreaks(const Reader& reader, const ParamDesc& param) {
  std::vector<std::pair<std::string, Breaks>> result;
  if (!reader.has("breaks")) return result;
  for (const auto& [value, breaks] : reader.object("breaks").items()) {
    checkValue(param, Value(value), param.place);
    result.emplace_back(value, breaksOf(reader, breaks));
  }
  return result;
}

ParamDesc readParam(const Json& json) {
  Reader reader(
      json, "parameter",
      {"name", "type", "default", "min", "max", "choices", "values", "breaks", "unit", "doc", "variant", "place"});
  ParamDesc param;
  param.place = reader.place();
  reader.setPlace(param.place);
  param.name = nameOf(reader);
  param.type = static_cast<ParamDesc::Type>(reader.oneOf("type", kParamTypes));
  param.min = reader.number("min");
  param.max = reader.number("max");
  bool crossed = param.min && param.max && *param.min > *param.max;
  if (crossed) reader.fail(fmt::format("min of '{}' is above max", param.name));
  param.choices = choicesOf(reader);
  param.values = choiceTexts(reader, json, "values");
  param.unit = reader.text("unit", "");
  param.doc = reader.text("doc", "");
  param.variant = reader.flag("variant");
  param.variant = isCompiledIn(param);
  param.breaks = valueBreaks(reader, param);
  param.default_value = checkValue(param, valueFromJson(reader.at("default")), param.place);
  return param;
}

PortDesc readRead(const Json& json) {
  Reader reader(json, "read", {"name", "doc", "uint", "optional", "linear", "place"});
  PortDesc port;
  port.place = reader.place();
  reader.setPlace(port.place);
  port.name = nameOf(reader);
  port.doc = reader.text("doc", "");
  port.uint = reader.flag("uint");
  port.optional = reader.flag("optional");
  port.linear = reader.flag("linear");
  return port;
}

PortDesc readWrite(const Json& json) {
  Reader reader(json, "write", {"name", "doc", "format", "format_by", "formats", "history", "place"});
  PortDesc port;
  port.place = reader.place();
  reader.setPlace(port.place);
  port.name = nameOf(reader);
  port.doc = reader.text("doc", "");
  port.format = formatNames()[reader.oneOf("format", formatNames())];
  port.format_by = reader.text("format_by", "");
  port.formats = choiceTexts(reader, json, "formats");
  port.history = reader.flag("history");
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
    bool is_default = Value(choice) == by->default_value;
    if (is_default && format != port.format) wrong(fmt::format("whose default is not {}", port.format));
  }
}

CounterDesc readCounter(const Json& json) {
  Reader reader(json, "counter", {"name", "doc", "limit"});
  return {nameOf(reader), reader.text("doc", ""), reader.text("limit", "")};
}

SizeDesc readSize(const Json& json, const PassDesc& pass) {
  Reader reader(json, fmt::format("size of pass '{}'", pass.name), {"kind", "port", "divide", "width", "height"});
  reader.setPlace(pass.place);
  SizeDesc size;
  size.kind = static_cast<SizeDesc::Kind>(reader.oneOf("kind", kSizeKinds));
  if (size.kind == SizeDesc::Kind::Fixed) {
    size.width = reader.whole("width", 1, kMaxSide);
    size.height = reader.whole("height", 1, kMaxSide);
  }
  if (size.kind != SizeDesc::Kind::Port) return size;

  size.port = reader.text("port");
  const PortDesc* port = find(pass.reads, size.port);
  if (!port || port->optional) reader.fail(fmt::format("'{}' is not a read that is always wired", size.port));
  size.divide = reader.text("divide", "");
  if (size.divide.empty()) return size;
  const ParamDesc* divide = find(pass.params, size.divide);
  bool positive = divide && divide->type == ParamDesc::Type::Int && divide->min && *divide->min >= 1;
  if (!positive) reader.fail(fmt::format("'{}' is not an integer parameter of at least 1", size.divide));
  return size;
}

void checkShaderPath(const Reader& reader, const std::string& shader) {
  const char* allowed = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./";
  bool plain = !shader.empty() && shader[0] != '/' && shader.find_first_not_of(allowed) == std::string::npos;
  bool climbs = shader.find("..") != std::string::npos;
  if (!plain || climbs) reader.fail(fmt::format("'{}' is not a path below shaders/", shader));
}

}  // namespace

PassDesc passFromJson(const Json& json) {
  Reader reader(json, "pass",
                {"name", "kind", "shader", "doc", "fails", "breaks", "size", "scene", "reads", "writes", "updates",
                 "params", "counters", "place"});
  PassDesc pass;
  pass.place = reader.place();
  reader.setPlace(pass.place);
  pass.name = nameOf(reader);
  pass.kind = static_cast<PassDesc::Kind>(reader.oneOf("kind", kPassKinds));
  pass.shader = reader.text("shader");
  checkShaderPath(reader, pass.shader);
  pass.doc = reader.text("doc", "");
  pass.fails = reader.text("fails", "");
  if (reader.has("breaks")) pass.breaks = breaksOf(reader, reader.object("breaks"));
  pass.scene = reader.flag("scene");
  pass.reads = itemsOf(reader.list("reads"), readRead);
  pass.writes = itemsOf(reader.list("writes"), readWrite);
  pass.updates = itemsOf(reader.list("updates"), readWrite);
  pass.params = itemsOf(reader.list("params"), readParam);
  pass.counters = itemsOf(reader.list("counters"), readCounter);
  pass.size = readSize(reader.at("size"), pass);

  std::vector<PortDesc> outputs = pass.writes;
  outputs.insert(outputs.end(), pass.updates.begin(), pass.updates.end());
  if (outputs.empty()) reader.fail(fmt::format("'{}' writes nothing", pass.name));
  refuseTwins(outputs, reader, "writes");
  for (const PortDesc& port : outputs) checkFormats(reader, port, pass);
  refuseTwins(pass.reads, reader, "reads");
  refuseTwins(pass.params, reader, "parameters");
  refuseTwins(pass.counters, reader, "counters");
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
  Reader reader(json, fmt::format("parameter '{}'", param.name), {"value", "follows", "place"});
  Binding binding;
  binding.place = reader.place();
  reader.setPlace(binding.place);
  if (reader.has("value") == reader.has("follows")) reader.fail("wants either 'value' or 'follows'");
  if (reader.has("value")) binding.value = checkValue(param, valueFromJson(reader.at("value")), binding.place);
  if (reader.has("follows")) binding.follows = reader.text("follows");
  if (reader.has("follows")) checkFollows(pipeline, param, binding);
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
    if (isUint(port.format) != read->uint) {
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
  Reader reader(json, "node", {"name", "pass", "inputs", "params", "time", "loop", "place"});
  NodeDesc node;
  node.place = reader.place();
  reader.setPlace(node.place);
  node.name = nameOf(reader);
  node.pass = reader.text("pass");
  if (find(pipeline.nodes, node.name)) reader.fail(fmt::format("two nodes are named '{}'", node.name));
  const PassDesc* pass = find(pipeline.passes, node.pass);
  if (!pass) reader.fail(fmt::format("there is no pass '{}'", node.pass));
  readInputs(reader.object("inputs"), pipeline, *pass, node);
  readNodeParams(reader.object("params"), pipeline, *pass, node);
  node.time = kNodeTimes[reader.oneOf("time", kNodeTimes)];
  node.loop = reader.text("loop", "");
  bool in_loop = !node.loop.empty();
  if (in_loop && !find(pipeline.loops, node.loop)) reader.fail(fmt::format("there is no loop '{}'", node.loop));
  if (node.time == "sample" && !in_loop) reader.fail("time 'sample' exists inside a loop only");
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
  Reader reader(json, "loop", {"name", "count", "times", "slices", "until", "place"});
  LoopDesc loop;
  loop.place = reader.place();
  reader.setPlace(loop.place);
  loop.name = nameOf(reader);
  ParamDesc times;
  times.name = "times";
  times.type = ParamDesc::Type::Choice;
  times.choices = kSampleTimes;
  loop.count = readBinding(reader.at("count"), pipeline, countParam("count", 1 << 20));
  loop.times = readBinding(reader.at("times"), pipeline, times);
  loop.slices = readBinding(reader.at("slices"), pipeline, countParam("slices", 1024));
  loop.until = reader.text("until", "");
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
  Reader reader(json, "equal", {"when", "pipeline", "set"});
  reader.setPlace({pipeline.file});
  EqualDesc equal{settingsOf(reader.object("when")), settingsOf(reader.object("set")), reader.text("pipeline")};
  for (const auto& [name, value] : equal.when) {
    const ParamDesc* param = find(pipeline.params, name);
    if (!param) reader.fail(fmt::format("there is no parameter '{}'", name));
    checkValue(*param, value, {pipeline.file});
  }
  return equal;
}

}  // namespace

PipelineDesc pipelineFromJson(const Json& json) {
  Reader reader(json, "pipeline",
                {"name", "file", "doc", "breaks", "compare_with", "equals", "params", "values", "passes", "nodes",
                 "loops", "outputs"});
  PipelineDesc pipeline;
  pipeline.name = reader.text("name");
  pipeline.file = reader.text("file");
  pipeline.doc = reader.text("doc", "");
  reader.setPlace({pipeline.file});
  pipeline.params = itemsOf(reader.list("params"), readParam);
  refuseTwins(pipeline.params, reader, "parameters");
  readValues(reader.object("values"), pipeline);
  if (reader.has("breaks")) pipeline.breaks = breaksOf(reader, reader.object("breaks"));
  pipeline.compare_with = reader.text("compare_with", "");
  pipeline.equals = itemsOf(reader.list("equals"), [&](const Json& equal) { return readEqual(equal, pipeline); });
  pipeline.passes = itemsOf(reader.list("passes"), passFromJson);
  refuseTwins(pipeline.passes, reader, "passes");
  pipeline.loops = itemsOf(reader.list("loops"), [&](const Json& loop) { return readLoop(loop, pipeline); });
  refuseTwins(pipeline.loops, reader, "loops");
  for (const Json& node : reader.list("nodes")) pipeline.nodes.push_back(readNode(node, pipeline));
  for (const LoopDesc& loop : pipeline.loops) checkUntil(pipeline, loop);

  for (const auto& [name, source] : reader.object("outputs").items()) {
    if (!isName(name)) reader.fail(fmt::format("'{}' is not the name of an output", name));
    checkSource(pipeline, source, {pipeline.file});
    pipeline.outputs.emplace_back(name, source.get<std::string>());
  }
  if (!reader.object("outputs").contains("color")) reader.fail("output 'color' is missing");
  return pipeline;
}

}  // namespace strobe::plan
