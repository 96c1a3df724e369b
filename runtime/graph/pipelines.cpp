// SPDX-License-Identifier: MIT
#include "graph/pipelines.h"

#include <algorithm>
#include <optional>
#include <unordered_set>

#include "base/cores.h"
#include "base/hash.h"
#include "gpu/limits.h"
#include "graph/images.h"
#include "plan/facts.h"
#include "plan/formats.h"
#include "shared/scene.h"

namespace strobe::graph {

using gpu::Spirv;
using plan::ParamDesc;
using plan::PassDesc;
using shader::ShaderStage;

static shader::Interface::Variant variantOf(const ParamDesc& param, const plan::Value& value) {
  shader::Interface::Variant variant{param.name, param.choices, 0};
  if (const bool* flag = std::get_if<bool>(&value)) variant.index = *flag;
  if (const int64_t* number = std::get_if<int64_t>(&value)) variant.index = *number;
  if (const std::string* choice = std::get_if<std::string>(&value))
    variant.index = std::find(param.choices.begin(), param.choices.end(), *choice) - param.choices.begin();
  return variant;
}

static bool decidesAFormat(const PassDesc& pass, const std::string& param) {
  for (const auto* ports : {&pass.writes, &pass.updates})
    for (const auto& port : *ports)
      if (port.format_by == param) return true;
  return false;
}

static uint32_t timeSlice(const std::string& time) {
  if (time == "shutter_open") return SLICE_SHUTTER_OPEN;
  if (time == "shutter_close") return SLICE_SHUTTER_CLOSE;
  if (time == "sample") return SLICE_SAMPLE;
  return SLICE_RASTER;
}

bool hasStages(const shader::Interface& in) {
  return in.backend != Backend::None && shader::rowOf(in.backend).has_stages;
}

// GLSL expression for a texel of a read that is not wired; "" if the read declares no replacement.
static std::string absentText(const plan::PortDesc& read) {
  if (!read.absent_read.empty()) return read.absent_read + "_at(at)";
  if (read.absent.empty()) return "";
  const auto& v = read.absent;
  return fmt::format("{}vec4({}, {}, {}, {})", read.uint ? "u" : "", v[0], v[1], v[2], v[3]);
}

shader::Interface interfaceOf(const PassDesc& pass, Backend backend, const std::vector<bool>& wired,
                              const ParamValues& values, const std::vector<std::string>& absent) {
  shader::Interface in;
  in.pass = pass.name;
  in.place = pass.place.text();
  in.raster = pass.kind == PassDesc::Kind::Raster;
  in.scene = pass.scene || pass.kind != PassDesc::Kind::Compute;
  for (const plan::Fact& fact : plan::facts())
    if (fact.compiled_into_all || (in.scene && fact.compiled_in))
      in.facts.push_back({fact.name, !std::count(absent.begin(), absent.end(), fact.name)});
  in.group = pass.group;
  in.backend = pass.kind == PassDesc::Kind::Trace ? backend : Backend::None;
  for (size_t i = 0; i < pass.reads.size(); ++i) {
    const plan::PortDesc& read = pass.reads[i];
    in.reads.push_back({read.name, read.uint, wired[i], read.buffer, read.name == pass.over, absentText(read)});
  }
  auto add_write = [&](const plan::PortDesc& port, bool update) {
    const std::string& name = formatOf(port, values);
    in.writes.push_back({port.name, deviceFormat(name).glsl, plan::isUint(name), update, name, plan::isBuffer(name)});
  };
  for (const auto& port : pass.writes) add_write(port, false);
  for (const auto& port : pass.updates) add_write(port, true);
  for (size_t i = 0; i < pass.params.size(); ++i) {
    const ParamDesc& param = pass.params[i];
    if (!isCompiledIn(param)) {
      in.params.push_back({param.name, param.type == ParamDesc::Type::Int});
      continue;
    }
    in.variants.push_back(variantOf(param, values[i].second));
    in.variants.back().decides_format = decidesAFormat(pass, param.name);
  }
  for (const auto& counter : pass.counters) in.counters.push_back(counter.name);
  if (in.backend != Backend::None) in.counters.push_back(fmt::format("rays_{}", backendName(in.backend)));
  return in;
}

shader::Interface interfaceOf(const plan::Plan& plan, const plan::PlanNode& node, Backend backend, uint32_t slices) {
  const PassDesc& pass = plan.passOf(node);
  std::vector<bool> wired;
  for (int resource : node.reads) wired.push_back(resource >= 0);
  shader::Interface in = interfaceOf(pass, backend, wired, node.params, plan.absent);
  in.slices = slices;
  in.static_once = node.static_once;
  in.in_moving_rect = node.in_moving_rect;
  in.time_slice = timeSlice(plan.descOf(node).time);
  return in;
}

static Path shaderFile(const Home& home, const PassDesc& pass, const char* suffix) {
  return home.at(Path("shaders") / (pass.shader + suffix));
}

std::vector<Path> shaderFiles(const Home& home, const PassDesc& pass) {
  if (pass.kind == PassDesc::Kind::Raster)
    return {shaderFile(home, pass, ".vert.glsl"), shaderFile(home, pass, ".frag.glsl")};
  return {shaderFile(home, pass, ".glsl")};
}

static std::string noShader(const Home& home, const PassDesc& pass, const Path& file) {
  const Path name = Path(pass.shader).parent_path() / file;
  return fmt::format("pass '{}': shader {} is missing in {}{}", pass.name, name.string(), placesText(home, "shaders"),
                     didYouMean(Path(name).replace_extension().string(), home.namesBelow("shaders", ".glsl")));
}

static void requireFiles(const Home& home, const PassDesc& pass) {
  for (const Path& file : shaderFiles(home, pass)) {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(file, ignored))
      throw Error(noShader(home, pass, file.filename()), pass.place);
  }
}

