#include "ui/editor/path/path_panel.h"

#include <imgui.h>

#include "core/base/assert.h"
#include "core/document/files/edit_path.h"
#include "core/document/files/stroke_settings.h"
#include "ui/editor/shared/panels/panel_rows.h"
#include "ui/editor/shared/panels/shortcut_text.h"
#include "ui/window/fitted_text.h"
#include "ui/window/landmarks.h"
#include "ui/window/number_text.h"
#include "ui/window/property.h"
#include "ui/window/row_button.h"
#include "ui/window/theme.h"

namespace kerf {

namespace {

constexpr size_t kMostRows = 7;
constexpr const char* kEmpty = "The path has no points.";

std::string summary(const PathWork& path, const ViewState& view) {
  if (path.empty())
    return with_shortcut(view, "Click points on a surface with the tool Path,", "Path") +
           " or load a path file.";
  double way = 0, seconds = 0;
  for (const StrokePath& stroke : path.strokes()) {
    way += way_of(stroke);
    seconds += duration_of(stroke);
  }
  return count_text(path.strokes().size(), "stroke") + ", " + count_text(path.points(), "point") +
         ", length " + length_label(way, view.frame.unit) + ", " + text_of("%.3g s", seconds);
}

// The point with this number, counted over all strokes.
PathPoint numbered(const PathWork& path, size_t number) {
  KERF_ASSERT(number < path.points());
  size_t stroke = 0;
  for (; number >= path.strokes()[stroke].keys.size(); ++stroke) number -= path.strokes()[stroke].keys.size();
  return {stroke, number};
}

size_t number_of(const PathWork& path, PathPoint point) {
  size_t number = point.key;
  for (size_t i = 0; i < point.stroke; ++i) number += path.strokes()[i].keys.size();
  return number;
}

// The headings, which stay while the list scrolls; lengths are in the unit.
void set_up_columns(const std::string& unit) {
  ImGui::TableSetupScrollFreeze(0, 1);
  ImGui::TableSetupColumn("Point");
  for (const char* axis : {"X", "Y", "Z"}) ImGui::TableSetupColumn((axis + (" (" + unit + ")")).c_str());
  ImGui::TableHeadersRow();
}

}  // namespace

void PathPanel::draw_buttons(PathWork& path, const ViewState& view, const char* why_no_run,
                             const PathWishes& wishes) {
  const std::string run =
      with_shortcut(view, "Cuts along the path, as kerf cut --path does with its file.", "Run the path");
  if (row_button("Run", 4, why_no_run, run.c_str())) wishes.run();
  ImGui::SameLine();
  if (row_button("Load", 4, nullptr, "Reads a path file (.json). It can also be dropped on the window."))
    wishes.load();
  ImGui::SameLine();
  const char* why_empty = path.empty() ? kEmpty : nullptr;
  if (row_button("Save", 4, why_empty, "Writes the path to a file (.json) for kerf cut --path."))
    wishes.save();
  ImGui::SameLine();
  if (!row_button("Clear", 4, why_empty, "Removes all points; undo brings them back.")) return;
  path.begin_edit();
  path.clear();
}

void PathPanel::draw_speed(PathWork& path, FileUnit unit) {
  double speed = path.speed();
  const char* meaning =
      path.has_times_of_file()
          ? "Of the origin of the beam: the mean of the times in the file. A speed that is typed replaces "
            "these times."
          : "Of the origin of the beam.";
  if (!length_field(fields_, "Speed", speed, label_unit(speed, unit), meaning, "/s", kPositive)) return;
  path.begin_edit();
  path.set_speed(speed);
}

void PathPanel::draw_radius(PathWork& path, const World& world, FileUnit unit) {
  const size_t stroke = path.chosen()->stroke;
  const StrokePath& drawn = path.strokes()[stroke];
  double radius = default_settings(drawn, world.bounds().diagonal()).laser.radius;
  if (!length_field(fields_, "Beam radius", radius, label_unit(radius, unit),
                    drawn.radius
                        ? "Of the stroke of the chosen point."
                        : "Of the stroke of the chosen point: the file gives none, so it is 1/400 of the "
                          "diagonal of all meshes.",
                    "", kPositive))
    return;
  path.begin_edit();
  path.set_radius(stroke, radius);
}

void PathPanel::draw_beam(PathWork& path, bool& at_panel_resolution, const World& world, FileUnit unit) {
  if (path.empty() || !begin_properties("beam")) return;
  draw_speed(path, unit);
  choice_row(
      "Cut", "##cut", at_panel_resolution, "As kerf cut does\0As in the Resolution panel\0",
      "path resolution",
      "How fine the faces along the cut are, and which rim is left: as kerf cut --path does with the same "
      "file, or as strokes of the pointer are cut.");
  if (path.chosen()) draw_radius(path, world, unit);
  end_properties();
}

void PathPanel::draw_row(PathWork& path, PathPoint point, int number, double unit, double diagonal) {
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
    draw_fitted_text(number_text(path.target(point)[i] / unit, "%.4g", diagonal / unit));
  }
  if (chosen) ImGui::PopStyleColor();
  ImGui::PopID();
}

