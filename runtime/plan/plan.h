// SPDX-License-Identifier: MIT
// A pipeline compiled for one frame size: which nodes run in which order, on which images, in which memory, and what
// has to be waited for in between. Data only: no device is needed to make one, print one or test one.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "plan/barriers.h"
#include "plan/description.h"

namespace strobe::plan {

// How an image is used, as bits; a slot has the union over the images it holds.
enum Usage : uint32_t {
  kUsageSampled = 1 << 0,
  kUsageStorage = 1 << 1,
  kUsageColorAttachment = 1 << 2,
  kUsageDepthAttachment = 1 << 3,
  kUsageTransferSource = 1 << 4,
  kUsageTransferTarget = 1 << 5,
};

// What one port of one node holds during a frame; or "node.@depth", the depth attachment of a raster node.
struct VirtualImage {
  std::string name;  // "node.port"
  std::string format;
  int width = 0, height = 0;
  uint32_t usage = 0;    // of this image alone
  int divide = 1;        // pixels of the frame per texel along an axis (tiles); 0: not a picture of the frame
  bool cleared = false;  // to zero whenever the node that writes it begins
  // Of a node that works within the reach: the image that it equals outside of that, or -1, also where nobody looks and
  // it has no contents; is it zero there?
  int outside = -1;
  bool zero_outside = false;
  bool zero = false;        // cleared to zero at the start of the frame and written by no node
  bool update = false;      // cleared to zero at the start of the frame, then read and written
  bool history = false;     // an updated image that is cleared before its first frame only
  bool kept = false;        // an output or a tap: whole and unchanged at the end of the frame
  int first = 0, last = 0;  // lifetime, inclusive: positions in `Plan::steps`
  bool read = false;        // some node samples it
  int slot = 0;             // index into `Plan::slots`
};

// Memory for one image at a time; all images that share it have the same format and size.
struct Slot {
  std::string format;
  int width = 0, height = 0;
  uint32_t usage = 0;
  uint64_t bytes = 0;
  bool zero_outside = false;  // as all images that share it
};

// A node that runs. Ports are in the order of the pass's declaration.
struct PlanNode {
  int node = 0;                                       // index into `pipeline.nodes`
  int pass = 0;                                       // index into `pipeline.passes`
  int loop = -1;                                      // index into `Plan::loops`, or -1
  int width = 0, height = 0;                          // of everything it writes
  int divide = 1;                                     // of everything it writes
  std::vector<std::pair<std::string, Value>> params;  // resolved, in the order of the pass's declaration
  std::vector<int> reads;                             // image per read port; -1 where an optional port is not wired
  std::vector<int> writes;                            // image per write port
  std::vector<int> updates;                           // image per update port
  int over = -1;   // image, a buffer, of the pixels that it runs for; -1: all of them
  int depth = -1;  // image of a raster node's depth attachment
  // In a loop, after its first iteration, it works on the pixels that something in motion reaches, and the others keep
  // what they have (Role::StillOnce).
  bool static_once = false;
  bool moving_only = false;  // before a camera at rest it draws what moves alone (Runs::MovingInstances)
  // It works on the pixels that something in motion reaches; the others have what stands in for it there: zeros, or a
  // copy of VirtualImage::outside, or nothing where nobody looks.
  bool in_moving_rect = false;
  bool counters = false;  // has a buffer of 32-bit event counts, in the order of the pass's declaration
};

struct PlanLoop {
  int loop = 0;  // index into `pipeline.loops`
  int count = 0;
  std::string times;  // one of LoopDesc::times
  int slices = 1;
  int first = 0, parts = 0;  // it takes `count` of so many parts of the exposure, from this on
  int until = -1;            // image read back after each iteration, non-zero to stop; or -1

  // True if each iteration is an exposure of its own. Its nodes then run on all pixels and instances, because
  // the moving rectangle and the moving instances apply to the whole frame.
  bool drawsParts() const { return times == kPartTimes; }
};

// One command of the frame, in the order of execution.
struct Step {
  enum class Kind {
    ClearImage,     // fill image `index` with zero
    CopyOutside,    // copy to image `index` what it equals outside of the reach, where there is such an outside
    ClearCounters,  // fill the counters of node `index` with zero
    Pass,           // run node `index`
    Loop,           // run `body` for each iteration of loop `index`
    ReadImage,      // copy image `index` out (an output, a tap; in a loop: its stop condition)
    ReadCounters,   // the host reads the counters of node `index`
  };
  Kind kind = Kind::Pass;
  int index = 0;
  std::vector<Step> body;              // of a loop; never holds another loop
  std::vector<Use> uses;               // what the command touches (a loop itself: nothing)
  std::vector<Barrier> barriers;       // to record before it; in a loop, before it in iteration 0
  std::vector<Barrier> barriers_next;  // in a loop: before it in every later iteration
};

struct CulledNode {
  std::string name;
  std::string reason;
  bool by_facts = false;  // it would run if all facts held
};

struct Plan {
  PipelineDesc pipeline;  // what it was made from, with `values` as overridden
  int width = 0, height = 0;
  std::vector<PlanNode> nodes;  // in the order of execution
  std::vector<PlanLoop> loops;  // those that run
  std::vector<VirtualImage> images;
  std::vector<Slot> slots;
  std::vector<Step> steps;
  std::vector<std::pair<std::string, int>> outputs;  // name of an output -> image
  std::vector<std::pair<std::string, int>> taps;     // "node.port" -> image
  std::vector<CulledNode> culled;                    // in the order of the calls
  std::vector<std::string> absent;                   // facts that do not hold, in the order of plan::facts()
};

struct CompileOptions {
  int width = 0, height = 0;      // of the frame, pixels
  std::vector<std::string> taps;  // "node.port" to keep and read back as well
  // Values that win over those in the description, by "param" (of the pipeline) or "node.param". A parameter of the
  // pipeline that decides the shape of the graph has done so already when the description was made.
  std::map<std::string, Value> set;
  Stage trace_stage = kStageCompute;  // where trace passes run: kStageCompute (queries) or kStageTrace (pipelines)
  // Facts that do not hold in the frame: where passes say what stands in for them, they do not run.
  std::vector<std::string> absent;
  // Outputs that are asked for; empty: all. Nodes that none of them needs do not run.
  std::set<std::string> outputs;
};

// Orders, culls, sizes, places and synchronises. Depends on its arguments alone.
// Throws `Error` with every mistake of the description it found, each at its place.
Plan compile(const PipelineDesc& pipeline, const CompileOptions& options);

// Whether a fact does not hold in the plan's frame.
bool lacks(const Plan& plan, const std::string& fact);

// Throws `Error` if an output that has to be as large as the frame is not: the colour, a region's mask, truth's error.
// Lists (PipelineDesc::Kind) may have any size.
// Its place is the `size` of the pass that decides the size.
void requireWholeOutputs(const Plan& plan);

// The image of "node.port", or -1.
int findImage(const Plan& plan, const std::string& name);

// Memory of all slots, and what it would be if every image had its own.
uint64_t bytesAliased(const Plan& plan);
uint64_t bytesUnaliased(const Plan& plan);

}  // namespace strobe::plan