static Path backendFile(const Home& home, const char* name) { return home.at(Path("shaders/backend") / name); }

struct StageFile {
  Path file;
  ShaderStage stage;
};

// Stages of the pass itself.
static std::vector<StageFile> ownStages(const Home& home, const shader::Interface& in, const PassDesc& pass) {
  requireFiles(home, pass);
  if (in.raster)
    return {{shaderFile(home, pass, ".vert.glsl"), ShaderStage::Vertex},
            {shaderFile(home, pass, ".frag.glsl"), ShaderStage::Fragment}};
  return {{shaderFile(home, pass, ".glsl"), hasStages(in) ? ShaderStage::RayGeneration : ShaderStage::Compute}};
}

// Stages shared by all passes of a backend with shader stages.
static std::vector<StageFile> sharedStages(const Home& home) {
  return {{backendFile(home, "miss.glsl"), ShaderStage::Miss},
          {backendFile(home, "closest_hit.glsl"), ShaderStage::ClosestHit},
          {backendFile(home, "any_hit.glsl"), ShaderStage::AnyHit}};
}

std::vector<Spirv> compileStages(const Home& home, const shader::Interface& in, const PassDesc& pass) {
  std::vector<Spirv> stages;
  for (const StageFile& own : ownStages(home, in, pass)) stages.push_back(compilePass(home, in, own.file, own.stage));
  if (!hasStages(in)) return stages;
  for (const StageFile& one : sharedStages(home)) stages.push_back(compilePass(home, in, one.file, one.stage));
  return stages;
}

std::string textOf(const shader::Interface& in) {
  ShaderStage stage = in.raster       ? ShaderStage::Fragment
                      : hasStages(in) ? ShaderStage::RayGeneration
                                      : ShaderStage::Compute;
  std::string text = fmt::format("{}|{}|{}", backendName(in.backend), preamble(in, stage), epilogue(in, stage));
  for (const auto& write : in.writes) text += write.format + ",";
  return text;
}

