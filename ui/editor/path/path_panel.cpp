#include "ui/editor/path/path_panel.h"

#include <imgui.h>

#include <cmath>
#include <cstdio>

#include "core/document/edit_path.h"
#include "ui/window/landmarks.h"
#include "ui/window/number_text.h"
#include "ui/window/property.h"
#include "ui/window/row_button.h"
#include "ui/window/theme.h"

namespace kerf {

namespace {

constexpr size_t kMostRows = 7;
constexpr const char* kEmpty = "The path has no points.";

std::string count_text(size_t count, const char* what) {
  return grouped(count) + ' ' + what + (count == 1 ? "" : "s");
}

std::string summary(const PathWork& path) {
  if (path.empty()) return "Click points on a surface with the tool Path (O), or load a path file.";
  double way = 0, seconds = 0;
  for (const StrokePath& stroke : path.strokes()) {
    way += way_of(stroke);
    seconds += duration_of(stroke);
  }
  std::array<char, 96> figures{};
  std::snprintf(figures.data(), figures.size(), ", length %.4g, %.3g s", way, seconds);
  return count_text(path.strokes().size(), "stroke") + ", " + count_text(path.points(), "point") +
         figures.data();
}

// The point with this number, counted over all strokes.
PathPoint numbered(const PathWork& path, size_t number) {
  size_t stroke = 0;
  for (; number >= path.strokes()[stroke].keys.size(); ++stroke) number -= path.strokes()[stroke].keys.size();
  return {stroke, number};
}

size_t number_of(const PathWork& path, PathPoint point) {
  size_t number = point.key;
  for (size_t i = 0; i < point.stroke; ++i) number += path.strokes()[i].keys.size();
  return number;
}

}  // namespace

void PathPanel::draw_buttons(PathWork& path, const char* why_no_run, const PathWishes& wishes) {
  if (row_button("Run", 4, why_no_run,
                 "Cuts along the path, as kerf cut --path does with its file (Ctrl+Enter)."))
    wishes.run();
  ImGui::SameLine();
  if (row_button("Load", 4, nullptr, "Reads a path file (.json). It can also be dropped on the window."))
    wishes.load();
  ImGui::SameLine();
  const char* why_empty = path.empty() ? kEmpty : nullptr;
  if (row_button("Save", 4, why_empty, "Writes the path to a file (.json) for kerf cut --path."))
    wishes.save();
  ImGui::SameLine();
  if (!row_button("Clear", 4, why_empty, "Removes all points. Ctrl+Z brings them back.")) return;
  path.begin_edit();
  path.clear();
}

void PathPanel::draw_beam(PlacedLasers& lasers) {
  PathWork& path = lasers.path;
  if (path.empty() || !begin_properties("beam")) return;
  double speed = path.speed();
  const char* meaning =
      path.has_times_of_file()
          ? "Of the origin of the beam, per second: the mean of the times in the file. A speed that "
            "is typed replaces these times."
          : "Of the origin of the beam, in the unit of the file per second.";
  if (fields_.number("Speed", speed, "%.4g /s", meaning) && speed > 0) {
    path.begin_edit();
    path.set_speed(speed);
  }
  property("Cut");
  int cut = lasers.at_panel_resolution ? 1 : 0;
  if (ImGui::Combo("##cut", &cut, "As kerf cut does\0As in the Resolution panel\0"))
    lasers.at_panel_resolution = cut == 1;
  mark_last_item("path resolution");
  tooltip(
      "How fine the faces along the cut are, and which rim is left: as kerf cut --path does with the same "
      "file, "
      "or as strokes of the pointer are cut.");
  if (path.chosen()) {
    const size_t stroke = path.chosen()->stroke;
    double radius = path.strokes()[stroke].radius.value_or(0);
    if (fields_.number("Beam radius", radius, radius > 0 ? "%.4g" : "by size",
                       "Of the stroke of the chosen point, in the unit of the file. Where the file gives "
                       "none, it is 1/400 of the diagonal of all meshes.") &&
        radius > 0) {
      path.begin_edit();
      path.set_radius(stroke, radius);
    }
  }
  end_properties();
}

void PathPanel::draw_row(PathWork& path, PathPoint point, int number) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  const bool chosen = path.chosen() == point;
  ImGui::PushID(number);
  if (chosen) ImGui::PushStyleColor(ImGuiCol_Text, colours::accent());
  const std::string label = std::to_string(point.stroke + 1) + "." + std::to_string(point.key + 1);
  if (ImGui::Selectable(label.c_str(), chosen, ImGuiSelectableFlags_SpanAllColumns))
    shown_ = point, path.choose(point);
  mark_last_item("path row", number);
  for (int i = 0; i < 3; ++i) {
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(text_of("%.4g", path.target(point)[i]).c_str());
  }
  if (chosen) ImGui::PopStyleColor();
  ImGui::PopID();
}

void PathPanel::draw_list(PathWork& path) {
  constexpr ImGuiTableFlags kList =
      ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersOuter;
  const size_t points = path.points();
  if (points == 0) return;
  const float line = ImGui::GetTextLineHeight() + 2 * ImGui::GetStyle().CellPadding.y;
  const float height = static_cast<float>(std::min(points, kMostRows)) * line + 0.2f * ImGui::GetFontSize();
  if (!ImGui::BeginTable("points", 4, kList, {0, height})) return;
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(points));
  while (clipper.Step()) {
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
      draw_row(path, numbered(path, static_cast<size_t>(i)), i);
  }
  if (path.chosen() && path.chosen() != shown_) {
    shown_ = path.chosen();
    ImGui::SetScrollY(line * static_cast<float>(number_of(path, *shown_)) - 0.5f * height);
  }
  ImGui::EndTable();
}

void PathPanel::draw_chosen(PathWork& path) {
  if (!path.chosen() || !begin_properties("point")) return;
  const PathPoint point = *path.chosen();
  Vec3 target = path.target(point), direction = path.pose(point).direction;
  double distance = path.distance(point);
  bool edited =
      fields_.vector("Aims at", target, "%.5g",
                     "X, Y and Z of the chosen point, in the unit of the file. The origin of its beam "
                     "moves along.");
  edited = fields_.vector("Direction", direction, "%.4g",
                          "X, Y and Z of the direction of the beam, of any length.") ||
           edited;
  edited =
      fields_.number("Distance", distance, "%.5g",
                     "From the origin of the beam to the point that it aims at. The beam cuts all that it "
                     "meets within its range.") ||
      edited;
  end_properties();
  if (!edited || direction == Vec3(0) || !(distance > 0)) return;
  direction = beam_direction(direction);
  path.begin_edit();
  path.set(point, {target - direction * distance, direction}, distance);
}

void PathPanel::draw(PlacedLasers& lasers, const World& world, const PathTool::Beam& beam,
                     const char* why_no_run, const PathWishes& wishes) {
  PathWork& path = lasers.path;
  draw_buttons(path, why_no_run, wishes);
  ImGui::PushStyleColor(ImGuiCol_Text, colours::secondary());
  ImGui::TextWrapped("%s", summary(path).c_str());
  ImGui::PopStyleColor();
  draw_beam(lasers);
  draw_list(path);
  draw_chosen(path);
  const bool unfolded = ImGui::TreeNodeEx("Holes", ImGuiTreeNodeFlags_NoTreePushOnOpen);
  mark_last_item("Holes header");
  tooltip("A grid or a circle of holes around the chosen point.");
  if (unfolded) holes_.draw(path, world, beam.radius, beam.speed);
}

}  // namespace kerf
