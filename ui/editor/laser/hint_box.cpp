#include "ui/editor/laser/hint_box.h"

#include <imgui.h>

#include "core/base/assert.h"
#include "ui/editor/shared/picture/axes_gizmo.h"
#include "ui/window/landmarks.h"
#include "ui/window/theme.h"

namespace kerf {

namespace {

constexpr std::array kHints{
    "Hold the left button and drag to cut",
    "Middle drag to look round, wheel to come closer",
    "F1 shows all shortcuts",
};

std::array<Vec2, 4> corners_of(const Area& a) {
  return {a.at, a.at + Vec2(a.size.x, 0), a.at + Vec2(0, a.size.y), a.at + a.size};
}

// Whether two sets of points lie on different sides of a line across `axis`.
bool apart_along(const Vec2& axis, std::span<const Vec2> a, std::span<const Vec2> b) {
  const auto less = [&](const Vec2& p, const Vec2& q) { return glm::dot(axis, p) < glm::dot(axis, q); };
  const auto [low_a, high_a] = std::minmax_element(a.begin(), a.end(), less);
  const auto [low_b, high_b] = std::minmax_element(b.begin(), b.end(), less);
  return less(*high_a, *low_b) || less(*high_b, *low_a);
}

bool hides_axes(const ViewState& view, const Area& area) {
  const std::vector<AxisEnd> ends = axis_ends(view);
  return std::any_of(ends.begin(), ends.end(), [&](const AxisEnd& end) { return area.contains(end.at); });
}

Vec2 size_of_hints() {
  const double em = ImGui::GetFontSize(), line = ImGui::GetTextLineHeightWithSpacing();
  double widest = 0;
  for (const char* hint : kHints) widest = std::max<double>(widest, ImGui::CalcTextSize(hint).x);
  return {widest + 2 * em, static_cast<double>(kHints.size()) * line + em};
}

void draw_hints(const Area& box) {
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const float em = ImGui::GetFontSize();
  const auto left = static_cast<float>(box.at.x), top = static_cast<float>(box.at.y);
  const auto width = static_cast<float>(box.size.x), height = static_cast<float>(box.size.y);
  list.AddRectFilled({left, top}, {left + width, top + height}, colours::kPictureShade, 3);
  float y = top + 0.65f * em;
  for (size_t i = 0; i < kHints.size(); ++i) {
    const float x = left + 0.5f * (width - ImGui::CalcTextSize(kHints[i]).x);
    list.AddText({x, y}, i == 0 ? colours::kPictureText : colours::kPictureSecondary, kHints[i]);
    y += ImGui::GetTextLineHeightWithSpacing();
  }
}

}  // namespace

std::optional<std::array<Vec2, 8>> seen_corners(const World::Bounds& bounds, const CameraView& view,
                                                const Area& picture) {
  std::array<Vec2, 8> corners;
  for (unsigned i = 0; i < 8; ++i) {
    const Vec3 seen = view.project({(i & 1u) != 0 ? bounds.max.x : bounds.min.x,
                                    (i & 2u) != 0 ? bounds.max.y : bounds.min.y,
                                    (i & 4u) != 0 ? bounds.max.z : bounds.min.z});
    if (seen.z <= 0) return std::nullopt;
    corners[i] = picture.at + Vec2(0.5 + 0.5 * seen.x, 0.5 - 0.5 * seen.y) * picture.size;
  }
  return corners;
}

bool meets_hull(const Area& area, std::span<const Vec2> points) {
  KERF_ASSERT(!points.empty());
  const std::array<Vec2, 4> corners = corners_of(area);
  if (apart_along({1, 0}, corners, points) || apart_along({0, 1}, corners, points)) return false;
  for (const Vec2& p : points) {
    for (const Vec2& q : points) {
      if (p != q && apart_along({q.y - p.y, p.x - q.x}, corners, points)) return false;
    }
  }
  return true;
}

std::optional<Area> free_place(const Area& picture, Vec2 size, double margin,
                               const std::function<bool(const Area&)>& is_free) {
  const Vec2 room = picture.size - size - Vec2(2 * margin);
  if (room.x < 0 || room.y < 0) return std::nullopt;
  for (const double down : {1.0, 0.0}) {
    for (const double along : {0.5, 0.0, 1.0}) {
      const Area place{picture.at + Vec2(margin) + room * Vec2(along, down), size};
      if (is_free(place)) return place;
    }
  }
  return std::nullopt;
}

void draw_hint_box(const World& world, const ViewState& view, const Area& taken) {
  const Area& picture = view.layout.first;
  const auto corners = seen_corners(world.bounds(), view.seen_first(), picture);
  if (!corners) return;
  const auto is_free = [&](const Area& area) {
    return !meets_hull(area, *corners) && !meets_hull(area, corners_of(taken)) && !hides_axes(view, area);
  };
  const auto place = free_place(picture, size_of_hints(), 1.2 * ImGui::GetFontSize(), is_free);
  if (!place) return;
  draw_hints(*place);
  mark_area("hints", *place);
}

}  // namespace kerf
