// SPDX-License-Identifier: MIT
#include "lab/record.h"

#include <sys/resource.h>

#include <map>

#include "base/hash.h"
#include "base/version.h"
#include "plan/canonical.h"
#include "plan/facts.h"

namespace strobe::lab {

std::string hashOf(const graph::ReadImage& read) {
  const auto& f = read.floats;
  const auto& u = read.uints;
  std::string head = fmt::format("{} {}x{} {}x{}|", read.format, f.width, f.height, u.width, u.height);
  std::string floats = hashBytes(f.values.data(), f.values.size() * sizeof(float));
  std::string uints = hashBytes(u.values.data(), u.values.size() * sizeof(uint32_t));
  return hashText(head + floats + uints);
}

// Hashes of the shader files of all nodes and their includes, at the time of compilation.
static Json shaderHashes(const Home& home, const graph::Graph& graph) {
  std::map<std::string, std::string> hashes;
  for (const auto& [node, pipeline] : graph.pipelines())
    for (const auto& [file, hash] : pipeline->sources) hashes[home.recorded(file, file)] = hash;
  return hashes;
}

const std::string& programHash() {
  static const std::string hash = hashText(readText("/proc/self/exe"));
  return hash;
}

Json makeRecord(const Home& home, const Shot& shot, const Drawing& drawing, const gpu::DeviceInfo& device,
                const graph::FrameResult& frame) {
  const plan::Plan& plan = drawing.plan();
  const HeldScene& scene = drawing.scene();
  Json record;
  record["strobe"] = {{"version", kVersion}, {"program", programHash()}};
  record["shot"] = toJson(shot);
  Json& pipeline = record["pipeline"];
  pipeline["name"] = plan.pipeline.name;
  if (!plan.pipeline.preset.empty()) pipeline["preset"] = plan.pipeline.preset;
  for (const auto& [name, value] : plan.pipeline.values) pipeline["values"][name] = plan::toJson(value);
  for (const auto& node : plan.nodes) {
    const auto& declared = plan.passOf(node).params;
    for (size_t i = 0; i < declared.size(); ++i) {
      const auto& [name, value] = node.params[i];
      pipeline["nodes"][plan.descOf(node).name][name] = plan::toJson(value);
    }
  }
  pipeline["plan"] = drawing.planned().hash;
  record["facts"] = Json::array();
  for (const plan::Fact& fact : plan::facts())
    if (!plan::lacks(plan, fact.name)) record["facts"].push_back(fact.name);
  record["scene"]["hash"] = scene.hash;
  record["scene"]["warnings"] = scene.scene.warnings;
  record["scene"]["assumptions"] = scene.scene.assumptions;
  if (!scene.scene.attribution.is_null()) record["scene"]["attribution"] = scene.scene.attribution;
  for (const auto* files : {&drawing.evaluation().scripts, &scene.dependencies})
    for (const auto& file : *files) record["scripts"][home.recorded(file.path, file.shown)] = file.hash;
  record["shaders"] = shaderHashes(home, drawing.graph());
  record["device"] = {{"name", device.name},
                      {"driver", device.driver},
                      {"api", device.api},
                      {"software", device.software},
                      {"backend", backendName(drawing.planned().backend)}};
  for (const auto& [name, count] : frame.counters) record["counters"][name] = count;
  for (const auto& [name, count] : frame.iterations) record["iterations"][name] = count;
  for (const auto& [name, image] : frame.outputs) record["outputs"][name] = hashOf(image);
  for (const auto& [name, image] : frame.taps) record["taps"][name] = hashOf(image);
  return record;
}

std::string attributionOf(const Json& record) {
  if (!record.contains("scene") || !record["scene"].contains("attribution")) return "";
  const Json& said = record["scene"]["attribution"];
  auto text = [&](const char* name) {
    return said.is_object() && said.contains(name) && said[name].is_string() ? said[name].get<std::string>() : "";
  };
  std::string copyright = text("copyright");
  if (!copyright.empty()) return copyright;
  std::string beside = text("text");
  return beside.substr(0, beside.find('\n'));
}

static uint64_t peakMemory() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return uint64_t(usage.ru_maxrss) << 10;
}

Json makeTimings(const graph::FrameResult& frame, const gpu::DeviceInfo& device, const HeldScene& scene,
                 double prepare_s, double draw_s) {
  Json json;
  json["device"] = device.name;
  json["note"] = device.software
                     ? "software device: not comparable with a GPU; each step is submitted and waited for on its own"
                     : "one frame, clocks not locked";
  json["load_s"] = {{"read", scene.read_s}, {"device", scene.device_s}};
  json["prepare_s"] = prepare_s;
  json["draw_s"] = draw_s;
  json["gpu_ms"] = frame.gpu_ms;
  json["peak_memory_bytes"] = peakMemory();
  for (const auto& step : frame.times)
    json["passes"].push_back({{"node", step.name}, {"gpu_ms", step.gpu_ms}, {"executions", step.executions}});
  return json;
}

}  // namespace strobe::lab
