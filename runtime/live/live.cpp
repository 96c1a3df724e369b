// SPDX-License-Identifier: MIT
#include "live/live.h"

#include <backends/imgui_impl_glfw.h>
#include <imgui.h>
#include <unistd.h>

#include <cstdio>

#include "base/leftovers.h"
#include "base/log.h"
#include "base/process_name.h"
#include "image/png.h"
#include "live/driven_window.h"
#include "live/picture_view.h"
#include "live/recording.h"
#include "live/surface.h"
#include "live/sweep_panel.h"
#include "live/window.h"

namespace strobe::live {

namespace {

// Seconds between checks for edited files: while the window is idle, and while edited scripts are evaluated.
constexpr double kIdle_s = 0.02, kEvaluates_s = 0.002;
constexpr int kSoftwareWidth = 320, kSoftwareHeight = 180;

// Dear ImGui context with fonts, and with mouse and keyboard of the window.
class Gui {
 public:
  explicit Gui(Window& window) {
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;
    // Surface supports draw lists of more than 65536 vertices. Values written on thousands of pixels need that many.
    ImGui::GetIO().BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
    fonts_ = applyStyle();
    ImGui_ImplGlfw_InitForVulkan(window.handle(), true);
    window.queueInput();
  }
  ~Gui() {
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
  }
  Gui(const Gui&) = delete;
  Gui& operator=(const Gui&) = delete;
  const Fonts& fonts() const { return fonts_; }

  // Begins a frame with the next batch of keys and buttons.
  static void beginFrame(Window& window) {
    for (const InputEvent& event : window.input().take(ImGui::GetIO().WantTextInput)) {
      if (event.kind == InputEvent::Kind::Key)
        ImGui_ImplGlfw_KeyCallback(window.handle(), event.code, event.scancode, event.action, event.mods);
      if (event.kind == InputEvent::Kind::Text) ImGui_ImplGlfw_CharCallback(window.handle(), unsigned(event.code));
    }
    ImGui_ImplGlfw_NewFrame();
    pointAndPress(window.input());
  }

 private:
  // Pointer and buttons in the backend include all queued events. This function sets them to the state after this
  // batch.
  static void pointAndPress(const InputQueue& input) {
    ImGuiIO& io = ImGui::GetIO();
    if (const dvec2* at = input.pointer()) setPointer(*at);
    for (int button = 0; button < 3; ++button) {
#if IMGUI_VERSION_NUM >= 18700  // since this version, positions and buttons are events
      io.AddMouseButtonEvent(button, input.isDown(button));
#else
      io.MouseDown[button] = input.isDown(button);
#endif
    }
  }
  static void setPointer(const dvec2& at) {
#if IMGUI_VERSION_NUM >= 18700
    ImGui::GetIO().AddMousePosEvent(float(at.x), float(at.y));
#else
    ImGui::GetIO().MousePos = ImVec2(float(at.x), float(at.y));
#endif
  }

