// SPDX-License-Identifier: MIT
#include "live/sweep_panel.h"

#include <algorithm>
#include <cmath>

#include "image/legend.h"
#include "image/magma.h"
#include "image/tone.h"
#include "live/widgets.h"
#include "page/number.h"

namespace strobe::live {

namespace {

constexpr float kRow = 25, kPad = 12, kLine = 15;  // row of widgets, padding, line of text
constexpr float kMostPicture = 108, kMostChart = 92, kLeastChart = 34;
constexpr float kNumber = 66;                    // width of a number's field
constexpr float kNames = 78, kNumberWidth = 48;  // widths: row names of a grid, number of an error
constexpr ImU32 kErrors = colours::kAccent, kTimes = colours::kOther;

std::string valueText(const SweepAxis& axis, size_t value) { return lab::plainText(axis.values[value]); }

std::string msText(double ms) { return fmt::format("{:.3g} ms", ms); }

// Text centred at x; omitted if wider than `room`.
void centred(ImFont* font, ImU32 color, const std::string& text, float x, float y, float room) {
  float width = font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, text.c_str()).x;
  if (width > room) return;
  ImGui::GetWindowDrawList()->AddText(font, font->FontSize, ImVec2(std::floor(x - width / 2), y), color, text.c_str());
}

// Text cut at its end to the width `room`.
std::string cut(ImFont* font, std::string text, float room) {
  auto width = [&] { return font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, text.c_str()).x; };
  while (text.size() > 1 && width() > room) text.pop_back();
  return text;
}

std::optional<double> largest(const Sweep& sweep, const std::function<std::optional<double>(const SweepPoint&)>& of) {
  std::optional<double> most;
  for (const SweepPoint& point : sweep.points())
    if (auto value = of(point); value && std::isfinite(*value)) most = std::max(most.value_or(0), *value);
  return most;
}

std::optional<double> errorOf(const SweepPoint& point) { return point.error; }
std::optional<double> msOf(const SweepPoint& point) { return point.median(); }

// ---- settings

// Field for a number. True if an edit of the field has ended.
bool numberField(const char* id, double& value, const std::string& explanation, float width = kNumber) {
  ImGui::SetNextItemWidth(width);
  ImGui::InputDouble(id, &value, 0, 0, "%.6g");
  bool left = ImGui::IsItemDeactivatedAfterEdit();
  tooltip(explanation);
  return left;
}

// Fields of a control. True if a field changed.
bool formFields(const Fonts& fonts, SweepForm& form, bool focus) {
  const plan::ParamDesc& declaration = form.control.declaration;
  ImGui::AlignTextToFramePadding();
  textIn(fonts.bold, colours::kText, declaration.name);
  tooltip(declaration.doc);
  ImGui::SameLine();
  if (!hasRange(declaration)) return ImGui::TextDisabled("all values"), false;
  if (!form.listed.empty())
    return ImGui::TextDisabled("%s", fmt::format("{}", fmt::join(form.listed, ", ")).c_str()), false;
  if (focus) ImGui::SetKeyboardFocusHere();
  bool changed = numberField("##from", form.range.from, "first value");
  ImGui::SameLine();
  ImGui::TextDisabled("to");
  ImGui::SameLine();
  changed = numberField("##to", form.range.to, "last value") || changed;
  ImGui::SameLine();
  ImGui::TextDisabled("in");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(36);
  ImGui::InputInt("##steps", &form.range.steps, 0);
  changed = ImGui::IsItemDeactivatedAfterEdit() || changed;
  tooltip("number of values, including both ends");
  ImGui::SameLine();
  changed = ImGui::Checkbox("log", &form.range.logarithmic) || changed;
  tooltip("logarithmic steps: a constant factor between values");
  return changed;
}

// Menu for the control of the second axis.
void crossChoice(Desk& desk, Sweeper& sweeper, PanelState& state) {
  const lab::Session& session = sweeper.ofB() && desk.b() ? *desk.b()->session : *desk.a().session;
  const std::string& first = sweeper.forms().front().control.declaration.name;
  std::string current = sweeper.forms().size() > 1 ? sweeper.forms()[1].control.declaration.name : "";
  ImGui::SetNextItemWidth(112);
  if (!ImGui::BeginCombo("##cross", current.empty() ? "one control" : ("by " + current).c_str(),
                         ImGuiComboFlags_HeightLarge))
    return tooltip("second control of a grid");
  std::optional<std::string> chosen;
  if (ImGui::Selectable("one control", current.empty())) chosen = "";
  for (const lab::Control& control : session.controls()) {
    const std::string& name = control.declaration.name;
    bool of_a = sweeper.ofB() && control.group == "shot";
    if (name == first || of_a || !canBeSwept(control)) continue;
    if (ImGui::Selectable(("by " + name).c_str(), name == current)) chosen = name;
  }
  ImGui::EndCombo();
  if (chosen && *chosen != current) attempt(state, [&] { sweeper.cross(desk, *chosen); });
}

