// SPDX-License-Identifier: MIT
#include "live/picture_view.h"

#include <algorithm>
#include <cmath>

namespace strobe::live {

static const double kClick = 4;         // a press that moves less is a click, pixels
static const double kNumbersFrom = 46;  // least texel size for three legible numbers, window pixels
static const double kWipeGrip = 7;      // distance at which a press grabs the wipe's line, pixels

static ImVec2 toIm(const dvec2& at) { return ImVec2(float(at.x), float(at.y)); }
static dvec2 fromIm(const ImVec2& at) { return {at.x, at.y}; }

static bool inside(const WindowArea& area, const dvec2& at) {
  return at.x >= area.x && at.y >= area.y && at.x < area.x + area.width && at.y < area.y + area.height;
}

static bool wipes(const Desk& desk) {
  Mode mode = desk.look().mode;
  return desk.b() && (mode == Mode::Wipe || mode == Mode::Error);
}

static std::string valueText(const PixelValue& value, const char* between) {
  std::string text;
  for (double number : value.values)
    text += (text.empty() ? "" : between) +
            (value.integers ? fmt::format("{:.0f}", number) : fmt::format("{:.4g}", number));
  return text;
}

void PictureView::draw(const Fonts& fonts, Desk& desk, const PanelState& state, const WindowArea& area,
                       const PanelTexture& picture) {
  width_ = picture.width();
  height_ = picture.height();
  placement_ = placed(area, width_, height_, state.magnification);
  ImDrawList* list = ImGui::GetBackgroundDrawList();
  ImVec2 low(float(area.x), float(area.y)), high(float(area.x + area.width), float(area.y + area.height));
  list->AddRectFilled(low, high, colours::kBackground);
  list->PushClipRect(low, high);
  list->AddImage(picture.id(), toIm(placement_.toWindow({0, 0})), toIm(placement_.toWindow({width_, height_})));
  if (placement_.scale >= kNumbersFrom) drawNumbers(fonts, desk, state, area);
  drawLegends(fonts, area);
  if (wipes(desk)) drawWipe(fonts, desk, area);
  if (desk.pixel().at()) {
    dvec2 at(desk.pixel().at()->first, desk.pixel().at()->second);
    dvec2 corner = placement_.toWindow(at), opposite = placement_.toWindow(at + dvec2(1));
    list->AddRect(toIm(corner - dvec2(4)), toIm(opposite + dvec2(4)), IM_COL32(0, 0, 0, 200), 2, 0, 4);
    list->AddRect(toIm(corner - dvec2(4)), toIm(opposite + dvec2(4)), colours::kAccent, 2, 0, 2);
  }
  list->PopClipRect();
  bool free = !ImGui::GetIO().WantCaptureMouse && inside(area, fromIm(ImGui::GetIO().MousePos)) && grip_ == Grip::None;
  if (free) drawPointed(fonts, desk, state);
}

void PictureView::prepare(Surface& surface, const Desk& desk) {
  for (size_t i = 0; i < legends_.size(); ++i) {
    if (legends_[i] == desk.legends()[i]) continue;
    legends_[i] = desk.legends()[i];
    image::Image picture = image::pictureOf(legends_[i]);
    if (picture.empty()) legend_pictures_[i].reset();
    else surface.upload(legend_pictures_[i], "legend", picture, false);
  }
}

// Draws legends unscaled: below the picture if there is room, otherwise over its lower corners. A's legend is at the
// left corner if B has a different one; every other legend is at the right corner.
void PictureView::drawLegends(const Fonts& fonts, const WindowArea& area) const {
  constexpr double kGap = 8;
  const bool two = legend_pictures_[1] != nullptr;
  dvec2 low = placement_.toWindow({0, 0}), high = placement_.toWindow({width_, height_});
  low.x = std::max(low.x, area.x), high.x = std::min(high.x, area.x + area.width);
  for (size_t i = 0; i < legend_pictures_.size(); ++i) {
    if (!legend_pictures_[i]) continue;
    const PanelTexture& picture = *legend_pictures_[i];
    bool below = high.y + kGap + picture.height() <= area.y + area.height;
    double bottom = std::min(high.y, area.y + area.height);
    dvec2 at(two && i == 0 ? low.x + kGap : high.x - kGap - picture.width(),
             below ? high.y + kGap : bottom - kGap - picture.height());
    at = glm::floor(at);
    ImDrawList* list = ImGui::GetBackgroundDrawList();
    list->AddImage(picture.id(), toIm(at), toIm(at + dvec2(picture.width(), picture.height())));
    dvec2 letter(two && i == 0 ? at.x + picture.width() + 5 : at.x - 15, at.y + picture.height() / 2.0 - 8);
    if (two)
      list->AddText(fonts.bold, fonts.bold->FontSize, toIm(letter), i ? colours::kOther : colours::kAccent,
                    i ? "B" : "A");
  }
}

void PictureView::drawWipe(const Fonts& fonts, const Desk& desk, const WindowArea& area) const {
  ImDrawList* list = ImGui::GetBackgroundDrawList();
  double x = placement_.toWindow({desk.look().wipe * width_, 0}).x;
  double top = std::max(area.y, placement_.origin.y);
  // A side without the chosen image shows another image. The label names that image.
  auto label = [&](const Side& side, const char* letter, ImU32 color, bool left) {
    bool named = !desk.look().isOfColour() && side.drawn_port != desk.look().port;
    std::string name = named ? fmt::format("{}  {}", letter, side.drawn_port) : letter;
    float width = fonts.bold->CalcTextSizeA(fonts.bold->FontSize, FLT_MAX, 0, name.c_str()).x;
    float at = float(x) + (left ? -16 - width : 16);
    list->AddRectFilled(ImVec2(at - 6, float(top + 8)), ImVec2(at + width + 6, float(top + 28)),
                        IM_COL32(10, 10, 12, 190), 3);
    list->AddText(fonts.bold, fonts.bold->FontSize, ImVec2(at, float(top + 11)), color, name.c_str());
  };
  label(desk.sides().a(), "A", colours::kAccent, true);
  label(*desk.b(), "B", colours::kOther, false);
  double middle = std::clamp(placement_.toWindow({0, height_ / 2.0}).y, area.y, area.y + area.height);
  list->AddCircleFilled(ImVec2(float(x), float(middle)), 7, IM_COL32(255, 255, 255, 230));
  list->AddCircle(ImVec2(float(x), float(middle)), 7, IM_COL32(0, 0, 0, 160));
}

// Writes the values of each texel on the texel.
void PictureView::drawNumbers(const Fonts& fonts, const Desk& desk, const PanelState& state,
                              const WindowArea& area) const {
  ImDrawList* list = ImGui::GetBackgroundDrawList();
  dvec2 first = glm::floor(placement_.toPicture({area.x, area.y})),
        last = placement_.toPicture({area.x + area.width, area.y + area.height});
  for (int y = std::max(0, int(first.y)); y < std::min(height_, int(last.y) + 1); ++y)
    for (int x = std::max(0, int(first.x)); x < std::min(width_, int(last.x) + 1); ++x) {
      std::vector<PixelValue> values = desk.valuesAt(x, y, state.window_frame);
      if (values.empty()) continue;
      std::string text = valueText(values.front(), "\n");
      dvec2 at = placement_.toWindow(dvec2(x, y)) + dvec2(4, 3);
      list->AddText(fonts.small, 12, toIm(at + dvec2(1)), IM_COL32(0, 0, 0, 255), text.c_str());
      list->AddText(fonts.small, 12, toIm(at), IM_COL32(255, 255, 255, 255), text.c_str());
    }
}

void PictureView::drawPointed(const Fonts& fonts, const Desk& desk, const PanelState& state) const {
  dvec2 pixel = glm::floor(placement_.toPicture(fromIm(ImGui::GetIO().MousePos)));
  std::vector<PixelValue> values = desk.valuesAt(int(pixel.x), int(pixel.y), state.window_frame);
  if (values.empty()) return;
  ImGui::BeginTooltip();
  ImGui::PushFont(fonts.small);
  ImGui::TextDisabled("%d, %d", int(pixel.x), int(pixel.y));
  ImGui::PopFont();
  for (const PixelValue& value : values) {
    if (desk.b() && value.side != ' ') {
      textIn(fonts.bold, value.side == 'A' ? colours::kAccent : colours::kOther, std::string(1, value.side), -FLT_MAX);
      ImGui::SameLine();
    }
    textIn(fonts.small, colours::kDim, value.port + (value.format.empty() ? "" : "   " + value.format), -FLT_MAX);
    textIn(fonts.mono, colours::kText, valueText(value, "  "), -FLT_MAX);
  }
  ImGui::EndTooltip();
}

PictureView::Grip PictureView::gripAt(const Desk& desk, bool right, bool control, bool shift) const {
  double line = placement_.toWindow({desk.look().wipe * width_, 0}).x;
  bool on_line = std::abs(ImGui::GetIO().MousePos.x - line) < kWipeGrip;
  if (right) return Grip::Look;
  if (control) return Grip::Picture;
  if (shift) return Grip::Pan;
  return wipes(desk) && on_line ? Grip::Wipe : Grip::Orbit;
}

void PictureView::grip(Desk& desk, Grip grip) {
  grip_ = grip;
  dragged_ = 0;
  if (grip_ == Grip::Orbit) pivot_ = desk.sides().pivotAt(placement_.toPicture(fromIm(ImGui::GetIO().MousePos)));
}

void PictureView::drag(Desk& desk, PanelState& state, const WindowArea& area, const dvec2& by) {
  dragged_ += glm::length(by);
  if (by == dvec2(0) || dragged_ < kClick) return;
  if (grip_ == Grip::Wipe)
    desk.look().wipe = std::clamp(placement_.toPicture(fromIm(ImGui::GetIO().MousePos)).x / width_, 0.0, 1.0);
  if (grip_ == Grip::Picture) state.magnification = dragged(state.magnification, by, area, width_, height_);
  dvec2 turn = by * kRadiansPerPixel;
  double shown_height = height_ * placement_.scale;
  attempt(state, [&] {
    if (grip_ == Grip::Orbit) desk.sides().setViewpoint(orbited(desk.sides().viewpoint(), pivot_, -turn.x, turn.y));
    if (grip_ == Grip::Look) desk.sides().setViewpoint(turned(desk.sides().viewpoint(), turn.x, -turn.y));
    if (grip_ == Grip::Pan)
      desk.sides().setViewpoint(panned(desk.sides().viewpoint(), by.x, by.y, shown_height, desk.sides().verticalFov()));
  });
}

void PictureView::fly(Desk& desk, PanelState& state, const InputQueue& input, double seconds) {
  dvec3 by(0);
  for (const HeldKey& key : heldKeys())
    if (input.isHeld(key.code)) by += dvec3(key.right, key.up, key.ahead);
  if (by == dvec3(0)) return;
  attempt(state, [&] {
    Viewpoint view = desk.sides().viewpoint();
    double speed = glm::length(view.target - view.eye) * (ImGui::GetIO().KeyShift ? 4 : 1);
    desk.sides().setViewpoint(flown(view, by * speed * seconds));
  });
}

void PictureView::interact(Desk& desk, PanelState& state, const WindowArea& area, const InputQueue& input) {
  ImGuiIO& io = ImGui::GetIO();
  dvec2 pointer = fromIm(io.MousePos);
  bool over = !io.WantCaptureMouse && inside(area, pointer);
  bool left = ImGui::IsMouseClicked(ImGuiMouseButton_Left), right = ImGui::IsMouseClicked(ImGuiMouseButton_Right);
  if (over && (left || right)) {
    grip(desk, gripAt(desk, right, io.KeyCtrl, io.KeyShift));
  }
  if (grip_ != Grip::None) drag(desk, state, area, fromIm(io.MouseDelta));
  bool released =
      grip_ != Grip::None && !ImGui::IsMouseDown(ImGuiMouseButton_Left) && !ImGui::IsMouseDown(ImGuiMouseButton_Right);
  if (released && dragged_ < kClick && grip_ != Grip::Look) {
    dvec2 pixel = glm::floor(placement_.toPicture(pointer));
    bool in_picture = pixel.x >= 0 && pixel.y >= 0 && pixel.x < width_ && pixel.y < height_;
    if (in_picture) attempt(state, [&] { desk.pin(int(pixel.x), int(pixel.y)); });
  }
  if (released) grip_ = Grip::None;

  if (over && io.MouseWheel != 0 && io.KeyCtrl)
    state.magnification = magnified(state.magnification, std::pow(1.2, io.MouseWheel), pointer, area, width_, height_);
  else if (over && io.MouseWheel != 0)
    attempt(state, [&] { desk.sides().setViewpoint(dollied(desk.sides().viewpoint(), std::pow(0.9, io.MouseWheel))); });
  if (!io.WantCaptureKeyboard && !io.WantTextInput) fly(desk, state, input, std::min(0.1, double(io.DeltaTime)));
}

}  // namespace strobe::live
