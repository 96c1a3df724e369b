// SPDX-License-Identifier: MIT
#include "live/desk.h"

#include <algorithm>
#include <limits>

#include "base/log.h"
#include "image/metrics.h"
#include "lab/capture.h"

namespace strobe::live {

static const char* const kColor = "color";
static const double kLookEvery_s = 0.1;     // at edited files
static const double kTruthBudget_s = 0.03;  // of a turn, so that the window stays responsive
static const int kTruthSamples = 4096;      // what is left of the noise then is less than a display's 8 bits show

const std::vector<std::string>& modeNames() {
  static const std::vector<std::string> names = {"single", "wipe", "flicker", "difference", "error"};
  return names;
}

Mode modeNamed(const std::string& name) {
  auto found = std::find(modeNames().begin(), modeNames().end(), name);
  if (found == modeNames().end())
    throw Error(fmt::format("there is no mode '{}'{}", name, didYouMean(name, modeNames())));
  return Mode(found - modeNames().begin());
}

// The image called `port` among those read back, or null.
static const graph::ReadImage* readImage(const graph::FrameResult& frame, const std::string& port) {
  for (const auto* images : {&frame.outputs, &frame.taps}) {
    auto found = images->find(port);
    if (found != images->end()) return &found->second;
  }
  return nullptr;
}

static bool isOutput(const plan::Plan& plan, const std::string& port) {
  return std::any_of(plan.outputs.begin(), plan.outputs.end(),
                     [&](const auto& output) { return output.first == port; });
}

// ---- sessions

Desk::Desk(lab::Workbench& bench, DeskOptions options)
    : bench_(bench), options_(std::move(options)), truth_(bench, options_.truth) {
  a_.session = openSession(options_.shot, "command line");
  first_frame_ = a_.session->shot().frame;
  bool moves_by_option = !options_.shot.moves.empty() || !options_.shot.spins.empty();
  if (moves_by_option && options_.shot.rest_frame < 0) {
    // Played from frame to frame, what is moved by options has to rest in one of them.
    options_.shot.rest_frame = first_frame_;
    a_.session = openSession(options_.shot, "command line");
  }
  if (!options_.versus.empty()) usePipeline(options_.versus, true);
}

std::unique_ptr<lab::Session> Desk::openSession(const lab::Shot& shot, const std::string& origin) {
  return std::make_unique<lab::Session>(bench_, shot, origin);
}

lab::Session& Desk::sessionOf(bool of_b) {
  if (of_b && !b_.session) throw Error("there is no B: choose a pipeline to compare with, or start with --vs");
  return of_b ? *b_.session : *a_.session;
}

// Pipelines made for a change spoil the times of the frame that uses them first.
void Desk::changed(Side& side, int compilations_before) {
  side.stale = true;
  if (bench_.compilations() != compilations_before) side.times.voidNext();
}

static bool isOfShot(const lab::Control& control) { return control.group == "shot"; }

// B has its own pipeline and that pipeline's values; everything else is A's, as far as B can have it.
void Desk::follow() {
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
      refuse(true, name, error.what());
    }
  };
  for (const lab::Control& control : a_.session->controls()) {
    auto found = values_b.find(control.declaration.name);
    bool same = found == values_b.end() || found->second == control.value;
    if (isOfShot(control) && !same) take(control.declaration.name, textOf(control.value));
  }
  const lab::Shot& shot = a_.session->shot();
  if (shot.view != b_.session->shot().view) take("view", shot.view ? lab::viewText(*shot.view) : "");
  if (b_.stale) changed(b_, compiled);
}

void Desk::refuse(bool of_b, const std::string& name, const std::string& text) { refusals_[{of_b, name}] = text; }

std::string Desk::refusalOf(const std::string& name, bool of_b) const {
  auto found = refusals_.find({of_b, name});
  return found == refusals_.end() ? "" : found->second;
}

double Desk::costOf(const std::string& name) const {
  auto found = costs_.find(name);
  return found == costs_.end() ? 0 : found->second;
}

void Desk::set(const std::string& name, const std::string& value, const std::string& origin, bool of_b) {
  int compiled = bench_.compilations();
  double started_s = clockSeconds();
  try {
    sessionOf(of_b).set(name, value, origin);
  } catch (const Error& error) {
    refuse(of_b, name, error.what());
    throw;
  }
  costs_[name] = clockSeconds() - started_s;
  refusals_.erase({of_b, name});
  changed(of_b ? b_ : a_, compiled);
  if (!of_b) follow();
}