std::string progressText(const Sweep& sweep, const Desk& desk) {
  const std::string& truth = desk.truth().pipeline();
  bool software = desk.sides().a().session->bench().device().info().software;
  size_t count = sweep.points().size();
  std::string done = sweep.stopped()         ? "stopped"
                     : sweep.drawn() < count ? fmt::format("drawing {} of {}", sweep.drawn() + 1, count)
                     : sweep.samplesOwn()    ? "sampling the truth of each value"
                     : sweep.timed() < count ? fmt::format("timing, {} of {} done", sweep.timed(), count)
                                             : fmt::format("{} values", count);
  std::string against =
      sweep.samples() == 0 ? "no errors yet"
      : sweep.sharesTruth()
          ? fmt::format("RMSE against {} of {}", truth, samplesText(sweep.samples(), Sweep::kEnough))
          : fmt::format("RMSE against {} of each value's own truth", samplesText(sweep.samples(), Sweep::kOwnSamples));
  const SweepPoint* worst = sweep.worst();
  std::string shown =
      worst ? fmt::format("  ·  pictures: the {}x{} px with the largest error", worst->worst.width, worst->worst.height)
            : "";
  return fmt::format("{}  ·  {}  ·  ms of {} frames{}{}", done, against, Sweep::kRounds,
                     software ? ", software device" : "", shown);
}

// ---- points

// Invisible button of a point; a click takes the point's values. True if the pointer is on the button.
bool pointButton(Desk& desk, Sweeper& sweeper, PanelState& state, size_t point, ImVec2 at, ImVec2 size) {
  ImGui::SetCursorScreenPos(at);
  ImGui::PushID(int(point));
  bool pressed = ImGui::InvisibleButton("point", size);
  ImGui::PopID();
  if (pressed) attempt(state, [&] { sweeper.take(desk, point); });
  return ImGui::IsItemHovered();
}

// Curve over columns. A point without a value leaves a gap. Points of categories are not joined.
struct PanelCurve {
  std::vector<std::optional<double>> values;
  double full = 1;  // value at the top
  ImU32 color = 0;
  bool joined = true;
};

void drawCurve(const PanelCurve& curve, ImVec2 at, float column, float height) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  auto place = [&](size_t i) {
    return ImVec2(at.x + (float(i) + 0.5f) * column,
                  at.y + height - height * float(std::clamp(*curve.values[i] / curve.full, 0.0, 1.0)));
  };
  for (size_t i = 0; i < curve.values.size(); ++i) {
    if (!curve.values[i]) continue;
    if (i > 0 && curve.joined && curve.values[i - 1]) list->AddLine(place(i - 1), place(i), curve.color, 1.5f);
  }
  for (size_t i = 0; i < curve.values.size(); ++i)
    if (curve.values[i]) list->AddCircleFilled(place(i), 3.5f, curve.color);
}

PanelCurve curveOf(const Sweep& sweep, const std::function<std::optional<double>(const SweepPoint&)>& of, ImU32 color) {
  PanelCurve curve{
      {}, image::niceCeiling(largest(sweep, of).value_or(0)), color, hasRange(sweep.axes().front().declaration)};
  for (const SweepPoint& point : sweep.points()) {
    std::optional<double> value = of(point);
    curve.values.push_back(value && std::isfinite(*value) ? value : std::nullopt);
  }
  return curve;
}

ImU32 errorColour(double share) {
  image::Colour colour = image::magma(float(0.12 + 0.8 * std::clamp(share, 0.0, 1.0)));
  auto byte = [](float value) { return int(std::lround(255 * value)); };
  return IM_COL32(byte(colour[0]), byte(colour[1]), byte(colour[2]), 255);
}

void frameOf(SweepPanel::Mark mark, ImVec2 low, ImVec2 high) {
  if (!mark.current && !mark.hovered) return;
  ImU32 color = mark.current ? colours::kAccent : colours::kDim;
  ImGui::GetWindowDrawList()->AddRect(low, high, color, 2, 0, mark.current ? 2.0f : 1.0f);
}

double shapeOf(const Sweep& sweep) { return double(sweep.shot().height) / sweep.shot().width; }

