// SPDX-License-Identifier: MIT
#include "live/panels.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/log.h"
#include "page/number.h"
#include "plan/named.h"

namespace strobe::live {

namespace {

constexpr float kSide = 340, kLeastSide = 190, kTop = 40, kHelpWidth = 92;
// Bottom bar without the command text, padding of a panel, lines of the command text.
constexpr float kBottom = 61, kPadding = 12, kMostCommandLines = 3;
constexpr double kMessage_s = 4;  // duration of a message; an error stays twice as long

constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                                    ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
                                    ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoNav;

// Draws a menu of names. True if another name was chosen.
bool combo(const char* id, const std::string& current, const std::vector<std::string>& names, std::string& chosen) {
  bool changed = false;
  if (!ImGui::BeginCombo(id, current.c_str(), ImGuiComboFlags_HeightLarge)) return false;
  for (const std::string& name : names) {
    if (!ImGui::Selectable(name.c_str(), name == current)) continue;
    chosen = name;
    changed = name != current;
  }
  ImGui::EndCombo();
  return changed;
}

std::vector<std::string> withOwn(std::vector<std::string> names, const std::string& own) {
  if (std::find(names.begin(), names.end(), own) == names.end()) names.insert(names.begin(), own);
  return names;
}

// Draws the label of a row. The next widget fills the second column.
void row(const char* name) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled("%s", name);
  ImGui::SameLine(96);
  ImGui::SetNextItemWidth(-1);
}

// Slider for a number between `ends`; logarithmic if the lower end is above 0.
bool floatSlider(const char* id, float& value, std::array<float, 2> ends, const char* format) {
  const bool logarithmic = ends[0] > 0;
  bool changed = slider(id, ImGuiDataType_Float, &value, &ends[0], &ends[1], format,
                        logarithmic ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None);
  slidePlace({Widget::Kind::FloatSlider, ends[0], ends[1], logarithmic, ""}, value);
  return changed;
}

// Width of a side panel. A wide window has wide panels; a small window keeps nearly half of its width for the picture.
float sideWidth(float window) { return std::clamp(std::floor(0.28f * window), kLeastSide, kSide); }

// ---- top

void topBar(const Fonts& fonts, Desk& desk, PanelState& state, float width) {
  beginPanel("top", 0, 0, width, kTop);
  const lab::Session& session = *desk.a().session;
  ImGui::AlignTextToFramePadding();
  textIn(fonts.bold, colours::kAccent, "strobe");
  ImGui::SameLine(0, 18);
  ImGui::SetNextItemWidth(190);
  std::string chosen, current = session.shot().pipeline;
  if (combo("##pipeline", current, withOwn(script::pipelineNames(session.bench().home()), current), chosen))
    attempt(state, [&] { desk.sides().usePipeline(chosen); });
  tooltip("pipeline of A\n" + session.plan().pipeline.doc);
  ImGui::SameLine(0, 14);
  const gpu::DeviceInfo& device = session.bench().device().info();
  std::string backend = std::string("rays by ") + shader::backendName(session.running().planned().backend);
  textIn(fonts.text, colours::kDim,
         fmt::format("{}  ·  {} x {}  ·  {}{}  ·  {}", Path(session.shot().scene).filename().string(),
                     session.shot().width, session.shot().height, device.name.substr(0, device.name.find(" (")),
                     device.software ? " (software)" : "", backend),
         kHelpWidth);
  ImGui::SameLine(width - kHelpWidth);
  if (quietButton("help  ?", "all keys", state.help)) state.requests.push_back(Action::ToggleHelp);
  ImGui::End();
}

// ---- right: view

void viewPart(const Fonts& fonts, Desk& desk, PanelState& state) {
  heading(fonts, "View");
  Look& look = desk.look();
  std::string chosen;
  // Errors and differences always show the colour, on their own scale.
  const bool compares = desk.look().isOfColour();
  ImGui::BeginDisabled(compares);
  row("image");
  if (combo("##port", compares ? "color" : look.port, desk.viewable(), chosen))
    attempt(state, [&] { desk.viewPort(chosen); });
  tooltip(compares ? modeNames()[size_t(look.mode)] + " always shows the colour"
                   : "any output of any pass; Up and Down change it");
  row("as");
  const graph::ReadImage* viewed = desk.a().image();
  std::vector<std::string> kinds = viewed ? lab::viewKinds(*viewed) : std::vector<std::string>{"auto"};
  if (combo("##kind", compares ? modeNames()[size_t(look.mode)] : look.view.kind, kinds, chosen))
    look.view.kind = chosen;
  float stops = float(look.view.exposure_stops);
  row("brightness");
  if (floatSlider("##stops", stops, {-6, 6}, "%+.1f stops")) look.view.exposure_stops = stops;
  tooltip("brightness of the picture in this window; saved pictures do not change");
  float range[2] = {float(look.view.low), float(look.view.high)};
  row("scale");
  if (ImGui::DragFloat2("##range", range, 0.01f, 0, 0, range[0] == range[1] ? "auto" : "%.4g")) {
    look.view.low = range[0];
    look.view.high = range[1];
  }
  tooltip("range of the scale for depths, velocities and other numbers; auto (two equal ends): range of the image");
  ImGui::EndDisabled();
}

// ---- right: comparison

void versusChoice(Desk& desk, PanelState& state) {
  row("B");
  const Side* b = desk.b();
  std::string current = b ? b->session->shot().pipeline : "none chosen", chosen;
  if (combo("##versus", current, withOwn(script::pipelineNames(desk.a().session->bench().home()), current), chosen))
    attempt(state, [&] {
      desk.sides().usePipeline(chosen, true);
      if (desk.look().mode == Mode::Single) desk.setMode(Mode::Wipe);
    });
  tooltip("a second pipeline under the same clock, camera and seed");
}

void modeButtons(Desk& desk, PanelState& state) {
  for (size_t i = 0; i < modeNames().size(); ++i) {
    float wide = ImGui::CalcTextSize(modeNames()[i].c_str()).x + 2 * ImGui::GetStyle().FramePadding.x;
    if (i) ImGui::SameLine(0, 2);
    if (i && ImGui::GetContentRegionAvail().x < wide) ImGui::NewLine();
    Mode mode = Mode(i);
    ImGui::BeginDisabled(comparesWithB(mode) && !desk.b());
    bool lit = desk.look().mode == mode;
    ImGui::PushStyleColor(ImGuiCol_Button, lit ? IM_COL32(92, 72, 44, 255) : IM_COL32(44, 47, 52, 255));
    ImGui::PushID(int(i));
    if (ImGui::Button(modeNames()[i].c_str())) attempt(state, [&] { desk.setMode(mode); });
    ImGui::PopID();
    ImGui::PopStyleColor();
    tooltipAbove(keys()[size_t(Action::ShowSingle) - 1 + i].doc);
    ImGui::EndDisabled();
  }
}

std::string errorText(const std::optional<double>& error) { return error ? page::shownError(*error) : "-"; }

void errorTable(const Fonts& fonts, Desk& desk) {
  if (!ImGui::BeginTable("errors", 3, ImGuiTableFlags_SizingStretchProp)) return;
  auto side = [&](const char* name, ImU32 color, const Side& of) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    textIn(fonts.bold, color, name);
    ImGui::TableNextColumn();
    textIn(fonts.text, colours::kText, of.session->shot().pipeline);
    ImGui::TableNextColumn();
    textIn(fonts.mono, colours::kText, errorText(desk.truth().errorOf(desk.shot(), of.color)));
    tooltip("root mean square error of the linear colour against the truth so far");
  };
  side("A", colours::kAccent, desk.a());
  if (desk.b()) side("B", colours::kOther, *desk.b());
  ImGui::EndTable();
  int samples = desk.truth().samples(desk.shot());
  if (samples > 0)
    textIn(fonts.small, colours::kDim,
           fmt::format("RMSE against {} of {}", desk.truth().pipeline(), samplesText(samples, GatheredTruth::kEnough)));
  else
    textIn(fonts.small, colours::kDim,
           desk.look().mode == Mode::Error ? "truth starts" : "choose error (5) to gather truth for an RMSE");
}

