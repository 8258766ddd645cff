#include "ui/editor/path/hole_pattern.h"

#include <imgui.h>
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/base/assert.h"
#include "core/base/geometry.h"
#include "ui/editor/shared/command_labels.h"
#include "ui/editor/shared/panel_rows.h"
#include "ui/editor/shared/viewport_pointer.h"
#include "ui/window/layout.h"
#include "ui/window/theme.h"
#include "ui/window/widgets.h"

namespace kerf {

namespace {

constexpr double kWholeTurn = 6.283185307179586;

constexpr size_t kMaxProjectedHoles = 400, kMaxFullySampledHoles = 100;
constexpr int kOutlinePoints = 40;
constexpr int kDash = 2;                      // segments of an outline in a dash
constexpr int kMinKeys = 12, kMaxKeys = 360;  // of a hole
constexpr double kSagitta = 1.0 / 16;         // max. distance of a chord from its circle, in beam radii

// Directions of the rows and columns, perpendicular to the beam.
struct Plane {
  Vec3 along, across;
  Vec3 at(double x, double y) const { return along * x + across * y; }
};

Plane plane_across(const Vec3& beam) {
  int best = 0;
  for (const int axis : {2, 1}) {
    if (std::abs(beam[axis]) < std::abs(beam[best]) - 1e-6) best = axis;
  }
  Vec3 along(0);
  along[best] = 1;
  along = glm::normalize(along - beam * glm::dot(along, beam));
  return {along, glm::cross(beam, along)};
}

int keys_of_circle(double circle, double radius) {
  const double sagitta = std::min(kSagitta * radius / circle, 1.0);
  const double keys = std::ceil(0.5 * kWholeTurn / std::acos(1 - sagitta));
  return static_cast<int>(std::clamp<double>(keys, kMinKeys, kMaxKeys));
}

std::vector<Vec3> middles(const HolePattern& p, const Plane& plane) {
  std::vector<Vec3> all;
  if (p.kind == HolePattern::Kind::kCircle) {
    for (int i = 0; i < p.count; ++i) {
      const double angle = kWholeTurn * i / p.count;
      all.push_back(plane.at(p.circle_radius * std::cos(angle), p.circle_radius * std::sin(angle)));
    }
    return all;
  }
  for (int row = 0; row < p.rows; ++row) {
    for (int column = 0; column < p.columns; ++column) {
      const double x = column - 0.5 * (p.columns - 1), y = row - 0.5 * (p.rows - 1);
      all.push_back(plane.at(p.spacing * x, p.spacing * y));
    }
  }
  return all;
}

std::vector<Vec3> circle_points(const Plane& plane, double radius) {
  std::vector<Vec3> points;
  for (int i = 0; i < kOutlinePoints; ++i) {
    const double angle = kWholeTurn * i / kOutlinePoints;
    points.push_back(plane.at(radius * std::cos(angle), radius * std::sin(angle)));
  }
  return points;
}

struct HoleDepth {
  HoleOutline::Meets meets = HoleOutline::Meets::kNothing;
  std::optional<double> depth;  // m along the beam, of the first surface found; nullopt if there is none
};

// Tests the centre of a hole, and every `stride`-th point of its circle until the answer is certain.
HoleDepth depth_of_hole(const World& world, const ViewOptions& look, const Pose& ray,
                        const std::vector<Vec3>& circle, size_t stride) {
  HoleDepth found;
  bool misses = false;
  const auto test = [&](const Vec3& offset) {
    const auto surface = surface_point(world, look, {ray.origin + offset, ray.direction});
    if (!surface) misses = true;
    if (surface && !found.depth) found.depth = glm::dot(surface->at - ray.origin, ray.direction);
  };
  test(Vec3(0));
  for (size_t i = 0; i < circle.size() && !(found.depth && misses); i += stride) test(circle[i]);
  if (found.depth) found.meets = misses ? HoleOutline::Meets::kInPart : HoleOutline::Meets::kFully;
  return found;
}

size_t count_missing(const std::vector<HoleOutline>& outlines) {
  return static_cast<size_t>(std::ranges::count_if(
      outlines, [](const HoleOutline& o) { return o.meets == HoleOutline::Meets::kNothing; }));
}

// Draws a closed outline, in dashes if the hole meets a surface in part.
void draw_outline(const std::vector<ImVec2>& places, HoleOutline::Meets meets, ImDrawList& list) {
  const ImU32 shade = IM_COL32(10, 12, 16, 170);
  const auto count = static_cast<int>(places.size());
  if (meets != HoleOutline::Meets::kInPart) {
    const bool full = meets == HoleOutline::Meets::kFully;
    list.AddPolyline(places.data(), count, shade, ImDrawFlags_Closed, 3.5f);
    list.AddPolyline(places.data(), count, full ? colours::accent() : colours::kPictureSecondary,
                     ImDrawFlags_Closed, 1.5f);
    return;
  }
  for (int i = 0; i + kDash < count; i += 2 * kDash) {
    list.AddPolyline(&places[i], kDash + 1, shade, 0, 3.5f);
    list.AddPolyline(&places[i], kDash + 1, colours::accent(), 0, 1.5f);
  }
}

StrokePath hole(const Pose& middle, const Plane& plane, double hole_radius, double radius) {
  StrokePath stroke;
  stroke.radius = std::min(radius, hole_radius);
  const double circle = hole_radius - radius;
  if (circle > 0) {
    const int keys = keys_of_circle(circle, radius);
    for (int i = 0; i <= keys; ++i) {
      const double angle = kWholeTurn * (i % keys) / keys;
      const Vec3 aside = plane.at(circle * std::cos(angle), circle * std::sin(angle));
      stroke.keys.push_back({middle.origin + aside, middle.direction});
    }
  } else {
    stroke.keys.push_back(middle);
  }
  retime(stroke, 1);
  return stroke;
}

void number_row(NumberFields& fields, const char* name, int& number, const char* meaning) {
  auto count = static_cast<size_t>(number);
  if (fields.count(name, count, meaning, 1, HolePattern::kMaxInALine)) number = static_cast<int>(count);
}

void length_row(NumberFields& fields, const char* name, double& length, FileUnit unit, const char* meaning) {
  length_field(fields, name, length, label_unit(length, unit), meaning, "", kPositive);
}

}  // namespace

std::vector<StrokePath> hole_strokes(const HolePattern& pattern, const Pose& beam, double radius) {
  KERF_ASSERT(pattern.hole_radius > 0 && radius > 0);
  KERF_ASSERT(is_unit(beam.direction));
  const Plane plane = plane_across(beam.direction);
  std::vector<StrokePath> strokes;
  for (const Vec3& middle : middles(pattern, plane))
    strokes.push_back(hole({beam.origin + middle, beam.direction}, plane, pattern.hole_radius, radius));
  return strokes;
}

std::vector<HoleOutline> hole_outlines(const HolePattern& pattern, const Pose& beam, double distance,
                                       const World& world, const ViewOptions& look) {
  KERF_ASSERT(pattern.hole_radius > 0 && distance >= 0);
  const Plane plane = plane_across(beam.direction);
  const std::vector<Vec3> all = middles(pattern, plane);
  const std::vector<Vec3> circle = circle_points(plane, pattern.hole_radius);
  ViewOptions in_place = look;
  for (auto& [id, piece] : in_place.pieces) piece.offset = Vec3(0);
  std::vector<HoleOutline> outlines;
  for (const Vec3& middle : all) {
    const Pose ray{beam.origin + middle, beam.direction};
    HoleOutline outline;
    double depth = distance;
    if (all.size() <= kMaxProjectedHoles) {
      const HoleDepth found =
          depth_of_hole(world, in_place, ray, circle, 1 + all.size() / kMaxFullySampledHoles);
      outline.meets = found.meets;
      depth = found.depth.value_or(distance);
    }
    for (const Vec3& p : circle) outline.points.push_back(ray.origin + depth * ray.direction + p);
    outlines.push_back(std::move(outline));
  }
  return outlines;
}

void HoleForm::draw_grid(FileUnit unit) {
  number_row(fields_, "Rows", pattern_.rows, "Number of rows of holes.");
  number_row(fields_, "Columns", pattern_.columns, "Number of holes in each row.");
  length_row(fields_, "Spacing", pattern_.spacing, unit,
             "Distance between the centres of neighbouring holes.");
}

void HoleForm::draw_circle(FileUnit unit) {
  number_row(fields_, "Holes", pattern_.count, "Number of holes on the circle.");
  length_row(fields_, "Circle Radius", pattern_.circle_radius, unit,
             "Radius of the circle through the centres of the holes.");
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
  KERF_ASSERT(path.selected());
  const PathPoint point = *path.selected();
  const Pose beam = path.pose(point);
  const double distance = path.distance(point);
  std::vector<StrokePath> strokes = hole_strokes(pattern_, beam, radius), met;
  KERF_ASSERT(strokes.size() == outlines_.size());
  for (size_t i = 0; i < strokes.size(); ++i) {
    if (outlines_[i].meets != HoleOutline::Meets::kNothing) met.push_back(std::move(strokes[i]));
  }
  path.begin_edit();
  path.add_strokes(met, world, distance, speed);
}

void HoleForm::draw_preview(const ViewState& view, ImDrawList& list) {
  const PrimaryViewport viewport(view);
  Vec2 low(INFINITY), high(-INFINITY);
  for (const HoleOutline& outline : std::exchange(outlines_, {})) {
    std::vector<ImVec2> places;
    for (const Vec3& p : outline.points) {
      const auto place = viewport.place_of(p);
      if (!place) break;
      places.push_back(to_im(*place));
      low = glm::min(low, *place);
      high = glm::max(high, *place);
    }
    if (places.size() < outline.points.size()) continue;
    draw_outline(places, outline.meets, list);
  }
  if (low.x <= high.x) mark_area("hole preview", {low, high - low});
}

void HoleForm::draw(PathWork& path, const World& world, const ViewOptions& look, double radius, double speed,
                    FileUnit unit) {
  outlines_.clear();
  fit_to(world.bounds().diagonal());
  if (!begin_properties("holes")) return;
  choice_row("Pattern", "##kind", pattern_.kind, "Grid\0Circle\0", "hole pattern", nullptr);
  const bool grid = pattern_.kind == HolePattern::Kind::kGrid;
  if (grid) draw_grid(unit);
  if (!grid) draw_circle(unit);
  length_row(fields_, "Hole Radius", pattern_.hole_radius, unit,
             "Holes no wider than the beam are cut by a single burst.");
  end_properties();
  if (const auto point = path.selected())
    outlines_ = hole_outlines(pattern_, path.pose(*point), path.distance(*point), world, look);
  const auto count = static_cast<size_t>(grid ? pattern_.rows * pattern_.columns : pattern_.count);
  const size_t missing = count_missing(outlines_), met = count - missing;
  std::string label = "Add " + grouped(met) + (met == 1 ? " Hole" : " Holes");
  if (missing > 0) label += ", " + grouped(missing) + (missing == 1 ? " meets" : " meet") + " no surface";
  const char* disabled_reason = met == 0 ? "None of the holes meets a surface." : nullptr;
  if (!path.selected()) disabled_reason = "Select a point of the path first; the holes are centred on it.";
  if (row_button((label + "###add holes").c_str(), 1, disabled_reason,
                 "Adds a stroke for each hole around the selected point, along its beam. Dashed holes meet a "
                 "surface in part."))
    add_holes(path, world, radius, speed);
  mark_last_item("add holes");
}

}  // namespace kerf
