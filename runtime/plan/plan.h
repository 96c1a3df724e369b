// SPDX-License-Identifier: MIT
// A pipeline compiled for one frame size: nodes in execution order, their images, memory and barriers. A plan is data
// only; it can be made, printed and tested without a device.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "plan/barriers.h"
#include "plan/description.h"

namespace strobe::plan {

// Usages of an image, as bits. A slot has the union of the usages of its images.
enum Usage : uint32_t {
  kUsageSampled = 1 << 0,
  kUsageStorage = 1 << 1,
  kUsageColorAttachment = 1 << 2,
  kUsageDepthAttachment = 1 << 3,
  kUsageTransferSource = 1 << 4,
  kUsageTransferTarget = 1 << 5,
};

// Contents of one port of one node during a frame; or "node.@depth", the depth attachment of a raster node.
struct VirtualImage {
  std::string name;  // "node.port"
  std::string format;
  int width = 0, height = 0;
  uint32_t usage = 0;    // of this image only
  int divide = 1;        // pixels of the frame per texel along an axis (tiles); 0: texels are not pixels of the frame
  bool cleared = false;  // cleared to zero before each execution of the node that writes it
  // Node within the moving rectangle: the image that this image equals outside of the rectangle. -1: zero outside
  // (`cleared`), or not read outside and undefined there.
  int outside = -1;
  bool zero = false;        // cleared to zero at the start of the frame and written by no node
  bool update = false;      // cleared to zero at the start of the frame, then read and written
  bool history = false;     // an update that is cleared before its first frame only
  bool kept = false;        // an output or a tap: whole and unchanged at the end of the frame
  int first = 0, last = 0;  // lifetime, inclusive; positions in `Plan::steps`
  bool read = false;        // a node samples the image
  int slot = 0;             // index into `Plan::slots`
};

// Memory for one image at a time; all images that share it have the same format and size.
struct Slot {
  std::string format;
  int width = 0, height = 0;
  uint32_t usage = 0;
  uint64_t bytes = 0;
};

// A node that runs. Ports are in the order of the pass's declaration.
struct PlanNode {
  int node = 0;                                       // index into `pipeline.nodes`
  int pass = 0;                                       // index into `pipeline.passes`
  int loop = -1;                                      // index into `Plan::loops`, or -1
  int width = 0, height = 0;                          // of all images it writes
  int divide = 1;                                     // VirtualImage::divide of all images it writes
  std::vector<std::pair<std::string, Value>> params;  // resolved, in the order of the pass's declaration
  std::vector<int> reads;                             // image per read port; -1 for an optional port that is not wired
  std::vector<int> writes;                            // image per write port
  std::vector<int> updates;                           // image per update port
  int over = -1;   // image, a buffer, with the pixels that the node runs for; -1: all pixels
  int depth = -1;  // image of a raster node's depth attachment
  // In a loop: after the first iteration the node runs on the pixels of the moving rectangle, and the other pixels keep
  // their values (Role::StillOnce).
  bool static_once = false;
  bool moving_only = false;  // under a static camera the node draws moving instances only (Runs::MovingInstances)
  // The node runs on the pixels of the moving rectangle. The other pixels have the stand-in: zeros, or a copy of
  // VirtualImage::outside, or undefined values if they are not read.
  bool in_moving_rect = false;
  bool counters = false;  // the node has a buffer of 32-bit event counts, in the order of the declaration
};

// Loop of a compiled pipeline: number of iterations, their sample times in the exposure, and the image that stops the
// loop early.
struct PlanLoop {
  int loop = 0;  // index into `pipeline.loops`
  int count = 0;
  std::string times;  // one of LoopDesc::times
  int slices = 1;
  int first = 0, parts = 0;  // the loop takes `count` of `parts` parts of the exposure, from number `first` on
  int until = -1;            // image read back after each iteration, non-zero to stop; or -1