// Setting of the mode. One row in every mode, so that the rows below do not move.
void modePart(const Fonts& fonts, Desk& desk) {
  Look& look = desk.look();
  if (desk.look().isOfColour()) {
    float gain = float(look.gain);
    row("gain");
    if (floatSlider("##gain", gain, {0.5f, 256}, "%.3g x")) look.gain = gain;
    return tooltip("full scale of the colours is 1 / gain of linear radiance");
  }
  if (look.mode == Mode::Wipe) {
    float at = 100 * float(look.wipe);
    row("line at");
    if (floatSlider("##wipe", at, {0, 100}, "%.0f %% of the width")) look.wipe = at / 100;
    return tooltip("or drag the line in the picture");
  }
  if (look.mode == Mode::Single && desk.b()) {
    bool other = look.single_b;
    if (ImGui::Checkbox("show B", &other)) look.single_b = other;
    return;
  }
  ImGui::AlignTextToFramePadding();
  textIn(fonts.small, colours::kDim, desk.b() ? "A and B alternately" : "choose a B, or show the error of A (5)");
}

void comparePart(const Fonts& fonts, Desk& desk, PanelState& state) {
  heading(fonts, "Compare");
  versusChoice(desk, state);
  modeButtons(desk, state);
  modePart(fonts, desk);
  Look& look = desk.look();
  if (desk.b() || look.mode == Mode::Error) errorTable(fonts, desk);
}