void Desk::unset(const std::string& name, bool of_b) {
  int compiled = bench_.compilations();
  try {
    sessionOf(of_b).unset(name);
  } catch (const Error& error) {
    refuse(of_b, name, error.what());
    throw;
  }
  refusals_.erase({of_b, name});
  changed(of_b ? b_ : a_, compiled);
  if (!of_b) follow();
}

void Desk::usePipeline(const std::string& name, bool of_b) {
  Side& side = of_b ? b_ : a_;
  try {
    if (side.session) {
      report(side, side.session->usePipeline(name));
    } else {
      lab::Shot shot = a_.session->shot();
      shot.pipeline = name;
      shot.taps.clear();
      shot.sets = lab::sceneSettings(shot.sets);
      shot.sets.insert(shot.sets.end(), options_.versus_sets.begin(), options_.versus_sets.end());
      side.session = openSession(shot, "--vs");
    }
  } catch (const Error& error) {
    refuse(of_b, "pipeline", error.what());
    throw;
  }
  refusals_.erase({of_b, "pipeline"});
  side.stale = true;
  side.times.clear();
  if (!of_b) follow();
}

void Desk::closeVersus() {
  b_ = {};
  look_.single_b = false;
  if (look_.mode != Mode::Error) look_.mode = Mode::Single;
  picture_stale_ = true;
}

// ---- time and camera

void Desk::goToFrame(int frame) { set("frame", std::to_string(std::max(0, frame)), "window"); }

int Desk::lastFrame() const {
  double seconds = 0;
  for (const scene::Animation& animation : a_.session->scene().animations)
    seconds = std::max(seconds, animation.duration);
  if (seconds == 0) seconds = 2;
  return first_frame_ + std::max(1, int(seconds * a_.session->shot().fps));
}

static int cameraNodeOf(const lab::Session& session) {
  return scene::cameraNode(session.scene(), session.shot().camera);
}

// How far away what the camera turns round is: the middle of the scene, as far as it lies ahead.
static double distanceToMiddle(const scene::Scene& scene, const scene::Pose& pose) {
  dvec3 low(std::numeric_limits<double>::infinity()), high(-low);
  std::vector<scene::Instance> instances = scene::instancesOf(scene);
  for (size_t i = 0; i < instances.size(); ++i)
    for (const scene::Geometry& geometry : scene.meshes[size_t(instances[i].mesh)].geometries)
      for (const scene::Vertex& vertex : geometry.vertices) {
        dvec3 at(pose.world_from_instance[i] * dvec4(dvec3(vertex.position), 1));
        low = glm::min(low, at);
        high = glm::max(high, at);
      }
  if (low.x > high.x) return 1;
  dvec3 ahead = -glm::normalize(dvec3(pose.world_from_camera[2]));
  double distance = glm::dot((low + high) * 0.5 - dvec3(pose.world_from_camera[3]), ahead);
  return std::max(distance, 0.05 * glm::length(high - low));
}

Viewpoint Desk::viewpoint() {
  const lab::Shot& shot = a_.session->shot();
  if (shot.view) {
    const auto& v = *shot.view;
    return {{v[0], v[1], v[2]}, {v[3], v[4], v[5]}};
  }
  scene::Poser poser(a_.session->scene(), cameraNodeOf(*a_.session), shot.animation);
  scene::Pose pose = poser.at(shot.captureTime());
  return viewpointOf(pose.world_from_camera, distanceToMiddle(a_.session->scene(), pose));
}

double Desk::verticalFov() {
  const scene::Scene& scene = a_.session->scene();
  return scene.cameras[size_t(scene.nodes[size_t(cameraNodeOf(*a_.session))].camera)].vertical_fov;
}

void Desk::setViewpoint(const Viewpoint& view) { set("view", toText(view), "window"); }

void Desk::giveCameraBack() {
  if (cameraIsMoved()) unset("view");
}

// ---- what is looked at

std::vector<std::string> Desk::viewable() const {
  std::vector<std::string> names;
  for (const auto& [name, image] : a_.session->plan().outputs) names.push_back(name);
  std::vector<std::string> ports = a_.session->ports();
  names.insert(names.end(), ports.begin(), ports.end());
  return names;
}

void Desk::viewPort(const std::string& port) {
  std::vector<std::string> names = viewable();
  if (std::find(names.begin(), names.end(), port) == names.end())
    throw Error(fmt::format("this frame has no image '{}'{}", port, didYouMean(port, names)));
  look_.port = port;
  look_.view.kind = "auto";
  a_.stale = true;
  b_.stale = b_.session != nullptr;
}