static std::string interfaceKey(const Home& home, const shader::Interface& in, const PassDesc& pass) {
  return fmt::format("{}|{}|{}", shaderFile(home, pass, "").string(), int(pass.kind), textOf(in));
}

// `files` (may be null) receives all files that were read.
static std::string contentKey(const Home& home, const shader::Interface& in, const PassDesc& pass,
                              std::vector<Path>* files = nullptr) {
  std::string key = fmt::format("{}|{}|{}", pass.shader, int(pass.kind), textOf(in));
  auto add = [&](const Path& file) {
    std::vector<Path> reached;
    key += shader::textWithIncludes(home, file, &reached);
    if (files) files->insert(files->end(), reached.begin(), reached.end());
  };
  for (const Path& file : shaderFiles(home, pass)) add(file);
  // Includes of the generated declarations.
  add(home.at("shaders/shared/frame.h"));
  if (in.scene) add(home.at("shaders/shared/bindings.glsl"));
  if (hasStages(in))
    for (const StageFile& one : sharedStages(home)) add(one.file);
  return hashText(key);
}

std::vector<Path> filesOf(const Home& home, const PassDesc& pass, Backend backend) {
  std::vector<Path> mains = shaderFiles(home, pass);
  for (const char* declarations : {"shaders/shared/frame.h", "shaders/shared/bindings.glsl"})
    mains.push_back(home.at(declarations));
  if (backend != Backend::None && shader::rowOf(backend).has_stages)
    for (const StageFile& one : sharedStages(home)) mains.push_back(one.file);
  std::set<Path> files;
  for (const Path& file : mains) {
    std::vector<Path> reached;
    shader::textWithIncludes(home, file, &reached);
    files.insert(reached.begin(), reached.end());
  }
  return {files.begin(), files.end()};
}

// True for SPIR-V instructions that only hold names and source positions.
static bool isDebugOnly(uint32_t opcode) {
  constexpr uint32_t kSourceContinued = 2, kSource = 3, kSourceExtension = 4, kName = 5, kMemberName = 6, kString = 7,
                     kLine = 8, kNoLine = 317;
  for (uint32_t other : {kSourceContinued, kSource, kSourceExtension, kName, kMemberName, kString, kLine, kNoLine})
    if (opcode == other) return true;
  return false;
}

std::string hashOfCode(const Spirv& spirv) {
  constexpr size_t kHeader = 5;
  Spirv code;
  for (size_t at = kHeader; at < spirv.size();) {
    size_t words = std::max<size_t>(spirv[at] >> 16, 1), end = std::min(at + words, spirv.size());
    if (!isDebugOnly(spirv[at] & 0xffff)) code.insert(code.end(), spirv.begin() + long(at), spirv.begin() + long(end));
    at = end;
  }
  return hashBytes(code.data(), code.size() * sizeof(uint32_t));
}

void ShaderCheck::add(const plan::Plan& plan, Backend backend) {
  for (const plan::PlanNode& node : plan.nodes) {
    const PassDesc& pass = plan.passOf(node);
    shader::Interface in = interfaceOf(plan, node, backend, SLICE_SAMPLE + 1);
    std::string key = fmt::format("{}|{}|{}|{}", pass.name, pass.shader, int(pass.kind), textOf(in));
    std::lock_guard lock(mutex_);
    if (!noted_.insert(key).second) continue;
    jobs_[fmt::format("{}|{}", pass.shader, int(pass.kind))].push_back({in, pass, key});
  }
}

