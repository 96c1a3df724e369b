// SPDX-License-Identifier: MIT
#include "plan/plan.h"

#include <algorithm>
#include <map>

#include "base/lists.h"
#include "plan/facts.h"
#include "plan/formats.h"
#include "plan/named.h"
#include "plan/omission.h"
#include "plan/order.h"
#include "plan/sizes.h"
#include "plan/slots.h"

namespace strobe::plan {
namespace {

class Compiler {
 public:
  Compiler(const PipelineDesc& pipeline, const CompileOptions& options)
      : options_(options), wiring_(wire(pipeline, options)) {
    plan_.pipeline = pipeline;
    plan_.pipeline.values = wiring_.values;
    plan_.width = options.width;
    plan_.height = options.height;
    for (const Fact& fact : facts())
      if (contains(options.absent, fact.name)) plan_.absent.push_back(fact.name);
  }

  Plan compile() {
    std::vector<bool> with_all_facts = neededNodes(wiring_);
    std::vector<std::string> left_out = leaveOut(plan_.pipeline, plan_.absent, wiring_);
    std::vector<bool> needed = neededNodes(wiring_);
    std::vector<Unit> units = orderNodes(wiring_, needed);
    for (size_t i = 0; i < needed.size(); ++i)
      if (!needed[i] || wiring_.nodes[i].blank) addCulled(i, with_all_facts[i], left_out[i]);
    makeNodes(units);
    keepImages();
    leaveOutCopies();
    addClears();
    for (const Unit& unit : units) addUnit(unit);
    addReadBacks();

    assignSlots(plan_);
    for (Step& step : plan_.steps) fillSlots(step);
    addBarriers(plan_);
    return std::move(plan_);
  }

 private:
  void addCulled(size_t node, bool with_all_facts, const std::string& left_out) {
    std::string reason = options_.outputs.empty() ? "not needed by any output" : "not needed by any requested output";
    if (with_all_facts) reason = left_out.empty() ? "needed only by nodes that do not run" : left_out;
    plan_.culled.push_back({plan_.pipeline.nodes[node].name, reason, with_all_facts});
  }

  void makeNodes(const std::vector<Unit>& units) {
    of_desc_.assign(wiring_.nodes.size(), -1);
    for (const Unit& unit : units) {
      if (unit.loop >= 0) plan_.loops.push_back(wiring_.loops[unit.loop].loop);
      for (int index : unit.nodes) addNode(index, unit.loop < 0 ? -1 : static_cast<int>(plan_.loops.size()) - 1);
      if (unit.loop >= 0 && wiring_.loops[unit.loop].until.node >= 0)
        plan_.loops.back().until = untilImage(wiring_.loops[unit.loop].until, unit.loop);
    }
  }

  int untilImage(const PortSource& source, int loop) {
    int image = imageOf(source);
    const VirtualImage& until = plan_.images[image];
    if (until.width == 1 && until.height == 1) return image;
    throw Error(fmt::format("loop '{}' stops on '{}', which is {}x{} instead of 1x1", plan_.pipeline.loops[loop].name,
                            until.name, until.width, until.height),
                plan_.pipeline.loops[loop].place);
  }

  // True if the pass has a bool parameter with that role and the value true.
  static bool isSet(Role role, const PassDesc& pass, const std::vector<std::pair<std::string, Value>>& params) {
    for (size_t i = 0; i < pass.params.size(); ++i)
      if (pass.params[i].role == role) return std::get<bool>(params[i].second);
    return false;
  }

