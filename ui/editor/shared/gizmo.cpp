#include "ui/editor/shared/gizmo.h"

#include <imgui.h>
#include <algorithm>

#include "core/base/assert.h"
#include "core/base/deterministic_math.h"
#include "core/base/geometry.h"
#include "ui/window/theme.h"
#include "ui/window/widgets.h"

namespace kerf {

namespace {

// Returns the position along a line of its point nearest to a ray; see dragged_along().
std::optional<double> along_axis(const Pose& ray, const Vec3& at, const Vec3& axis) {
  KERF_ASSERT(is_unit(axis));
  constexpr double kMinSine2 = 1e-3;  // the square of the sine of the angle between the two
  const double cosine = glm::dot(axis, ray.direction), sine2 = 1 - cosine * cosine;
  if (sine2 < kMinSine2) return std::nullopt;
  const Vec3 from = ray.origin - at;
  return (glm::dot(from, axis) - cosine * glm::dot(from, ray.direction)) / sine2;
}

// Sizes of the text.
constexpr double kRadius = 2.6;  // from the middle to the end of an axis
constexpr double kEnd = 0.62;    // of the disc at a positive end
constexpr double kOppositeEnd = 0.45;
constexpr double kMargin = 0.9;     // around the gizmo
constexpr double kMinPicture = 14;  // minimum width and height of the viewport

double whole_radius(const ViewState& view) { return (kRadius + kEnd + 0.25) * view.layout.em; }

bool has_room(const ViewState& view) {
  return std::min(view.layout.first.size.x, view.layout.first.size.y) >= kMinPicture * view.layout.em;
}

Vec2 middle_of(const ViewState& view) {
  const Area& area = view.layout.first;
  const double inset = whole_radius(view) + kMargin * view.layout.em;
  return area.at + Vec2(area.size.x - inset, inset);
}

double reach_of(const AxisEnd& end, double em) { return (end.positive ? kEnd : kOppositeEnd) * em; }

ImU32 faded(ImU32 colour, double opacity) {
  ImVec4 c = ImGui::ColorConvertU32ToFloat4(colour);
  c.w *= static_cast<float>(opacity);
  return ImGui::ColorConvertFloat4ToU32(c);
}

void draw_letter(const AxisEnd& end, ImU32 colour, ImDrawList& list) {
  const std::string letter(1, static_cast<char>('X' + end.axis));
  const ImVec2 size = ImGui::CalcTextSize(letter.c_str());
  const ImVec2 at = to_im(end.at);
  list.AddText({at.x - 0.5f * size.x, at.y - 0.5f * size.y}, colour, letter.c_str());
}

void draw_end(const AxisEnd& end, Vec2 middle, double em, bool pointed_at, ImDrawList& list) {
  const auto reach = static_cast<float>(reach_of(end, em));
  const double opacity = pointed_at ? 1 : 0.72 - 0.22 * end.depth;
  const ImU32 colour = faded(colours::kAxes.at(static_cast<size_t>(end.axis)), opacity);
  if (end.positive) list.AddLine(to_im(middle), to_im(end.at), colour, 2);
  if (end.positive) {
    list.AddCircleFilled(to_im(end.at), reach, colour);
  } else {
    list.AddCircleFilled(to_im(end.at), reach, colours::shade());
    list.AddCircle(to_im(end.at), reach, colour, 0, 1.5f);
  }
  if (pointed_at) list.AddCircle(to_im(end.at), reach + 1.5f, colours::text(), 0, 1.5f);
  if (end.positive || pointed_at)
    draw_letter(end, end.positive ? IM_COL32(14, 17, 21, 255) : colours::text(), list);
}

// "Top, orthographic"; empty in a perspective view along no axis.
std::string kind_of_view(const ViewState& view) {
  const auto standard = standard_view_of(view.camera);
  std::string text = standard ? standard->name : "";
  if (view.camera.parallel()) text += text.empty() ? "Orthographic" : ", orthographic";
  return text;
}

constexpr ImU32 kMeasureShade = IM_COL32(10, 12, 16, 190);

}  // namespace

GizmoHandle::GizmoHandle(const PrimaryViewport& picture, std::string its_name, std::vector<Vec3> its_points,
                         size_t its_grip)
    : name(std::move(its_name)), points(std::move(its_points)), grip(its_grip) {
  KERF_ASSERT(grip < points.size());
  for (const Vec3& p : points) {
    if (const auto at = picture.place_of(p)) places.push_back(*at);
  }
  if (places.size() < points.size()) places.clear();
}

std::vector<Vec3> gizmo_arrow(const PrimaryViewport& picture, const Vec3& from, const Vec3& direction,
                              double ems) {
  return {from, from + direction * (ems * picture.metres_of_em(from))};
}

// The front half is one run of points, which begins where the ring is in front of its middle.
std::vector<Vec3> gizmo_ring(const PrimaryViewport& picture, const Vec3& middle, const Vec3& u, const Vec3& v,
                             double ems) {
  const double radius = ems * picture.metres_of_em(middle);
  const Vec3 towards = picture.camera().eye - middle;
  const double front = std::atan2(glm::dot(v, towards), glm::dot(u, towards));
  std::vector<Vec3> points;
  for (size_t k = 0; k < kGizmoRing; ++k) {
    const double angle = front + kPi * (static_cast<double>(k) / (kGizmoRing - 1) - 0.5);
    points.push_back(middle + (u * std::cos(angle) + v * std::sin(angle)) * radius);
  }
  return points;
}

GizmoPoint nearest_point(const GizmoHandle& handle, Vec2 at) {
  const std::vector<Vec2>& places = handle.places;
  GizmoPoint nearest;
  if (places.empty()) return nearest;
  const double length = glm::length(places.back() - places.front());
  if (glm::length(at - places.front()) < handle.free_share * length) return nearest;
  for (size_t i = 0; i < places.size(); ++i) {
    const size_t next = std::min(i + 1, places.size() - 1);
    const Vec2 along = places[next] - places[i];
    const double length2 = glm::dot(along, along);
    const double t = length2 > 0 ? std::clamp(glm::dot(at - places[i], along) / length2, 0.0, 1.0) : 0;
    const double distance = glm::length(at - (places[i] + along * t));
    if (distance >= nearest.distance) continue;
    nearest = {distance, handle.points[i] + (handle.points[next] - handle.points[i]) * t};
  }
  return nearest;
}

Vec3 dragged_around(const PrimaryViewport& picture, const Vec3& pivot, double distance, const Vec3& now,
                    Vec2 place) {
  KERF_ASSERT(distance > 0);
  const Pose ray = picture.ray(place);
  const bool away = glm::dot(now - pivot, ray.direction) > 0;
  const Vec3 from = ray.origin - pivot;
  const Vec3 nearest = from - ray.direction * glm::dot(from, ray.direction);
  const double inside = distance * distance - glm::dot(nearest, nearest);
  if (inside <= 0) return pivot + glm::normalize(nearest) * distance;
  return pivot + nearest + ray.direction * ((away ? 1.0 : -1.0) * std::sqrt(inside));
}

double dragged_along(const Pose& from, const Pose& to, const Vec3& at, const Vec3& axis) {
  const auto begin = along_axis(from, at, axis), end = along_axis(to, at, axis);
  return begin && end ? *end - *begin : 0;
}

void draw_handle(const GizmoHandle& handle, double em, uint32_t colour, ImDrawList& list) {
  constexpr ImU32 kRim = IM_COL32(10, 12, 16, 150);
  if (handle.places.empty()) return;
  std::vector<ImVec2> points;
  for (const Vec2& p : handle.places) points.push_back(to_im(p));
  const auto count = static_cast<int>(points.size());
  const bool is_arrow = count == 2;
  list.AddPolyline(points.data(), count, kRim, 0, is_arrow ? 5.0f : 4.0f);
  list.AddPolyline(points.data(), count, colour, 0, is_arrow ? 2.6f : 1.8f);
  if (!is_arrow) return;
  const Vec2 way = handle.places[1] - handle.places[0];
  if (glm::length(way) < 0.5 * em)
    return list.AddCircleFilled(points[1], static_cast<float>(0.3 * em), colour);
  const Vec2 along = glm::normalize(way) * (0.85 * em), across(-0.35 * along.y, 0.35 * along.x);
  const Vec2 tip = handle.places[1] + 0.5 * along;
  list.AddTriangleFilled(to_im(tip), to_im(tip - along + across), to_im(tip - along - across), colour);
}

std::vector<AxisEnd> axis_ends(const ViewState& view) {
  std::vector<AxisEnd> ends;
  if (!has_room(view)) return ends;
  const CameraView camera = view.seen_first();
  const Vec2 middle = middle_of(view);
  for (const StandardView& standard : kStandardViews) {
    const Vec3 way = from_y_up(Camera::direction_of(standard.yaw, standard.pitch), camera.up_axis);
    AxisEnd end{standard};
    for (int i = 1; i < 3; ++i) {
      if (std::abs(way[i]) > std::abs(way[end.axis])) end.axis = i;
    }
    end.positive = way[end.axis] > 0;
    end.depth = glm::dot(way, camera.forward);
    const Vec2 seen(glm::dot(way, camera.right), -glm::dot(way, camera.up));
    end.at = middle + seen * (kRadius * view.layout.em);
    ends.push_back(end);
  }
  std::stable_sort(ends.begin(), ends.end(),
                   [](const AxisEnd& a, const AxisEnd& b) { return a.depth > b.depth; });
  return ends;
}

bool is_on_axes(const ViewState& view, Vec2 at) {
  return has_room(view) && glm::length(at - middle_of(view)) < whole_radius(view);
}

std::optional<AxisEnd> axis_end_under(const ViewState& view, Vec2 at) {
  std::optional<AxisEnd> found;
  for (const AxisEnd& end : axis_ends(view)) {
    if (glm::length(end.at - at) < reach_of(end, view.layout.em) + 2) found = end;
  }
  return found;
}

std::string name_of(const AxisEnd& end) {
  return std::string("axis ") + (end.positive ? "" : "-") + static_cast<char>('X' + end.axis);
}

void draw_axes_gizmo(const ViewState& view, Vec2 pointer, ImDrawList& list) {
  if (!has_room(view)) return;
  const Vec2 middle = middle_of(view);
  const double em = view.layout.em;
  if (is_on_axes(view, pointer))
    list.AddCircleFilled(to_im(middle), static_cast<float>(whole_radius(view)), colours::shade());
  const std::optional<AxisEnd> under = axis_end_under(view, pointer);
  for (const AxisEnd& end : axis_ends(view)) {
    const bool pointed_at = under && under->axis == end.axis && under->positive == end.positive;
    draw_end(end, middle, em, pointed_at, list);
  }
  const std::string kind = kind_of_view(view);
  const ImVec2 size = ImGui::CalcTextSize(kind.c_str());
  const Area& area = view.layout.first;
  const auto right = static_cast<float>(area.at.x + area.size.x - kMargin * em);
  const auto x = std::min(static_cast<float>(middle.x) - 0.5f * size.x, right - size.x);
  const auto y = static_cast<float>(middle.y + whole_radius(view) + 0.3 * em);
  list.AddText({x, y}, colours::secondary(), kind.c_str());
}

std::optional<StandardView> standard_view_of(const Camera& camera) {
  const auto* found =
      std::find_if(kStandardViews.begin(), kStandardViews.end(),
                   [&](const StandardView& view) { return camera.is_turned_to(view.yaw, view.pitch); });
  return found == kStandardViews.end() ? std::nullopt : std::optional(*found);
}

void draw_measured_point(const ViewState& view, const Vec3& point, ImDrawList& list) {
  const auto at = PrimaryViewport(view).place_of(point);
  if (!at) return;
  list.AddCircleFilled(to_im(*at), 5, kMeasureShade);
  list.AddCircleFilled(to_im(*at), 3.2f, colours::accent());
}

void draw_distance(const ViewState& view, const Vec3& from, const Vec3& to, const std::string& text,
                   ImDrawList& list) {
  const PrimaryViewport picture(view);
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