// Reads the names that a shader uses once for all its variants.
std::set<std::string> ShaderCheck::problemsOf(const std::vector<Job>& jobs) const {
  std::set<std::string> problems;
  std::optional<std::unordered_set<std::string>> used;
  auto note = [&](const auto& find) {
    try {
      find();
    } catch (const Error& error) {
      problems.insert(error.what());
    }
  };
  for (const auto& [in, pass, key, with_shared] : jobs) {
    auto compile = [&, &in = in](const std::vector<StageFile>& stages) {
      for (const auto& [file, stage] : stages) compilePass(home_, in, file, stage, shader::Output::None, &sources_);
    };
    note([&, &in = in, &pass = pass] {
      compile(ownStages(home_, in, pass));
      const std::vector<Path> files = shaderFiles(home_, pass);
      if (!used) used = shader::namesUsed(home_, files, &sources_);
      for (const std::string& problem : nameProblems(home_, in, files, *used)) problems.insert(problem);
    });
    if (with_shared) note([&] { compile(sharedStages(home_)); });
  }
  return problems;
}

std::set<std::string> ShaderCheck::problemsOf(const Shaders& shaders) const {
  std::vector<std::set<std::string>> found(shaders.size());
  forEachOnAllCores(shaders.size(), [&](size_t i) { found[i] = problemsOf(shaders[i]); });
  std::set<std::string> problems;
  for (auto& some : found) problems.merge(some);
  return problems;
}

void ShaderCheck::start() {
  Shaders shaders;
  for (auto& [shader, jobs] : jobs_) {
    std::sort(jobs.begin(), jobs.end(), [](const Job& a, const Job& b) { return a.key < b.key; });
    // Passes with the same preamble share the compiled shared stages.
    for (Job& job : jobs)
      job.with_shared = hasStages(job.interface) && noted_.insert(preamble(job.interface, ShaderStage::Miss)).second;
    shaders.push_back(std::move(jobs));
  }
  jobs_.clear();
  started_.push_back(
      std::async(std::launch::async, [this, shaders = std::move(shaders)] { return problemsOf(shaders); }));
}

std::vector<std::string> ShaderCheck::finish() {
  std::set<std::string> problems;
  for (auto& some : started_) problems.merge(some.get());
  started_.clear();
  return {problems.begin(), problems.end()};
}

struct PipelineCache::Making {
  const CompileRequest* request;
  std::string key;
  std::vector<Spirv> stages;
  std::shared_ptr<NodePipeline> pipeline;
  std::exception_ptr error;
};

// Returns the exception that `work` throws; null if it returns.
template <typename Work>
static std::exception_ptr thrownBy(const Work& work) {
  try {
    work();
  } catch (...) {
    return std::current_exception();
  }
  return nullptr;
}

std::vector<PipelineFound> PipelineCache::get(const std::vector<CompileRequest>& requests,
                                              const world::GpuScene& scene) {
  std::vector<PipelineFound> found(requests.size());
  std::vector<std::string> keys(requests.size());
  std::vector<Making> making;
  std::map<std::string, std::exception_ptr> failed;  // by key
  for (size_t i = 0; i < requests.size(); ++i) {
    const CompileRequest& request = requests[i];
    // Scenes with equal set layouts share pipelines.
    found[i].error =
        thrownBy([&] { keys[i] = contentOf(request.interface, *request.pass) + "|" + scene.layoutText(); });
    if (!found[i].error && !made_.contains(keys[i]) && failed.emplace(keys[i], nullptr).second)
      making.push_back({&requests[i], keys[i], {}, {}, {}});
  }
  make(making, scene);
  for (Making& one : making) {
    failed[one.key] = one.error;
    if (one.error) continue;
    made_.emplace(one.key, Held{std::move(one.pipeline)});
    ++compilations_;
  }
  for (size_t i = 0; i < requests.size(); ++i) {
    if (found[i].error) continue;
    if (auto held = made_.find(keys[i]); held != made_.end()) {
      held->second.asked = ++questions_;
      found[i].pipeline = held->second.pipeline;
    } else {
      found[i].error = failed.at(keys[i]);
    }
  }
  forgetOldest();
  return found;
}