  void addNode(int index, int loop) {
    const WiredNode& wired = wiring_.nodes[index];
    const PassDesc& pass = plan_.pipeline.passes[wired.pass];
    PlanNode node;
    node.node = index;
    node.pass = wired.pass;
    node.loop = loop;
    node.params = wired.params;
    bool raster = pass.kind == PassDesc::Kind::Raster;
    const bool in_parts = loop >= 0 && plan_.loops[size_t(loop)].drawsParts();
    node.static_once = loop >= 0 && !in_parts && !raster && isSet(Role::StillOnce, pass, node.params);
    const Runs runs = in_parts ? Runs::Everywhere : plan_.pipeline.nodes[size_t(index)].runs;
    node.moving_only = runs == Runs::MovingInstances;
    node.counters = !pass.counters.empty();
    for (const PortSource& source : wired.reads) node.reads.push_back(source.node < 0 ? -1 : imageOf(source));
    const NodeSize size = sizeOf(plan_.pipeline, wiring_, index);
    node.width = size.width, node.height = size.height, node.divide = size.divide;

    uint32_t usage = raster ? kUsageColorAttachment : kUsageStorage;
    for (const PortDesc& port : pass.writes) {
      int image = addImage(node, port.name, formatOf(port, node.params), usage);
      plan_.images[image].width *= port.each;
      plan_.images[image].cleared = isCleared(port);
      if (isCleared(port)) plan_.images[image].usage |= kUsageTransferTarget;
      node.writes.push_back(image);
    }
    for (const PortDesc& port : pass.updates) {
      int image = addImage(node, port.name, formatOf(port, node.params), kUsageStorage | kUsageTransferTarget);
      plan_.images[image].width *= port.each;
      plan_.images[image].update = true;
      plan_.images[image].history = port.history;
      node.updates.push_back(image);
    }
    node.over = readNamed(node, pass, pass.over);
    if (node.over >= 0) node.static_once = false;
    node.in_moving_rect = runs == Runs::MovingRect && !raster && !node.static_once && mayRunInMovingRect(node, pass);
    if (raster) node.depth = addImage(node, "@depth", "d32f", kUsageDepthAttachment);
    for (int image : node.reads) markRead(image);

    of_desc_[index] = static_cast<int>(plan_.nodes.size());
    plan_.nodes.push_back(std::move(node));
  }

  // Decides if a node may run within the moving rectangle only, and sets `outside` of its images. The pass needs a
  // stand-in for the pixels outside. The node runs on all pixels if a stand-in has another format or size, or if the
  // stand-in is an image that is itself computed outside of the rectangle although its pass has a stand-in for these
  // pixels.
  bool mayRunInMovingRect(const PlanNode& node, const PassDesc& pass) {
    const WithoutDesc* outside = find(pass.without, kMovingRect);
    if (!outside || node.over >= 0 || stopsLoop(node)) return false;
    std::vector<int> stand_ins;
    for (size_t i = 0; i < node.writes.size(); ++i) {
      const VirtualImage& image = plan_.images[node.writes[i]];
      const int stand_in = readNamed(node, pass, outside->writes[i].second);
      if (isBuffer(image.format) && stand_in >= 0) return false;
      if (stand_in >= 0) {
        if (runsOutside(stand_in)) return false;
        const VirtualImage& other = plan_.images[stand_in];
        if (other.format != image.format || other.width != image.width || other.height != image.height) return false;
      }
      stand_ins.push_back(stand_in);
    }
    for (size_t i = 0; i < stand_ins.size(); ++i) {
      VirtualImage& image = plan_.images[node.writes[i]];
      if (isBuffer(image.format)) continue;  // cleared before the pass, and its stand-in is zero
      image.outside = stand_ins[i];
      if (image.outside < 0) {
        image.cleared = true;
        image.usage |= kUsageTransferTarget;
        continue;
      }
      // The stand-in may itself be a copy: copy from the original then.
      const int copied = plan_.images[image.outside].outside;
      if (copied >= 0) image.outside = copied;
    }
    return true;
  }

  bool stopsLoop(const PlanNode& node) const {
    return std::any_of(wiring_.loops.begin(), wiring_.loops.end(),
                       [&](const WiredLoop& loop) { return loop.until.node == node.node; });
  }

