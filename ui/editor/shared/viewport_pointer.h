#pragma once

#include <optional>

#include "ui/editor/shared/workspace.h"

namespace kerf {

// Drags of the camera: around its pivot, and parallel to the view plane.
class Orbit : public Interaction {
 public:
  explicit Orbit(Workspace& workspace) : workspace_(workspace), last_(workspace.input.pointer) {}
  void move(const InputEvent&) override;
  const char* words() const override { return "Orbiting"; }

 private:
  Workspace& workspace_;
  Vec2 last_;  // of the pointer
};

class Pan : public Interaction {
 public:
  explicit Pan(Workspace& workspace) : workspace_(workspace), last_(workspace.input.pointer) {}
  void move(const InputEvent&) override;
  const char* words() const override { return "Panning"; }

 private:
  Workspace& workspace_;
  Vec2 last_;
};

void zoom(Workspace& workspace, double notches);

// A point of a visible surface, with the unit normal of its face on the visible side.
struct SurfacePoint {
  Vec3 at{0}, normal{0, 1, 0};
};

// Returns the first point of a visible surface (see pick) on a ray in world space. Precondition: the
// direction is a unit vector.
std::optional<SurfacePoint> surface_point(const World& world, const ViewOptions& look, const Pose& ray);

// Returns the point of a visible surface under the pointer, in the first half of the viewport.
std::optional<Vec3> point_under_pointer(const Workspace& workspace);

// Rotates a direction by the shortest rotation from one unit vector to another.
Vec3 turned_with(const Vec3& direction, const Vec3& from, const Vec3& to);

// Returns true if a press selects pieces: with the Select tool, or with Ctrl and any tool.
inline bool picks(const PointerInput& input, const Press& press) { return input.picks() || press.control; }

// Returns the visible face at a place of the window within the first half of the viewport.
std::optional<FaceOfBody> face_at(const World& world, const ViewState& view, Vec2 place);

// Returns the face under the pointer, if it is in the first half of the viewport.
std::optional<FaceOfBody> face_under_pointer(const Workspace& workspace);

// Returns the piece under the pointer, if it is in the first half of the viewport.
std::optional<PieceId> piece_under_pointer(const Workspace& workspace);
bool selected_under_pointer(const Workspace& workspace);

// Selects the piece under the pointer; `add` keeps the rest of the selection.
void select_under_pointer(Workspace& workspace, bool add);

// Returns the selected pieces in the order of their ids.
std::vector<PieceId> selected_ids(const PieceMap& looks);

}  // namespace kerf
