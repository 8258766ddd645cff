#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "core/document/job_files.h"
#include "core/world/world.h"
#include "ui/editor/shared/gizmo.h"
#include "ui/editor/shared/viewport_pointer.h"

namespace kerf {

// Directions of the beam of DrawingMode::kAxis (see plane_onto()).
inline constexpr std::array<const char*, 6> kBeamAxes{"+x", "-x", "+y", "-y", "+z", "-z"};
// Returns the index of the one that points down.
constexpr int downward_beam(UpAxis up) { return up == UpAxis::kZ ? 5 : 3; }

enum class DrawingMode {
  kPlane,  // the plane of a surface; the beam is perpendicular to it
  kAxis,   // the beam is parallel to an axis of the world
  kView,   // as lines on the screen, along the view
  kWrap,   // round a cylinder, whose axis is parallel to one of the world and goes through the middle of it
};

// Where a drawing lies: its middle is at the anchor.
struct DrawingPlacement {
  DrawingMode mode = DrawingMode::kPlane;
  SurfacePoint anchor;
  CameraView view;               // of kView; its up direction is that of drawings on a surface, too
  int beam = 3;                  // of kAxis: an index into kBeamAxes
  int axis = 1;                  // of kWrap: 0 for X, 1 for Y, 2 for Z
  std::optional<double> radius;  // of the cylinder [m, > 0]; nullopt: the anchor lies on it
  double turn = 0;               // rad, counter-clockwise as seen along the beam
  double scale = 1;              // m of the world per m of the drawing, > 0

  // Returns the plane or the cylinder through the anchor, in a world with these bounds.
  JobPlane plane(const Bounds& bounds) const;
  // Returns the same plane moved back against the beam to where the beams start: half the diagonal of the
  // drawing, `extent` [m], from the plane of a surface, else outside the bounds.
  JobPlane start(const Bounds& bounds, double extent) const;
};

// Returns the point of the plane or of the cylinder at which a point of the drawing lies.
Vec3 point_on(const JobPlane& plane, Vec2 p);
// Returns the inverse for the point that a ray meets; nullopt if it meets none.
std::optional<Vec2> drawing_point(const JobPlane& plane, const Pose& ray);

// A part of a line of a drawing, along the beams.
struct ProjectedLine {
  size_t line = 0;           // of the drawing
  bool on_surface = false;   // false: the beam hits nothing, and the points are those of the plane
  std::vector<Vec3> points;  // m, at least one
};

// Projects the lines of a drawing, whose middle is given, onto the first surfaces that the beams hit. Lines
// are divided to follow the surfaces, at about 256 points per `extent` [m of the drawing, its diagonal], and
// at kMaxProjected points altogether; they break where the surface does. One query of the trees per point.
inline constexpr size_t kMaxProjected = 20'000;
std::vector<ProjectedLine> project_lines(std::span<const DrawnLine> lines, Vec2 middle, double extent,
                                         const DrawingPlacement& placement, const World& world);

// Ends the beams of strokes, one per line as drawing_strokes() returns them from placement.start(), a little
// behind the farthest first surface along each line. Costs as much as project_lines() for each line.
void end_behind_surface(std::span<const DrawnLine> lines, Vec2 middle, double extent,
                        const DrawingPlacement& placement, const World& world, std::span<StrokePath> strokes);

// A handle of the frame around a drawing.
struct DrawingHandle : GizmoHandle {
  enum class Kind { kSize, kTurn };
  Kind kind;
};

// Returns the corners of the frame, whose half size is given [m of the drawing], and the knob over its upper
// edge that turns it.
std::vector<DrawingHandle> drawing_handles(const PrimaryViewport& picture, const JobPlane& plane, Vec2 half);
// Returns the line of the frame, which begins at its lower left corner and is closed; empty if a part lies
// behind the eye.
std::vector<Vec2> drawing_frame(const PrimaryViewport& picture, const JobPlane& plane, Vec2 half);

}  // namespace kerf
