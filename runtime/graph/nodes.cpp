// SPDX-License-Identifier: MIT
#include "graph/nodes.h"

#include <algorithm>

#include "plan/named.h"

namespace strobe::graph {

void NodeInFrame::begin() {
  gpu_ms = executions = 0;
  std::fill(counts.begin(), counts.end(), 0);
}

void NodeInFrame::takeCounts() {
  for (size_t c = 0; c < counts.size(); ++c) counts[c] += std::exchange(counted[c], 0u);
}

PlanNodes::PlanNodes(const gpu::Device& device, const plan::Plan& plan)
    : device_(device), plan_(&plan), nodes_(plan.nodes.size()) {}

const GraphNode* PlanNodes::named(const std::string& name) const {
  for (size_t i = 0; i < nodes_.size(); ++i)
    if (this->name(i) == name) return &nodes_[i];
  return nullptr;
}

// Returns `held` if it was made for the same interface, otherwise null.
static std::shared_ptr<const NodePipeline> ifItServes(const std::shared_ptr<const NodePipeline>& held,
                                                      const shader::Interface& wanted) {
  return held && textOf(held->interface) == textOf(wanted) ? held : nullptr;
}

// Removes duplicates: several passes can fail for one reason.
static void dropTwins(std::vector<std::string>& problems) {
  std::sort(problems.begin(), problems.end());
  problems.erase(std::unique(problems.begin(), problems.end()), problems.end());
}

static bool hasDoubles(Backend backend) { return backend != Backend::None && shader::rowOf(backend).has_doubles; }

void PlanNodes::findPipelines(PipelineCache& cache, const world::GpuScene& scene, Backend backend,
                              const PlanNodes* previous, std::vector<std::string>* problems) {
  std::vector<CompileRequest> requests;
  for (size_t i = 0; i < nodes_.size(); ++i) {
    shader::Interface wanted = interfaceOf(*plan_, planned(i), backend, scene.slices());
    wanted.doubles = hasDoubles(wanted.backend) && device_.info().has("shaderFloat64");
    wanted.deal_rows = device_.info().software;
    wanted.separate_triangles = wanted.raster && !device_.info().has("geometryShader");
    requests.push_back({std::move(wanted), &pass(i)});
  }
  const std::vector<PipelineFound> found = cache.get(requests, scene);
  std::vector<std::string> fatal;
  for (size_t i = 0; i < nodes_.size(); ++i) {
    nodes_[i].pipeline = found[i].pipeline;
    if (!found[i].error) continue;
    try {
      std::rethrow_exception(found[i].error);
    } catch (const Error& error) {
      const GraphNode* before = previous ? previous->named(name(i)) : nullptr;
      if (before && problems) nodes_[i].pipeline = ifItServes(before->pipeline, requests[i].interface);
      (nodes_[i].pipeline ? *problems : fatal).push_back(error.what());
    }
  }
  if (problems) dropTwins(*problems);
  dropTwins(fatal);
  throwIfAny(fatal);
}

// Lays out the parameters and counters of all nodes in one buffer, and creates the buffer.
void PlanNodes::layOut(size_t frames) {
  constexpr size_t kAlignment = 256;  // no device needs more
  size_t end = 0;
  auto take = [&](size_t words) {
    BufferPart part{end, 4 * words};
    end += (part.bytes + kAlignment - 1) / kAlignment * kAlignment;
    return part;
  };
  for (GraphNode& node : nodes_) {
    const shader::Interface& in = node.pipeline->interface;
    node.frames.resize(frames);
    for (NodeInFrame& frame : node.frames) {
      frame.params = take(in.params.size() + (in.sizeIsGiven() ? 2 : 0));
      frame.counters = take(in.counters.size());
      frame.counts.assign(in.counters.size(), 0);
    }
  }
  numbers_ =
      gpu::Buffer(device_, "parameters and counters", end,
                  VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT | VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, gpu::Buffer::Memory::Host);
  std::memset(numbers_.mapped(), 0, numbers_.size());
  for (GraphNode& node : nodes_)
    for (NodeInFrame& frame : node.frames)
      frame.counted = reinterpret_cast<uint32_t*>(static_cast<char*>(numbers_.mapped()) + frame.counters.offset);
}

void PlanNodes::make(const PlanImages& images, size_t frames) {
  nearest_ = gpu::makeSampler(device_, "nearest", {});
  linear_ = gpu::makeSampler(device_, "linear", gpu::kLinear);
  has_params_.assign(frames, false);
  layOut(frames);
  for (size_t i = 0; i < nodes_.size(); ++i) {
    GraphNode& node = nodes_[i];
    for (size_t frame = 0; frame < frames; ++frame) {
      node.frames[frame].set =
          gpu::DescriptorSet(device_, name(i), node.pipeline->driver->set_layout.get(), node.pipeline->bindings);
      fillSet(i, frame, images);
    }
  }
}

void PlanNodes::setPlan(const plan::Plan& plan) {
  STROBE_ASSERT(plan.nodes.size() == nodes_.size(), "{} nodes", plan.nodes.size());
  plan_ = &plan;
  has_params_.assign(has_params_.size(), false);
}

void PlanNodes::begin(size_t frame) {
  for (GraphNode& node : nodes_) node.frames[frame].begin();
  if (has_params_[frame]) return;
  for (size_t i = 0; i < nodes_.size(); ++i) writeParams(i, frame);
  has_params_[frame] = true;
}

void PlanNodes::writeParams(size_t i, size_t frame) {
  const GraphNode& node = nodes_[i];
  std::vector<uint32_t> words;
  for (const auto& param : node.pipeline->interface.params) {
    const plan::Value* value = plan::valueIn(planned(i).params, param.name);
    STROBE_ASSERT(value, "{}", param.name);
    const double* real = std::get_if<double>(value);
    double number = real ? *real : double(std::get<int64_t>(*value));
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
  if (node.pipeline->interface.sizeIsGiven())
    words.insert(words.end(), {uint32_t(planned(i).width), uint32_t(planned(i).height)});
  const BufferPart& part = node.frames[frame].params;
  STROBE_ASSERT(4 * words.size() == part.bytes, "{} words in {} bytes", words.size(), part.bytes);
  if (!words.empty()) std::memcpy(static_cast<char*>(numbers_.mapped()) + part.offset, words.data(), part.bytes);
}

void PlanNodes::fillSet(size_t i, size_t frame, const PlanImages& images) {
  const NodeInFrame& own = nodes_[i].frames[frame];
  const shader::Interface& in = nodes_[i].pipeline->interface;
  auto write_part = [&](uint32_t binding, const BufferPart& part) {
    own.set.write(binding, {numbers_.handle(), part.offset, part.bytes});
  };
  auto write_image = [&](uint32_t binding, const gpu::DeviceImage& image, VkSampler sampler) {
    own.set.write(binding, std::vector{gpu::inGeneral(image.view(), sampler)});
  };
  if (in.hasParams()) write_part(shader::Interface::kParamsBinding, own.params);
  if (!in.counters.empty()) write_part(shader::Interface::kCountersBinding, own.counters);
  for (size_t r = 0; r < in.reads.size(); ++r) {
    const int read = planned(i).reads[r];
    const VkSampler sampler = pass(i).reads[r].linear ? linear_.get() : nearest_.get();
    if (in.reads[r].buffer) own.set.write(in.readBinding(r), read >= 0 ? images.buffer(read) : images.unwiredBuffer());
    else write_image(in.readBinding(r), read >= 0 ? images.of(read) : images.unwired(in.reads[r].uint), sampler);
  }
  std::vector<int> written = planned(i).writes;
  written.insert(written.end(), planned(i).updates.begin(), planned(i).updates.end());
  for (size_t w = 0; w < in.writes.size() && !in.raster; ++w) {
    if (in.writes[w].buffer) own.set.write(in.writeBinding(w), images.buffer(written[w]));
    else write_image(in.writeBinding(w), images.of(written[w]), VK_NULL_HANDLE);
  }
}

}  // namespace strobe::graph
