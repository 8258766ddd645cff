#include "ui/editor/picture_marks.h"

#include <imgui.h>

#include "ui/editor/theme.h"

namespace kerf {

namespace {

constexpr std::array kHints{
    "Hold the left button and drag to cut",
    "Middle drag to look round, wheel to come closer",
    "F1 shows all shortcuts",
};
constexpr double kLeastRing = 3, kMostRing = 400;  // pixels

ImVec2 to_im(Vec2 p) { return {static_cast<float>(p.x), static_cast<float>(p.y)}; }

// As large as the cut would be where the pointer is.
void draw_ring(const EditorState& state, ImDrawList& list) {
  if (!state.pointer_over_picture && state.drag != Drag::kCut) return;
  if (state.left_button != Tool::kLaser && state.drag != Drag::kCut) return;
  if (state.drag != Drag::kNone && state.drag != Drag::kCut) return;
  const CameraView view = state.view();
  const Vec2 p = state.in_picture(state.pointer);
  const double distance = first_hit(state.document.world(), view.ray(p.x, p.y)).value_or(view.focus);
  const double pixels =
      state.laser.radius / (distance * view.tan_half_fov) * 0.5 * state.layout.viewport.size.y;
  const auto ring = static_cast<float>(std::clamp(pixels, kLeastRing, kMostRing));
  const ImVec2 at = to_im(state.pointer);
  list.AddCircle(at, ring + 1.5f, IM_COL32(10, 12, 16, 150), 0, 3.0f);
  list.AddCircle(at, ring + 1.5f, state.drag == Drag::kCut ? colours::accent() : colours::kPictureText, 0,
                 1.3f);
}

void draw_hints(const EditorState& state, ImDrawList& list) {
  if (state.cut_once) return;
  const float line = ImGui::GetTextLineHeightWithSpacing(), em = ImGui::GetFontSize();
  float widest = 0;
  for (const char* hint : kHints) widest = std::max(widest, ImGui::CalcTextSize(hint).x);
  const Area& area = state.layout.viewport;
  const float middle = static_cast<float>(area.at.x + 0.5 * area.size.x);
  const float bottom = static_cast<float>(area.at.y + area.size.y) - 1.6f * em;
  const float top = bottom - line * kHints.size();
  list.AddRectFilled({middle - 0.5f * widest - em, top - 0.6f * em},
                     {middle + 0.5f * widest + em, bottom + 0.4f * em}, colours::kPictureShade, 3);
  for (size_t i = 0; i < kHints.size(); ++i) {
    const float width = ImGui::CalcTextSize(kHints[i]).x;
    list.AddText({middle - 0.5f * width, top + static_cast<float>(i) * line},
                 i == 0 ? colours::kPictureText : colours::kPictureSecondary, kHints[i]);
  }
}

}  // namespace

void draw_picture_marks(const EditorState& state) {
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const Area& area = state.layout.viewport;
  list.PushClipRect(to_im(area.at), to_im(area.at + area.size));
  draw_ring(state, list);
  draw_hints(state, list);
  list.PopClipRect();
}

}  // namespace kerf