void Desk::setMode(Mode mode) {
  bool wants_b = mode == Mode::Wipe || mode == Mode::Flicker || mode == Mode::Difference;
  if (wants_b) sessionOf(true);
  look_.mode = mode;
}

const Side& Desk::flickering(int window_frame) const {
  bool show_b = look_.mode == Mode::Flicker ? window_frame / look_.flicker_frames % 2 != 0 : look_.single_b;
  return show_b && b_.session ? b_ : a_;
}

std::optional<PixelValue> Desk::valueAt(int x, int y) const {
  const Side& side = look_.mode == Mode::Single ? flickering(0) : a_;
  const graph::ReadImage* read = readImage(side.frame, side.drawn_port);
  const lab::Shot& shot = side.session->shot();
  if (!read || x < 0 || y < 0 || x >= shot.width || y >= shot.height) return {};
  bool integers = !read->uints.values.empty();
  int width = integers ? read->uints.width : read->floats.width,
      height = integers ? read->uints.height : read->floats.height;
  int channels = integers ? read->uints.channels : read->floats.channels;
  int divide = divideOf(side.session->plan(), side.drawn_port);
  PixelValue value{side.drawn_port, read->format};
  value.integers = integers;
  value.x = divide > 0 ? x / divide : x * width / shot.width;
  value.y = divide > 0 ? y / divide : y * height / shot.height;
  if (value.x >= width || value.y >= height) return {};
  for (int c = 0; c < channels; ++c)
    value.values.push_back(integers ? double(read->uints.at(value.x, value.y, c))
                                    : double(read->floats.at(value.x, value.y, c)));
  return value;
}

void Desk::pin(int x, int y) {
  const lab::Shot& shot = a_.session->shot();
  if (x < 0 || y < 0 || x >= shot.width || y >= shot.height)
    throw Error(fmt::format("pixel {} {} lies outside of {}x{}", x, y, shot.width, shot.height));
  pinned_ = {x, y};
  refreshTrail();
  if (!trail_problem_.empty()) throw Error(trail_problem_);
}

void Desk::unpin() {
  pinned_.reset();
  trail_.reset();
  trail_problem_.clear();
}

// ---- turns

// On the terminal all of it, in the window what was lost.
void Desk::report(const Side& side, const lab::Reload& reload) {
  std::string who = b_.session ? (&side == &a_ ? "A: " : "B: ") : "";
  note(who + lab::textOf(reload));
  if (!reload.reset.empty()) message_ = fmt::format("{}reset {}", who, fmt::join(reload.reset, "; "));
  else if (reload.swapped && reload.problems.empty() && !reload.changed.empty())
    message_ = fmt::format("{}reloaded {}", who, fmt::join(reload.changed, ", "));
}

// True where a version was swapped in or refused.
bool Desk::lookAtFiles(Side& side) {
  std::optional<lab::Reload> reload = side.session->reload(false);
  if (!reload) return false;
  report(side, *reload);
  if (reload->swapped) side.stale = true;
  if (reload->swapped) truth_key_.clear();
  if (reload->swapped || reload->compilations > 0) side.times.voidNext();
  if (&side == &a_) ++reloads_;
  if (&side == &a_) last_reload_ = std::move(reload);
  return true;
}

void Desk::draw(Side& side) {
  side.stale = false;
  picture_stale_ = true;
  try {
    const plan::Plan& plan = side.session->plan();
    std::vector<std::string> ports = side.session->ports();
    bool tapped = std::find(ports.begin(), ports.end(), look_.port) != ports.end() && !isOutput(plan, look_.port);
    bool there = tapped || isOutput(plan, look_.port);
    std::vector<std::string> taps = tapped ? std::vector<std::string>{look_.port} : std::vector<std::string>{};
    if (side.session->shot().taps != taps && tapped) {
      side.session->tap(taps);
      side.times.voidNext();
    }
    std::string port = there ? look_.port : kColor;
    std::set<std::string> wanted = {kColor, port};
    graph::FrameResult frame = side.session->draw(&wanted);
    side.warnings = side.session->limitsMet(frame);
    side.frame = std::move(frame);
    side.drawn_port = port;
    side.color = image::threeChannels(side.frame.outputs.at(kColor).floats);
    side.problem.clear();
    side.times.add(side.frame);
    ++side.frames_drawn;
  } catch (const Error& error) {
    side.problem = error.what();
  }
}

// Drawn once more without a change, so that its times are known.
static bool isUnmeasured(const Side& side) { return side.problem.empty() && side.times.lastIsVoid(); }

