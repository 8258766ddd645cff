#include "ui/game/hud_paint.h"

#include <algorithm>

#include "ui/window/number_text.h"
#include "ui/window/theme.h"

namespace kerf {

namespace {

// What a window has to hold, in the size of the text; in a smaller one the text is smaller.
constexpr float kLeastWide = 50, kLeastHigh = 32;

constexpr ImU32 kEdge = IM_COL32(8, 10, 13, 200);

}  // namespace

std::string clock_text(double seconds) {
  const int whole = static_cast<int>(std::max(0.0, seconds));
  return text_of("%d:%02d", whole / 60, whole % 60);
}

HudPaint::HudPaint() : list_(*ImGui::GetBackgroundDrawList()), size_(ImGui::GetIO().DisplaySize) {
  em_ = std::min({ImGui::GetFontSize(), size_.x / kLeastWide, size_.y / kLeastHigh});
}

ImU32 HudPaint::faded(ImU32 colour, double opacity) {
  const auto alpha =
      static_cast<ImU32>(std::clamp(opacity, 0.0, 1.0) * ((colour >> IM_COL32_A_SHIFT) & 0xff));
  return (colour & ~IM_COL32_A_MASK) | (alpha << IM_COL32_A_SHIFT);
}

float HudPaint::width_of(const std::string& text, float scale) const {
  return ImGui::GetFont()->CalcTextSizeA(em_ * scale, FLT_MAX, 0, text.c_str()).x;
}

void HudPaint::text(ImVec2 at, const std::string& text, ImU32 colour, float scale, Align align) const {
  if (align != Align::kLeft) at.x -= width_of(text, scale) * (align == Align::kMiddle ? 0.5f : 1.0f);
  const ImU32 edge = faded(kEdge, ((colour >> IM_COL32_A_SHIFT) & 0xff) / 255.0);
  const float off = std::max(1.0f, em_ * scale / 16);
  for (const ImVec2 by : {ImVec2(off, 0), ImVec2(-off, 0), ImVec2(0, off), ImVec2(0, -off)})
    list_.AddText(ImGui::GetFont(), em_ * scale, {at.x + by.x, at.y + by.y}, edge, text.c_str());
  list_.AddText(ImGui::GetFont(), em_ * scale, at, colour, text.c_str());
}

void HudPaint::bar(ImVec2 at, float width, const char* name, double share, ImU32 colour, bool striped) const {
  const float height = 0.55f * em_;
  text({at.x - 0.6f * em_, at.y - 0.3f * em_}, name, colours::kPictureText, 0.9f, Align::kRight);
  list_.AddRectFilled({at.x - 2, at.y - 2}, {at.x + width + 2, at.y + height + 2}, kEdge, 3);
  const float end = at.x + width * static_cast<float>(std::clamp(share, 0.0, 1.0));
  list_.AddRectFilled(at, {end, at.y + height}, colour, 2);
  for (float x = at.x; striped && x + height < end; x += 1.1f * height)
    list_.AddLine({x, at.y + height}, {x + height, at.y}, kEdge, 2);
}

void HudPaint::line(ImVec2 from, ImVec2 to, ImU32 colour, float width) const {
  list_.AddLine(from, to, kEdge, width + 2);
  list_.AddLine(from, to, colour, width);
}

void HudPaint::circle(ImVec2 at, float radius, ImU32 colour, float width) const {
  list_.AddCircle(at, radius, kEdge, 0, width + 2);
  list_.AddCircle(at, radius, colour, 0, width);
}

void HudPaint::shade(ImVec2 from, ImVec2 to) const {
  list_.AddRectFilled(from, to, colours::kPictureShade, 4);
}

}  // namespace kerf