// ---- right: times

// Bar chart of times, newest at the right. A void frame leaves a gap.
void sparkline(const TimeHistory::Row& times, float width, float height) {
  ImVec2 at = ImGui::GetCursorScreenPos();
  ImDrawList* list = ImGui::GetWindowDrawList();
  float highest = 0;
  for (float ms : times.ms) highest = std::isnan(ms) ? highest : std::max(highest, ms);
  float step = width / float(TimeHistory::kFrames);
  float x = at.x + width - step * float(times.ms.size());
  for (float ms : times.ms) {
    float tall = std::isnan(ms) || highest <= 0 ? 0 : std::max(1.0f, height * ms / highest);
    if (tall > 0)
      list->AddRectFilled(ImVec2(x, at.y + height - tall), ImVec2(x + std::max(1.0f, step - 0.5f), at.y + height),
                          IM_COL32(116, 150, 178, 255));
    x += step;
  }
  ImGui::Dummy(ImVec2(width, height));
}

std::string msText(const std::optional<double>& ms) {
  if (!ms) return "-";
  return *ms >= 100 ? fmt::format("{:.0f}", *ms) : *ms >= 10 ? fmt::format("{:.1f}", *ms) : fmt::format("{:.2f}", *ms);
}

void timeCell(const Fonts& fonts, const TimeHistory::Row* times, ImU32 color) {
  ImGui::TableNextColumn();
  if (!times) return;
  textIn(fonts.mono, color, fmt::format("{:>7}", msText(times->median())));
  tooltip(fmt::format(
      "{}\nlast frame {} ms, median of the frames at the right {} ms\nframes with a new pipeline are not counted",
      times->name, msText(times->latest()), msText(times->median())));
}

// Row of a pass: time of A, time of B if there are `two` sides, and the history of A (of B if A lacks the pass).
void timeRow(const Fonts& fonts, const TimeHistory::Row* a, const TimeHistory::Row* b, bool two, ImU32 color) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  textIn(fonts.small, color, (a ? a : b)->name);
  timeCell(fonts, a, color);
  if (two) timeCell(fonts, b, color);
  ImGui::TableNextColumn();
  sparkline(*(a ? a : b), ImGui::GetContentRegionAvail().x, 14);
}

const TimeHistory::Row* passNamed(const Side* side, const std::string& name) {
  return side ? plan::find(side->times.passes(), name) : nullptr;
}

// Passes of A in their order, then passes that only B has. A pass of both sides has one row.
void timesPart(const Fonts& fonts, Desk& desk) {
  heading(fonts, "GPU time, ms");
  const Side &a = desk.a(), *b = desk.b();
  if (!ImGui::BeginTable("times", b ? 4 : 3, ImGuiTableFlags_SizingFixedFit)) return;
  float history = std::clamp(ImGui::GetContentRegionAvail().x - 220 - (b ? 58 : 0), 10.0f, 96.0f);
  ImGui::TableSetupColumn("pass", ImGuiTableColumnFlags_WidthStretch);
  ImGui::TableSetupColumn("A", ImGuiTableColumnFlags_WidthFixed, 58);
  if (b) ImGui::TableSetupColumn("B", ImGuiTableColumnFlags_WidthFixed, 58);
  ImGui::TableSetupColumn("history", ImGuiTableColumnFlags_WidthFixed, history);
  if (b) {
    ImGui::TableNextRow();
    ImGui::TableSetColumnIndex(1);
    textIn(fonts.bold, colours::kAccent, "      A");
    ImGui::TableNextColumn();
    textIn(fonts.bold, colours::kOther, "      B");
  }
  timeRow(fonts, &a.times.total(), b ? &b->times.total() : nullptr, b, colours::kText);
  for (const TimeHistory::Row& pass : a.times.passes())
    timeRow(fonts, &pass, passNamed(b, pass.name), b, colours::kDim);
  for (const TimeHistory::Row& pass : b ? b->times.passes() : std::vector<TimeHistory::Row>())
    if (!passNamed(&a, pass.name)) timeRow(fonts, nullptr, &pass, true, colours::kDim);
  ImGui::EndTable();
}

