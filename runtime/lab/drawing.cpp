// SPDX-License-Identifier: MIT
#include "lab/drawing.h"

#include <algorithm>
#include <cmath>
#include <future>

#include "base/interruption.h"
#include "base/log.h"
#include "base/memory.h"
#include "gpu/limits.h"
#include "lab/frame.h"
#include "lab/record.h"
#include "lab/warnings.h"
#include "plan/canonical.h"
#include "plan/formats.h"
#include "world/fits.h"

namespace strobe::lab {

// ---- plans

const std::string& Planned::shape() const {
  if (shape_.empty()) shape_ = plan::shapeOf(*plan);
  return shape_;
}

// The hash for the record does not depend on the facts of the frame, so another thread computes it meanwhile.
Planned plannedOf(const Workbench& bench, const Shot& shot, HeldScene* scene, const plan::PipelineDesc& pipeline,
                  const std::set<std::string>& outputs) {
  Planned planned;
  planned.backend = bench.chooseBackend(shot.backend);
  Shot untapped = shot;
  untapped.taps.clear();
  std::future<std::string> hash =
      std::async(std::launch::async, [&] { return plan::hashOf(planOf(untapped, pipeline, planned.backend)); });
  std::vector<std::string> absent;
  if (scene) absent = absentFacts(scene->frame(shot, plan::earlierFrames(pipeline)), pipeline);
  planned.plan = std::make_shared<const plan::Plan>(planOf(shot, pipeline, planned.backend, absent, outputs));
  planned.hash = hash.get();
  return planned;
}

// ---- memory

// Bytes of a drawing, estimated before the first allocation.
struct DrawingBytes {
  uint64_t scene = 0;
  graph::ImageBytes images;

