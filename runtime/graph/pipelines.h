// SPDX-License-Identifier: MIT
// Compiles and caches the pipeline of a pass for one combination of variants, formats and backend.
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

// Vulkan objects of a pass, shared by all interfaces that compile to the same code.
struct DriverPipeline {
  gpu::Owned<VkDescriptorSetLayout> set_layout;
  gpu::Pipeline pipeline;
};

// Compiled pipeline of a pass for one shader interface, with its bindings and its source files.
struct NodePipeline {
  std::shared_ptr<const DriverPipeline> driver;
  std::vector<VkDescriptorSetLayoutBinding> bindings;
  shader::Interface interface;
  std::map<Path, std::string> sources;  // hash of each file of `filesOf` at compile time
  mutable bool ran = false;             // software devices compile in the first run
};

// Returns the interface that a node's shader is compiled against.
shader::Interface interfaceOf(const plan::Plan& plan, const plan::PlanNode& node, Backend backend, uint32_t slices);

using ParamValues = std::vector<std::pair<std::string, plan::Value>>;
// Interface of a pass without a plan: no slices, raster time, all pixels. `wired`: by read, true if wired; `values`:
// parameter values; both in declaration order. `absent`: facts that do not hold.
shader::Interface interfaceOf(const plan::PassDesc& pass, Backend backend, const std::vector<bool>& wired,
                              const ParamValues& values, const std::vector<std::string>& absent = {});

// True if the pass runs in the stages of a ray tracing pipeline.
bool hasStages(const shader::Interface& interface);

// Text that identifies an interface: equal texts, equal interfaces.
std::string textOf(const shader::Interface& interface);

// Shader files of a pass, main file first.
std::vector<Path> shaderFiles(const Home& home, const plan::PassDesc& pass);

// All files that a pass is compiled from: its shaders, the shared declarations, the shared stages of the backend, and
// their includes.
std::vector<Path> filesOf(const Home& home, const plan::PassDesc& pass, Backend backend);

// Compiles the stages of a pass without a device: the pass's own stages, then the shared stages of the backend. Throws
// `Error`.
std::vector<gpu::Spirv> compileStages(const Home& home, const shader::Interface& interface, const plan::PassDesc& pass);

// Hash of SPIR-V without debug instructions.
std::string hashOfCode(const gpu::Spirv& spirv);

// Compiles shaders without a device, each variant of each pass once, on all cores.
class ShaderCheck {
 public:
  explicit ShaderCheck(Home home) : home_(std::move(home)), sources_(home_) {}
  ShaderCheck(const ShaderCheck&) = delete;
  // Adds the shader variants of the plan's nodes that were not added before. Thread-safe.
  void add(const plan::Plan& plan, Backend backend);
  // Starts compiling the added variants on all cores and returns without waiting.
  void start();
  // Waits for all started work. Returns the problems of all passes, sorted and without duplicates.
  std::vector<std::string> finish();

 private:
  struct Job {
    shader::Interface interface;
    plan::PassDesc pass;
    std::string key;
    bool with_shared = false;  // compile the backend's shared stages too
  };
  using Shaders = std::vector<std::vector<Job>>;
  std::set<std::string> problemsOf(const std::vector<Job>& jobs) const;
  std::set<std::string> problemsOf(const Shaders& shaders) const;

  Home home_;
  mutable shader::Sources sources_;
  std::mutex mutex_;                              // guards jobs_ and noted_ in `add`
  std::map<std::string, std::vector<Job>> jobs_;  // by shader
  std::set<std::string> noted_;
  std::vector<std::future<std::set<std::string>>> started_;
};

// A pass and its interface in one node. The pass must outlive the request.
struct CompileRequest {
  shader::Interface interface;
  const plan::PassDesc* pass;
};

// Result of a request.
struct PipelineFound {
  std::shared_ptr<const NodePipeline> pipeline;
  std::exception_ptr error;  // set if `pipeline` is null; an `Error` for a mistake in a shader or a pass
};

// Pipelines by content: equal text and options give the same pipeline, so the cache never returns a stale pipeline and
// compiles nothing twice. Keeps the last few hundred unused pipelines.
class PipelineCache {
 public:
  PipelineCache(const Home& home, const gpu::Device& device) : home_(home), device_(device) {}
  // Returns one result per request, in order. Compiles missing pipelines on all cores, the driver's part included.
  std::vector<PipelineFound> get(const std::vector<CompileRequest>& requests, const world::GpuScene& scene);
  // Pipeline that clears an image of `format`, the only binding of its only set, to zero, with one work group per 8x8
  // pixels. The shader is generated source: a bundle need not contain it.
  const DriverPipeline& clearOf(const std::string& format);
  // Number of pass pipelines made by this cache.
  int compilations() const { return compilations_; }

 private:
  // Content of an interface's files. Files are read again only after a change.
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
    uint64_t asked = 0;  // number of the last request that used it
  };
  const Home home_;
  const gpu::Device& device_;
  std::map<std::string, Seen> seen_;                                    // by interface
  std::map<std::string, Held> made_;                                    // by content
  std::map<std::string, std::weak_ptr<const DriverPipeline>> drivers_;  // by pass, code and bindings
  std::map<std::string, DriverPipeline> clears_;                        // by format
  uint64_t questions_ = 0;
  int compilations_ = 0;
};

}  // namespace strobe::graph