// ---- right: budget

void budgetPart(const Fonts& fonts, Desk& desk) {
  const plan::ParamDesc* param = BudgetKeeper::param(desk.a());
  if (!param) return;
  heading(fonts, "Budget");
  float ms = float(desk.budget().ms());
  row("a frame of A");
  if (ImGui::DragFloat("##budget", &ms, 0.2f, 0, 10000, ms > 0 ? "%.1f ms" : "none", ImGuiSliderFlags_AlwaysClamp))
    desk.budget().set(double(ms));
  tooltip(fmt::format(
      "maximum GPU time of a frame of A; 0: no limit\n{} follows the times of the last frames, until it is set by hand",
      param->name));
  const lab::Budget* budget = desk.budget().budget();
  if (!budget) return;
  textIn(fonts.small, budget->isMet() ? colours::kDim : colours::kBad,
         fmt::format("{} {:g}: {} of {:.1f} ms", param->name, budget->value(), msText(budget->cost()), budget->ms()));
}

// ---- right: limits that the frame met

void limitsPart(const Fonts& fonts, const char* title, const Side& side) {
  if (side.limits.empty()) return;
  heading(fonts, title);
  for (const LimitMet& met : side.limits) wrappedIn(fonts.small, colours::kBad, met.text());
}

// ---- right: the pinned pixel

// Name, value and meaning. Long texts wrap.
void trailLine(const Fonts& fonts, const TrailLine& line) {
  textIn(fonts.small, line.heading ? colours::kAccent : colours::kText, line.name);
  tooltip(line.doc);
  if (!line.value.empty()) {
    ImVec2 wide = fonts.mono->CalcTextSizeA(fonts.mono->FontSize, FLT_MAX, 0, line.value.c_str());
    float left = ImGui::GetItemRectMax().x - ImGui::GetWindowPos().x + 10;
    bool beside = left + wide.x < ImGui::GetContentRegionMax().x;
    if (beside) ImGui::SameLine(ImGui::GetContentRegionMax().x - wide.x);
    wrappedIn(fonts.mono, colours::kText, line.value);
  }
  if (!line.meaning.empty()) wrappedIn(fonts.small, colours::kDim, line.meaning);
  ImGui::Dummy(ImVec2(0, 1));
}

void trailPart(const Fonts& fonts, Desk& desk, PanelState& state) {
  if (!desk.pixel().at()) return;
  auto [x, y] = *desk.pixel().at();
  heading(fonts, fmt::format("Pixel {}, {}", x, y).c_str());
  if (ImGui::Button("copy as JSON"))
    attempt(state, [&] {
      ImGui::SetClipboardText(desk.pixel().json().dump(2).c_str());
      state.say("copied the trail of the pixel");
    });
  ImGui::SameLine();
  if (ImGui::Button("unpin")) return desk.pixel().unpin();
  // Keep space for the first times below. Longer trails scroll.
  float height = std::max(240.0f, ImGui::GetContentRegionAvail().y - 130);
  ImGui::BeginChild("trail", ImVec2(0, height));
  for (const TrailLine& line : desk.pixel().lines()) trailLine(fonts, line);
  ImGui::EndChild();
}

void rightPanel(const Fonts& fonts, Desk& desk, PanelState& state, float x, float width, float height) {
  beginPanel("right", x, kTop, width, height);
  viewPart(fonts, desk, state);
  comparePart(fonts, desk, state);
  trailPart(fonts, desk, state);
  limitsPart(fonts, desk.b() ? "Limits met by A" : "Limits met", desk.a());
  if (desk.b()) limitsPart(fonts, "Limits met by B", *desk.b());
  budgetPart(fonts, desk);
  timesPart(fonts, desk);
  ImGui::End();
}

// ---- bottom

// Height of the command text in the bottom bar, pixels; at most `kMostCommandLines` lines.
float commandHeight(const Fonts& fonts, const std::string& command, float width) {
  float tall = fonts.mono->CalcTextSizeA(fonts.mono->FontSize, FLT_MAX, width - 2 * kPadding, command.c_str()).y;
  return std::min(tall, kMostCommandLines * fonts.mono->FontSize);
}