SweepPanel::Strip stripOf(const Sweep& sweep, ImVec2 at, ImVec2 room) {
  SweepPanel::Strip strip{at, room.x / float(sweep.points().size())};
  float shape = float(shapeOf(sweep)), texts = 4 * kLine + 12;
  strip.tall = std::max(8.0f, std::min({kMostPicture, (strip.column - 4) * shape, room.y - texts - kLeastChart}));
  strip.wide = strip.tall / shape;
  strip.chart_y = at.y + strip.tall + 2 * kLine + 6;
  strip.chart = std::clamp(room.y - strip.tall - texts, kLeastChart, kMostChart);
  return strip;
}

// The control with more values goes across. Narrow cells have no space for numbers.
SweepPanel::Grid gridOf(const Sweep& sweep, ImVec2 room) {
  SweepPanel::Grid grid;
  size_t first = sweep.axes()[0].values.size(), second = sweep.axes()[1].values.size();
  grid.across = first >= second ? 0 : 1;
  grid.columns = std::max(first, second);
  grid.rows = std::min(first, second);
  float shape = float(shapeOf(sweep));
  grid.wide = (room.x - kNames) / float(grid.columns);
  grid.line = grid.wide < kNumberWidth ? 0 : kLine;
  grid.tall = std::min((room.y - kLine) / float(grid.rows), (grid.wide - 8) * shape + grid.line + 8);
  grid.wide = std::min(grid.wide, std::max(kNumberWidth, (grid.tall - grid.line - 8) / shape + 8));
  grid.worst = largest(sweep, errorOf).value_or(0);
  return grid;
}

float heightOf(const Sweeper& sweeper, const WindowArea& area) {
  const Sweep& sweep = sweeper.sweep();
  float head = 2 * kPad + kRow * float(1 + sweep.axes().size()) + kLine + 4;
  float most = 0.62f * float(area.height);
  if (sweep.axes().size() > 1) {
    SweepPanel::Grid grid = gridOf(sweep, ImVec2(float(area.width) - 2 * kPad, most - head));
    return std::min(most, head + kLine + float(grid.rows) * grid.tall);
  }
  float column = (float(area.width) - 2 * kPad) / float(sweep.points().size());
  float picture = std::min(kMostPicture, (column - 4) * float(shapeOf(sweep)));
  return std::min(most, head + picture + 4 * kLine + 12 + kMostChart);
}

}  // namespace

void SweepPanel::prepare(Surface& surface, const Sweeper& sweeper, double stops) {
  if (!sweeper.isOpen()) return;
  const Sweep& sweep = sweeper.sweep();
  const SweepPoint* worst = sweep.worst();
  const Made made{sweeper.serial(), stops, worst, worst ? worst->worst : image::Rectangle()};
  thumbnails_.resize(sweep.points().size());
  for (size_t i = 0; i < thumbnails_.size(); ++i) {
    const SweepPoint& point = sweep.points()[i];
    if (point.color.empty() || thumbnails_[i].made == made) continue;
    surface.upload(thumbnails_[i].texture, "sweep", image::toneMap(thumbnailOf(point, worst), {float(stops)}), true);
    thumbnails_[i].made = made;
  }
}

// Draws the thumbnail of a point. The crop has the aspect ratio of `size`.
void SweepPanel::drawPicture(const Sweep& sweep, size_t point, ImVec2 at, ImVec2 size) const {
  ImDrawList* list = ImGui::GetWindowDrawList();
  ImVec2 end(at.x + size.x, at.y + size.y);
  const SweepPoint& of = sweep.points()[point];
  // Points of a sweep that began after the thumbnails were made lack a thumbnail.
  bool has_picture = !of.color.empty() && point < thumbnails_.size() && thumbnails_[point].texture;
  if (!has_picture)
    return list->AddRectFilled(at, end, of.problem.empty() ? colours::kBackground : IM_COL32(58, 28, 26, 255));
  list->AddImage(thumbnails_[point].texture->id(), at, end);
}

void SweepPanel::describe(const Fonts& fonts, const Sweep& sweep, size_t point) const {
  const SweepPoint& of = sweep.points()[point];
  ImGui::BeginTooltip();
  for (size_t i = 0; i < of.at.size(); ++i)
    textIn(fonts.bold, colours::kText,
           fmt::format("{} = {}", sweep.axes()[i].declaration.name, valueText(sweep.axes()[i], of.at[i])), -FLT_MAX);
  if (of.error) textIn(fonts.mono, kErrors, "RMSE " + page::shownError(*of.error), -FLT_MAX);
  if (of.median()) textIn(fonts.mono, kTimes, msText(*of.median()), -FLT_MAX);
  if (!of.problem.empty()) wrappedIn(fonts.small, colours::kBad, of.problem, 360);
  else textIn(fonts.small, colours::kDim, "click to take these values", -FLT_MAX);
  ImGui::EndTooltip();
}

