// SPDX-License-Identifier: MIT
#include "graph/graph.h"

#include <algorithm>
#include <glm/gtc/packing.hpp>

#include "base/log.h"
#include "gpu/limits.h"
#include "math/sampling.h"

namespace strobe::graph {

using plan::PassDesc;
using plan::Plan;
using plan::PlanNode;
using plan::Step;

static VkImageUsageFlags vulkanUsage(uint32_t usage) {
  VkImageUsageFlags flags = 0;
  if (usage & plan::kUsageSampled) flags |= VK_IMAGE_USAGE_SAMPLED_BIT;
  if (usage & plan::kUsageStorage) flags |= VK_IMAGE_USAGE_STORAGE_BIT;
  if (usage & plan::kUsageColorAttachment) flags |= VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT;
  if (usage & plan::kUsageDepthAttachment) flags |= VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT;
  if (usage & plan::kUsageTransferSource) flags |= VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
  if (usage & plan::kUsageTransferTarget) flags |= VK_IMAGE_USAGE_TRANSFER_DST_BIT;
  return flags;
}

static VkFormat vulkanFormat(const std::string& format) {
  return format == "d32f" ? VK_FORMAT_D32_SFLOAT : gpu::formatInfo(format).vk;
}

uint32_t Graph::sampleSlices(const Plan& plan) {
  uint32_t slices = 0;
  for (const auto& loop : plan.loops) slices = std::max(slices, uint32_t(loop.slices));
  return slices;
}

Graph::Graph(const gpu::Device& device, PipelineCache& cache, const Plan& plan, scene::GpuScene& scene, Backend backend)
    : device_(device), cache_(cache), plan_(&plan), scene_(scene), backend_(backend), nodes_(plan.nodes.size()) {
  findPipelines(nullptr, nullptr);
  makeAll(nullptr);
}

Graph::Graph(const gpu::Device& device, PipelineCache& cache, const Plan& plan, scene::GpuScene& scene, Backend backend,
             Graph& previous, std::vector<std::string>& problems)
    : device_(device), cache_(cache), plan_(&plan), scene_(scene), backend_(backend), nodes_(plan.nodes.size()) {
  findPipelines(&previous, &problems);
  try {
    makeAll(&previous);
  } catch (...) {
    giveBack(previous);
    throw;
  }
}

// The pipeline, where it was made for the same names and types; else null.
static std::shared_ptr<const NodePipeline> ifItServes(const std::shared_ptr<const NodePipeline>& held,
                                                      const shader::Interface& wanted) {
  return held && textOf(held->interface) == textOf(wanted) ? held : nullptr;
}

void Graph::findPipelines(Graph* previous, std::vector<std::string>* problems) {
  STROBE_ASSERT(scene_.slices() >= SLICE_SAMPLE + sampleSlices(*plan_), "{} slices", scene_.slices());
  double started_s = clockSeconds();
  std::vector<std::string> fatal;
  for (size_t i = 0; i < nodes_.size(); ++i) {
    const PlanNode& planned = plan_->nodes[i];
    const PassDesc& pass = plan_->pipeline.passes[size_t(planned.pass)];
    traces_ |= pass.kind == PassDesc::Kind::Trace;
    shader::Interface wanted = interfaceOf(*plan_, planned, backend_, scene_.slices());
    try {
      nodes_[i].pipeline = cache_.get(wanted, pass, scene_);
    } catch (const Error& error) {
      const std::string& name = plan_->pipeline.nodes[size_t(planned.node)].name;
      int before = previous ? previous->nodeNamed(name) : -1;
      if (before >= 0) nodes_[i].pipeline = ifItServes(previous->nodes_[size_t(before)].pipeline, wanted);
      (nodes_[i].pipeline ? *problems : fatal).push_back(error.what());
    }
  }
  compile_ms_ = 1000 * (clockSeconds() - started_s);
  // Passes that fail the same way are one mistake.
  for (auto* list : {&fatal, problems}) {
    if (!list) continue;
    std::sort(list->begin(), list->end());
    list->erase(std::unique(list->begin(), list->end()), list->end());
  }
  throwIfAny(fatal);
}

void Graph::makeAll(Graph* previous) {
  nearest_ = gpu::makeSampler(device_, "nearest", {false});
  linear_ = gpu::makeSampler(device_, "linear", {true});
  makeImages(previous);
  for (size_t i = 0; i < nodes_.size(); ++i) makeNode(plan_->nodes[i], nodes_[i]);
  timer_ = gpu::Timer(device_, uint32_t(2 * nodes_.size() + 2));
}

int Graph::nodeNamed(const std::string& name) const {
  for (size_t i = 0; i < nodes_.size(); ++i)
    if (plan_->pipeline.nodes[size_t(plan_->nodes[i].node)].name == name) return int(i);
  return -1;
}

std::map<std::string, std::shared_ptr<const NodePipeline>> Graph::pipelines() const {
  std::map<std::string, std::shared_ptr<const NodePipeline>> pipelines;
  for (size_t i = 0; i < nodes_.size(); ++i)
    pipelines[plan_->pipeline.nodes[size_t(plan_->nodes[i].node)].name] = nodes_[i].pipeline;
  return pipelines;
}

void Graph::setParams(const Plan& plan) {
  STROBE_ASSERT(plan.nodes.size() == nodes_.size(), "{} nodes", plan.nodes.size());
  plan_ = &plan;
  for (size_t i = 0; i < nodes_.size(); ++i) writeParams(plan.nodes[i], nodes_[i]);
}

std::vector<std::string> Graph::histories(bool taken_over) const {
  std::vector<std::string> names;
  for (const auto& [image, earlier] : history_) {
    const std::string& name = plan_->images[size_t(image)].name;
    if (bool(taken_over_.count(name)) == taken_over) names.push_back(name);
  }
  return names;
}

void Graph::forgetHistories() {
  for (auto& [image, earlier] : history_) earlier = false;
}

// The image of a slot described alike, moved out of `previous`; an empty one if there is none.
gpu::Image Graph::takeOver(const plan::VirtualImage& image, const gpu::ImageDesc& desc, Graph& previous) {
  for (size_t i = 0; i < previous.plan_->images.size(); ++i) {
    const plan::VirtualImage& other = previous.plan_->images[i];
    gpu::Image& held = previous.slots_[size_t(other.slot)];
    bool alike = other.name == image.name && other.history == image.history && held.desc() == desc;
    if (!alike || !held.handle()) continue;
    auto history = previous.history_.find(int(i));
    if (image.history && history != previous.history_.end() && history->second) taken_over_.insert(image.name);
    taken_slots_.push_back({slots_.size(), size_t(other.slot)});
    return std::move(held);
  }
  return {};
}

void Graph::giveBack(Graph& previous) {
  for (auto [slot, from] : taken_slots_)
    if (slot < slots_.size()) previous.slots_[from] = std::move(slots_[slot]);
}

// Before any of them is allocated.
static void requireImages(const gpu::Device& device, const Plan& plan) {
  uint64_t most = gpu::limitsOf(device).image_side;
  for (const plan::VirtualImage& image : plan.images) {
    if (uint64_t(std::max(image.width, image.height)) <= most) continue;
    throw Error(gpu::kImageLimit.text(fmt::format("'{}' is {}x{} pixels, of at most {} a side on device '{}'",
                                                  image.name, image.width, image.height, most, device.info().name)));
  }
}

void Graph::makeImages(Graph* previous) {
  requireImages(device_, *plan_);
  std::vector<bool> fresh;
  for (size_t i = 0; i < plan_->slots.size(); ++i) {
    const plan::Slot& slot = plan_->slots[i];
    gpu::ImageDesc desc;
    desc.format = vulkanFormat(slot.format);
    desc.width = uint32_t(slot.width);
    desc.height = uint32_t(slot.height);
    desc.usage = vulkanUsage(slot.usage);
    const plan::VirtualImage* held = nullptr;
    for (const auto& image : plan_->images)
      if (image.slot == int(i)) held = &image;
    gpu::Image taken = held && previous ? takeOver(*held, desc, *previous) : gpu::Image();
    fresh.push_back(!taken.handle());
    if (fresh.back()) taken = gpu::Image(device_, held ? held->name : fmt::format("slot {}", i), desc);
    slots_.push_back(std::move(taken));
  }
  for (size_t i = 0; i < plan_->images.size(); ++i)
    if (plan_->images[i].history) history_[int(i)] = taken_over_.count(plan_->images[i].name) > 0;
  gpu::ImageDesc one;
  one.usage = VK_IMAGE_USAGE_SAMPLED_BIT;
  one.format = VK_FORMAT_R32_SFLOAT;
  unwired_ = gpu::Image(device_, "unwired", one);
  one.format = VK_FORMAT_R32_UINT;
  unwired_uint_ = gpu::Image(device_, "unwired uint", one);
  device_.submit([&](VkCommandBuffer commands) {
    for (size_t i = 0; i < slots_.size(); ++i) {
      if (!fresh[i]) continue;
      bool depth = slots_[i].desc().format == VK_FORMAT_D32_SFLOAT;
      VkImageAspectFlags aspect = depth ? VK_IMAGE_ASPECT_DEPTH_BIT : VK_IMAGE_ASPECT_COLOR_BIT;
      gpu::recordFirstLayout(device_, commands, slots_[i].handle(), aspect);
    }
    for (const gpu::Image* image : {&unwired_, &unwired_uint_})
      gpu::recordFirstLayout(device_, commands, image->handle(), VK_IMAGE_ASPECT_COLOR_BIT);
  });
  auto keep = [this](int image) {
    const plan::VirtualImage& kept = plan_->images[size_t(image)];
    size_t bytes = size_t(kept.width) * kept.height * gpu::formatInfo(kept.format).bytes;
    read_back_[image] = gpu::Buffer(device_, kept.name + ".read_back", bytes, 0, gpu::Buffer::Memory::Host);
  };
  for (const auto& [name, image] : plan_->outputs) keep(image);
  for (const auto& [name, image] : plan_->taps) keep(image);
  for (const auto& loop : plan_->loops)
    if (loop.until >= 0) keep(loop.until);
}

const gpu::Image& Graph::imageOf(int virtual_image) const {
  return slots_[size_t(plan_->images[size_t(virtual_image)].slot)];
}

void Graph::makeNode(const PlanNode& planned, Node& node) {
  const shader::Interface& in = node.pipeline->interface;
  const std::string& name = plan_->pipeline.nodes[size_t(planned.node)].name;
  if (!in.params.empty())
    node.params = gpu::Buffer(device_, name + ".params", in.params.size() * 4, VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT,
                              gpu::Buffer::Memory::Host);
  if (!in.counters.empty()) {
    node.counters = gpu::Buffer(device_, name + ".counters", in.counters.size() * 4, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT,
                                gpu::Buffer::Memory::Host);
    std::memset(node.counters.mapped(), 0, node.counters.size());
  }
  node.pool = gpu::makeDescriptorPool(device_, name, node.pipeline->bindings, 1);
  node.set = gpu::allocateSet(device_, node.pool.get(), node.pipeline->set_layout.get());
  writeParams(planned, node);
  fillSet(planned, node);
}

void Graph::writeParams(const PlanNode& planned, Node& node) {
  std::vector<uint32_t> words;
  for (const auto& param : node.pipeline->interface.params) {
    auto found = std::find_if(planned.params.begin(), planned.params.end(),
                              [&](const auto& p) { return p.first == param.name; });
    STROBE_ASSERT(found != planned.params.end(), "{}", param.name);
    const plan::Value& value = found->second;
    double number = std::holds_alternative<double>(value) ? std::get<double>(value) : double(std::get<int64_t>(value));
    uint32_t word;
    if (param.integer) {
      int32_t integer = int32_t(number);
      std::memcpy(&word, &integer, 4);
    } else {
      float single = float(number);
      std::memcpy(&word, &single, 4);
    }
    words.push_back(word);
  }
  if (!words.empty()) node.params.write(words);
}

void Graph::fillSet(const PlanNode& planned, Node& node) {
  const shader::Interface& in = node.pipeline->interface;
  const PassDesc& pass = plan_->pipeline.passes[size_t(planned.pass)];
  std::vector<VkDescriptorBufferInfo> buffers(2);
  std::vector<VkDescriptorImageInfo> images;
  images.reserve(in.reads.size() + in.writes.size());
  std::vector<VkWriteDescriptorSet> writes;
  auto add = [&](uint32_t binding, VkDescriptorType type) -> VkWriteDescriptorSet& {
    VkWriteDescriptorSet write{VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
    write.dstSet = node.set;
    write.dstBinding = binding;
    write.descriptorCount = 1;
    write.descriptorType = type;
    writes.push_back(write);
    return writes.back();
  };
  if (!in.params.empty()) {
    buffers[0] = {node.params.handle(), 0, VK_WHOLE_SIZE};
    add(shader::Interface::kParamsBinding, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER).pBufferInfo = &buffers[0];
  }
  if (!in.counters.empty()) {
    buffers[1] = {node.counters.handle(), 0, VK_WHOLE_SIZE};
    add(shader::Interface::kCountersBinding, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER).pBufferInfo = &buffers[1];
  }
  for (size_t i = 0; i < in.reads.size(); ++i) {
    const gpu::Image& unwired = in.reads[i].uint ? unwired_uint_ : unwired_;
    VkImageView view = planned.reads[i] >= 0 ? imageOf(planned.reads[i]).view() : unwired.view();
    images.push_back({pass.reads[i].linear ? linear_.get() : nearest_.get(), view, VK_IMAGE_LAYOUT_GENERAL});
    add(in.readBinding(i), VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER).pImageInfo = &images.back();
  }
  std::vector<int> written = planned.writes;
  written.insert(written.end(), planned.updates.begin(), planned.updates.end());
  for (size_t i = 0; i < in.writes.size() && !in.raster; ++i) {
    images.push_back({VK_NULL_HANDLE, imageOf(written[i]).view(), VK_IMAGE_LAYOUT_GENERAL});
    add(in.writeBinding(i), VK_DESCRIPTOR_TYPE_STORAGE_IMAGE).pImageInfo = &images.back();
  }
  device_.vk().UpdateDescriptorSets(device_.handle(), uint32_t(writes.size()), writes.data(), 0, nullptr);
}

shared::FrameData Graph::frameData(const FrameSetup& setup) const {
  shared::FrameData frame{};
  frame.size = uvec2(plan_->width, plan_->height);
  frame.subpixel = setup.subpixel;
  frame.shutter = setup.anchor == ANCHOR_CLOSE  ? vec2(-1, 0)
                  : setup.anchor == ANCHOR_OPEN ? vec2(0, 1)
                                                : vec2(-0.5f, 0.5f);
  frame.anchor = setup.anchor;
  frame.frame = setup.frame;
  frame.seed = setup.seed;
  frame.iteration_count = frame.slice_count = 1;
  frame.instance_count = scene_.instanceCount();
  frame.light_count = scene_.lightCount();
  frame.sky = setup.environment.sky;
  frame.ground = setup.environment.ground;
  frame.reach = ivec4(setup.reach.x0, setup.reach.y0, setup.reach.x1, setup.reach.y1);
  frame.exposure = float((setup.close_s - setup.open_s) / setup.frame_s);
  if (setup.environment.background) frame.background = vec4(*setup.environment.background, 1);
  return frame;
}

// One origin for every pose of the frame: the camera at the capture.
static dvec3 frameOrigin(const FrameSetup& setup) { return dvec3(setup.pose_at(setup.capture_s).world_from_camera[3]); }

static double aspect(const Plan& plan) { return double(plan.width) / plan.height; }

void Graph::poseFixedSlices(const FrameSetup& setup) {
  dvec3 origin = frameOrigin(setup);
  const double times[] = {setup.capture_s, setup.open_s, setup.close_s, setup.capture_s - setup.frame_s};
  for (uint32_t slice : {SLICE_CAPTURE, SLICE_OPEN, SLICE_CLOSE, SLICE_PREVIOUS})
    scene_.setPose(slice, setup.pose_at(times[slice]), setup.camera, aspect(*plan_), origin);
}

void Graph::poseSamples(const FrameSetup& setup, const plan::PlanLoop& loop, int iteration) {
  dvec3 origin = frameOrigin(setup);
  for (int q = 0; q < loop.slices; ++q) {
    // Midpoint of the stratum, or a random time in each of its parts.
    double in_stratum = 0.5;
    if (loop.times == "stratified") {
      uint32_t index = uint32_t(iteration) * uint32_t(loop.slices) + uint32_t(q);
      in_stratum = (q + hashUniform(setup.seed, setup.frame, index, 0)) / loop.slices;
    }
    double time_s = setup.open_s + (setup.close_s - setup.open_s) * ((iteration + in_stratum) / loop.count);
    scene_.setPose(SLICE_SAMPLE + uint32_t(q), setup.pose_at(time_s), setup.camera, aspect(*plan_), origin);
  }
}

FrameResult Graph::run(const FrameSetup& setup, const std::function<void(int, int)>& on_iteration) {
  FrameResult result;
  gpu_ms_ = 0;
  wanted_ = setup.wanted;
  for (Node& node : nodes_) {
    node.gpu_ms = node.executions = 0;
    node.counts.assign(node.pipeline->interface.counters.size(), 0);
  }
  poseFixedSlices(setup);
  shared::FrameData frame = frameData(setup);
  scene_.setFrame(frame);

  // Steps between loops go to the device together; each iteration of a loop is a submission of its own, because the
  // host poses the scene anew in between.
  bool first = true;
  std::vector<const Step*> pending;
  auto flush = [&] {
    submit(pending, 0, 0, first && traces_ ? 1 : 0);
    first = false;
    pending.clear();
  };
  for (const Step& step : plan_->steps) {
    if (step.kind != Step::Kind::Loop) {
      pending.push_back(&step);
      continue;
    }
    flush();
    runLoop(setup, step, frame, result, on_iteration);
    scene_.setFrame(frame);
  }
  flush();
  for (auto& [image, earlier] : history_) earlier = true;
  collect(result);
  return result;
}

void Graph::runLoop(const FrameSetup& setup, const Step& step, shared::FrameData frame, FrameResult& result,
                    const std::function<void(int, int)>& on_iteration) {
  const plan::PlanLoop& loop = plan_->loops[size_t(step.index)];
  std::vector<const Step*> body;
  for (const Step& inner : step.body) body.push_back(&inner);
  frame.iteration_count = uint32_t(loop.count);
  frame.slice_count = uint32_t(loop.slices);
  int iteration = 0;
  bool stop = false;
  while (iteration < loop.count && !stop) {
    poseSamples(setup, loop, iteration);
    frame.iteration = uint32_t(iteration);
    scene_.setFrame(frame);
    submit(body, iteration, SLICE_SAMPLE, traces_ ? uint32_t(loop.slices) : 0);
    ++iteration;
    if (loop.until >= 0) stop = static_cast<const float*>(read_back_.at(loop.until).mapped())[0] != 0;
    if (on_iteration) on_iteration(iteration, loop.count);
  }
  result.iterations.push_back({plan_->pipeline.loops[size_t(loop.loop)].name, iteration});
}

static float unpackHalf(uint16_t bits) { return glm::unpackHalf1x16(bits); }

ReadImage Graph::fetch(int image) const {
  const plan::VirtualImage& source = plan_->images[size_t(image)];
  const gpu::FormatInfo& format = gpu::formatInfo(source.format);
  const void* data = read_back_.at(image).mapped();
  size_t count = size_t(source.width) * source.height * format.channels;
  ReadImage read;
  read.format = source.format;
  if (format.uint) {
    read.uints = {source.width, source.height, format.channels, std::vector<uint32_t>(count)};
    std::memcpy(read.uints.values.data(), data, count * 4);
    return read;
  }
  read.floats = image::Image(source.width, source.height, format.channels);
  int bytes_per_channel = format.bytes / format.channels;
  for (size_t i = 0; i < count; ++i) {
    float& value = read.floats.values[i];
    if (bytes_per_channel == 4) value = static_cast<const float*>(data)[i];
    if (bytes_per_channel == 2) value = unpackHalf(static_cast<const uint16_t*>(data)[i]);
    if (bytes_per_channel == 1) value = static_cast<const uint8_t*>(data)[i] / 255.0f;
  }
  return read;
}

bool Graph::wants(int image) const {
  for (const auto& loop : plan_->loops)
    if (loop.until == image) return true;
  for (const auto* named : {&plan_->outputs, &plan_->taps})
    for (const auto& [name, kept] : *named)
      if (kept == image && wants(name)) return true;
  return false;
}

void Graph::collect(FrameResult& result) const {
  for (const auto& [name, image] : plan_->outputs)
    if (wants(name)) result.outputs[name] = fetch(image);
  for (const auto& [name, image] : plan_->taps)
    if (wants(name)) result.taps[name] = fetch(image);
  for (size_t i = 0; i < nodes_.size(); ++i) {
    const std::string& name = plan_->pipeline.nodes[size_t(plan_->nodes[i].node)].name;
    const auto& counters = nodes_[i].pipeline->interface.counters;
    for (size_t c = 0; c < counters.size(); ++c)
      result.counters.push_back({name + "." + counters[c], nodes_[i].counts[c]});
    result.times.push_back({name, nodes_[i].gpu_ms, nodes_[i].executions});
  }
  result.gpu_ms = gpu_ms_;
}

}  // namespace strobe::graph
