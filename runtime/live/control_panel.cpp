// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstring>

#include "live/panels.h"
#include "live/sweep_axis.h"

namespace strobe::live {

void slidePlace(const Widget& slider, double value) {
  ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  ImU32 color = ImGui::GetColorU32(ImGui::IsItemActive() ? ImGuiCol_SliderGrabActive : ImGuiCol_SliderGrab);
  float end = low.x + (high.x - low.x) * float(shareOf(slider, value));
  ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(low.x, high.y - 3), ImVec2(std::max(end, low.x + 3), high.y), color);
}

namespace {

// A change that takes longer is applied when the widget is released.
constexpr double kPatience_s = 0.25;

struct Edit {
  bool changed = false;  // the widget has a new value
  std::string text;
};

Edit checkbox(const plan::Value& value) {
  bool on = std::get<bool>(value);
  bool changed = ImGui::Checkbox("##value", &on);
  return {changed, on ? "true" : "false"};
}

Edit menu(const plan::ParamDesc& declaration, const plan::Value& value) {
  Edit edit;
  std::string current = lab::plainText(value);
  if (!ImGui::BeginCombo("##value", current.c_str(), ImGuiComboFlags_HeightLarge)) return edit;
  for (const std::string& choice : declaration.choices) {
    if (ImGui::Selectable(choice.c_str(), choice == current)) edit = {choice != current, choice};
    for (const auto& [name, meaning] : declaration.values)
      if (name == choice) tooltip(meaning);
  }
  ImGui::EndCombo();
  return edit;
}

// `type`: ImGui's constant for `Number`. `speed`: change per pixel of a drag.
template <class Number>
bool dragOrSlide(const Widget& widget, ImGuiDataType type, Number& shown, float speed, const std::string& format) {
  Number low = Number(widget.low), high = Number(widget.high);
  ImGuiSliderFlags flags = ImGuiSliderFlags_AlwaysClamp | (widget.logarithmic ? ImGuiSliderFlags_Logarithmic : 0);
  bool limited = widget.low < widget.high;
  if (widget.kind == Widget::Kind::IntSlider || widget.kind == Widget::Kind::FloatSlider) {
    bool changed = slider("##value", type, &shown, &low, &high, format.c_str(), flags);
    slidePlace(widget, double(shown));
    return changed;
  }
  return ImGui::DragScalar("##value", type, &shown, speed, limited ? &low : nullptr, limited ? &high : nullptr,
                           format.c_str(), flags);
}

Edit integer(const Widget& widget, const plan::Value& value) {
  int64_t whole = std::get<int64_t>(value);
  std::string format = widget.format;
  format.replace(format.find("%d"), 2, "%lld");
  bool changed = dragOrSlide(widget, ImGuiDataType_S64, whole, 0.2f, format);
  return {changed, std::to_string(whole)};
}

Edit number(Widget widget, const plan::ParamDesc& declaration, const plan::Value& value) {
  double shown = std::get<double>(value);
  if (isOpen(declaration, shown)) widget.format = "auto";
  float speed = float(std::max(1e-3, std::abs(shown) * 0.005));
  bool changed = dragOrSlide(widget, ImGuiDataType_Double, shown, speed, widget.format);
  return {changed, lab::plainText(shown)};
}

Edit line(const plan::Value& value) {
  char buffer[512];
  std::string current = lab::plainText(value);
  std::snprintf(buffer, sizeof(buffer), "%s", current.c_str());
  bool changed =
      ImGui::InputTextWithHint("##value", "none", buffer, sizeof(buffer), ImGuiInputTextFlags_EnterReturnsTrue);
  return {changed && buffer != current, buffer};
}

Edit showWidget(const lab::Control& control) {
  Widget widget = widgetOf(control.declaration);
  ImGui::SetNextItemWidth(-1);
  switch (widget.kind) {
    case Widget::Kind::Checkbox:
      return checkbox(control.value);
    case Widget::Kind::Combo:
      return menu(control.declaration, control.value);
    case Widget::Kind::IntSlider:
    case Widget::Kind::IntDrag:
      return integer(widget, control.value);
    case Widget::Kind::FloatSlider:
    case Widget::Kind::FloatDrag:
      return number(widget, control.declaration, control.value);
    case Widget::Kind::Text:
      return line(control.value);
  }
  return {};
}

// Value that a widget is dragged to, until the widget is released.
struct Held {
  std::string name, text;
  bool of_b = false;
};
Held& held() {
  static Held value;
  return value;
}

ImU32 nameColour(const lab::Control& control) {
  if (control.set) return colours::kAccent;
  return control.origin == "default" || control.group == "shot" ? colours::kText : colours::kOther;
}

lab::Control asHeld(lab::Control control, bool of_b) {
  if (held().name != control.declaration.name || held().of_b != of_b) return control;
  try {
    control.value = plan::checkValue(control.declaration, plan::Value(held().text), {});
  } catch (const Error&) {
    held() = {};
  }
  return control;
}

void takeEdit(Desk& desk, PanelState& state, const lab::Control& control, const Edit& edit) {
  const std::string& name = control.declaration.name;
  bool of_b = state.controls_of_b;
  if (edit.changed) state.changed_control = name;
  auto apply = [&](const std::string& text) { attempt(state, [&] { desk.sides().set(name, text, "window", of_b); }); };
  bool dear = desk.sides().costOf(name) > kPatience_s;
  if (edit.changed && dear && ImGui::IsItemActive()) held() = {name, edit.text, of_b};
  else if (edit.changed) apply(edit.text);
  bool let_go = held().name == name && held().of_b == of_b && !ImGui::IsItemActive();
  if (!let_go) return;
  std::string text = held().text;
  held() = {};
  apply(text);
}

void sweepButton(PanelState& state, const lab::Control& control) {
  if (!canBeSwept(control)) return;
  ImGui::PushStyleColor(ImGuiCol_Button, ImVec4(0, 0, 0, 0));
  ImGui::PushStyleColor(ImGuiCol_Text, colours::kDim);
  if (ImGui::Button("\u25a5")) state.swept_control = control.declaration.name;
  ImGui::PopStyleColor(2);
  tooltip("sweep: show several values of this control side by side, with errors and times (R)");
}

// True if the pointer is anywhere in the row that begins at `top`.
bool isPointed(float top) {
  float left = ImGui::GetWindowPos().x;
  return ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem) &&
         ImGui::IsMouseHoveringRect(ImVec2(left, top),
                                    ImVec2(left + ImGui::GetWindowWidth(), ImGui::GetCursorScreenPos().y), false);
}