bool Desk::busy() const {
  bool gathers = gathersTruth() && truthSamples() < kTruthSamples && truth_problem_.empty();
  auto draws = [](const Side& side) { return side.session && (side.stale || isUnmeasured(side)); };
  return playing || draws(a_) || draws(b_) || gathers || look_.mode == Mode::Flicker;
}

bool Desk::turn() {
  bool news = false;
  if (clockSeconds() - looked_at_files_s_ > kLookEvery_s) {
    news = lookAtFiles(a_);
    if (b_.session) news = lookAtFiles(b_) || news;
    looked_at_files_s_ = clockSeconds();
  }
  if (playing && !a_.stale) goToFrame(frame() >= lastFrame() ? first_frame_ : frame() + 1);
  bool redrawn = a_.stale;
  if (a_.stale || isUnmeasured(a_)) draw(a_), news = true;
  if (b_.session && (b_.stale || isUnmeasured(b_))) draw(b_), news = true;
  if (redrawn && pinned_) refreshTrail();
  bool gathered = gathersTruth() && gatherTruth();
  return news || gathered;
}

std::vector<std::string> Desk::problems() const {
  std::vector<std::string> all = a_.session->problems();
  if (!a_.problem.empty()) all.push_back(a_.problem);
  if (!truth_problem_.empty() && gathersTruth()) all.push_back("truth: " + truth_problem_);
  if (!trail_problem_.empty()) all.push_back("trail: " + trail_problem_);
  if (!b_.session) return all;
  std::vector<std::string> more = b_.session->problems();
  if (!b_.problem.empty()) more.push_back(b_.problem);
  for (const std::string& problem : more)
    if (std::find(all.begin(), all.end(), problem) == all.end()) all.push_back(problem);
  return all;
}

// ---- truth

// What truth depends on: everything of the shot but how A draws it.
static lab::Shot truthShot(const lab::Shot& shot) {
  lab::Shot truth = shot;
  truth.pipeline.clear();
  truth.taps.clear();
  truth.aa = 1;
  truth.sets = lab::sceneSettings(shot.sets);
  return truth;
}

std::string Desk::truthKey() const { return lab::canonical(truthShot(a_.session->shot())); }

int Desk::truthSamples() const { return truth_key_ == truthKey() ? truth_.samples() : 0; }

bool Desk::gatherTruth() {
  bool anew = truthKey() != truth_key_;
  if (!anew && (truthSamples() >= kTruthSamples || !truth_problem_.empty())) return false;
  double started_s = clockSeconds();
  try {
    if (anew) {
      truth_problem_.clear();
      truth_key_ = truthKey();
      truth_.restart(a_.session->shot());
    }
    while (truth_.step() && clockSeconds() - started_s < kTruthBudget_s) continue;
  } catch (const Error& error) {
    truth_problem_ = error.what();
  }
  picture_stale_ = picture_stale_ || look_.mode == Mode::Error;
  return true;
}

std::optional<double> Desk::errorOf(const Side& side) const {
  if (truthSamples() == 0 || !sameSize(side.color, truth_.mean())) return {};
  return image::rootMeanSquaredError(side.color, truth_.mean());
}

// A value that B refuses, or a frame that could not be drawn, leaves the two with pictures of different sizes.
static bool sameFrame(const Side& a, const Side& b) {
  const lab::Shot &of_a = a.session->shot(), &of_b = b.session->shot();
  return of_a.width == of_b.width && of_a.height == of_b.height;
}

image::Image Desk::errorPicture() const {
  const image::Image& mean = truth_.mean();
  auto errors = [&](const Side& side) {
    return sameSize(side.color, mean) ? difference(side.color, mean, look_.gain, "mean |x - truth|") : shownSide(side);
  };
  if (!b_.session || !sameFrame(a_, b_)) return errors(a_);
  return wiped(errors(a_), errors(b_), look_.wipe);
}

// ---- the pixel's trail

void Desk::refreshTrail() {
  auto [x, y] = *pinned_;
  const lab::Shot& shot = a_.session->shot();
  if (x >= shot.width || y >= shot.height) return unpin();
  trail_.reset();
  trail_problem_.clear();
  try {
    trail_ = lab::follow(bench_, shot, x, y).trail;
  } catch (const Error& error) {
    trail_problem_ = error.what();
  }
}

Json Desk::trailJson() const {
  if (!trail_) throw Error(trail_problem_.empty() ? "no pixel is pinned" : trail_problem_);
  return lab::toJson(*trail_);
}

static std::string numbersText(const std::vector<double>& values) {
  std::string text;
  for (double value : values) text += fmt::format("{}{:.5g}", text.empty() ? "" : "  ", value);
  return text;
}