void SweepPanel::drawHead(const Fonts& fonts, Desk& desk, Sweeper& sweeper, PanelState& state) {
  ImGui::AlignTextToFramePadding();
  textIn(fonts.bold, sweeper.ofB() ? kTimes : kErrors, sweeper.ofB() ? "Sweep of B" : "Sweep");
  ImGui::SameLine();
  crossChoice(desk, sweeper, state);
  ImGui::SameLine();
  bool again = ImGui::Button("draw again");
  tooltip("draw the sweep again with the current controls and files");
  ImGui::SameLine();
  ImGui::BeginDisabled(!sweeper.busy());
  if (ImGui::Button("cancel")) sweeper.stop();
  ImGui::EndDisabled();
  ImGui::SameLine();
  if (ImGui::Button("save as experiment")) state.requests.push_back(Action::SaveExperiment);
  tooltip("save a file for 'strobe sweep' (F5)");
  ImGui::SameLine(ImGui::GetWindowWidth() - 34);
  bool closes = quietButton("\u00d7", "close the sweep (Escape)");
  for (size_t i = 0; i < sweeper.forms().size(); ++i) {
    ImGui::PushID(int(i));
    again = formFields(fonts, sweeper.forms()[i], i == 0 && std::exchange(focus_, false)) || again;
    ImGui::PopID();
  }
  bool stale = sweeper.isStale(desk);
  std::string progress = progressText(sweeper.sweep(), desk);
  for (const SweepForm& form : sweeper.forms())
    if (!form.control.idle.empty())
      progress = fmt::format("{} has no effect: {}  ·  {}", form.control.declaration.name, form.control.idle, progress);
  if (stale) progress = "stale: values or files of the picture have changed  ·  " + progress;
  textIn(fonts.small, stale ? colours::kBad : colours::kDim, progress);
  tooltip(progress);
  if (again) attempt(state, [&] { sweeper.begin(desk); });
  if (closes) state.requests.push_back(Action::Unpin);
}

// Column of the strip for a point: picture, value and numbers, and a highlight of the hovered column in the chart.
void SweepPanel::drawColumn(const Fonts& fonts, const Sweep& sweep, const Strip& strip, size_t i, Mark mark) const {
  ImDrawList* list = ImGui::GetWindowDrawList();
  float x = strip.at.x + strip.column * float(i), middle = x + strip.column / 2;
  float bottom = strip.chart_y + strip.chart + 4;
  if (mark.hovered)
    list->AddRectFilled(ImVec2(x, strip.chart_y - kLine), ImVec2(x + strip.column, bottom),
                        IM_COL32(255, 255, 255, 14));
  ImVec2 corner(std::floor(middle - strip.wide / 2), strip.at.y);
  drawPicture(sweep, i, corner, ImVec2(strip.wide, strip.tall));
  frameOf(mark, ImVec2(corner.x - 1, corner.y - 1), ImVec2(corner.x + strip.wide + 1, corner.y + strip.tall + 1));
  ImFont* font = mark.current ? fonts.bold : fonts.small;
  std::string value = cut(font, valueText(sweep.axes()[0], i), strip.column - 2);
  centred(font, mark.current ? kErrors : colours::kText, value, middle, strip.at.y + strip.tall + 2, strip.column);
  const SweepPoint& point = sweep.points()[i];
  if (point.error) centred(fonts.small, kErrors, page::shownError(*point.error), middle, bottom + 1, strip.column);
  if (point.median()) centred(fonts.small, kTimes, msText(*point.median()), middle, bottom + kLine, strip.column);
  if (mark.hovered) describe(fonts, sweep, i);
}

