// SPDX-License-Identifier: MIT
#include "plan/barriers.h"

#include <array>

#include "base/error.h"
#include "plan/plan.h"

namespace strobe::plan {
namespace {

// Earlier accesses to one resource that later commands may have to wait for.
struct Pending {
  int image = -1;                               // image whose contents are in the resource
  uint32_t write_stages = 0, write_access = 0;  // the last write
  std::array<uint32_t, kStageCount> visible{};  // per stage: reads that the write is visible to
  uint32_t read_stages = 0;                     // reads since that write
  bool carried = false;                         // the last use was in an earlier iteration

  bool operator==(const Pending&) const = default;
};

bool seesAlready(const Pending& pending, uint32_t stages, uint32_t access) {
  for (int s = 0; s < kStageCount; ++s) {
    if ((stages & (1u << s)) && (pending.visible[s] & access) != access) return false;
  }
  return true;
}

// The states of all resources of a plan: slots first, then the counters of each node.
class Tracker {
 public:
  explicit Tracker(const Plan& plan) : slot_count_(plan.slots.size()), states_(slot_count_ + plan.nodes.size()) {}

  // Records `use`, and appends a barrier if `use` needs one.
  void apply(const Use& use, std::vector<Barrier>& barriers) {
    Pending& pending = at(use.resource);
    bool writes = use.access & kAccessAnyWrite;
    if (needsBarrier(pending, use, writes)) barriers.push_back(barrierFor(pending, use, writes));
    if (writes) {
      pending = Pending{use.image, use.stages, use.access & kAccessAnyWrite, {}, 0, false};
      return;
    }
    for (int s = 0; s < kStageCount; ++s) {
      if (use.stages & (1u << s)) pending.visible[s] |= use.access;
    }
    pending.read_stages |= use.stages;
    pending.carried = false;
  }

  void markCarried(bool carried) {
    for (Pending& pending : states_) pending.carried = carried;
  }

  bool operator==(const Tracker&) const = default;

 private:
  Pending& at(const Resource& resource) {
    bool slot = resource.kind == Resource::Kind::Slot;
    return states_.at(slot ? resource.index : slot_count_ + resource.index);
  }

  static bool needsBarrier(const Pending& pending, const Use& use, bool writes) {
    if (writes) return pending.write_stages || pending.read_stages;
    return pending.write_stages && !seesAlready(pending, use.stages, use.access);
  }

  static Barrier barrierFor(const Pending& pending, const Use& use, bool writes) {
    Barrier barrier{use.resource, use.image, pending.write_stages, pending.write_access, use.stages, use.access};
    // The last write is visible to the reads after it, but the next write has to wait for the last write too.
    if (writes) barrier.src_stages |= pending.read_stages;
    barrier.hazard = hazardOf(pending, use, writes);
    barrier.carried = pending.carried;
    barrier.discard = pending.image != use.image;
    return barrier;
  }

  static Hazard hazardOf(const Pending& pending, const Use& use, bool writes) {
    if (!writes) return Hazard::ReadAfterWrite;
    if (pending.read_stages) return Hazard::WriteAfterRead;
    bool reads_too = use.access & ~kAccessAnyWrite;
    return reads_too && pending.image == use.image ? Hazard::ReadAfterWrite : Hazard::WriteAfterWrite;
  }

  size_t slot_count_;
  std::vector<Pending> states_;
};

// Runs through one iteration of a loop, and stores the barriers in `list` of each step.
void iterate(std::vector<Step>& body, Tracker& tracker, std::vector<Barrier> Step::*list) {
  for (Step& step : body) {
    (step.*list).clear();
    for (const Use& use : step.uses) tracker.apply(use, step.*list);
  }
}

// The state after an iteration does not depend on the state before it. For memory that the iteration writes, the state
// is its last write and the reads after that write. For memory that the iteration only reads, the iteration adds
// readers. So all iterations after the first need the same barriers, and the commands after the loop do not depend on
// the number of iterations.
void addLoopBarriers(Step& loop, Tracker& tracker) {
  iterate(loop.body, tracker, &Step::barriers);
  Tracker after_first = tracker;
  tracker.markCarried(true);
  iterate(loop.body, tracker, &Step::barriers_next);
  tracker.markCarried(false);
  after_first.markCarried(false);
  STROBE_ASSERT(tracker == after_first, "loop {}", loop.index);
}

}  // namespace

void addBarriers(Plan& plan) {
  Tracker tracker(plan);
  for (Step& step : plan.steps) {
    step.barriers.clear();
    for (const Use& use : step.uses) tracker.apply(use, step.barriers);
    if (step.kind == Step::Kind::Loop) addLoopBarriers(step, tracker);
  }
}

int barrierCount(const Plan& plan) {
  size_t count = 0;
  for (const Step& step : plan.steps) {
    count += step.barriers.size();
    if (step.kind != Step::Kind::Loop) continue;
    size_t later_iterations = plan.loops[step.index].count - 1;
    for (const Step& inner : step.body) count += inner.barriers.size() + later_iterations * inner.barriers_next.size();
  }
  return static_cast<int>(count);
}

}  // namespace strobe::plan
