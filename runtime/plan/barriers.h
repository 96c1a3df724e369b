// SPDX-License-Identifier: MIT
// Barriers between the commands of a plan.
//
// All images stay in one layout, so a barrier is an execution and memory dependency only. Two commands conflict if they
// access the same memory and at least one writes: read after write, write after read, or write after write. Two images
// that share a slot, and two iterations of a loop, conflict in the same way. A barrier before the later command orders
// each conflicting pair. Work of an earlier frame is not covered: to run a plan twice on the same memory, put a full
// memory barrier (or a wait) between the two runs.
#pragma once

#include <cstdint>
#include <vector>

namespace strobe::plan {

struct Plan;

// Device stages, as bits.
enum PipelineStage : uint32_t {
  kStageCompute = 1 << 0,
  kStageTrace = 1 << 1,  // ray tracing pipelines
  kStageFragment = 1 << 2,
  kStageDepth = 1 << 3,  // early and late depth tests
  kStageColor = 1 << 4,  // colour attachment output
  kStageTransfer = 1 << 5,
  kStageHost = 1 << 6,
  kStageIndirect = 1 << 7,  // numbers of work groups of an indirect dispatch
};
constexpr int kStageCount = 8;

// Kinds of memory access, as bits.
enum Access : uint32_t {
  kAccessSampledRead = 1 << 0,
  kAccessStorageRead = 1 << 1,
  kAccessStorageWrite = 1 << 2,
  kAccessColorWrite = 1 << 3,
  kAccessDepthRead = 1 << 4,
  kAccessDepthWrite = 1 << 5,
  kAccessTransferRead = 1 << 6,
  kAccessTransferWrite = 1 << 7,
  kAccessHostRead = 1 << 8,
  kAccessIndirectRead = 1 << 9,
};
constexpr uint32_t kAccessAnyWrite = kAccessStorageWrite | kAccessColorWrite | kAccessDepthWrite | kAccessTransferWrite;

// Memory: a slot of images, or the counters of a node.
struct Resource {
  enum class Kind { Slot, Counters };
  Kind kind = Kind::Slot;
  int index = 0;
  bool operator==(const Resource&) const = default;
};

// Access of one command to one resource.
struct Use {
  Resource resource;
  int image = -1;  // index into `Plan::images`; -1 for counters
  uint32_t stages = 0;
  uint32_t access = 0;
};

// Kind of conflict between two accesses to the same memory, named with the later access first; a barrier orders both.
enum class Hazard { ReadAfterWrite, WriteAfterRead, WriteAfterWrite };

// All earlier work at `src_stages` is finished, and its `src_access` is visible to `dst_access` at `dst_stages` of all
// later work. `src_access` is 0 if the earlier accesses are reads only.
struct Barrier {
  Resource resource;
  int image = -1;  // image of the next use; -1 for counters
  uint32_t src_stages = 0, src_access = 0;
  uint32_t dst_stages = 0, dst_access = 0;
  Hazard hazard = Hazard::ReadAfterWrite;
  bool carried = false;  // the conflict is with the previous iteration of the loop
  bool discard = false;  // the slot changes to another image, so its contents may be lost
};

// Fills `barriers` and `barriers_next` of every step from the steps' `uses`.
void addBarriers(Plan& plan);

// Number of barriers in one frame; a loop counts with all its iterations.
int barrierCount(const Plan& plan);

}  // namespace strobe::plan