  // True if the image is written outside of the moving rectangle although its pass has a stand-in for these pixels.
  bool runsOutside(int image) const {
    for (const PlanNode& node : plan_.nodes) {
      if (std::find(node.writes.begin(), node.writes.end(), image) == node.writes.end()) continue;
      return !node.in_moving_rect && find(plan_.passOf(node).without, kMovingRect);
    }
    return false;
  }

  // Drops the copies of images that are not read outside of the moving rectangle.
  void leaveOutCopies() {
    std::vector<bool> looked_at(plan_.images.size());
    auto is_whole = [&](const auto& one) { return one.width == plan_.width && one.height == plan_.height; };
    for (const PlanNode& node : plan_.nodes) {
      const std::vector<PortDesc>& reads = plan_.passOf(node).reads;
      for (size_t i = 0; i < reads.size(); ++i) {
        if (node.reads[i] < 0) continue;
        const bool same_pixel = reads[i].pointwise && is_whole(node) && is_whole(plan_.images[node.reads[i]]);
        if (!node.in_moving_rect || !same_pixel) looked_at[node.reads[i]] = true;
      }
    }
    for (size_t i = 0; i < plan_.images.size(); ++i)
      if (!looked_at[i] && !plan_.images[i].kept) plan_.images[i].outside = -1;
  }

  // The image of the read `name`; -1 for "" and unwired reads.
  static int readNamed(const PlanNode& node, const PassDesc& pass, const std::string& name) {
    const int read = indexOf(pass.reads, name);
    return read < 0 ? -1 : node.reads[size_t(read)];
  }

  int addImage(const PlanNode& node, const std::string& port, const std::string& format, uint32_t usage) {
    VirtualImage image;
    image.name = plan_.descOf(node).name + "." + port;
    image.format = format;
    image.width = node.width;
    image.height = node.height;
    image.divide = isBuffer(format) ? 0 : node.divide;
    image.usage = usage;
    plan_.images.push_back(std::move(image));
    return static_cast<int>(plan_.images.size()) - 1;
  }

  void markRead(int image) {
    if (image < 0) return;
    plan_.images[image].read = true;
    plan_.images[image].usage |= kUsageSampled;
  }

  int imageOf(const PortSource& source) {
    if (wiring_.nodes[source.node].blank) return zerosOf(source);
    const PlanNode& node = plan_.nodes[of_desc_[source.node]];
    size_t writes = node.writes.size();
    size_t port = source.port;
    return port < writes ? node.writes[port] : node.updates[port - writes];
  }

  // Image of zeros in place of a port of a node that is left out.
  int zerosOf(const PortSource& source) {
    auto [known, is_new] = zeros_.try_emplace({source.node, source.port}, -1);
    if (!is_new) return known->second;
    const NodeSize size = sizeOf(plan_.pipeline, wiring_, source.node);
    const PortDesc& port = portOf(plan_.pipeline, wiring_, source);
    PlanNode node;
    node.node = source.node;
    node.width = size.width, node.height = size.height, node.divide = size.divide;
    const std::string& format = formatOf(port, wiring_.nodes[source.node].params);
    known->second = addImage(node, port.name, format, kUsageSampled | kUsageTransferTarget);
    plan_.images[known->second].width *= port.each;
    plan_.images[known->second].zero = true;
    return known->second;
  }

  void keepImages() {
    for (size_t i = 0; i < wiring_.outputs.size(); ++i) {
      if (wiring_.outputs[i].node < 0) continue;
      plan_.outputs.emplace_back(plan_.pipeline.outputs[i].first, keep(wiring_.outputs[i]));
    }
    for (size_t i = 0; i < wiring_.taps.size(); ++i) {
      plan_.taps.emplace_back(options_.taps[i], keep(wiring_.taps[i]));
    }
    for (const PlanLoop& loop : plan_.loops) {
      if (loop.until >= 0) plan_.images[loop.until].usage |= kUsageTransferSource;
    }
  }

  int keep(const PortSource& source) {
    int image = imageOf(source);
    plan_.images[image].kept = true;
    plan_.images[image].usage |= kUsageTransferSource;
    return image;
  }

