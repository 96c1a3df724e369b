// SPDX-License-Identifier: MIT
#include "live/style.h"

#include "image/canvas.h"

namespace strobe::live {

namespace {

ImFont* loadFont(const char* file, float size_px) {
  // Western letters, Greek, punctuation, arrows, mathematics, and the shapes on buttons.
  static const ImWchar ranges[] = {0x20,   0x17f,  0x370,  0x3ff,  0x2010, 0x2044, 0x2190, 0x21ff,
                                   0x2200, 0x22ff, 0x25a0, 0x25ff, 0x2758, 0x275a, 0};
  Path path = image::fontFile().parent_path() / file;
  if (!std::filesystem::is_regular_file(path)) path = image::fontFile();
  ImFontConfig config;
  config.OversampleH = 2;
  config.PixelSnapH = true;
  return ImGui::GetIO().Fonts->AddFontFromFileTTF(path.c_str(), size_px, &config, ranges);
}

ImVec4 mixed(ImU32 color, float alpha) {
  ImVec4 value = ImGui::ColorConvertU32ToFloat4(color);
  value.w = alpha;
  return value;
}

void applyColours(ImGuiStyle& style) {
  ImGui::StyleColorsDark(&style);
  ImVec4* c = style.Colors;
  c[ImGuiCol_Text] = mixed(colours::kText, 1);
  c[ImGuiCol_TextDisabled] = mixed(colours::kDim, 1);
  c[ImGuiCol_WindowBg] = c[ImGuiCol_ChildBg] = mixed(colours::kPanel, 1);
  c[ImGuiCol_PopupBg] = ImVec4(0.16f, 0.17f, 0.185f, 0.99f);
  c[ImGuiCol_Border] = mixed(colours::kLine, 1);
  c[ImGuiCol_FrameBg] = ImVec4(0.165f, 0.175f, 0.19f, 1);
  c[ImGuiCol_FrameBgHovered] = ImVec4(0.21f, 0.22f, 0.24f, 1);
  c[ImGuiCol_FrameBgActive] = ImVec4(0.24f, 0.25f, 0.275f, 1);
  c[ImGuiCol_SliderGrab] = ImVec4(0.55f, 0.60f, 0.68f, 0.75f);
  c[ImGuiCol_SliderGrabActive] = mixed(colours::kAccent, 0.85f);
  c[ImGuiCol_CheckMark] = mixed(colours::kAccent, 1);
  c[ImGuiCol_Button] = ImVec4(0.19f, 0.20f, 0.22f, 1);
  c[ImGuiCol_ButtonHovered] = ImVec4(0.25f, 0.265f, 0.29f, 1);
  c[ImGuiCol_ButtonActive] = mixed(colours::kAccent, 0.55f);
  c[ImGuiCol_Header] = ImVec4(0.185f, 0.195f, 0.215f, 1);
  c[ImGuiCol_HeaderHovered] = ImVec4(0.23f, 0.245f, 0.27f, 1);
  c[ImGuiCol_HeaderActive] = ImVec4(0.27f, 0.285f, 0.31f, 1);
  c[ImGuiCol_Separator] = mixed(colours::kLine, 1);
  c[ImGuiCol_ScrollbarBg] = ImVec4(0, 0, 0, 0);
  c[ImGuiCol_ScrollbarGrab] = ImVec4(0.24f, 0.25f, 0.27f, 1);
  c[ImGuiCol_TextSelectedBg] = mixed(colours::kAccent, 0.35f);
  c[ImGuiCol_TableHeaderBg] = ImVec4(0.15f, 0.16f, 0.175f, 1);
  c[ImGuiCol_TableBorderLight] = c[ImGuiCol_TableBorderStrong] = mixed(colours::kLine, 1);
  c[ImGuiCol_TableRowBgAlt] = ImVec4(1, 1, 1, 0.025f);
  c[ImGuiCol_NavHighlight] = ImVec4(0, 0, 0, 0);
}

}  // namespace

Fonts applyStyle() {
  ImGuiStyle& style = ImGui::GetStyle();
  applyColours(style);
  style.WindowRounding = style.ChildRounding = 0;
  style.FrameRounding = style.GrabRounding = style.PopupRounding = 3;
  style.WindowBorderSize = style.ChildBorderSize = 0;
  style.PopupBorderSize = 1;
  style.WindowPadding = ImVec2(12, 10);
  style.FramePadding = ImVec2(7, 3);
  style.ItemSpacing = ImVec2(8, 5);
  style.ItemInnerSpacing = ImVec2(6, 4);
  style.ScrollbarSize = 10;
  style.ScrollbarRounding = 5;
  style.GrabMinSize = 6;
  style.IndentSpacing = 10;
  Fonts fonts;
  fonts.text = loadFont("DejaVuSans.ttf", 14);
  fonts.small = loadFont("DejaVuSans.ttf", 12);
  fonts.bold = loadFont("DejaVuSans-Bold.ttf", 14);
  fonts.mono = loadFont("DejaVuSansMono.ttf", 13);
  return fonts;
}

void textIn(ImFont* font, ImU32 color, const std::string& text, float margin) {
  ImGui::PushFont(font);
  ImGui::PushStyleColor(ImGuiCol_Text, color);
  std::string shown = text;
  float room = ImGui::GetContentRegionAvail().x - margin;
  if (ImGui::CalcTextSize(shown.c_str()).x > room) {
    while (!shown.empty() && ImGui::CalcTextSize((shown + "...").c_str()).x > room) shown.pop_back();
    shown += "...";
  }
  ImGui::TextUnformatted(shown.c_str());
  ImGui::PopStyleColor();
  ImGui::PopFont();
}

void wrappedIn(ImFont* font, ImU32 color, const std::string& text, float width) {
  ImGui::PushFont(font);
  ImGui::PushStyleColor(ImGuiCol_Text, color);
  ImGui::PushTextWrapPos(width);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
  ImGui::PopFont();
}

void heading(const Fonts& fonts, const char* text) {
  ImGui::Dummy(ImVec2(0, 4));
  textIn(fonts.bold, colours::kText, text);
  ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::GetWindowDrawList()->AddLine(ImVec2(at.x, at.y - 2), ImVec2(at.x + ImGui::GetContentRegionAvail().x, at.y - 2),
                                      colours::kLine);
  ImGui::Dummy(ImVec2(0, 1));
}

void tooltip(const std::string& text) {
  if (text.empty() || !ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(ImGui::GetFontSize() * 28);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

void tooltipAbove(const std::string& text) {
  if (text.empty() || !ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
  float right = ImGui::GetWindowPos().x + ImGui::GetWindowWidth() - 8;
  ImGui::SetNextWindowPos(ImVec2(right, ImGui::GetItemRectMin().y - 4), ImGuiCond_Always, ImVec2(1, 1));
  tooltip(text);
}

bool slider(const char* id, ImGuiDataType type, void* value, const void* low, const void* high, const char* format,
            ImGuiSliderFlags flags) {
  ImGui::PushStyleColor(ImGuiCol_SliderGrab, 0);
  ImGui::PushStyleColor(ImGuiCol_SliderGrabActive, 0);
  bool changed = ImGui::SliderScalar(id, type, value, low, high, format, flags);
  ImGui::PopStyleColor(2);
  return changed;
}

bool quietButton(const char* label, const std::string& explanation, bool lit) {
  ImGui::PushStyleColor(ImGuiCol_Button, ImVec4(0, 0, 0, 0));
  ImGui::PushStyleColor(ImGuiCol_Text, lit ? colours::kAccent : colours::kText);
  bool pressed = ImGui::Button(label);
  ImGui::PopStyleColor(2);
  tooltip(explanation);
  return pressed;
}

}  // namespace strobe::live