std::vector<TrailLine> Desk::trailLines() const {
  std::vector<TrailLine> lines;
  if (!trail_) return lines;
  for (const lab::TrailRow& row : trail_->rows) {
    std::vector<double> values = row.values;
    if (values.empty()) values.assign(row.integers.begin(), row.integers.end());
    std::string doc = fmt::format("{}.{}, {}, {}x{}, texel {}, {}\n{}", row.node, row.port, row.format, row.width,
                                  row.height, row.x, row.y, row.doc);
    lines.push_back({false, row.node + "." + row.port, numbersText(values), doc});
  }
  for (const lab::TrailHit& hit : trail_->hits) {
    lines.push_back(
        {true, fmt::format("{}. {}", hit.layer, hit.instance), fmt::format("{:.4g} m", hit.depth),
         fmt::format("geometry {}, triangle {}, {} side", hit.geometry, hit.primitive, hit.front ? "front" : "back")});
    lines.push_back(
        {false, "  velocity px", numbersText({hit.velocity.x, hit.velocity.y}), "over the exposure, y down"});
    lines.push_back({false, "  normal", numbersText({hit.normal.x, hit.normal.y, hit.normal.z}), "world space"});
    lines.push_back({false, "  colour", numbersText({hit.color.x, hit.color.y, hit.color.z}), "linear radiance"});
  }
  return lines;
}

// ---- the picture

std::vector<std::string> Desk::viewKindsHere() const {
  const graph::ReadImage* read = readImage(a_.frame, a_.drawn_port);
  return read ? viewKinds(*read) : std::vector<std::string>{"auto"};
}

image::Image Desk::shownSide(const Side& side) const {
  const lab::Shot& shot = side.session->shot();
  const graph::ReadImage* read = readImage(side.frame, side.drawn_port);
  if (!read) return image::Image(shot.width, shot.height, 3);
  return shown(*read, side.drawn_port, divideOf(side.session->plan(), side.drawn_port), shot.width, shot.height,
               look_.view, side.color.empty() ? nullptr : &side.color);
}

static bool sameLook(const Look& a, const Look& b) {
  return a.port == b.port && a.mode == b.mode && a.single_b == b.single_b && a.wipe == b.wipe && a.gain == b.gain &&
         a.view.kind == b.view.kind && a.view.exposure_stops == b.view.exposure_stops && a.view.low == b.view.low &&
         a.view.high == b.view.high && a.view.over == b.view.over;
}

bool Desk::pictureChanged(int window_frame) const {
  return picture_stale_ || !sameLook(look_, shown_look_) || (&flickering(window_frame) == &b_) != picture_of_b_;
}

const image::Image& Desk::picture(int window_frame) {
  if (!pictureChanged(window_frame)) return picture_;
  picture_ = compose(window_frame);
  picture_stale_ = false;
  shown_look_ = look_;
  picture_of_b_ = &flickering(window_frame) == &b_;
  return picture_;
}

image::Image Desk::compose(int window_frame) const {
  bool both = b_.session && !a_.color.empty() && !b_.color.empty();
  if (look_.mode == Mode::Wipe && both && sameFrame(a_, b_)) return wiped(shownSide(a_), shownSide(b_), look_.wipe);
  if (look_.mode == Mode::Difference && both && sameSize(a_.color, b_.color))
    return difference(a_.color, b_.color, look_.gain);
  if (look_.mode == Mode::Error) return errorPicture();
  return shownSide(flickering(window_frame));
}

// ---- results

std::string Desk::command() const { return lab::commandOf(a_.session->shot()); }

Path Desk::freeName(const std::string& ending) const {
  const lab::Shot& shot = a_.session->shot();
  std::string stem =
      fmt::format("{}_{}_f{}", Path(shot.pipeline).stem().string(), Path(shot.scene).stem().string(), shot.frame);
  for (int i = 1;; ++i) {
    Path file = options_.out / fmt::format("{}_{:03}{}", stem, i, ending);
    if (!std::filesystem::exists(file)) return file;
  }
}

void Desk::capture(const Path& file) {
  lab::checkPictureName(file);
  lab::writePicture(a_.session->capture(), file, false);
}

std::vector<Path> Desk::save() {
  Path file = freeName(".exr");
  std::vector<Path> files = lab::writePicture(a_.session->capture(), file, false);
  if (!b_.session || look_.mode == Mode::Single || look_.mode == Mode::Error) return files;
  Path other = file.parent_path() / (file.stem().string() + "_b.exr");
  for (const Path& written : lab::writePicture(b_.session->capture(), other, false)) files.push_back(written);
  return files;
}

}  // namespace strobe::live
