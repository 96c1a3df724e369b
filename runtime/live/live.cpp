// SPDX-License-Identifier: MIT
#include "live/live.h"

#include <backends/imgui_impl_glfw.h>
#include <imgui.h>
#include <unistd.h>

#include <cstdio>
#include <sstream>

#include "base/log.h"
#include "image/png.h"
#include "lab/capture.h"
#include "live/drive.h"
#include "live/picture_view.h"
#include "live/recording.h"
#include "live/surface.h"
#include "live/sweep_panel.h"
#include "live/window.h"

namespace strobe::live {

namespace {

constexpr double kReloadLimit_s = 20;  // for 'reloaded'
constexpr double kTruthLimit_s = 60;   // for 'truth' and 'swept'
constexpr double kIdle_s = 0.1;        // between looks at edited files while nothing happens
constexpr int kSettle = 3;             // frames that panels need to come to rest after an event
constexpr int kSoftwareWidth = 320, kSoftwareHeight = 180;

// ImGui with its fonts and its view of the window's mouse and keyboard.
class Gui {
 public:
  explicit Gui(Window& window) {
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;
    // Surface draws lists of more than 65536 vertices: values written on thousands of pixels are as many.
    ImGui::GetIO().BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
    fonts_ = applyStyle();
    ImGui_ImplGlfw_InitForVulkan(window.handle(), true);
  }
  ~Gui() {
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
  }
  Gui(const Gui&) = delete;
  Gui& operator=(const Gui&) = delete;
  const Fonts& fonts() const { return fonts_; }

 private:
  Fonts fonts_;
};

gpu::DeviceOptions deviceOptions(const Window& window, const LiveOptions& options) {
  gpu::DeviceOptions device = window.extensions();
  device.device = options.desk.shot.device;
  device.validation = options.validation;
  return device;
}

// A picture that a software device draws several times a second, unless a size was asked for.
DeskOptions deskOptions(const lab::Workbench& bench, const LiveOptions& options) {
  DeskOptions desk = options.desk;
  if (options.size_given || !bench.device().info().software) return desk;
  desk.shot.width = kSoftwareWidth;
  desk.shot.height = kSoftwareHeight;
  return desk;
}

class Live {
 public:
  Live(const Home& home, const LiveOptions& options);
  void run();

 private:
  void watch();
  void turn();
  void drawWindow();
  void takeKeys();
  std::map<Action, std::function<void()>> actions();
  void stepView(int by);
  void sweepPointed();
  void closeUppermost();
  void save();
  void beginRecording();
  void toggleRecording();
  void keepRecording();
  Path stopRecording(const Path& script);
  void sendToTev();
  void pointAsDriven();
  void holdPressedKeys(bool down);
  std::map<std::string, Handler> handlers();
  void addShotHandlers(std::map<std::string, Handler>& handlers);
  void addLookHandlers(std::map<std::string, Handler>& handlers);
  void addWaitHandlers(std::map<std::string, Handler>& handlers);
  void addFileHandlers(std::map<std::string, Handler>& handlers);
  void addSweepHandlers(std::map<std::string, Handler>& handlers);
  Handler afterFrames(int frames, std::function<void(const Command&)> then);