  // The slot is set later, by `fillSlots`.
  static Use imageUse(int image, uint32_t stages, uint32_t access) { return {{}, image, stages, access}; }
  static Use counterUse(int node, uint32_t stages, uint32_t access) {
    return {{Resource::Kind::Counters, node}, -1, stages, access};
  }

  void addCopyOutside(std::vector<Step>& steps, int image) {
    plan_.images[image].usage |= kUsageTransferTarget;
    plan_.images[plan_.images[image].outside].usage |= kUsageTransferSource;
    addStep(steps, Step::Kind::CopyOutside, image,
            {imageUse(plan_.images[image].outside, kStageTransfer, kAccessTransferRead),
             imageUse(image, kStageTransfer, kAccessTransferWrite)});
  }

  static void addClear(std::vector<Step>& steps, int image) {
    addStep(steps, Step::Kind::ClearImage, image, {imageUse(image, kStageTransfer, kAccessTransferWrite)});
  }

  void addClears() {
    for (size_t i = 0; i < plan_.images.size(); ++i) {
      if (!plan_.images[i].update && !plan_.images[i].zero) continue;
      addClear(plan_.steps, static_cast<int>(i));
    }
    for (size_t i = 0; i < plan_.nodes.size(); ++i) {
      if (!plan_.nodes[i].counters) continue;
      int node = static_cast<int>(i);
      addStep(plan_.steps, Step::Kind::ClearCounters, node, {counterUse(node, kStageTransfer, kAccessTransferWrite)});
    }
  }

  void addUnit(const Unit& unit) {
    if (unit.loop < 0) return addPass(plan_.steps, of_desc_[unit.nodes.front()]);
    int loop = plan_.nodes[of_desc_[unit.nodes.front()]].loop;
    addStep(plan_.steps, Step::Kind::Loop, loop, {});
    std::vector<Step>& body = plan_.steps.back().body;
    for (int index : unit.nodes) addPass(body, of_desc_[index]);
    int until = plan_.loops[loop].until;
    if (until >= 0) addStep(body, Step::Kind::ReadImage, until, {imageUse(until, kStageTransfer, kAccessTransferRead)});
  }

  void addPass(std::vector<Step>& steps, int index) {
    const PlanNode& node = plan_.nodes[index];
    PassDesc::Kind kind = plan_.passOf(node).kind;
    uint32_t shader = kStageCompute;
    if (kind == PassDesc::Kind::Raster) shader = kStageFragment;
    if (kind == PassDesc::Kind::Trace) shader = options_.trace_stage;

    for (int image : node.writes) {
      if (plan_.images[image].cleared) addClear(steps, image);
      if (plan_.images[image].outside >= 0) addCopyOutside(steps, image);
    }
    std::vector<Use> uses;
    for (int image : node.reads) {
      bool seen = std::any_of(uses.begin(), uses.end(), [&](const Use& use) { return use.image == image; });
      if (image < 0 || seen) continue;
      const bool buffer = isBuffer(plan_.images[image].format);
      uses.push_back(imageUse(image, shader, buffer ? kAccessStorageRead : kAccessSampledRead));
    }
    if (node.over >= 0) uses.push_back(imageUse(node.over, kStageIndirect, kAccessIndirectRead));
    const bool raster = kind == PassDesc::Kind::Raster;
    const uint32_t read_write = kAccessStorageRead | kAccessStorageWrite;
    for (int image : node.writes) {
      const bool adds = isBuffer(plan_.images[image].format);  // buffers are cleared, then read and written
      uses.push_back(raster ? imageUse(image, kStageColor, kAccessColorWrite)
                            : imageUse(image, shader, adds ? read_write : kAccessStorageWrite));
    }
    for (int image : node.updates) uses.push_back(imageUse(image, shader, read_write));
    if (node.depth >= 0) uses.push_back(imageUse(node.depth, kStageDepth, kAccessDepthRead | kAccessDepthWrite));
    if (node.counters) uses.push_back(counterUse(index, shader, read_write));
    addStep(steps, Step::Kind::Pass, index, std::move(uses));
  }

