// SPDX-License-Identifier: MIT
#include "plan/canonical.h"

#include "base/hash.h"
#include "base/json.h"
#include "plan/facts.h"

namespace strobe::plan {
namespace {

// Names in the order of the enumerations.
const char* const kStepKinds[] = {"clear_image", "copy_outside", "clear_counters", "pass",
                                  "loop",        "read_image",   "read_counters"};
const char* const kHazards[] = {"read after write", "write after read", "write after write"};

const std::string& kindName(const PassDesc& pass) { return kPassKinds[size_t(pass.kind)]; }

template <class Items, class Write>
Json listOf(const Items& items, const Write& write) {
  Json list = Json::array();
  for (const auto& item : items) list.push_back(write(item));
  return list;
}

Json valuesJson(const std::vector<std::pair<std::string, Value>>& values) {
  Json json = Json::object();
  for (const auto& [name, value] : values) json[name] = toJson(value);
  return json;
}

Json bitNames(uint32_t bits, const std::vector<const char*>& names) {
  Json list = Json::array();
  for (size_t i = 0; i < names.size(); ++i) {
    if (bits & (1u << i)) list.push_back(names[i]);
  }
  return list;
}

Json stageNames(uint32_t stages) {
  return bitNames(stages, {"compute", "trace", "fragment", "depth", "color", "transfer", "host", "indirect"});
}

Json accessNames(uint32_t access) {
  return bitNames(access, {"sampled_read", "storage_read", "storage_write", "color_write", "depth_read", "depth_write",
                           "transfer_read", "transfer_write", "host_read", "indirect_read"});
}

Json usageNames(uint32_t usage) {
  return bitNames(usage,
                  {"sampled", "storage", "color_attachment", "depth_attachment", "transfer_source", "transfer_target"});
}

const std::string& nodeName(const Plan& plan, int node) { return plan.descOf(plan.nodes[size_t(node)]).name; }

const std::string& loopName(const Plan& plan, const PlanLoop& loop) {
  return plan.pipeline.loops[size_t(loop.loop)].name;
}

std::string stepName(const Plan& plan, const Step& step) {
  bool image =
      step.kind == Step::Kind::ClearImage || step.kind == Step::Kind::CopyOutside || step.kind == Step::Kind::ReadImage;
  if (image) return plan.images[step.index].name;
  return step.kind == Step::Kind::Loop ? loopName(plan, plan.loops[step.index]) : nodeName(plan, step.index);
}

Json portsJson(const Plan& plan, const std::vector<PortDesc>& ports, const std::vector<int>& images) {
  Json json = Json::object();
  for (size_t i = 0; i < ports.size(); ++i) {
    json[ports[i].name] = images[i] < 0 ? Json() : Json(plan.images[images[i]].name);
  }
  return json;
}

Json plannedNodeJson(const Plan& plan, const PlanNode& node) {
  const PassDesc& pass = plan.passOf(node);
  Json json;
  json["name"] = plan.descOf(node).name;
  json["pass"] = pass.name;
  json["kind"] = kindName(pass);
  json["shader"] = pass.shader;
  json["size"] = {node.width, node.height};
  json["time"] = plan.descOf(node).time;
  json["loop"] = node.loop < 0 ? "" : loopName(plan, plan.loops[node.loop]);
  json["params"] = valuesJson(node.params);
  if (node.over >= 0) json["over"] = plan.images[node.over].name;
  if (pass.group) json["group"] = true;
  if (node.in_moving_rect) json["in_moving_rect"] = true;
  json["reads"] = portsJson(plan, pass.reads, node.reads);
  json["writes"] = portsJson(plan, pass.writes, node.writes);
  json["updates"] = portsJson(plan, pass.updates, node.updates);
  return json;
}

Json plannedLoopJson(const Plan& plan, const PlanLoop& loop) {
  Json json;
  json["name"] = loopName(plan, loop);
  json["count"] = loop.count;
  json["times"] = loop.times;
  json["slices"] = loop.slices;
  if (loop.parts != loop.count) json["first"] = loop.first, json["parts"] = loop.parts;
  json["until"] = loop.until < 0 ? "" : plan.images[loop.until].name;
  return json;
}

Json imageJson(const Plan& plan, const VirtualImage& image) {
  Json json;
  json["name"] = image.name;
  json["format"] = image.format;
  json["size"] = {image.width, image.height};
  json["usage"] = usageNames(image.usage);
  json["life"] = {image.first, image.last};
  json["slot"] = image.slot;
  if (image.history) json["history"] = true;
  if (image.outside >= 0) json["outside"] = plan.images[size_t(image.outside)].name;
  if (image.zero) json["zero"] = true;
  return json;
}

Json slotJson(const Slot& slot) {
  Json json;
  json["format"] = slot.format;
  json["size"] = {slot.width, slot.height};
  json["usage"] = usageNames(slot.usage);
  json["bytes"] = slot.bytes;
  return json;
}

Json barrierJson(const Plan& plan, const Barrier& barrier) {
  Json json;
  bool slot = barrier.resource.kind == Resource::Kind::Slot;
  if (slot) json["slot"] = barrier.resource.index;
  json[slot ? "image" : "counters"] = slot ? plan.images[barrier.image].name : nodeName(plan, barrier.resource.index);
  json["src"] = {stageNames(barrier.src_stages), accessNames(barrier.src_access)};
  json["dst"] = {stageNames(barrier.dst_stages), accessNames(barrier.dst_access)};
  json["hazard"] = kHazards[size_t(barrier.hazard)];
  json["carried"] = barrier.carried;
  json["discard"] = barrier.discard;
  return json;
}

Json stepsJson(const Plan& plan, const std::vector<Step>& steps, bool in_loop) {
  auto barriers = [&](const Barrier& barrier) { return barrierJson(plan, barrier); };
  return listOf(steps, [&](const Step& step) {
    Json json;
    json["kind"] = kStepKinds[size_t(step.kind)];
    json["of"] = stepName(plan, step);
    json["barriers"] = listOf(step.barriers, barriers);
    if (in_loop) json["barriers_next"] = listOf(step.barriers_next, barriers);
    if (step.kind == Step::Kind::Loop) json["body"] = stepsJson(plan, step.body, true);
    return json;
  });
}

Json namedImages(const Plan& plan, const std::vector<std::pair<std::string, int>>& named) {
  Json json = Json::object();
  for (const auto& [name, image] : named) json[name] = plan.images[image].name;
  return json;
}

std::string megabytes(uint64_t bytes) { return fmt::format("{:.1f} MiB", bytes / (1024.0 * 1024.0)); }

std::string portText(const Plan& plan, const std::string& port, int image_index) {
  const VirtualImage& image = plan.images[image_index];
  std::string marks = image.kept ? ", kept" : image.read ? "" : ", never read";
  return fmt::format("{} {} (slot {}{})", port, image.format, image.slot, marks);
}

// The value as written on the command line: "auto" in place of its number.
std::string shownValue(const ParamDesc& param, const Value& value) {
  return param.has_auto && value == Value(kAuto) ? "auto" : toJson(value).dump();
}

std::string nodeText(const Plan& plan, const PlanNode& node, const std::string& indent) {
  const PassDesc& pass = plan.passOf(node);
  const NodeDesc& desc = plan.descOf(node);
  std::string text = fmt::format("{}{:<24} {:<8} {}x{}", indent, desc.name, kindName(pass), node.width, node.height);
  if (desc.name != pass.name) text += "  pass " + pass.name;
  if (node.over >= 0) text += "  over " + plan.images[node.over].name;
  if (pass.group) text += "  a group for each pixel";
  if (node.in_moving_rect) text += "  in the moving rectangle";
  if (desc.time != "raster") text += "  time " + desc.time;
  text += "\n";
  auto line = [&](const char* what, const std::string& rest) {
    text += fmt::format("{}    {:<8}{}\n", indent, what, rest);
  };
  for (size_t i = 0; i < pass.reads.size(); ++i) {
    std::string source = node.reads[i] < 0 ? "(not wired)" : plan.images[node.reads[i]].name;
    line("reads", fmt::format("{} = {}", pass.reads[i].name, source));
  }
  for (size_t i = 0; i < pass.writes.size(); ++i) line("writes", portText(plan, pass.writes[i].name, node.writes[i]));
  for (size_t i = 0; i < pass.updates.size(); ++i) {
    line("updates", portText(plan, pass.updates[i].name, node.updates[i]));
  }
  std::string params;
  for (size_t i = 0; i < pass.params.size(); ++i)
    params += fmt::format(" {}={}", node.params[i].first, shownValue(pass.params[i], node.params[i].second));
  if (!params.empty()) line("params", params.substr(1));
  return text;
}

std::string partsText(const PlanLoop& loop) {
  if (loop.parts == loop.count) return "";
  return fmt::format(", from number {} of {}", loop.first, loop.parts);
}

std::string timesText(const PlanLoop& loop) {
  if (loop.drawsParts()) return "each over a part of the exposure";
  return fmt::format("{} times of the scene, {} per iteration", loop.times, loop.slices);
}

std::string orderText(const Plan& plan) {
  std::string text;
  for (const Step& step : plan.steps) {
    if (step.kind == Step::Kind::Pass) text += nodeText(plan, plan.nodes[step.index], "  ");
    if (step.kind != Step::Kind::Loop) continue;
    const PlanLoop& loop = plan.loops[step.index];
    text += fmt::format("  loop {}: {} times, {}{}{}\n", loopName(plan, loop), loop.count, timesText(loop),
                        partsText(loop), loop.until < 0 ? "" : ", until " + plan.images[loop.until].name);
    for (const Step& inner : step.body) {
      if (inner.kind == Step::Kind::Pass) text += nodeText(plan, plan.nodes[inner.index], "    ");
    }
  }
  return text;
}

}  // namespace

Json toJson(const Plan& plan) {
  Json json;
  json["pipeline"] = plan.pipeline.name;
  json["size"] = {plan.width, plan.height};
  if (!plan.pipeline.preset.empty()) json["preset"] = plan.pipeline.preset;
  json["values"] = valuesJson(plan.pipeline.values);
  json["nodes"] = listOf(plan.nodes, [&](const PlanNode& node) { return plannedNodeJson(plan, node); });
  json["loops"] = listOf(plan.loops, [&](const PlanLoop& loop) { return plannedLoopJson(plan, loop); });
  json["outputs"] = namedImages(plan, plan.outputs);
  json["taps"] = namedImages(plan, plan.taps);
  json["culled"] = Json::object();
  for (const CulledNode& node : plan.culled) json["culled"][node.name] = node.reason;
  if (!plan.absent.empty()) json["absent"] = plan.absent;
  json["images"] = listOf(plan.images, [&](const VirtualImage& image) { return imageJson(plan, image); });
  json["slots"] = listOf(plan.slots, slotJson);
  json["steps"] = stepsJson(plan, plan.steps, false);
  return json;
}

std::string hashOf(const Plan& plan) { return hashText(toJson(plan).dump()); }

std::string shapeOf(const Plan& plan) {
  Json json = toJson(plan);
  for (const char* key : {"values", "preset", "absent"}) json.erase(key);
  for (const Fact& fact : facts())
    if ((fact.compiled_in || fact.compiled_into_all) && lacks(plan, fact.name))
      json["compiled_without"].push_back(fact.name);
  for (size_t i = 0; i < plan.nodes.size(); ++i) {
    const PassDesc& pass = plan.passOf(plan.nodes[i]);
    for (const ParamDesc& param : pass.params)
      if (!isCompiledIn(param)) json["nodes"][i]["params"].erase(param.name);
    json["nodes"][i]["place"] = pass.place.file;
  }
  return hashText(json.dump());
}

std::string describe(const Plan& plan) {
  std::string text = fmt::format("pipeline {} at {}x{}\n", plan.pipeline.name, plan.width, plan.height);
  if (!plan.pipeline.preset.empty()) text += fmt::format("  preset {}\n", plan.pipeline.preset);
  for (const ParamDesc& param : plan.pipeline.params)
    if (const Value* value = valueOf(plan.pipeline, param.name))
      text += fmt::format("  {} = {}\n", param.name, shownValue(param, *value));
  text += fmt::format("\n{} nodes in order\n", plan.nodes.size()) + orderText(plan);

  text += "\noutputs\n";
  for (const auto& [name, image] : plan.outputs) text += fmt::format("  {} = {}\n", name, plan.images[image].name);
  for (const auto& [name, image] : plan.taps) text += fmt::format("  {} (tap)\n", name);

  for (const VirtualImage& image : plan.images)
    if (image.zero) text += fmt::format("  {} is cleared to zero\n", image.name);

  text += fmt::format("\nculled: {}\n", plan.culled.empty() ? "nothing" : std::to_string(plan.culled.size()));
  for (const CulledNode& node : plan.culled) text += fmt::format("  {}: {}\n", node.name, node.reason);

  text += fmt::format("\nimages: {} in {} slots, {} instead of {}\n", plan.images.size(), plan.slots.size(),
                      megabytes(bytesAliased(plan)), megabytes(bytesUnaliased(plan)));
  text += fmt::format("barriers: {} per frame\n", barrierCount(plan));
  return text + "hash: " + hashOf(plan) + "\n";
}

}  // namespace strobe::plan