const std::string& PipelineCache::contentOf(const shader::Interface& in, const PassDesc& pass) {
  Seen& seen = seen_[interfaceKey(home_, in, pass)];
  if (seen.content.empty() || !seen.files.current()) {
    requireFiles(home_, pass);
    seen = lookAt(in, pass);
  }
  return seen.content;
}

PipelineCache::Seen PipelineCache::lookAt(const shader::Interface& in, const PassDesc& pass) const {
  std::vector<Path> files;
  Seen seen;
  contentKey(home_, in, pass, &files);
  // A new file in the same folder may replace an include, so stamp the folder too. Stamp before reading the contents: a
  // change in between makes the stamps differ.
  for (const Path& file : files) {
    seen.files.add(file);
    seen.files.add(file.parent_path());
  }
  seen.content = contentKey(home_, in, pass);
  return seen;
}

// Drops the least recently used pipelines that no graph holds. Each edit of a shader leaves a pipeline behind.
void PipelineCache::forgetOldest() {
  constexpr size_t kMost = 512;  // more than all presets of all pipelines need
  if (made_.size() <= kMost) return;
  while (made_.size() > kMost) {
    auto oldest = made_.end();
    for (auto it = made_.begin(); it != made_.end(); ++it) {
      bool used = it->second.pipeline.use_count() > 1;
      if (!used && (oldest == made_.end() || it->second.asked < oldest->second.asked)) oldest = it;
    }
    if (oldest == made_.end()) break;
    made_.erase(oldest);
  }
  std::erase_if(drivers_, [](const auto& known) { return known.second.expired(); });
}

static std::vector<VkDescriptorSetLayoutBinding> bindingsOf(const shader::Interface& in) {
  std::vector<VkDescriptorSetLayoutBinding> bindings;
  auto add = [&bindings](uint32_t binding, VkDescriptorType type) {
    bindings.push_back({binding, type, 1, VK_SHADER_STAGE_ALL, nullptr});
  };
  if (in.hasParams()) add(shader::Interface::kParamsBinding, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER);
  if (!in.counters.empty()) add(shader::Interface::kCountersBinding, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER);
  for (size_t i = 0; i < in.reads.size(); ++i)
    add(in.readBinding(i),
        in.reads[i].buffer ? VK_DESCRIPTOR_TYPE_STORAGE_BUFFER : VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER);
  for (size_t i = 0; i < in.writes.size() && !in.raster; ++i)
    add(in.writeBinding(i), in.writes[i].buffer ? VK_DESCRIPTOR_TYPE_STORAGE_BUFFER : VK_DESCRIPTOR_TYPE_STORAGE_IMAGE);
  return bindings;
}

// Nodes with equal keys share a driver pipeline.
static std::string driverKey(const NodePipeline& node, const PassDesc& pass, const std::vector<Spirv>& stages,
                             const world::GpuScene& scene) {
  std::string key = pass.name + "|" + scene.layoutText();
  for (const Spirv& stage : stages) key += "|" + hashOfCode(stage);
  for (const auto& binding : node.bindings) key += fmt::format("|{} {}", binding.binding, int(binding.descriptorType));
  for (const auto& write : node.interface.writes) key += "|" + write.texels;
  return key;
}

static std::shared_ptr<const DriverPipeline> makeDriver(const gpu::Device& device, const NodePipeline& node,
                                                        const PassDesc& pass, const std::vector<Spirv>& stages,
                                                        const world::GpuScene& scene) {
  const shader::Interface& in = node.interface;
  gpu::requireDescriptors(device, pass.name, {scene.bindings(), node.bindings});
  auto driver = std::make_shared<DriverPipeline>();
  driver->set_layout = gpu::makeSetLayout(device, pass.name, node.bindings);
  std::vector<VkDescriptorSetLayout> sets = {scene.setLayout(), driver->set_layout.get()};
  if (in.raster) {
    gpu::RasterShaders shaders{stages[0], stages[1], {}};
    for (const auto& write : in.writes) shaders.color_formats.push_back(deviceFormat(write.texels).vk);
    driver->pipeline = gpu::Pipeline::raster(device, pass.name, shaders, sets);
  } else if (hasStages(in)) {
    gpu::TraceShaders shaders{stages[0], stages[1], stages[2], stages[3]};
    driver->pipeline = gpu::Pipeline::trace(device, pass.name, shaders, sets);
  } else {
    driver->pipeline = gpu::Pipeline::compute(device, pass.name, stages[0], sets);
  }
  return driver;
}