  Fonts fonts_;
};

gpu::DeviceOptions deviceOptions(const Window& window, const LiveOptions& options) {
  gpu::DeviceOptions device = window.extensions();
  device.device = options.desk.shot.device;
  device.validation = options.validation;
  return device;
}

// Options with a small picture for a software device, unless a size was given. The device draws the small picture
// several times a second.
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
  DrivenParts drivenParts();

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
  std::unique_ptr<PanelTexture> picture_;
  std::unique_ptr<DrivenWindow> drive_;
  std::unique_ptr<lab::Tev> tev_;
  std::string title_;
  std::optional<Path> screenshot_;
  int settle_ = kSettleFrames;
  bool quit_ = false;
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
  removeLeftovers(options.desk.out, ".recorded.");
  if (!options.drive.empty()) drive_ = std::make_unique<DrivenWindow>(options.drive, drivenParts());
}

DrivenParts Live::drivenParts() {
  return {desk_,
          sweeper_,
          state_,
          window_,
          screenshot_,
          quit_,
          [this](Action action) { actions_.at(action)(); },
          [this] { beginRecording(); },
          [this](const Path& script) { stopRecording(script); }};
}

// A shader that never ends cannot be stopped. At the time limit, the handler reports the shader, saves the shot to a
// file, and exits without releasing the device.
void Live::watch() {
  bench_.device().setTimeLimit(options_.time_limit_s, [this](const std::string& text) {
    Path file = options_.desk.out / "overrun.record.json";
    std::string kept;
    try {
      Json record;
      record["shot"] = lab::toJson(desk_.shot());
      writeFileAtomically(file, record.dump(2) + "\n");
      kept = fmt::format("; the shot is saved in {}: open it with --record", file.string());
    } catch (const Error& error) {
      kept = fmt::format("; the shot could not be saved: {}", error.what());
    }
    std::fprintf(stderr, "strobe: %s (--time-limit)%s\n", text.c_str(), kept.c_str());
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

// Sweeps the control under the pointer; otherwise the first search result, by name before description; otherwise the
// control that was changed last.
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
  if (name.empty()) throw Error("no control to sweep: point at a control, or find one with /");
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
  recording_ = std::make_unique<Recording>(bench_.home(), desk_.options().out / (".recorded." + processName()));
}

Path Live::stopRecording(const Path& script) {
  if (!recording_) throw Error("no recording is running");
  recording_->write(script, bench_.limits);
  recording_.reset();
  return script;
}

// Writes the recording when the window is closed.
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
  state_.say(fmt::format("saved; repeat it with: strobe capture {} -o DIR", script.string()));
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
      {Action::SaveExperiment,
       [this] { state_.say("saved; run it with: strobe sweep " + sweeper_.save(desk_).string()); }},
      {Action::Record, [this] { toggleRecording(); }},
      {Action::TogglePanels, [this] { state_.panels = !state_.panels; }},
      {Action::ToggleHelp, [this] { state_.help = !state_.help; }},
      {Action::Quit, [this] { quit_ = true; }},
  };
}

void Live::takeKeys() {
  for (int key : window_.input().takePressed())
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

void Live::drawWindow() {
  const image::Image& shown = desk_.picture(state_.window_frame);
  ++state_.window_frame;
  auto [width, height] = window_.size();
  if (width == 0 || height == 0) return;
  // A reduced picture is filtered. An enlarged picture shows its pixels as squares.
  bool smooth = shown.width > width || shown.height > height;
  surface_.upload(picture_, "picture", shown, smooth);
  view_.prepare(surface_, desk_);
  sweep_panel_.prepare(surface_, sweeper_, desk_.look().view.exposure_stops);

  Gui::beginFrame(window_);
  if (drive_) drive_->point(view_);
  ImGui::NewFrame();
  WindowArea area = drawPanels(gui_.fonts(), desk_, state_);
  area = sweep_panel_.draw(gui_.fonts(), desk_, sweeper_, state_, area);
  view_.interact(desk_, state_, area, window_.input());
  view_.draw(gui_.fonts(), desk_, state_, area, *picture_);
  drawOverlays(gui_.fonts(), desk_, state_, area);
  ImGui::Render();
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
  window_.takeEvents(awake ? 0 : desk_.sides().evaluate() ? kEvaluates_s : kIdle_s);
  if (window_.stirred() || !window_.input().empty() || spoke != state_.speaks()) settle_ = kSettleFrames;
  window_.settle();
  if (drive_) drive_->advance();
  if (recording_) recording_->lookAtFiles();
  bool news = desk_.turn([this] { return window_.takeEvents(0), window_.stirred(); });
  if (std::string message = desk_.sides().takeMessage(); !message.empty()) state_.say(message);
  if (news) sendToTev();
  if (recording_) recording_->look(desk_, ImGui::IsAnyMouseDown() || desk_.playing || desk_.a().more > 0);
  state_.recorded.reset();
  if (recording_) state_.recorded = recording_->moments();
  // A drag has priority over the sweep.
  bool swept = !ImGui::IsAnyMouseDown() && sweeper_.turn(desk_);
  if (news || swept) settle_ = kSettleFrames;
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

}  // namespace

void runLive(const Home& home, const LiveOptions& options) {
  Live live(home, options);
  live.run();
}

}  // namespace strobe::live
