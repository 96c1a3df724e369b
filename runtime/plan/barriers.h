// SPDX-License-Identifier: MIT
// What has to be waited for between the commands of a plan.
//
// All images stay in one layout, so a barrier is an execution and memory dependency and nothing else. Two commands
// conflict when they touch the same memory and one of them writes: read after write, write after read, write after
// write, and the same between two images that share a slot, and between two iterations of a loop. A barrier before the
// later command orders each such pair. Work of an earlier frame is not looked at: whoever runs a plan twice on the same
// memory puts a full memory barrier (or a wait) between.
#pragma once

#include <cstdint>
#include <vector>

namespace strobe::plan {

struct Plan;

// Where on the device something happens, as bits.
enum Stage : uint32_t {
  kStageCompute = 1 << 0,
  kStageTrace = 1 << 1,  // ray tracing pipelines
  kStageFragment = 1 << 2,
  kStageDepth = 1 << 3,  // early and late depth tests
  kStageColor = 1 << 4,  // colour attachment output
  kStageTransfer = 1 << 5,
  kStageHost = 1 << 6,
  kStageIndirect = 1 << 7,  // numbers of groups are read
};
constexpr int kStageCount = 8;

// What it does to memory, as bits.
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

// A command touches a resource.
struct Use {
  Resource resource;
  int image = -1;  // index into `Plan::images`; -1 for counters
  uint32_t stages = 0;
  uint32_t access = 0;
};

enum class Hazard { ReadAfterWrite, WriteAfterRead, WriteAfterWrite };

// Everything before it at `src_stages` is finished, and its `src_access` is visible to `dst_access` at `dst_stages`
// of everything after it. `src_access` is 0 where only reads came before.
struct Barrier {
  Resource resource;
  int image = -1;  // whose use comes next
  uint32_t src_stages = 0, src_access = 0;
  uint32_t dst_stages = 0, dst_access = 0;
  Hazard hazard = Hazard::ReadAfterWrite;
  bool carried = false;  // against the previous iteration of the loop
  bool discard = false;  // the slot goes over to another image: what it holds need not survive
};

// Fills `barriers` and `barriers_next` of every step from the steps' `uses`.
void addBarriers(Plan& plan);

// Barriers recorded in one frame, loops counted with all their iterations.
int barrierCount(const Plan& plan);

}  // namespace strobe::plan