void SweepPanel::drawStrip(const Fonts& fonts, Desk& desk, Sweeper& sweeper, PanelState& state) {
  const Sweep& sweep = sweeper.sweep();
  ImDrawList* list = ImGui::GetWindowDrawList();
  ImVec2 at = ImGui::GetCursorScreenPos(), room = ImGui::GetContentRegionAvail();
  Strip strip = stripOf(sweep, at, room);
  ImVec2 chart(at.x, strip.chart_y);
  list->AddRectFilled(ImVec2(at.x, strip.chart_y - kLine), ImVec2(at.x + room.x, strip.chart_y + strip.chart + 4),
                      colours::kBackground, 3);
  std::optional<size_t> current = sweeper.current(desk);
  for (size_t i = 0; i < sweep.points().size(); ++i) {
    ImVec2 corner(at.x + strip.column * float(i), at.y);
    bool hovered = pointButton(desk, sweeper, state, i, corner, ImVec2(strip.column, strip.height()));
    drawColumn(fonts, sweep, strip, i, {current == i, hovered});
  }
  PanelCurve errors = curveOf(sweep, errorOf, kErrors), times = curveOf(sweep, msOf, kTimes);
  drawCurve(times, chart, strip.column, strip.chart);
  drawCurve(errors, chart, strip.column, strip.chart);
  auto label = [&](const PanelCurve& curve, const char* what, bool right) {
    std::string text = fmt::format("{} to {}", what, page::shownNumber(curve.full));
    float width = fonts.small->CalcTextSizeA(11, FLT_MAX, 0, text.c_str()).x;
    ImVec2 corner(right ? at.x + room.x - width - 4 : at.x + 4, strip.chart_y - kLine + 1);
    list->AddText(fonts.small, 11, corner, (curve.color & 0x00ffffff) | 0xb0000000, text.c_str());
  };
  if (sweep.samples() > 0) label(errors, "RMSE", false);
  if (largest(sweep, msOf)) label(times, "ms", true);
}

void SweepPanel::drawCell(const Fonts& fonts, const Sweep& sweep, const Grid& grid, size_t point, ImVec2 low,
                          Mark mark) const {
  const SweepPoint& of = sweep.points()[point];
  ImVec2 high(low.x + grid.wide - 2, low.y + grid.tall - 2);
  double share = of.error && grid.worst > 0 ? *of.error / grid.worst : 0;
  ImGui::GetWindowDrawList()->AddRectFilled(low, high, of.error ? errorColour(share) : colours::kBackground, 2);
  drawPicture(sweep, point, ImVec2(low.x + 3, low.y + 3), ImVec2(grid.wide - 8, grid.tall - grid.line - 8));
  ImU32 ink = share > 0.62 ? IM_COL32(20, 20, 24, 255) : IM_COL32(240, 240, 244, 255);
  if (of.error && grid.line > 0)
    centred(fonts.small, ink, page::shownError(*of.error), (low.x + high.x) / 2, high.y - kLine, grid.wide);
  frameOf(mark, low, high);
  if (mark.hovered) describe(fonts, sweep, point);
}

void SweepPanel::drawGrid(const Fonts& fonts, Desk& desk, Sweeper& sweeper, PanelState& state) {
  const Sweep& sweep = sweeper.sweep();
  ImVec2 at = ImGui::GetCursorScreenPos();
  Grid grid = gridOf(sweep, ImGui::GetContentRegionAvail());
  const SweepAxis &across = sweep.axes()[grid.across], &down = sweep.axes()[1 - grid.across];
  std::optional<size_t> current = sweeper.current(desk);
  for (size_t c = 0; c < grid.columns; ++c)
    centred(fonts.small, colours::kText, cut(fonts.small, valueText(across, c), grid.wide - 4),
            at.x + kNames + (float(c) + 0.5f) * grid.wide, at.y, grid.wide);
  for (size_t r = 0; r < grid.rows; ++r) {
    float y = at.y + kLine + float(r) * grid.tall;
    std::string name = cut(fonts.small, valueText(down, r), kNames - 6);
    ImGui::GetWindowDrawList()->AddText(fonts.small, fonts.small->FontSize, ImVec2(at.x, y + grid.tall / 2 - 7),
                                        colours::kText, name.c_str());
    for (size_t c = 0; c < grid.columns; ++c) {
      size_t point = grid.across == 0 ? c * grid.rows + r : r * grid.columns + c;
      ImVec2 low(at.x + kNames + float(c) * grid.wide + 1, y + 1);
      bool hovered = pointButton(desk, sweeper, state, point, low, ImVec2(grid.wide - 2, grid.tall - 2));
      drawCell(fonts, sweep, grid, point, low, {current == point, hovered});
    }
  }
}

WindowArea SweepPanel::draw(const Fonts& fonts, Desk& desk, Sweeper& sweeper, PanelState& state,
                            const WindowArea& area) {
  if (!sweeper.isOpen() || !state.panels) return area;
  float height = std::floor(heightOf(sweeper, area));
  WindowArea rest = area;
  rest.height = std::max(20.0, area.height - height - 1);
  beginPanel("sweep", float(area.x), float(area.y + area.height) - height, float(area.width), height, true);
  drawHead(fonts, desk, sweeper, state);
  if (sweeper.sweep().axes().size() > 1) drawGrid(fonts, desk, sweeper, state);
  else drawStrip(fonts, desk, sweeper, state);
  ImGui::End();
  return rest;
}

}  // namespace strobe::live