void bottomBar(const Fonts& fonts, Desk& desk, PanelState& state, float width, float y, float height) {
  beginPanel("bottom", 0, y, width, height);
  auto press = [&](const char* label, const char* explanation, Action action, bool lit = false) {
    if (quietButton(label, explanation, lit)) state.requests.push_back(action);
    ImGui::SameLine(0, 2);
  };
  press("\u25c0##back", "one frame back", Action::StepBack);
  press(desk.playing ? "\u275a\u275a##play" : "\u25b6##play", "play or pause (Space)", Action::TogglePlay,
        desk.playing);
  press("\u25b6\u2759##ahead", "one frame ahead", Action::StepAhead);
  int frame = desk.shot().frame, last = std::max(desk.sides().lastFrame(), frame);
  ImGui::SetNextItemWidth(std::max(120.0f, width - 600));
  const int first = 0;
  if (slider("##frame", ImGuiDataType_S32, &frame, &first, &last, "frame %d", ImGuiSliderFlags_None))
    attempt(state, [&] { desk.goToFrame(frame); });
  slidePlace({Widget::Kind::IntSlider, 0, double(last), false, ""}, frame);
  ImGui::SameLine(0, 14);
  press("save", "save the picture with its run record (F2)", Action::Save);
  press("copy command", "copy the command that makes this picture (F4)", Action::CopyCommand);
  press("camera back", "reset the camera to the scene (C)", Action::CameraBack, desk.shot().view.has_value());
  press(state.recorded ? fmt::format("\u25a0 stop ({})", *state.recorded).c_str() : "\u25cf record",
        "record a capture script (F6)", Action::Record, state.recorded.has_value());
  press("fit", "fit the picture into the window (F)", Action::FitPicture);
  ImGui::NewLine();
  wrappedIn(fonts.mono, colours::kDim, lab::commandOf(desk.shot()));
  tooltip(lab::commandOf(desk.shot()));
  ImGui::End();
}

}  // namespace

void beginPanel(const char* name, float x, float y, float width, float height, bool tabs) {
  ImGui::SetNextWindowPos(ImVec2(x, y));
  ImGui::SetNextWindowSize(ImVec2(width, height));
  ImGui::Begin(name, nullptr, tabs ? kFixed & ~ImGuiWindowFlags_NoNav : kFixed);
}

void PanelState::say(const std::string& text, bool bad) {
  message = text;
  message_is_bad = bad;
  message_until_s = clockSeconds() + (bad ? 2 : 1) * kMessage_s;
}

bool PanelState::speaks() const { return !message.empty() && clockSeconds() < message_until_s; }

void attempt(PanelState& state, const std::function<void()>& change) {
  try {
    change();
  } catch (const Error& error) {
    state.say(error.what(), true);
  }
}

WindowArea drawPanels(const Fonts& fonts, Desk& desk, PanelState& state) {
  ImVec2 size = ImGui::GetIO().DisplaySize;
  if (!state.panels) return {0, 0, size.x, size.y};
  float bottom = kBottom + commandHeight(fonts, lab::commandOf(desk.shot()), size.x);
  float middle = std::max(50.0f, size.y - kTop - bottom);
  topBar(fonts, desk, state, size.x);
  float side = sideWidth(size.x);
  beginPanel("left", 0, kTop, side, middle);
  drawControls(fonts, desk, state);
  ImGui::End();
  rightPanel(fonts, desk, state, size.x - side, side, middle);
  bottomBar(fonts, desk, state, size.x, kTop + middle, bottom);
  return {side + 1, kTop + 1, std::max(50.0, double(size.x) - 2 * side - 2), double(middle) - 2};
}

// ---- overlays

