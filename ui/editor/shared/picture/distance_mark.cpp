#include "ui/editor/shared/picture/distance_mark.h"

#include <imgui.h>

#include "ui/editor/shared/picture/first_picture.h"
#include "ui/window/imgui_vector.h"
#include "ui/window/theme.h"

namespace kerf {

namespace {

constexpr ImU32 kMeasureShade = IM_COL32(10, 12, 16, 190);

}  // namespace

void draw_measured_point(const ViewState& view, const Vec3& point, ImDrawList& list) {
  const auto at = FirstPicture(view).place_of(point);
  if (!at) return;
  list.AddCircleFilled(to_im(*at), 5, kMeasureShade);
  list.AddCircleFilled(to_im(*at), 3.2f, colours::accent());
}

void draw_distance(const ViewState& view, const Vec3& from, const Vec3& to, const std::string& text,
                   ImDrawList& list) {
  const FirstPicture picture(view);
  const auto begin = picture.place_of(from), end = picture.place_of(to);
  if (!begin || !end) return;
  list.AddLine(to_im(*begin), to_im(*end), kMeasureShade, 4);
  list.AddLine(to_im(*begin), to_im(*end), colours::accent(), 1.6f);
  draw_measured_point(view, from, list);
  draw_measured_point(view, to, list);
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  const float em = ImGui::GetFontSize();
  const Vec2 middle = 0.5 * (*begin + *end);
  const ImVec2 at(static_cast<float>(middle.x) - 0.5f * size.x, static_cast<float>(middle.y) - 1.8f * em);
  list.AddRectFilled({at.x - 0.5f * em, at.y - 0.25f * em}, {at.x + size.x + 0.5f * em, at.y + 1.3f * em},
                     IM_COL32(0x1b, 0x1f, 0x26, 230), 3);
  list.AddText(at, colours::kPictureText, text.c_str());
}

}  // namespace kerf
