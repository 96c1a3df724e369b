// SPDX-License-Identifier: MIT
#include "live/sides.h"

#include <algorithm>
#include <cmath>

#include "base/lists.h"
#include "base/log.h"
#include "live/widgets.h"
#include "math/bounds.h"
#include "scene/bend.h"
#include "scene/clips.h"

namespace strobe::live {

const graph::ReadImage* Side::image() const {
  for (const auto* images : {&frame.outputs, &frame.taps}) {
    auto found = images->find(drawn_port);
    if (found != images->end()) return &found->second;
  }
  return nullptr;
}

std::optional<double> Side::depthAt(int x, int y) const {
  auto found = frame.outputs.find(kDepth);
  if (found == frame.outputs.end() || found->second.floats.empty()) return {};
  const image::Image& depth = found->second.floats;
  if (x < 0 || y < 0 || x >= depth.width || y >= depth.height) return {};
  double metres = depth.at(x, y, 0);
  return std::isfinite(metres) && metres > 0 ? std::optional(metres) : std::nullopt;
}

Sides::Sides(lab::Workbench& bench, lab::Shot shot, script::Settings versus_sets)
    : bench_(bench), versus_sets_(std::move(versus_sets)) {
  auto open = [&] { a_.session = std::make_unique<lab::Session>(bench_, shot, "command line"); };
  open();
  first_frame_ = a_.session->shot().frame;
  bool moves_by_option = !shot.moves.empty() || !shot.spins.empty();
  if (!moves_by_option || shot.rest_frame >= 0) return;
  // Objects that options move need a rest frame that does not change while frames are played.
  shot.rest_frame = first_frame_;
  open();
}

lab::Session& Sides::sessionOf(bool of_b) {
  if (of_b && !b_.session) throw Error("no pipeline B: choose a pipeline to compare with, or start with --vs");
  return of_b ? *b_.session : *a_.session;
}

// ---- values

void Sides::change(const std::string& name, bool of_b, const std::function<void()>& change) {
  int compiled = bench_.compilations();
  double started_s = clockSeconds();
  try {
    change();
  } catch (const Error& error) {
    refusals_[{of_b, name}] = error.what();
    throw;
  }
  costs_[name] = clockSeconds() - started_s;
  refusals_.erase({of_b, name});
  Side& side = of_b ? b_ : a_;
  side.stale = true;
  // GPU pipelines that were compiled for a change distort the times of the first frame that uses them.
  if (bench_.compilations() != compiled) side.times.voidNext();
  if (!of_b) follow();
}

void Sides::set(const std::string& name, const std::string& value, const std::string& origin, bool of_b) {
  change(name, of_b, [&] { sessionOf(of_b).set(name, value, origin); });
}

void Sides::unset(const std::string& name, bool of_b) {
  change(name, of_b, [&] { sessionOf(of_b).unset(name); });
}

void Sides::usePipeline(const std::string& name, bool of_b) {
  Side& side = of_b ? b_ : a_;
  change("pipeline", of_b, [&] {
    if (side.session) return report(side, side.session->usePipeline(name));
    lab::Shot shot = a_.session->shot();
    shot.pipeline = name;
    shot.taps.clear();
    shot.sets = lab::sceneSettings(shot.sets);
    shot.sets.insert(shot.sets.end(), versus_sets_.begin(), versus_sets_.end());
    side.session = std::make_unique<lab::Session>(bench_, shot, "--vs");
  });
  side.times.clear();
}

// Copies A's shot values to B, if B accepts them.
void Sides::follow() {
  if (!b_.session) return;
  std::map<std::string, plan::Value> values_b;
  for (const lab::Control& control : b_.session->controls()) values_b[control.declaration.name] = control.value;
  int compiled = bench_.compilations();
  auto take = [&](const std::string& name, const std::string& value) {
    try {
      b_.session->set(name, value, "A");
      refusals_.erase({true, name});
      b_.stale = true;
    } catch (const Error& error) {
      refusals_[{true, name}] = error.what();
    }
  };
  for (const lab::Control& control : a_.session->controls()) {
    auto found = values_b.find(control.declaration.name);
    bool same = found == values_b.end() || found->second == control.value;
    if (control.group == "shot" && !same) take(control.declaration.name, lab::plainText(control.value));
  }
  const lab::Shot& shot = a_.session->shot();
  if (shot.view != b_.session->shot().view) take("view", shot.view ? lab::viewText(*shot.view) : "");
  if (b_.stale && bench_.compilations() != compiled) b_.times.voidNext();
}

std::string Sides::refusalOf(const std::string& name, bool of_b) const {
  auto found = refusals_.find({of_b, name});
  return found == refusals_.end() ? "" : found->second;
}

double Sides::costOf(const std::string& name) const {
  auto found = costs_.find(name);
  return found == costs_.end() ? 0 : found->second;
}

// ---- camera and time

// Distance from the camera to the middle of the scene, along the view direction, metres. At least a tenth of the
// scene's radius.
static double distanceToMiddle(const scene::Scene& scene, const scene::Pose& pose) {
  Bounds bounds;
  std::vector<scene::Instance> instances = scene::instancesOf(scene);
  for (size_t i = 0; i < instances.size(); ++i) bounds.add(scene::posedBounds(scene, instances, i, pose));
  if (bounds.empty()) return 1;
  dvec3 ahead = -glm::normalize(dvec3(pose.world_from_camera[2]));
  double distance = glm::dot(bounds.middle() - dvec3(pose.world_from_camera[3]), ahead);
  return std::max(distance, 0.1 * bounds.radius());
}

static int cameraNodeOf(const lab::Session& session) {
  return scene::cameraNode(session.scene(), session.shot().camera);
}

Viewpoint Sides::viewpoint() const {
  const lab::Shot& shot = a_.session->shot();
  if (shot.view) {
    const auto& v = *shot.view;
    return {{v[0], v[1], v[2]}, {v[3], v[4], v[5]}};
  }
  scene::Poser poser(a_.session->scene(), cameraNodeOf(*a_.session), shot.animation);
  scene::Pose pose = poser.at(shot.rasterTime());
  return viewpointOf(pose.world_from_camera, distanceToMiddle(a_.session->scene(), pose));
}

static const scene::Camera& cameraOf(const lab::Session& session) {
  const scene::Scene& scene = session.scene();
  return scene.cameras[size_t(scene.nodes[size_t(cameraNodeOf(session))].camera)];
}

double Sides::verticalFov() const { return cameraOf(*a_.session).vertical_fov; }

dvec3 Sides::pivotAt(const dvec2& pixel) const {
  const scene::Camera& camera = cameraOf(*a_.session);
  const lab::Shot& shot = a_.session->shot();
  const Viewpoint view = viewpoint();
  const dvec2 middle = dvec2(shot.width, shot.height) / 2.0;
  for (const dvec2& at : {pixel, middle}) {
    std::optional<double> depth = a_.depthAt(int(std::floor(at.x)), int(std::floor(at.y)));
    if (!depth) continue;
    double half_height = camera.orthographic ? camera.half_height : *depth * std::tan(camera.vertical_fov / 2);
    return pointAt(view, at - middle, 2 * half_height / shot.height, *depth);
  }
  return view.target;
}

void Sides::giveCameraBack() {
  if (a_.session->shot().view) unset("view");
}

int Sides::lastFrame() const { return first_frame_ + scene::loopFrames(a_.session->scene(), a_.session->shot().fps); }

// ---- files

// The terminal gets the whole report. The window gets the most important part: reset values, new choices, or reloaded
// files.
void Sides::report(const Side& side, const lab::Reload& reload) {
  std::string who = b_.session ? (&side == &a_ ? "A: " : "B: ") : "";
  note(who + lab::textOf(reload));
  if (!reload.reset.empty()) message_ = fmt::format("{}reset {}", who, fmt::join(reload.reset, "; "));
  else if (!reload.choices.empty()) message_ = fmt::format("{}new choice {}", who, fmt::join(reload.choices, ", "));
  else if (reload.swapped && reload.problems.empty() && !reload.changed.empty())
    message_ = fmt::format("{}reloaded {}", who, fmt::join(reload.changed, ", "));
}

Sides::Looked Sides::lookAtFiles() {
  Looked looked;
  for (Side* side : {&a_, b()}) {
    std::optional<lab::Reload> reload = side ? side->session->reload(false) : std::nullopt;
    if (!reload) continue;
    report(*side, *reload);
    looked.news = true;
    looked.swapped = looked.swapped || reload->swapped;
    side->stale = side->stale || reload->swapped;
    if (reload->swapped || reload->compilations > 0) side->times.voidNext();
    reloads_ += side == &a_;
    swaps_ += reload->swapped;
  }
  return looked;
}

// ---- frames

bool Sides::draw(const std::string& port) {
  bool drawn = false;
  for (Side* side : {&a_, &b_}) {
    if (!side->isDue()) continue;
    draw(*side, port);
    drawn = true;
  }
  return drawn;
}

void Sides::draw(Side& side, const std::string& port) {
  static const std::string kColor = "color";
  side.stale = false;
  side.more -= side.more > 0;
  try {
    const auto& outputs = side.session->plan().outputs;
    bool output = std::any_of(outputs.begin(), outputs.end(), [&](const auto& one) { return one.first == port; });
    bool tapped = !output && contains(side.session->ports(), port);
    if (tapped && side.session->shot().taps != std::vector<std::string>{port}) {
      side.session->tap({port});
      side.times.voidNext();
    }
    std::string shown = output || tapped ? port : kColor;
    std::set<std::string> wanted = {kColor, shown, Side::kDepth};
    graph::FrameResult frame = side.session->draw(&wanted);
    side.limits = side.session->limitsMet(frame);
    side.frame = std::move(frame);
    side.drawn_port = shown;
    side.color = image::threeChannels(side.frame.outputs.at(kColor).floats);
    side.problem.clear();
    side.times.add(side.frame);
    ++side.frames_drawn;
  } catch (const Error& error) {
    side.problem = error.what();
  }
}

std::vector<std::string> Sides::problems() const {
  std::vector<std::string> all;
  for (const Side* side : {&a_, b()}) {
    if (!side) continue;
    std::vector<std::string> own = side->session->problems();
    if (!side->problem.empty()) own.push_back(side->problem);
    for (const std::string& problem : own)
      if (!contains(all, problem)) all.push_back(problem);
  }
  return all;
}

}  // namespace strobe::live
