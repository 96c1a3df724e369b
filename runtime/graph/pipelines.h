// SPDX-License-Identifier: MIT
// A pass's pipeline for the variants, formats and backend of one node, made once per distinct content.
#pragma once

#include <exception>
#include <future>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>

#include "base/stamps.h"
#include "gpu/pipeline.h"
#include "plan/plan.h"
#include "shader/interface.h"
#include "shader/sources.h"
#include "world/gpu_scene.h"

namespace strobe::graph {

using shader::Backend;

// What the driver has of a pass: one for all interfaces that compile to the same code.
struct DriverPipeline {
  gpu::Owned<VkDescriptorSetLayout> set_layout;
  gpu::Pipeline pipeline;
};

struct NodePipeline {
  std::shared_ptr<const DriverPipeline> driver;
  std::vector<VkDescriptorSetLayoutBinding> bindings;
  shader::Interface interface;
  std::vector<Path> files;              // its shaders and what they include
  std::map<Path, std::string> sources;  // `filesOf` with their hashes, as they were compiled
  mutable bool ran = false;             // software devices compile when it runs first
};

// The interface a node's shader is compiled against.
shader::Interface interfaceOf(const plan::Plan& plan, const plan::PlanNode& node, Backend backend, uint32_t slices);

// Does it run in the stages of a ray tracing pipeline?
bool hasStages(const shader::Interface& interface);

// What distinguishes two interfaces, as text.
std::string textOf(const shader::Interface& interface);

// The shader files of a pass, main file first.
std::vector<Path> shaderFiles(const Home& home, const plan::PassDesc& pass);

// Every file that a pass is compiled from: its shaders, the declarations in front of them, the stages that passes of
// the backend share, and all that these include.
std::vector<Path> filesOf(const Home& home, const plan::PassDesc& pass, Backend backend);

// What a pass's stages compile to, and the files they come from, the shared declarations among them. Throws `Error`.
struct PassCode {
  std::string hash;  // of the SPIR-V without names of files and lines
  std::vector<Path> files;
};
PassCode compileAlone(const Home& home, const shader::Interface& interface, const plan::PassDesc& pass);

// The interfaces of a pass alone, without a pipeline: for every pair of what can be chosen when it is compiled
// (choices, switches, optional reads) all combinations of their values, the rest as declared.
std::vector<shader::Interface> interfacesOf(const plan::PassDesc& pass, Backend backend);

// Compiles shaders without a device, each variant of each pass once, on all cores.
class ShaderCheck {
 public:
  explicit ShaderCheck(Home home) : home_(std::move(home)), sources_(home_) {}
  ShaderCheck(const ShaderCheck&) = delete;
  // Notes what the plan's nodes need that has not been noted before. Threads may do so at once.
  void add(const plan::Plan& plan, Backend backend);
  // Begins to compile what was noted since the last call, on all cores, and returns.
  void start();
  // Waits for all that was started; all problems of all passes, sorted, each once.
  std::vector<std::string> finish();

 private:
  struct Job {
    shader::Interface interface;
    plan::PassDesc pass;
    std::string key;
    bool with_shared = false;  // the stages that passes share as well
  };
  using Shaders = std::vector<std::vector<Job>>;
  std::set<std::string> problemsOf(const std::vector<Job>& jobs) const;
  std::set<std::string> problemsOf(const Shaders& shaders) const;

  Home home_;
  mutable shader::Sources sources_;
  std::mutex mutex_;                              // of what is noted
  std::map<std::string, std::vector<Job>> jobs_;  // by shader
  std::set<std::string> noted_;
  std::vector<std::future<std::set<std::string>>> started_;
};

// A pass by its interface in one node of a plan, which must outlive the request.
struct PipelineRequest {
  shader::Interface interface;
  const plan::PassDesc* pass;
};

// The answer to a request.
struct PipelineFound {
  std::shared_ptr<const NodePipeline> pipeline;
  std::exception_ptr error;  // why there is none; of a mistake in a shader or a pass an `Error`
};

// Pipelines by the content they come from: the same text compiled the same way is the same pipeline, so nothing stale
// can be served and nothing is compiled twice. Of those no longer in use, the last few hundred are kept.
class PipelineCache {
 public:
  PipelineCache(const Home& home, const gpu::Device& device) : home_(home), device_(device) {}
  // An answer for each request, in their order. What is not held is compiled on all cores, by the driver as well.
  std::vector<PipelineFound> get(const std::vector<PipelineRequest>& requests, const world::GpuScene& scene);
  // Clears an image of this format, the one storage image of its only set, to zero: a work group for 8x8 pixels. The
  // shader is generated source: a bundle need not contain it.
  const DriverPipeline& clearOf(const std::string& format);
  // Pipelines of passes made since the cache exists.
  int compilations() const { return compilations_; }

 private:
  // What the files of an interface said, so that they are read again only when one of them changed.
  struct Seen {
    Stamps files;
    std::string content;
  };
  // A pipeline that is being made.
  struct Making;
  const std::string& contentOf(const shader::Interface& interface, const plan::PassDesc& pass);
  void make(std::vector<Making>& making, const world::GpuScene& scene);
  void compile(Making& one) const;
  Seen lookAt(const shader::Interface& interface, const plan::PassDesc& pass) const;
  void forgetOldest();

  struct Held {
    std::shared_ptr<const NodePipeline> pipeline;
    uint64_t asked = 0;  // number of the request that used it last
  };
  const Home home_;
  const gpu::Device& device_;
  std::map<std::string, Seen> seen_;                                    // by interface
  std::map<std::string, Held> made_;                                    // by content
  std::map<std::string, std::weak_ptr<const DriverPipeline>> drivers_;  // by pass, code and what it is bound to
  std::map<std::string, DriverPipeline> clears_;                        // by format
  uint64_t questions_ = 0;
  int compilations_ = 0;
};

}  // namespace strobe::graph