void drawControl(const Fonts& fonts, Desk& desk, PanelState& state, const lab::Control& control) {
  const std::string& name = control.declaration.name;
  bool of_b = state.controls_of_b;
  ImGui::PushID(name.c_str());
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::AlignTextToFramePadding();
  float top = ImGui::GetCursorScreenPos().y;
  // An idle control stays editable: with another value it may have an effect.
  ImGui::PushStyleVar(ImGuiStyleVar_Alpha, control.idle.empty() ? 1.0f : 0.42f);
  textIn(fonts.text, nameColour(control), shortName(control));
  ImGui::PopStyleVar();
  tooltip(tooltipOf(control));
  ImGui::TableNextColumn();
  ImGui::PushStyleVar(ImGuiStyleVar_Alpha, control.idle.empty() ? 1.0f : 0.42f);
  Edit edit = showWidget(asHeld(control, of_b));
  ImGui::PopStyleVar();
  takeEdit(desk, state, control, edit);
  bool plain = control.declaration.values.empty();
  std::string idle = control.idle.empty() ? "" : "has no effect: " + control.idle;
  std::string doc = plain ? control.declaration.doc : "";
  tooltip(doc + (doc.empty() || idle.empty() ? "" : "\n\n") + idle);
  ImGui::TableNextColumn();
  sweepButton(state, control);
  if (isPointed(top)) state.pointed_control = name;
  ImGui::TableNextColumn();
  if (control.set && quietButton("\u21ba", "reset to the preset, scene or default (now: " + control.origin + ")"))
    attempt(state, [&] { desk.sides().unset(name, of_b); });

  std::string refused = desk.sides().refusalOf(name, of_b);
  // A shot option from the command line or the scene is expected, so its origin is not shown.
  bool expected = control.origin.empty() || control.origin == "default" || (control.group == "shot" && !control.set);
  bool quiet = refused.empty() && expected;
  if (!quiet) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TableNextColumn();
    if (refused.empty()) wrappedIn(fonts.small, colours::kDim, control.origin);
    else wrappedIn(fonts.small, colours::kBad, refused);
  }
  ImGui::PopID();
}

