// SPDX-License-Identifier: MIT
#include "plan/replay.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "plan/formats.h"

namespace strobe::plan::test {
namespace {

struct Touch {
  int memory = 0;  // slot, or number of slots + node for counters
  int image = -1;
  uint32_t stage = 0;  // one bit
  uint32_t reads = 0, writes = 0;
};

// A past access and its guarantees since then.
struct Event {
  Touch touch;
  std::string command;
  uint32_t followed_by = 0;                     // stages whose later accesses wait for this one
  bool available = false;                       // its writes have left the caches of its stage
  std::array<uint32_t, kStageCount> visible{};  // accesses per stage with visible writes
};

class Replay {
 public:
  Replay(const Plan& plan, uint32_t trace_stage, int iterations)
      : plan_(plan), trace_stage_(trace_stage), iterations_(iterations) {}

  std::vector<std::string> run() {
    for (const Step& step : plan_.steps) {
      execute(step, step.barriers, "");
      if (step.kind != Step::Kind::Loop) continue;
      int count = plan_.loops[step.index].count;
      if (iterations_ > 0) count = std::min(count, iterations_);
      for (int k = 0; k < count; ++k) {
        for (const Step& inner : step.body) {
          execute(inner, k == 0 ? inner.barriers : inner.barriers_next, fmt::format(" of iteration {}", k));
        }
      }
    }
    return problems_;
  }

 private:
  void execute(const Step& step, const std::vector<Barrier>& barriers, const std::string& when) {
    wait(barriers);
    std::string command = commandName(step) + when;
    std::vector<Touch> touches = touchesOf(step);
    for (const Touch& touch : touches) judge(touch, command);
    for (const Touch& touch : touches) {
      events_[touch.memory].push_back({touch, command});
      if (touch.writes) holds_[touch.memory] = touch.image;
    }
  }

  // The barriers of one command are one batch: they do not wait for each other.
  void wait(const std::vector<Barrier>& barriers) {
    for (auto& [memory, events] : events_) {
      for (Event& event : events) {
        Event before = event;
        for (const Barrier& barrier : barriers) {
          if (memoryOf(barrier.resource) == memory) guarantee(event, before, barrier);
        }
      }
    }
  }

  static void guarantee(Event& event, const Event& before, const Barrier& barrier) {
    bool own_stage = event.touch.stage & barrier.src_stages;
    bool chained = before.followed_by & barrier.src_stages;
    if (!own_stage && !chained) return;
    event.followed_by |= barrier.dst_stages;
    bool flushed = own_stage && (event.touch.writes & ~barrier.src_access) == 0;
    event.available = event.available || flushed;
    if (!flushed && !before.available) return;
    for (int s = 0; s < kStageCount; ++s) {
      if (barrier.dst_stages & (1u << s)) event.visible[s] |= barrier.dst_access;
    }
  }

  void judge(const Touch& touch, const std::string& command) {
    if (touch.image >= 0 && touch.reads) judgeContents(touch, command);
    for (const Event& earlier : events_[touch.memory]) {
      if (!earlier.touch.writes && !touch.writes) continue;
      if (!(earlier.followed_by & touch.stage)) {
        problem("{} does not wait for {} ({})", command, earlier.command, name(touch));
      } else if (earlier.touch.writes && !sees(touch, earlier)) {
        problem("{} does not see {} ({})", command, earlier.command, name(touch));
      }
    }
  }

  // A depth attachment is cleared as a part of the pass: its earlier contents do not matter.
  void judgeContents(const Touch& touch, const std::string& command) {
    if (touch.reads & kAccessDepthRead) return;
    auto held = holds_.find(touch.memory);
    if (held == holds_.end()) problem("{} reads {}, which holds nothing yet", command, name(touch));
    else if (held->second != touch.image) {
      problem("{} reads {}, but finds {}", command, name(touch), plan_.images[held->second].name);
    }
  }

  static bool sees(const Touch& touch, const Event& earlier) {
    uint32_t all = touch.reads | touch.writes;
    for (int s = 0; s < kStageCount; ++s) {
      if ((touch.stage & (1u << s)) && (all & ~earlier.visible[s])) return false;
    }
    return true;
  }

