// SPDX-License-Identifier: MIT
// Style of the window: fonts, colours, and shapes that panels share.
#pragma once

#include <imgui.h>

#include <string>

namespace strobe::live {

// Fonts of the user interface: text, small, bold and monospaced. ImGui owns the fonts.
struct Fonts {
  ImFont* text = nullptr;
  ImFont* small = nullptr;
  ImFont* bold = nullptr;
  ImFont* mono = nullptr;
};

namespace colours {
constexpr ImU32 kBackground = IM_COL32(20, 21, 23, 255);  // background of the picture
constexpr ImU32 kPanel = IM_COL32(29, 31, 34, 255);
constexpr ImU32 kLine = IM_COL32(48, 51, 56, 255);
constexpr ImU32 kText = IM_COL32(222, 224, 228, 255);
constexpr ImU32 kDim = IM_COL32(138, 143, 152, 255);
constexpr ImU32 kAccent = IM_COL32(240, 170, 80, 255);  // value set by hand; side A
constexpr ImU32 kOther = IM_COL32(104, 178, 230, 255);  // value from another origin; side B
constexpr ImU32 kBad = IM_COL32(240, 104, 96, 255);
}  // namespace colours

// Sets ImGui's fonts and style. Throws `Error` if the font is not installed.
Fonts applyStyle();

// Text in a font and colour. Cut with "..." at the right end of the region, less `margin` pixels.
void textIn(ImFont* font, ImU32 color, const std::string& text, float margin = 0);

// Whole text, wrapped at `width` pixels (0: the region's width).
void wrappedIn(ImFont* font, ImU32 color, const std::string& text, float width = 0);

// Heading of a part of a panel, with a line below.
void heading(const Fonts& fonts, const char* text);

// Tooltip of the last item, wrapped.
void tooltip(const std::string& text);

// Tooltip of the last item, above the item, so that the rows below stay visible.
void tooltipAbove(const std::string& text);

// Slider without ImGui's grab, which would cover the value.
bool slider(const char* id, ImGuiDataType type, void* value, const void* low, const void* high, const char* format,
            ImGuiSliderFlags flags);

// Small button without a frame.
bool quietButton(const char* label, const std::string& explanation, bool lit = false);

}  // namespace strobe::live