namespace {

void drawProblems(const Fonts& fonts, const std::vector<std::string>& problems, const WindowArea& area) {
  ImDrawList* list = ImGui::GetBackgroundDrawList();
  list->AddRectFilled(ImVec2(float(area.x), float(area.y)),
                      ImVec2(float(area.x + area.width), float(area.y + area.height)), IM_COL32(10, 8, 8, 170));
  float width = float(std::min(area.width - 40, 860.0));
  ImGui::SetNextWindowPos(ImVec2(float(area.x + (area.width - width) / 2), float(area.y + 28)));
  ImGui::SetNextWindowSizeConstraints(ImVec2(width, 60), ImVec2(width, float(area.height - 60)));
  ImGui::PushStyleColor(ImGuiCol_WindowBg, IM_COL32(40, 24, 24, 245));
  ImGui::Begin("problems", nullptr,
               (kFixed & ~ImGuiWindowFlags_NoBringToFrontOnFocus) | ImGuiWindowFlags_AlwaysAutoResize |
                   ImGuiWindowFlags_NoFocusOnAppearing);
  textIn(fonts.bold, colours::kBad, problems.size() == 1 ? "1 problem" : fmt::format("{} problems", problems.size()));
  ImGui::SameLine();
  textIn(fonts.small, colours::kDim, "the picture below is from the last good version; the next good save replaces it");
  ImGui::Dummy(ImVec2(0, 2));
  for (const std::string& problem : problems) wrappedIn(fonts.mono, colours::kText, problem, width - 24);
  ImGui::End();
  ImGui::PopStyleColor();
}

// Rows for the elements of a list, which have `shown` and `doc`.
template <class List>
void keyRows(const Fonts& fonts, const List& list) {
  for (const auto& key : list) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    textIn(fonts.mono, colours::kAccent, key.shown);
    ImGui::TableNextColumn();
    textIn(fonts.text, colours::kText, key.doc);
  }
}

bool beginKeys(const Fonts& fonts, const char* title) {
  heading(fonts, title);
  if (!ImGui::BeginTable(title, 2)) return false;
  ImGui::TableSetupColumn("key", ImGuiTableColumnFlags_WidthFixed, 110);
  ImGui::TableSetupColumn("what", ImGuiTableColumnFlags_WidthStretch);
  return true;
}

void drawHelp(const Fonts& fonts) {
  ImVec2 window = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos(ImVec2(window.x / 2, window.y / 2), 0, ImVec2(0.5f, 0.5f));
  ImGui::SetNextWindowSizeConstraints(ImVec2(0, 0), ImVec2(window.x - 20, window.y - 20));
  bool wide = window.x > 1040;  // keys on the left, the mouse on the right
  ImGui::SetNextWindowSize(ImVec2(wide ? 1000.0f : 600.0f, 0));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(20, 14));
  ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, ImVec2(6, 1));
  ImGui::PushStyleColor(ImGuiCol_WindowBg, IM_COL32(26, 28, 31, 248));
  ImGui::Begin("help", nullptr, kFixed & ~ImGuiWindowFlags_NoBringToFrontOnFocus);
  ImGui::SetWindowFocus();
  bool columns = wide && ImGui::BeginTable("columns", 2);
  if (columns) ImGui::TableNextColumn();
  if (beginKeys(fonts, "Keys")) {
    keyRows(fonts, keys());
    ImGui::EndTable();
  }
  if (columns) ImGui::TableNextColumn();
  if (beginKeys(fonts, "While held")) {
    keyRows(fonts, heldKeys());
    ImGui::EndTable();
  }
  if (beginKeys(fonts, "Over the picture")) {
    keyRows(fonts, gestures());
    ImGui::EndTable();
  }
  if (columns) ImGui::EndTable();
  ImGui::End();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(2);
}

void drawMessage(const Fonts& fonts, const PanelState& state, const WindowArea& area) {
  ImGui::SetNextWindowPos(ImVec2(float(area.x + area.width / 2), float(area.y + area.height - 14)), 0, ImVec2(0.5f, 1));
  ImGui::SetNextWindowSizeConstraints(ImVec2(0, 0), ImVec2(float(area.width - 40), 200));
  ImGui::PushStyleColor(ImGuiCol_WindowBg,
                        state.message_is_bad ? IM_COL32(58, 28, 26, 240) : IM_COL32(38, 41, 46, 240));
  ImGui::Begin("message", nullptr,
               (kFixed & ~ImGuiWindowFlags_NoBringToFrontOnFocus) | ImGuiWindowFlags_AlwaysAutoResize |
                   ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoFocusOnAppearing);
  wrappedIn(fonts.text, colours::kText, state.message, float(area.width - 64));
  ImGui::End();
  ImGui::PopStyleColor();
}

}  // namespace

void drawOverlays(const Fonts& fonts, const Desk& desk, PanelState& state, const WindowArea& area) {
  std::vector<std::string> problems = desk.problems();
  if (!problems.empty()) drawProblems(fonts, problems, area);
  if (state.speaks()) drawMessage(fonts, state, area);
  if (state.help) drawHelp(fonts);
}

}  // namespace strobe::live