  // True if each iteration is an exposure of its own. Its nodes then run on all pixels and instances, because
  // the moving rectangle and the moving instances apply to the whole frame.
  bool drawsParts() const { return times == kPartTimes; }
};

// One command of the frame, in the order of execution.
struct Step {
  enum class Kind {
    ClearImage,     // fill image `index` with zero
    CopyOutside,    // copy VirtualImage::outside to image `index`, for the pixels outside of the moving rectangle
    ClearCounters,  // fill the counters of node `index` with zero
    Pass,           // run node `index`
    Loop,           // run `body` for each iteration of loop `index`
    ReadImage,      // read back image `index` (an output or a tap; in a loop, its stop condition)
    ReadCounters,   // the host reads the counters of node `index`
  };
  Kind kind = Kind::Pass;
  int index = 0;
  std::vector<Step> body;              // of a loop; does not contain loops
  std::vector<Use> uses;               // accesses of the command; a loop itself has no uses
  std::vector<Barrier> barriers;       // recorded before the command; in a loop, in iteration 0
  std::vector<Barrier> barriers_next;  // in a loop: recorded before the command in later iterations
};

// Node that does not run in this frame, with the reason.
struct CulledNode {
  std::string name;
  std::string reason;
  bool by_facts = false;  // the node would run if all facts held
};

// Compiled render graph for one frame size: nodes and commands in execution order, images, shared memory slots,
// barriers and outputs.
struct Plan {
  PipelineDesc pipeline;  // description of the pipeline, with the overridden `values`
  int width = 0, height = 0;
  std::vector<PlanNode> nodes;  // in the order of execution
  std::vector<PlanLoop> loops;  // loops that run
  std::vector<VirtualImage> images;
  std::vector<Slot> slots;
  std::vector<Step> steps;
  std::vector<std::pair<std::string, int>> outputs;  // name of an output -> image
  std::vector<std::pair<std::string, int>> taps;     // "node.port" -> image
  std::vector<CulledNode> culled;                    // in the order of the calls
  std::vector<std::string> absent;                   // facts that do not hold, in the order of plan::facts()

  const NodeDesc& descOf(const PlanNode& node) const { return pipeline.nodes[size_t(node.node)]; }
  const PassDesc& passOf(const PlanNode& node) const { return pipeline.passes[size_t(node.pass)]; }
};

// Options of the compilation of a pipeline: frame size in pixels, requested outputs, intermediate images to keep, and
// absent features of the frame.
struct CompileOptions {
  int width = 0, height = 0;      // frame size, pixels
  std::vector<std::string> taps;  // "node.port" of images that are also kept and read back
  PipelineStage trace_stage =
      kStageCompute;  // stage of trace passes: kStageCompute (queries) or kStageTrace (pipelines)
  // Facts that do not hold in the frame. Passes with a stand-in for a missing fact do not run.
  std::vector<std::string> absent;
  // Requested outputs; empty: all outputs. Nodes that no requested output needs do not run.
  std::set<std::string> outputs;
};

// Compiles a pipeline: order, culled nodes, sizes, memory and barriers. The result depends on the arguments only.
// Throws `Error` with every mistake in the description, each with its place.
Plan compile(const PipelineDesc& pipeline, const CompileOptions& options);

// True if a fact does not hold in the plan's frame.
bool lacks(const Plan& plan, const std::string& fact);

// Throws `Error` if the colour, the mask of a region or the error of ground truth is not as large as the frame. The
// outputs of lists (PipelineDesc::Kind) may have any size. The place of the error is the `size` of the pass that
// decides the size.
void requireWholeOutputs(const Plan& plan);

// The image of "node.port", or -1.
int findImage(const Plan& plan, const std::string& name);

// Memory of all slots, and memory without sharing, bytes.
uint64_t bytesAliased(const Plan& plan);
uint64_t bytesUnaliased(const Plan& plan);

}  // namespace strobe::plan