// Arguments: side of a work group, format, type prefix ("u" for unsigned integers).
static constexpr char kClear[] = R"(#version 460
layout(local_size_x = {0}, local_size_y = {0}) in;
layout(set = 0, binding = 0, {1}) uniform writeonly {2}image2D cleared;
void main() {{
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (all(lessThan(pixel, imageSize(cleared)))) imageStore(cleared, pixel, {2}vec4(0));
}}
)";

const DriverPipeline& PipelineCache::clearOf(const std::string& format) {
  auto found = clears_.find(format);
  if (found != clears_.end()) return found->second;
  DriverPipeline clear;
  const std::string glsl =
      fmt::format(kClear, shader::kGroupSize, deviceFormat(format).glsl, plan::isUint(format) ? "u" : "");
  const VkDescriptorSetLayoutBinding binding{0, VK_DESCRIPTOR_TYPE_STORAGE_IMAGE, 1, VK_SHADER_STAGE_COMPUTE_BIT,
                                             nullptr};
  clear.set_layout = gpu::makeSetLayout(device_, "clear", {binding});
  clear.pipeline = gpu::Pipeline::compute(device_, "clear", shader::compileText(glsl, ShaderStage::Compute),
                                          {clear.set_layout.get()});
  return clears_.emplace(format, std::move(clear)).first->second;
}

void PipelineCache::compile(Making& one) const {
  const auto& [in, pass] = *one.request;
  one.stages = compileStages(home_, in, *pass);
  const std::vector<Path> shaders = shaderFiles(home_, *pass);
  throwIfAny(nameProblems(home_, in, shaders, shader::namesUsed(home_, shaders)));
  one.pipeline = std::make_shared<NodePipeline>();
  one.pipeline->interface = in;
  for (const Path& file : filesOf(home_, *pass, in.backend)) one.pipeline->sources[file] = hashText(readText(file));
  one.pipeline->bindings = bindingsOf(in);
}

void PipelineCache::make(std::vector<Making>& making, const world::GpuScene& scene) {
  forEachOnAllCores(making.size(), [&](size_t i) { making[i].error = thrownBy([&] { compile(making[i]); }); });
  // The driver makes each distinct code once.
  std::map<std::string, std::vector<Making*>> by_driver;
  for (Making& one : making) {
    if (one.error) continue;
    const std::string key = driverKey(*one.pipeline, *one.request->pass, one.stages, scene);
    one.pipeline->driver = drivers_[key].lock();
    if (!one.pipeline->driver) by_driver[key].push_back(&one);
  }
  const std::vector<std::pair<std::string, std::vector<Making*>>> drivers(by_driver.begin(), by_driver.end());
  forEachOnAllCores(drivers.size(), [&](size_t i) {
    const auto& sharing = drivers[i].second;
    const Making& first = *sharing.front();
    std::shared_ptr<const DriverPipeline> driver;
    const std::exception_ptr error =
        thrownBy([&] { driver = makeDriver(device_, *first.pipeline, *first.request->pass, first.stages, scene); });
    for (Making* one : sharing) one->pipeline->driver = driver, one->error = error;
  });
  for (const auto& [key, sharing] : drivers) drivers_[key] = sharing.front()->pipeline->driver;
}

}  // namespace strobe::graph