void PathPanel::draw_list(PathWork& path, const World& world, FileUnit unit) {
  constexpr ImGuiTableFlags kList =
      ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersOuter;
  const size_t points = path.points();
  if (points == 0) return;
  const float height = height_of_rows(std::min(points, kMostRows) + 1);
  if (!ImGui::BeginTable("points", 4, kList, {0, height})) return;
  const double diagonal = world.loaded_bounds().diagonal();
  const LengthUnit shown = label_unit(diagonal, unit);
  set_up_columns(shown.name);
  draw_rows_in_sight(points, [&](size_t i) {
    draw_row(path, numbered(path, i), static_cast<int>(i), shown.metres, diagonal);
  });
  if (path.chosen() && path.chosen() != shown_) {
    shown_ = path.chosen();
    scroll_to_row(number_of(path, *shown_), height);
  }
  ImGui::EndTable();
}

void PathPanel::draw_chosen(PathWork& path, const World& world, FileUnit unit) {
  if (!path.chosen() || !begin_properties("point")) return;
  const PathPoint point = *path.chosen();
  Vec3 target = path.target(point), direction = path.pose(point).direction;
  double distance = path.distance(point);
  bool edited =
      fields_.vector("Aims at", target, "%.5g",
                     "X, Y and Z of the chosen point, in the unit of the file. The origin of its beam "
                     "moves along.",
                     file_unit(unit), world.loaded_bounds().diagonal());
  edited = fields_.vector("Direction", direction, "%.4g",
                          "X, Y and Z of the direction of the beam, of any length.") ||
           edited;
  edited = length_field(fields_, "Distance", distance, label_unit(distance, unit),
                        "From the origin of the beam to the point that it aims at. The beam cuts all that it "
                        "meets within its range.",
                        "", kPositive) ||
           edited;
  end_properties();
  if (!edited || direction == Vec3(0)) return;
  direction = beam_direction(direction);
  path.begin_edit();
  path.set(point, {target - direction * distance, direction}, distance);
}

void PathPanel::draw(PathWork& path, bool& at_panel_resolution, const ViewState& view, const World& world,
                     const PathTool::Beam& beam, const char* why_no_run, const PathWishes& wishes) {
  const FileUnit unit = view.frame.unit;
  draw_buttons(path, view, why_no_run, wishes);
  secondary_text(summary(path, view));
  draw_beam(path, at_panel_resolution, world, unit);
  draw_list(path, world, unit);
  draw_chosen(path, world, unit);
  const bool unfolded = ImGui::TreeNodeEx("Holes", ImGuiTreeNodeFlags_NoTreePushOnOpen);
  mark_last_item("Holes header");
  tooltip("A grid or a circle of holes around the chosen point.");
  if (unfolded) holes_.draw(path, world, beam.radius, beam.speed, unit);
}

}  // namespace kerf