  // Reads each kept image once, even if it has several names.
  void addReadBacks() {
    for (size_t i = 0; i < plan_.images.size(); ++i) {
      if (!plan_.images[i].kept) continue;
      int image = static_cast<int>(i);
      addStep(plan_.steps, Step::Kind::ReadImage, image, {imageUse(image, kStageTransfer, kAccessTransferRead)});
    }
    for (size_t i = 0; i < plan_.nodes.size(); ++i) {
      if (!plan_.nodes[i].counters) continue;
      int node = static_cast<int>(i);
      addStep(plan_.steps, Step::Kind::ReadCounters, node, {counterUse(node, kStageHost, kAccessHostRead)});
    }
  }

  static void addStep(std::vector<Step>& steps, Step::Kind kind, int index, std::vector<Use> uses) {
    Step step;
    step.kind = kind;
    step.index = index;
    step.uses = std::move(uses);
    steps.push_back(std::move(step));
  }

  void fillSlots(Step& step) {
    for (Use& use : step.uses) {
      if (use.image >= 0) use.resource = {Resource::Kind::Slot, plan_.images[use.image].slot};
    }
    for (Step& inner : step.body) fillSlots(inner);
  }

  const CompileOptions& options_;
  Wiring wiring_;
  Plan plan_;
  std::map<std::pair<int, int>, int> zeros_;  // images of zeros, by node and port
  std::vector<int> of_desc_;  // index into `plan_.nodes` by index into the description, -1 for culled nodes
};

}  // namespace

Plan compile(const PipelineDesc& pipeline, const CompileOptions& options) {
  return Compiler(pipeline, options).compile();
}

// The pass that decides the size of "node.port". Passes that are as large as a read are followed to that read.
static const PassDesc& sizingPass(const PipelineDesc& pipeline, std::string source) {
  while (true) {
    const NodeDesc& node = *find(pipeline.nodes, source.substr(0, source.find('.')));
    const PassDesc& pass = *find(pipeline.passes, node.pass);
    if (pass.size.kind != SizeDesc::Kind::Port || !pass.size.divide.empty()) return pass;
    if (const std::string* from = valueIn(node.inputs, pass.size.port)) source = *from;
  }
}

void requireWholeOutputs(const Plan& plan) {
  const PipelineDesc& pipeline = plan.pipeline;
  if (pipeline.kind == PipelineDesc::Kind::List) return;
  std::vector<std::string> whole = {"color"};
  for (const RegionDesc& region : pipeline.regions) whole.push_back(region.name);
  if (pipeline.kind == PipelineDesc::Kind::Truth) whole.push_back("error");
  for (const auto& [name, index] : plan.outputs) {
    const VirtualImage& image = plan.images[size_t(index)];
    if (!contains(whole, name) || image.divide == 1) continue;
    const PassDesc& pass = sizingPass(pipeline, image.name);
    throw Error(
        fmt::format("output '{}' of pipeline '{}' is '{}', which is {}x{} in a frame of {}x{}; it has to be as "
                    "large as the frame, and pass '{}' decides its size",
                    name, pipeline.name, image.name, image.width, image.height, plan.width, plan.height, pass.name),
        pass.size.place);
  }
}

bool lacks(const Plan& plan, const std::string& fact) { return contains(plan.absent, fact); }

int findImage(const Plan& plan, const std::string& name) { return indexOf(plan.images, name); }

uint64_t bytesAliased(const Plan& plan) {
  uint64_t bytes = 0;
  for (const Slot& slot : plan.slots) bytes += slot.bytes;
  return bytes;
}

uint64_t bytesUnaliased(const Plan& plan) {
  uint64_t bytes = 0;
  for (const VirtualImage& image : plan.images) bytes += plan.slots[image.slot].bytes;
  return bytes;
}

}  // namespace strobe::plan