  std::vector<Touch> touchesOf(const Step& step) const {
    switch (step.kind) {
      case Step::Kind::ClearImage:
        return {image(step.index, kStageTransfer, 0, kAccessTransferWrite)};
      case Step::Kind::CopyOutside:
        return {image(plan_.images[step.index].outside, kStageTransfer, kAccessTransferRead, 0),
                image(step.index, kStageTransfer, 0, kAccessTransferWrite)};
      case Step::Kind::ReadImage:
        return {image(step.index, kStageTransfer, kAccessTransferRead, 0)};
      case Step::Kind::ClearCounters:
        return {counters(step.index, kStageTransfer, 0, kAccessTransferWrite)};
      case Step::Kind::ReadCounters:
        return {counters(step.index, kStageHost, kAccessHostRead, 0)};
      case Step::Kind::Pass:
        return passTouches(step.index);
      case Step::Kind::Loop:
        return {};
    }
    return {};
  }

  std::vector<Touch> passTouches(int index) const {
    const PlanNode& node = plan_.nodes[index];
    const PassDesc& pass = plan_.pipeline.passes[node.pass];
    std::vector<Touch> touches;
    bool raster = pass.kind == PassDesc::Kind::Raster;
    uint32_t stage = raster ? kStageFragment : pass.kind == PassDesc::Kind::Trace ? trace_stage_ : kStageCompute;
    for (int read : node.reads) {
      if (read < 0) continue;
      const bool buffer = isBuffer(plan_.images[read].format);
      touches.push_back(image(read, stage, buffer ? kAccessStorageRead : kAccessSampledRead, 0));
    }
    for (size_t i = 0; i < pass.reads.size(); ++i)
      if (pass.reads[i].name == pass.over && node.reads[i] >= 0)
        touches.push_back(image(node.reads[i], kStageIndirect, kAccessIndirectRead, 0));
    for (int write : node.writes) {
      const uint32_t reads = isBuffer(plan_.images[write].format) ? uint32_t(kAccessStorageRead) : 0;  // its atomics
      touches.push_back(raster ? image(write, kStageColor, 0, kAccessColorWrite)
                               : image(write, stage, reads, kAccessStorageWrite));
    }
    for (int update : node.updates) touches.push_back(image(update, stage, kAccessStorageRead, kAccessStorageWrite));
    if (raster) touches.push_back(image(node.depth, kStageDepth, kAccessDepthRead, kAccessDepthWrite));
    if (!pass.counters.empty()) touches.push_back(counters(index, stage, kAccessStorageRead, kAccessStorageWrite));
    return touches;
  }

  Touch image(int index, uint32_t stage, uint32_t reads, uint32_t writes) const {
    return {plan_.images[index].slot, index, stage, reads, writes};
  }

  Touch counters(int node, uint32_t stage, uint32_t reads, uint32_t writes) const {
    return {static_cast<int>(plan_.slots.size()) + node, -1, stage, reads, writes};
  }

  int memoryOf(const Resource& resource) const {
    bool slot = resource.kind == Resource::Kind::Slot;
    return slot ? resource.index : static_cast<int>(plan_.slots.size()) + resource.index;
  }

  std::string name(const Touch& touch) const { return touch.image >= 0 ? plan_.images[touch.image].name : "counters"; }

  std::string commandName(const Step& step) const {
    switch (step.kind) {
      case Step::Kind::ClearImage:
        return "clear of " + plan_.images[step.index].name;
      case Step::Kind::CopyOutside:
        return "copy to " + plan_.images[step.index].name;
      case Step::Kind::ReadImage:
        return "read-back of " + plan_.images[step.index].name;
      case Step::Kind::ClearCounters:
        return "clear of counters";
      case Step::Kind::ReadCounters:
        return "read-back of counters";
      case Step::Kind::Pass:
        return plan_.pipeline.nodes[plan_.nodes[step.index].node].name;
      case Step::Kind::Loop:
        return "loop";
    }
    return "";
  }

  template <class... Args>
  void problem(fmt::format_string<Args...> format, Args&&... args) {
    problems_.push_back(fmt::format(format, std::forward<Args>(args)...));
  }

  const Plan& plan_;
  uint32_t trace_stage_;
  int iterations_;
  std::map<int, std::vector<Event>> events_;  // per memory
  std::map<int, int> holds_;                  // image written last, per memory
  std::vector<std::string> problems_;
};

}  // namespace

std::vector<std::string> replay(const Plan& plan, uint32_t trace_stage, int iterations) {
  return Replay(plan, trace_stage, iterations).run();
}

std::vector<std::string> replayAll(const Plan& plan, uint32_t trace_stage) {
  int longest = 1;
  for (const PlanLoop& loop : plan.loops) longest = std::max(longest, loop.count);
  std::vector<std::string> problems;
  for (int iterations = 1; iterations <= longest; ++iterations) {
    std::vector<std::string> found = replay(plan, trace_stage, iterations);
    problems.insert(problems.end(), found.begin(), found.end());
  }
  return problems;
}

}  // namespace strobe::plan::test