  LiveOptions options_;
  Window window_;
  Gui gui_;
  lab::Workbench bench_;
  Surface surface_;
  Desk desk_;
  Sweeper sweeper_;
  PanelState state_;
  const std::map<Action, std::function<void()>> actions_ = actions();
  PictureView view_;
  SweepPanel sweep_panel_;
  std::unique_ptr<Recording> recording_;
  std::unique_ptr<Texture> picture_;
  std::unique_ptr<Drive> drive_;
  std::unique_ptr<lab::Tev> tev_;
  std::string title_;
  std::optional<Path> screenshot_;
  int settle_ = kSettle;
  bool quit_ = false;
  // What the drive file waits for.
  std::optional<int> wait_from_;
  std::optional<double> wait_since_s_;
  int reloads_seen_ = 0;
  bool shot_asked_ = false;
  std::optional<dvec2> pointed_;  // pixel of the picture
  std::optional<dvec2> clicked_;  // of the window
  bool pressed_ = false;          // ... and the button is down
};

Live::Live(const Home& home, const LiveOptions& options)
    : options_(options),
      window_(options.width, options.height, "strobe live"),
      gui_(window_),
      bench_(home, deviceOptions(window_, options)),
      surface_(home, bench_.device(), window_.makeSurface(bench_.device()), options.width, options.height),
      desk_(bench_, deskOptions(bench_, options)) {
  watch();
  if (options.tev) tev_ = std::make_unique<lab::Tev>(*options.tev);
  if (!options.drive.empty())
    drive_ = std::make_unique<Drive>(parseDrive(readText(options.drive), options.drive), handlers());
}

// A shader that never ends cannot be stopped: say which, keep what was asked for, and leave the device as it is.
void Live::watch() {
  bench_.device().setTimeLimit(options_.time_limit_s, [this](const std::string& what) {
    Path file = options_.desk.out / "overrun.record.json";
    std::string kept;
    try {
      Json record;
      record["shot"] = lab::toJson(desk_.shot());
      writeFileAtomically(file, record.dump(2) + "\n");
      kept = fmt::format("; the shot is kept in {}: open it with --record", file.string());
    } catch (const Error& error) {
      kept = fmt::format("; the shot could not be kept: {}", error.what());
    }
    std::fprintf(stderr, "strobe: '%s' ran for more than %g s on the device (--time-limit)%s\n", what.c_str(),
                 options_.time_limit_s, kept.c_str());
    std::fflush(stderr);
    std::_Exit(1);
  });
}

// ---- keys and buttons

void Live::stepView(int by) {
  std::vector<std::string> names = desk_.viewable();
  auto found = std::find(names.begin(), names.end(), desk_.look().port);
  int at = found == names.end() ? 0 : int(found - names.begin());
  desk_.viewPort(names[size_t((at + by + int(names.size())) % int(names.size()))]);
}

// The control under the pointer, else one that is found (by its name rather than by its description), else the one
// changed last.
void Live::sweepPointed() {
  bool of_b = state_.controls_of_b && desk_.b();
  std::string name = state_.pointed_control, by_name, by_text;
  for (const lab::Control& control : (of_b ? *desk_.b() : desk_.a()).session->controls()) {
    if (state_.search.empty() || !canBeSwept(control) || !isFound(control, state_.search)) continue;
    const std::string& found = control.declaration.name;
    if (by_text.empty()) by_text = found;
    if (by_name.empty() && found.find(state_.search) != std::string::npos) by_name = found;
  }
  for (const std::string& next : {by_name, by_text, state_.changed_control})
    if (name.empty()) name = next;
  bool again = sweeper_.isOpen() && sweeper_.ofB() == of_b && sweeper_.forms()[0].control.declaration.name == name;
  if (again) return sweep_panel_.focus();
  if (name.empty()) throw Error("no control to sweep: put the pointer on one, or find one with /");
  sweeper_.open(desk_, name, of_b);
}

void Live::closeUppermost() {
  if (state_.help) state_.help = false;
  else if (sweeper_.isOpen()) sweeper_.close(desk_);
  else desk_.pixel().unpin();
}

void Live::save() {
  Path file = desk_.save().front();
  if (recording_) recording_->markSaved(desk_);
  state_.say("saved " + file.string());
}

void Live::beginRecording() {
  recording_ =
      std::make_unique<Recording>(bench_.home(), desk_.options().out / fmt::format(".recorded.{}", ::getpid()));
}

Path Live::stopRecording(const Path& script) {
  if (!recording_) throw Error("nothing is recorded");
  recording_->write(bench_, script);
  recording_.reset();
  return script;
}

// Of a window that is closed.
void Live::keepRecording() {
  try {
    note("recorded: " + stopRecording(desk_.freeName(".recording.lua")).string());
  } catch (const Error& error) {
    warn(fmt::format("the recording is lost: {}", error.what()));
  }
}

void Live::toggleRecording() {
  if (!recording_) {
    beginRecording();
    return state_.say("recording; F6 writes it as a capture script");
  }
  Path script = stopRecording(desk_.freeName(".recording.lua"));
  state_.say(fmt::format("saved; take it again: strobe capture {} -o DIR", script.string()));
  openInEditor(script);
}

std::map<Action, std::function<void()>> Live::actions() {
  return {
      {Action::TogglePlay, [this] { desk_.playing = !desk_.playing; }},
      {Action::StepBack, [this] { desk_.goToFrame(desk_.shot().frame - 1); }},
      {Action::StepAhead, [this] { desk_.goToFrame(desk_.shot().frame + 1); }},
      {Action::FirstFrame, [this] { desk_.goToFrame(desk_.sides().firstFrame()); }},
      {Action::CameraBack, [this] { desk_.sides().giveCameraBack(); }},
      {Action::FitPicture, [this] { state_.magnification = {}; }},
      {Action::ShowSingle, [this] { desk_.setMode(Mode::Single); }},
      {Action::ShowWipe, [this] { desk_.setMode(Mode::Wipe); }},
      {Action::ShowFlicker, [this] { desk_.setMode(Mode::Flicker); }},
      {Action::ShowDifference, [this] { desk_.setMode(Mode::Difference); }},
      {Action::ShowError, [this] { desk_.setMode(Mode::Error); }},
      {Action::PreviousView, [this] { stepView(-1); }},
      {Action::NextView, [this] { stepView(1); }},
      {Action::ViewColor, [this] { desk_.viewPort("color"); }},
      {Action::Unpin, [this] { closeUppermost(); }},
      {Action::Save, [this] { save(); }},
      {Action::Screenshot, [this] { screenshot_ = desk_.freeName(".window.png"); }},
      {Action::CopyCommand,
       [this] {
         window_.setClipboard(lab::commandOf(desk_.shot()));
         state_.say("copied: " + lab::commandOf(desk_.shot()));
       }},
      {Action::Search, [this] { state_.focus_search = state_.panels = true; }},
      {Action::Sweep, [this] { sweepPointed(); }},
      {Action::TakePrevious, [this] { sweeper_.takeNext(desk_, -1); }},
      {Action::TakeNext, [this] { sweeper_.takeNext(desk_, 1); }},
      {Action::SaveExperiment, [this] { state_.say("saved; run it: strobe sweep " + sweeper_.save(desk_).string()); }},
      {Action::Record, [this] { toggleRecording(); }},
      {Action::TogglePanels, [this] { state_.panels = !state_.panels; }},
      {Action::ToggleHelp, [this] { state_.help = !state_.help; }},
      {Action::Quit, [this] { quit_ = true; }},
  };
}

void Live::takeKeys() {
  if (!ImGui::GetIO().WantTextInput)
    for (int key : window_.pressed())
      if (Action action = actionOf(key); action != Action::None) state_.requests.push_back(action);
  for (Action action : std::exchange(state_.requests, {})) attempt(state_, actions_.at(action));
  std::string swept = std::exchange(state_.swept_control, "");
  if (!swept.empty()) attempt(state_, [&] { sweeper_.open(desk_, swept, state_.controls_of_b && desk_.b()); });
}

// ---- a turn

void Live::sendToTev() {
  if (!tev_) return;
  for (const auto& [name, image] : desk_.a().frame.outputs) tev_->send(name, image);
}

// A driven window does not depend on where the mouse happens to be.
void Live::pointAsDriven() {
  dvec2 at = clicked_ ? *clicked_ : pointed_ ? view_.inWindow(*pointed_ + dvec2(0.5)) : dvec2(-1e6);
#if IMGUI_VERSION_NUM >= 18700  // from here on, positions and buttons are events
  ImGui::GetIO().AddMousePosEvent(float(at.x), float(at.y));
  ImGui::GetIO().AddMouseButtonEvent(0, pressed_);
#endif
  ImGui::GetIO().MousePos = ImVec2(float(at.x), float(at.y));
  ImGui::GetIO().MouseDown[0] = pressed_;
}

// A key that went up again since the last frame was down all the same: frames of a software device take long.
void Live::holdPressedKeys([[maybe_unused]] bool down) {
#if IMGUI_VERSION_NUM < 18700  // from here on, keys are events
  for (int key : window_.pressed())
    if (key >= 256 && !window_.isDown(key)) ImGui::GetIO().KeysDown[key] = down;
#endif
}

void Live::drawWindow() {
  const image::Image& shown = desk_.picture(state_.window_frame);
  ++state_.window_frame;
  auto [width, height] = window_.size();
  if (width == 0 || height == 0) return;
  // A picture made smaller needs its pixels mixed; one enlarged shows them as they are.
  bool smooth = shown.width > width || shown.height > height;
  surface_.upload(picture_, "picture", shown, smooth);
  sweep_panel_.prepare(surface_, sweeper_, desk_.look().view.exposure_stops);

  ImGui_ImplGlfw_NewFrame();
  if (drive_) pointAsDriven();
  holdPressedKeys(true);
  ImGui::NewFrame();
  Area area = drawPanels(gui_.fonts(), desk_, state_);
  area = sweep_panel_.draw(gui_.fonts(), desk_, sweeper_, state_, area);
  view_.interact(desk_, state_, area, window_);
  view_.draw(gui_.fonts(), desk_, state_, area, *picture_);
  drawOverlays(gui_.fonts(), desk_, state_, area);
  ImGui::Render();
  holdPressedKeys(false);
  image::Image shot;
  bool done = surface_.show(*ImGui::GetDrawData(), width, height, screenshot_ ? &shot : nullptr);
  if (!screenshot_ || !done) return;
  Path file = *std::exchange(screenshot_, {});
  if (drive_) return image::writePng(file, shot);
  attempt(state_, [&] {
    image::writePng(file, shot);
    state_.say("saved " + file.string());
  });
}

void Live::turn() {
  bool spoke = state_.speaks();
  bool awake = settle_ > 0 || desk_.busy() || sweeper_.busy() || (drive_ && !drive_->done());
  window_.takeEvents(awake ? 0 : kIdle_s);
  if (window_.stirred() || spoke != state_.speaks()) settle_ = kSettle;
  if (drive_) drive_->advance();
  bool news = desk_.turn();
  if (std::string message = desk_.sides().takeMessage(); !message.empty()) state_.say(message);
  if (news) sendToTev();
  if (recording_) recording_->look(desk_, ImGui::IsAnyMouseDown() || desk_.playing);
  state_.recorded.reset();
  if (recording_) state_.recorded = recording_->moments();
  // A drag comes first.
  bool swept = !ImGui::IsAnyMouseDown() && sweeper_.turn(desk_);
  if (news || swept) settle_ = kSettle;
  bool draws = settle_ > 0 || desk_.pictureChanged(state_.window_frame) || screenshot_ || (drive_ && !drive_->done());
  if (!draws) return;
  drawWindow();
  takeKeys();
  --settle_;
  std::string title = fmt::format("{} - strobe live", desk_.shot().pipeline);
  if (title != title_) window_.setTitle(title_ = title);
}

void Live::run() {
  while (!quit_ && !window_.closing()) turn();
  if (recording_) keepRecording();
  std::vector<std::string> messages = bench_.device().takeMessages();
  for (std::string& message : messages) message = "Vulkan validation: " + message;
  throwIfAny(messages);
}

// ---- the drive file

// Carries out `then` when that many frames of the window have passed.
Handler Live::afterFrames(int frames, std::function<void(const Command&)> then) {
  return [this, frames, then](const Command& command) {
    if (!wait_from_) wait_from_ = state_.window_frame;
    if (state_.window_frame < *wait_from_ + frames) return false;
    then(command);
    wait_from_.reset();
    return true;
  };
}

bool onOff(const Command& command) {
  const std::string& word = command.arguments[0];
  if (word != "on" && word != "off") throw Error(fmt::format("'{}' takes on or off", command.name), command.place);
  return word == "on";
}

void Live::addShotHandlers(std::map<std::string, Handler>& handlers) {
  handlers["set"] = [this](const Command& c) {
    return desk_.sides().set(c.arguments[0], c.arguments[1], "drive"), true;
  };
  handlers["unset"] = [this](const Command& c) { return desk_.sides().unset(c.arguments[0]), true; };
  handlers["pipeline"] = [this](const Command& c) { return desk_.sides().usePipeline(c.arguments[0]), true; };
  handlers["frame"] = [this](const Command& c) { return desk_.goToFrame(integerOf(c, 0)), true; };
  handlers["play"] = [this](const Command& c) { return desk_.playing = onOff(c), true; };
  handlers["orbit"] = [this](const Command& c) {
    desk_.sides().setViewpoint(
        orbited(desk_.sides().viewpoint(), -numberOf(c, 0) * kRadiansPerPixel, numberOf(c, 1) * kRadiansPerPixel));
    return true;
  };
  handlers["expect"] = [this](const Command& c) {
    for (const lab::Control& control : desk_.a().session->controls()) {
      if (control.declaration.name != c.arguments[0]) continue;
      if (lab::plainText(control.value) == c.arguments[1]) return true;
      throw Error(fmt::format("{} is {}, expected {}", c.arguments[0], lab::plainText(control.value), c.arguments[1]),
                  c.place);
    }
    throw Error(fmt::format("there is no control '{}'", c.arguments[0]), c.place);
  };
}

void Live::addLookHandlers(std::map<std::string, Handler>& handlers) {
  handlers["view"] = [this](const Command& c) { return desk_.viewPort(c.arguments[0]), true; };
  handlers["kind"] = [this](const Command& c) { return desk_.look().view.kind = c.arguments[0], true; };
  handlers["mode"] = [this](const Command& c) { return desk_.setMode(modeNamed(c.arguments[0])), true; };
  handlers["wipe"] = [this](const Command& c) { return desk_.look().wipe = numberOf(c, 0), true; };
  handlers["zoom"] = [this](const Command& c) {
    const lab::Shot& shot = desk_.shot();
    dvec2 centre((numberOf(c, 1) + 0.5) / shot.width, (numberOf(c, 2) + 0.5) / shot.height);
    state_.magnification = {std::max(0.1, numberOf(c, 0)), centre};
    return true;
  };
  handlers["point"] = [this](const Command& c) {
    pointed_.reset();
    if (c.arguments.size() == 2) pointed_ = dvec2(integerOf(c, 0), integerOf(c, 1));
    return true;
  };
  handlers["inspect"] = [this](const Command& c) { return desk_.pin(integerOf(c, 0), integerOf(c, 1)), true; };
  handlers["key"] = [this](const Command& c) { return actions_.at(actionNamed(c.arguments[0]))(), true; };
  handlers["search"] = [this](const Command& c) {
    state_.search = c.arguments.empty() ? "" : c.arguments[0];
    return true;
  };
  handlers["panels"] = [this](const Command& c) { return state_.panels = onOff(c), true; };
  handlers["help"] = [this](const Command& c) { return state_.help = onOff(c), true; };
  handlers["resize"] = [this](const Command& c) {
    auto [width, height] = lab::parseSize(c.arguments[0], "resize");
    window_.resize(width, height);
    return true;
  };
}

void Live::addWaitHandlers(std::map<std::string, Handler>& handlers) {
  handlers["wait"] = [this](const Command& c) { return afterFrames(integerOf(c, 0), [](const Command&) {})(c); };
  handlers["reloaded"] = [this](const Command& c) {
    if (!wait_since_s_) wait_since_s_ = clockSeconds();
    if (clockSeconds() - *wait_since_s_ > kReloadLimit_s) throw Error("no edited file was noticed", c.place);
    if (desk_.sides().reloads() == reloads_seen_) return false;
    wait_since_s_.reset();
    reloads_seen_ = desk_.sides().reloads();
    return true;
  };
  handlers["truth"] = [this](const Command& c) {
    if (!wait_since_s_) wait_since_s_ = clockSeconds();
    desk_.wantTruth(integerOf(c, 0));
    if (clockSeconds() - *wait_since_s_ > kTruthLimit_s)
      throw Error(fmt::format("the truth has {} samples", desk_.truth().samples(desk_.shot())), c.place);
    if (desk_.truth().samples(desk_.shot()) < integerOf(c, 0)) return false;
    wait_since_s_.reset();
    desk_.wantTruth(0);
    return true;
  };
  handlers["problems"] = [this](const Command& c) {
    if (c.arguments[0] != "yes" && c.arguments[0] != "no") throw Error("'problems' takes yes or no", c.place);
    std::vector<std::string> problems = desk_.problems();
    if (problems.empty() != (c.arguments[0] == "no"))
      throw Error(problems.empty() ? "there are no problems" : problems.front(), c.place);
    return true;
  };
  handlers["quit"] = [this](const Command&) { return quit_ = true; };
}

void Live::addFileHandlers(std::map<std::string, Handler>& handlers) {
  handlers["replace"] = [this](const Command& c) {
    reloads_seen_ = desk_.sides().reloads();  // 'reloaded' waits for this edit, not for one before it
    return writeFileAtomically(c.arguments[0], readText(c.arguments[1])), true;
  };
  handlers["screenshot"] = [this](const Command& c) {
    if (!wait_from_) wait_from_ = state_.window_frame;
    // What was changed a moment ago is drawn and at rest first.
    if (!shot_asked_ && state_.window_frame >= *wait_from_ + kSettle) {
      screenshot_ = c.arguments[0];
      shot_asked_ = true;
    }
    if (!shot_asked_ || screenshot_) return false;
    shot_asked_ = false;
    wait_from_.reset();
    return true;
  };
  handlers["capture"] = [this](const Command& c) {
    lab::checkPictureName(c.arguments[0]);
    return lab::writePicture(desk_.a().session->capture(), c.arguments[0]), true;
  };
  handlers["record"] = [this](const Command&) { return beginRecording(), true; };
  handlers["recording"] = [this](const Command& c) { return stopRecording(c.arguments[0]), true; };
  handlers["trail"] = [this](const Command& c) {
    writeFileAtomically(c.arguments[0], desk_.pixel().json().dump(2) + "\n");
    return true;
  };
}

// "NAME" or "NAME=VALUE,VALUE,...".
std::pair<std::string, std::vector<std::string>> axisIn(const std::string& text) {
  size_t at = std::min(text.find('='), text.size());
  std::istringstream list(text.substr(std::min(at + 1, text.size())));
  std::vector<std::string> values;
  for (std::string value; std::getline(list, value, ',');) values.push_back(value);
  return {text.substr(0, at), values};
}

void Live::addSweepHandlers(std::map<std::string, Handler>& handlers) {
  handlers["sweep"] = [this](const Command& c) {
    auto [name, values] = axisIn(c.arguments[0]);
    sweeper_.open(desk_, name, false, values);
    if (c.arguments.size() == 1) return true;
    auto [other, others] = axisIn(c.arguments[1]);
    sweeper_.cross(desk_, other, others);
    return true;
  };
  handlers["swept"] = [this](const Command& c) {
    if (!wait_since_s_) wait_since_s_ = clockSeconds();
    if (!sweeper_.isOpen()) throw Error("there is no sweep", c.place);
    if (clockSeconds() - *wait_since_s_ > kTruthLimit_s) throw Error("the sweep is not complete", c.place);
    if (!sweeper_.isComplete()) return false;
    wait_since_s_.reset();
    return true;
  };
  handlers["experiment"] = [this](const Command& c) {
    return writeFileAtomically(c.arguments[0], sweeper_.experiment(desk_)), true;
  };
  handlers["click"] = [this](const Command& c) {
    if (!wait_from_) wait_from_ = state_.window_frame;
    int passed = state_.window_frame - *wait_from_;
    clicked_ = dvec2(integerOf(c, 0), integerOf(c, 1));
    // Panels learn first where the pointer is, then that the button is down, then that it is up.
    pressed_ = passed == 2;
    if (passed < 4) return false;
    clicked_.reset();
    wait_from_.reset();
    return true;
  };
}

std::map<std::string, Handler> Live::handlers() {
  std::map<std::string, Handler> handlers;
  addShotHandlers(handlers);
  addLookHandlers(handlers);
  addWaitHandlers(handlers);
  addFileHandlers(handlers);
  addSweepHandlers(handlers);
  return handlers;
}

}  // namespace

void runLive(const Home& home, const LiveOptions& options) {
  Live live(home, options);
  live.run();
}

}  // namespace strobe::live
