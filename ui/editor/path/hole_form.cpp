#include "ui/editor/path/hole_form.h"

#include <imgui.h>

#include <string>

#include "core/base/assert.h"
#include "ui/editor/shared/panels/panel_rows.h"
#include "ui/window/landmarks.h"
#include "ui/window/property.h"
#include "ui/window/row_button.h"

namespace kerf {

namespace {

void number_row(NumberFields& fields, const char* name, int& number, const char* meaning) {
  auto count = static_cast<size_t>(number);
  if (fields.count(name, count, meaning, 1, HolePattern::kMostInALine)) number = static_cast<int>(count);
}

void length_row(NumberFields& fields, const char* name, double& length, FileUnit unit, const char* meaning) {
  length_field(fields, name, length, label_unit(length, unit), meaning, "", kPositive);
}

}  // namespace

void HoleForm::draw_grid(FileUnit unit) {
  number_row(fields_, "Rows", pattern_.rows, "How many rows of holes there are.");
  number_row(fields_, "Columns", pattern_.columns, "How many holes there are in each row.");
  length_row(fields_, "Spacing", pattern_.spacing, unit, "Between the middles of neighbouring holes.");
}

void HoleForm::draw_circle(FileUnit unit) {
  number_row(fields_, "Holes", pattern_.count, "How many holes there are on the circle.");
  length_row(fields_, "Circle radius", pattern_.circle_radius, unit,
             "Of the circle on which the middles of the holes lie.");
}

void HoleForm::fit_to(double diagonal) {
  const bool of_another_size = diagonal < 0.5 * fitted_to_ || diagonal > 2 * fitted_to_;
  if (!of_another_size || !(diagonal > 0)) return;
  fitted_to_ = diagonal;
  pattern_.spacing = diagonal / 12;
  pattern_.circle_radius = diagonal / 6;
  pattern_.hole_radius = diagonal / 40;
}

void HoleForm::add_holes(PathWork& path, const World& world, double radius, double speed) const {
  KERF_ASSERT(path.chosen());
  const PathPoint point = *path.chosen();
  const Pose beam = path.pose(point);
  const double distance = path.distance(point);
  path.begin_edit();
  path.add_strokes(hole_strokes(pattern_, beam, radius), world, distance, speed);
}

void HoleForm::draw(PathWork& path, const World& world, double radius, double speed, FileUnit unit) {
  fit_to(world.bounds().diagonal());
  if (!begin_properties("holes")) return;
  choice_row("Pattern", "##kind", pattern_.kind, "Grid\0Circle\0", "hole pattern", nullptr);
  const bool grid = pattern_.kind == HolePattern::Kind::kGrid;
  if (grid) draw_grid(unit);
  if (!grid) draw_circle(unit);
  length_row(fields_, "Hole radius", pattern_.hole_radius, unit,
             "A hole that is no wider than the beam is a single burst.");
  end_properties();
  const int count = grid ? pattern_.rows * pattern_.columns : pattern_.count;
  const std::string label = "Add " + count_text(static_cast<size_t>(count), "hole");
  if (row_button((label + "###add holes").c_str(), 1,
                 path.chosen() ? nullptr : "Click a point on a surface first: it is the middle of the holes.",
                 "Adds a stroke for each hole around the chosen point, along its beam."))
    add_holes(path, world, radius, speed);
  mark_last_item("add holes");
}

}  // namespace kerf
