#include "ui/figures/marks.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "ui/window/theme.h"

namespace kerf {

namespace {

constexpr ImU32 kPaper = IM_COL32(255, 255, 255, 255), kInk = IM_COL32(0x1b, 0x1f, 0x26, 255);
constexpr ImU32 kRuler = IM_COL32(0xff, 0xff, 0xff, 255), kEdge = IM_COL32(0, 0, 0, 200);
constexpr float kMargin = 1.2f;  // em

ImVec2 on_picture(const CameraView& view, const Vec3& p) {
  const Vec3 seen = view.project(p);
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  return {size.x * static_cast<float>(0.5 + 0.5 * seen.x), size.y * static_cast<float>(0.5 - 0.5 * seen.y)};
}

// A line with an arrow head at each end. `along` is the unit vector from one to the other.
void draw_arrows(ImDrawList& list, ImVec2 from, ImVec2 to, ImVec2 along, ImU32 colour, float width) {
  const float head = 0.45f * ImGui::GetFontSize();
  list.AddLine(from, to, colour, width);
  for (const auto& [tip, sign] : {std::pair{from, 1.0f}, {to, -1.0f}}) {
    const ImVec2 base(tip.x + sign * head * along.x, tip.y + sign * head * along.y);
    const ImVec2 side(-0.4f * head * along.y, 0.4f * head * along.x);
    list.AddTriangleFilled(tip, {base.x + side.x, base.y + side.y}, {base.x - side.x, base.y - side.y},
                           colour);
    // The end of what is measured.
    const ImVec2 tick(-head * along.y, head * along.x);
    list.AddLine({tip.x - tick.x, tip.y - tick.y}, {tip.x + tick.x, tip.y + tick.y}, colour, width);
  }
}

void draw_text(ImDrawList& list, ImVec2 at, const std::string& text) {
  for (const auto& [x, y] : {std::pair{-1.0f, 0.0f}, {1.0f, 0.0f}, {0.0f, -1.0f}, {0.0f, 1.0f}})
    list.AddText({at.x + x, at.y + y}, kEdge, text.c_str());
  list.AddText(at, kRuler, text.c_str());
}

void draw_ruler(const Ruler& ruler, const CameraView& view) {
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const ImVec2 from = on_picture(view, ruler.from), to = on_picture(view, ruler.to);
  const float length = std::max(1e-3f, std::hypot(to.x - from.x, to.y - from.y));
  const ImVec2 along((to.x - from.x) / length, (to.y - from.y) / length);
  const float width = std::max(1.5f, 0.11f * ImGui::GetFontSize());
  draw_arrows(list, from, to, along, kEdge, width + 2);
  draw_arrows(list, from, to, along, kRuler, width);
  // The text stands over the middle of a line that lies and is longer, and else at the right.
  const ImVec2 size = ImGui::CalcTextSize(ruler.text.c_str());
  const ImVec2 middle(0.5f * (from.x + to.x), 0.5f * (from.y + to.y));
  const float gap = 0.5f * ImGui::GetFontSize();
  const bool over = std::abs(along.x) > std::abs(along.y) && length > size.x;
  const float right = std::max(from.x, to.x);
  draw_text(list,
            over ? ImVec2(middle.x - 0.5f * size.x, middle.y - size.y - gap)
                 : ImVec2(right + gap, middle.y - 0.5f * size.y),
            ruler.text);
}

}  // namespace

void draw_rulers(const std::vector<Ruler>& rulers, const CameraView& view) {
  for (const Ruler& ruler : rulers) draw_ruler(ruler, view);
}

void draw_caption_strip(const std::string& text) {
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const ImVec2 picture = ImGui::GetIO().DisplaySize;
  const float margin = kMargin * ImGui::GetFontSize(), width = picture.x - 2 * margin;
  const ImVec2 size = ImGui::CalcTextSize(text.c_str(), nullptr, false, width);
  list.AddRectFilled({0, 0}, picture, kPaper);
  list.AddText(ImGui::GetFont(), ImGui::GetFontSize(), {margin, 0.5f * (picture.y - size.y)}, kInk,
               text.c_str(), nullptr, width);
}

}  // namespace kerf