void searchBox(PanelState& state) {
  char buffer[128];
  std::snprintf(buffer, sizeof(buffer), "%s", state.search.c_str());
  if (state.focus_search) ImGui::SetKeyboardFocusHere();
  state.focus_search = false;
  ImGui::SetNextItemWidth(-1);
  if (ImGui::InputTextWithHint("##search", "find a control  ( / )", buffer, sizeof(buffer))) state.search = buffer;
}

void sideChoice(const Fonts& fonts, Desk& desk, PanelState& state) {
  if (!desk.b()) state.controls_of_b = false;
  if (!desk.b()) return;
  auto button = [&](const char* label, bool of_b) {
    bool lit = state.controls_of_b == of_b;
    ImGui::PushStyleColor(ImGuiCol_Button, lit ? IM_COL32(70, 74, 82, 255) : IM_COL32(40, 43, 47, 255));
    ImGui::PushStyleColor(ImGuiCol_Text, of_b ? colours::kOther : colours::kAccent);
    float width = (ImGui::GetContentRegionAvail().x - (of_b ? 0 : 4)) / (of_b ? 1 : 2);
    if (ImGui::Button(label, ImVec2(width, 0))) state.controls_of_b = of_b;
    ImGui::PopStyleColor(2);
  };
  ImGui::PushFont(fonts.text);
  button(fmt::format("A  {}", desk.shot().pipeline).c_str(), false);
  ImGui::SameLine(0, 4);
  button(fmt::format("B  {}", desk.b()->session->shot().pipeline).c_str(), true);
  ImGui::PopFont();
}

}  // namespace

void drawControls(const Fonts& fonts, Desk& desk, PanelState& state) {
  state.pointed_control.clear();
  searchBox(state);
  sideChoice(fonts, desk, state);
  lab::Session& session = state.controls_of_b ? *desk.b()->session : *desk.a().session;
  std::vector<lab::Control> controls = session.controls();
  std::erase_if(controls, [&](const lab::Control& control) { return !isFound(control, state.search); });
  ImGui::BeginChild("controls");
  if (controls.empty()) textIn(fonts.text, colours::kDim, "no control has this text in its name or description");
  for (size_t i = 0; i < controls.size();) {
    const std::string& group = controls[i].group;
    size_t end = i;
    while (end < controls.size() && controls[end].group == group) ++end;
    bool of_b_shot = state.controls_of_b && group == "shot";
    bool open = group == "pipeline" || group == "shot" || !state.search.empty();
    if (!state.search.empty()) ImGui::SetNextItemOpen(true);
    ImGui::PushFont(fonts.bold);
    bool shown = ImGui::CollapsingHeader(group.c_str(), open ? ImGuiTreeNodeFlags_DefaultOpen : 0);
    ImGui::PopFont();
    if (of_b_shot && shown) textIn(fonts.small, colours::kDim, "same as A");
    if (shown && !of_b_shot && ImGui::BeginTable(group.c_str(), 4)) {
      float room = ImGui::GetContentRegionAvail().x;
      ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthFixed, std::min(118.0f, 0.4f * room));
      ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthStretch);
      ImGui::TableSetupColumn("sweep", ImGuiTableColumnFlags_WidthFixed, 22);
      ImGui::TableSetupColumn("reset", ImGuiTableColumnFlags_WidthFixed, 22);
      for (size_t k = i; k < end; ++k) drawControl(fonts, desk, state, controls[k]);
      ImGui::EndTable();
    }
    i = end;
  }
  ImGui::EndChild();
}

}  // namespace strobe::live