  uint64_t onDevice() const { return scene + images.on_device; }
  uint64_t onHost() const { return images.read_back + images.pictures; }
  std::string text() const {
    return fmt::format("images {}, read back {}, pictures {}, scene {}", bytesText(images.on_device),
                       bytesText(images.read_back), bytesText(images.pictures), bytesText(scene));
  }
};

static DrawingBytes drawingBytes(const HeldScene& held, const Planned& planned, uint32_t slices, size_t frames) {
  const scene::Scene& scene = held.scene;
  const shader::StructureKind structures = shader::rowOf(planned.backend).structures;
  DrawingBytes bytes{0, graph::Graph::bytes(*planned.plan, frames)};
  if (!held.unposed) bytes.scene = world::unposedBytes(scene, structures);
  if (!held.on_device.count({slices, structures})) bytes.scene += world::posedBytes(scene, slices);
  return bytes;
}

// Bytes without the images reused from the previous drawing. Images are reused only if the frame sizes are equal.
static graph::ImageBytes withoutTaken(graph::ImageBytes bytes, const plan::Plan& plan, const plan::Plan& previous,
                                      size_t frames) {
  if (plan.width != previous.width || plan.height != previous.height) return bytes;
  const graph::ImageBytes taken = graph::Graph::bytes(previous, frames);
  bytes.on_device -= std::min(bytes.on_device, taken.on_device);
  bytes.read_back -= std::min(bytes.read_back, taken.read_back);
  return bytes;
}

static void requireBytes(const plan::Plan& plan, const std::string& of, uint64_t bytes, uint64_t available,
                         const std::string& where) {
  if (bytes <= available) return;
  throw Error(
      gpu::kMemoryLimit.text(fmt::format("{} at {}x{} takes {} ({}), of {} available {}", plan.pipeline.name,
                                         plan.width, plan.height, bytesText(bytes), of, bytesText(available), where)));
}

// Throws `Error` before the first allocation. If the device shares the memory of the machine, the system would kill a
// program that takes too much.
static void requireBytes(const gpu::Device& device, const plan::Plan& plan, const DrawingBytes& bytes, uint64_t most) {
  const gpu::DeviceLimits limits = gpu::limitsOf(device);
  const std::string on_device = fmt::format("on device '{}'", device.info().name);
  const bool shared = device.info().shares_memory;
  const uint64_t available = std::min(limits.memory_bytes, most), on_host = std::min(limits.host_bytes, most);
  requireBytes(plan, bytes.text(), bytes.onDevice() + (shared ? bytes.onHost() : 0), available, on_device);
  if (!shared) requireBytes(plan, bytes.text(), bytes.onHost(), on_host, "in this machine's memory");
}

Drawing::Drawing(Workbench& bench, std::shared_ptr<HeldScene> scene, Planned planned,
                 std::shared_ptr<const Evaluation> evaluation, Drawing* previous, std::vector<std::string>* problems,
                 bool whole)
    : bench_(bench), scene_(std::move(scene)), planned_(std::move(planned)), evaluation_(std::move(evaluation)) {
  const gpu::Device& device = bench.device();
  const uint32_t slices = SLICE_SAMPLE + graph::Graph::sampleSlices(plan());
  DrawingBytes bytes = drawingBytes(*scene_, planned_, slices, bench.frames_in_flight);
  if (previous) bytes.images = withoutTaken(bytes.images, plan(), previous->plan(), bench.frames_in_flight);
  requireBytes(device, plan(), bytes, bench.most_bytes);
  on_device_ = scene_->onDevice(device, slices, shader::rowOf(planned_.backend).structures);
  if (previous && previous->graph_) previous->graph_->drop();
  if (previous && !problems && previous->fits(planned_, *scene_)) {
    graph_ = std::move(previous->graph_);
    graph_->setParams(plan());
    return;
  }
  std::vector<std::string> known;  // dropped: these problems were reported earlier
  if (!problems) problems = &known;
  graph_ = std::make_unique<graph::Graph>(device, bench.pipelines(), plan(), *on_device_, planned_.backend,
                                          bench.frames_in_flight, previous ? previous->graph_.get() : nullptr,
                                          whole ? nullptr : problems);
}

bool Drawing::fits(const Planned& planned, const HeldScene& scene) const {
  return planned_.backend == planned.backend && scene_.get() == &scene && planned_.shape() == planned.shape();
}

void Drawing::become(Planned planned, std::shared_ptr<const Evaluation> evaluation) {
  STROBE_ASSERT(fits(planned, *scene_));
  graph_->setParams(*planned.plan);
  planned_ = std::move(planned);
  evaluation_ = std::move(evaluation);
}

graph::Frame Drawing::frameOf(const Shot& shot) const {
  return scene_->frame(shot, plan::earlierFrames(plan().pipeline));
}

graph::FrameResult Drawing::draw(const Shot& shot, const std::set<std::string>* outputs,
                                 const std::function<void(int, int)>& progress) {
  graph::Frame frame = frameOf(shot);
  frame.wanted = outputs;
  return graph_->run(frame, progress);
}

void Drawing::begin(const Shot& shot, const std::set<std::string>* outputs) {
  graph::Frame frame = frameOf(shot);
  frame.wanted = outputs;
  graph_->begin(frame);
}

graph::FrameResult Drawing::finish() { return graph_->finish(); }

std::vector<LimitMet> Drawing::limitsMet(const Shot& shot, const graph::FrameResult& frame) const {
  std::vector<LimitMet> met = lab::limitsMet(shot, scene().scene);
  for (LimitMet& one : lab::limitsMet(plan(), frame)) met.push_back(std::move(one));
  for (LimitMet& one : lab::limitsMet(frame)) met.push_back(std::move(one));
  return met;
}

// ---- a picture

// Offset of sub-pixel sample i of n from the pixel centre, px (rank-1 lattice). One sample lies at the centre.
static vec2 subpixelOffset(int i, int n) {
  if (n == 1) return vec2(0);
  double x = (i + 0.5) / n - 0.5;
  double y = (i + 0.5) * 0.6180339887498949;
  return vec2(x, y - std::floor(y) - 0.5);
}

// Projection for compositing programs. Depth: 0 at the near plane; at infinity 1 (perspective) or unbounded
// (orthographic).
static dmat4 ndcFromCamera(const scene::Camera& camera, double aspect) {
  double half_height = camera.orthographic ? camera.half_height : std::tan(camera.vertical_fov / 2);
  dmat4 m(0);
  m[0][0] = 1 / (half_height * aspect);
  m[1][1] = 1 / half_height;
  if (camera.orthographic) {
    m[2][2] = -1;
    m[3][2] = -camera.near;
    m[3][3] = 1;
  } else {
    m[2][2] = m[2][3] = -1;
    m[3][2] = -camera.near;
  }
  return m;
}

static void accumulate(graph::FrameResult& sum, const graph::FrameResult& added) {
  auto add = [](std::map<std::string, graph::ReadImage>& into, const std::map<std::string, graph::ReadImage>& from) {
    for (auto& [name, read] : into) {
      const auto& values = from.at(name).floats.values;
      for (size_t i = 0; i < values.size(); ++i) read.floats.values[i] += values[i];
    }
  };
  add(sum.outputs, added.outputs);
  add(sum.taps, added.taps);
  for (size_t i = 0; i < sum.counters.size(); ++i) sum.counters[i].second += added.counters[i].second;
  for (size_t i = 0; i < sum.times.size(); ++i) {
    sum.times[i].gpu_ms += added.times[i].gpu_ms;
    sum.times[i].executions += added.times[i].executions;
  }
  sum.gpu_ms += added.gpu_ms;
}

static void divide(graph::FrameResult& sum, int n) {
  for (auto* images : {&sum.outputs, &sum.taps})
    for (auto& [name, read] : *images)
      for (float& value : read.floats.values) value /= float(n);
}

// Fills in the camera matrices, id names, warnings and record of a picture.
static void describe(const Home& home, Picture& picture, const Drawing& drawing, const Shot& shot,
                     const graph::Frame& setup, const gpu::DeviceInfo& device) {
  scene::Pose pose = setup.pose_at(setup.view.raster_s);
  dmat4 camera_from_world = glm::inverse(pose.world_from_camera);
  picture.camera_from_world = mat4(camera_from_world);
  double aspect = double(shot.width) / shot.height;
  picture.ndc_from_world = mat4(ndcFromCamera(pose.camera, aspect) * camera_from_world);
  picture.id_names = idNamesOf(drawing.scene().scene);
  picture.warnings = drawing.scene().scene.warnings;
  picture.record = makeRecord(home, shot, drawing, device, picture.frame);
  picture.record["limits"] = Json::array();
  for (const LimitMet& met : drawing.limitsMet(shot, picture.frame)) {
    picture.warnings.push_back(met.text());
    picture.record["limits"].push_back(met.facts);
  }
  picture.record["warnings"] = picture.warnings;
}

static void requireIds(const plan::Plan& plan) {
  for (const auto& [name, image] : plan.outputs)
    if (name == "id" && plan::isUint(plan.images[size_t(image)].format)) return;
  throw Error(fmt::format("pipeline '{}' has no output 'id' of integers, which mattes need", plan.pipeline.name), {},
              2);
}

Picture Drawing::capture(const Shot& shot, const std::set<std::string>* outputs,
                         const std::function<void(int, int)>& progress, bool id_coverage) {
  STROBE_ASSERT(!id_coverage || !outputs || outputs->count("id"), "ids are not read back");
  if (id_coverage) requireIds(plan());
  auto seen = std::make_shared<image::IdCoverage>();
  double started_s = clockSeconds();
  graph::Frame setup = frameOf(shot);
  setup.wanted = outputs;
  Picture picture;
  double ready_s = clockSeconds();
  int taken = 0;
  auto take = [&] {
    graph::FrameResult frame = finish();
    if (id_coverage) seen->add(frame.outputs.at("id").uints);
    if (taken++ == 0) picture.frame = std::move(frame);
    else accumulate(picture.frame, frame);
  };
  graph_->drop();
  for (int i = 0; i < shot.aa; ++i) {
    setup.subpixel = subpixelOffset(i, shot.aa);
    auto advance = [&](int done, int of) {
      stopIfOverdue();
      if (progress) progress(i * of + done, shot.aa * of);
    };
    stopIfOverdue();
    if (graph_->underWay() == graph_->mostUnderWay()) take();
    graph_->forgetHistories();
    graph_->begin(setup, advance);
  }
  while (graph_->underWay() > 0) take();
  if (shot.aa > 1) divide(picture.frame, shot.aa);
  if (id_coverage) picture.id_coverage = std::move(seen);
  double done_s = clockSeconds();
  describe(bench_.home(), picture, *this, shot, setup, bench_.device().info());
  picture.timings = makeTimings(picture.frame, bench_.device().info(), *held(), ready_s - started_s, done_s - ready_s);
  return picture;
}

}  // namespace strobe::lab
