#pragma once

#include <optional>

#include "ui/editor/shared/workspace.h"

namespace kerf {

// Drags that move the camera and nothing else: around what is looked at, and parallel to the picture.
class Orbit : public Interaction {
 public:
  explicit Orbit(Workspace& workspace) : workspace_(workspace), last_(workspace.pointer) {}
  void move(const InputEvent&) override;
  const char* words() const override { return "Orbiting"; }

 private:
  Workspace& workspace_;
  Vec2 last_;  // of the pointer
};

class Pan : public Interaction {
 public:
  explicit Pan(Workspace& workspace) : workspace_(workspace), last_(workspace.pointer) {}
  void move(const InputEvent&) override;
  const char* words() const override { return "Panning"; }

 private:
  Workspace& workspace_;
  Vec2 last_;
};

// Zooms to the pointer, by so many notches of the wheel.
void zoom(Workspace& workspace, double notches);

// A point of a visible surface, with the unit normal of its face on the side from which it is seen.
struct SurfacePoint {
  Vec3 at{0}, normal{0, 1, 0};
};

// The first point of a visible surface (see pick) on a ray of the world. Precondition: the direction is a
// unit vector.
std::optional<SurfacePoint> surface_point(const World& world, const ViewOptions& look, const Pose& ray);

// The point of a visible surface under the pointer, in the first half of the picture.
std::optional<Vec3> point_under_pointer(const Workspace& workspace);

// The direction after the shortest rotation that turns the unit vector `from` into `to`, another one.
Vec3 turned_with(const Vec3& direction, const Vec3& from, const Vec3& to);

// The tool that chooses pieces; with Ctrl each tool does.
inline constexpr const char* kPickTool = "Pick pieces";
inline bool picks(const Workspace& workspace, const Press& press) {
  return workspace.tool == kPickTool || press.control;
}

// What a click does: chooses the piece under the pointer, with `add` beside those that are chosen.
void choose_under_pointer(Workspace& workspace, bool add);

// The chosen pieces in the order of their ids.
std::vector<PieceId> chosen_ids(const PieceMap& looks);

}  // namespace kerf
