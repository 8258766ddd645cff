#include "ui/editor/shared/picture/axes_gizmo.h"

#include <imgui.h>

#include <algorithm>

#include "ui/window/imgui_vector.h"
#include "ui/window/theme.h"

namespace kerf {

namespace {

// Sizes of the text.
constexpr double kRadius = 2.6;  // from the middle to the end of an axis
constexpr double kEnd = 0.62;    // of the disc at a positive end
constexpr double kOppositeEnd = 0.45;
constexpr double kMargin = 0.9;       // around all that
constexpr double kLeastPicture = 14;  // width and height of a picture that has room for it

double whole_radius(const ViewState& view) { return (kRadius + kEnd + 0.25) * view.layout.em; }

bool has_room(const ViewState& view) {
  return std::min(view.layout.first.size.x, view.layout.first.size.y) >= kLeastPicture * view.layout.em;
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
    list.AddCircleFilled(to_im(end.at), reach, colours::kPictureShade);
    list.AddCircle(to_im(end.at), reach, colour, 0, 1.5f);
  }
  if (pointed_at) list.AddCircle(to_im(end.at), reach + 1.5f, colours::kPictureText, 0, 1.5f);
  if (end.positive || pointed_at)
    draw_letter(end, end.positive ? IM_COL32(14, 17, 21, 255) : colours::kPictureText, list);
}

// "Top, orthographic"; empty in a perspective view along no axis.
std::string kind_of_view(const ViewState& view) {
  const auto standard = standard_view_of(view.camera);
  std::string text = standard ? standard->name : "";
  if (view.camera.parallel()) text += text.empty() ? "Orthographic" : ", orthographic";
  return text;
}

}  // namespace

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
    list.AddCircleFilled(to_im(middle), static_cast<float>(whole_radius(view)), colours::kPictureShade);
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
  list.AddText({x, y}, colours::kPictureSecondary, kind.c_str());
}

std::optional<StandardView> standard_view_of(const Camera& camera) {
  const auto* found =
      std::find_if(kStandardViews.begin(), kStandardViews.end(),
                   [&](const StandardView& view) { return camera.is_turned_to(view.yaw, view.pitch); });
  return found == kStandardViews.end() ? std::nullopt : std::optional(*found);
}

}  // namespace kerf
