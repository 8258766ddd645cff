#include "ui/editor/shared/viewport_pointer.h"

#include <cmath>

#include "core/base/assert.h"
#include "core/base/geometry.h"
#include "ui/editor/shared/piece_set.h"
#include "ui/editor/shared/viewport.h"
#include "ui/render/bodies/body_picture.h"

namespace kerf {

namespace {

constexpr double kOrbitPerHeight = 3.6;  // radians for a drag over the height of the viewport
constexpr double kZoomPerNotch = 0.88;

// Returns the motion of the pointer since the last call, in heights of the viewport.
Vec2 way_of(const Workspace& workspace, Vec2& last) {
  return (workspace.input.pointer - std::exchange(last, workspace.input.pointer)) /
         workspace.view.pane().size.y;
}

}  // namespace

void Orbit::move(const InputEvent&) {
  const Vec2 way = way_of(workspace_, last_);
  const double speed = workspace_.settings.drag_speed;
  workspace_.view.camera.orbit(-way.x * kOrbitPerHeight * speed, way.y * kOrbitPerHeight * speed);
}

void Pan::move(const InputEvent&) {
  const Vec2 way = 2.0 * way_of(workspace_, last_);
  workspace_.view.camera.pan(way.x / workspace_.view.aspect(), -way.y, workspace_.view.aspect());
}

void zoom(Workspace& workspace, double notches) {
  const Vec2 p = workspace.view.in_picture(workspace.input.pointer);
  workspace.view.camera.zoom(std::pow(kZoomPerNotch, notches * workspace.settings.wheel_speed), p.x, p.y,
                             workspace.view.aspect());
}

std::optional<SurfacePoint> surface_point(const World& world, const ViewOptions& look, const Pose& ray) {
  const std::optional<Pick> seen = pick(world, look, ray);
  if (!seen) return std::nullopt;
  const Body& body = world.body(seen->body);
  const Triangle t = body.mesh.triangle(seen->face);
  const Vec3 across = body.placement.orientation * glm::cross(t[1] - t[0], t[2] - t[0]);
  const double length = glm::length(across);
  Vec3 normal = length > 0 ? across / length : -ray.direction;
  if (glm::dot(normal, ray.direction) > 0) normal = -normal;
  return SurfacePoint{ray.origin + ray.direction * seen->length, normal};
}

std::optional<Vec3> point_under_pointer(const Workspace& workspace) {
  const auto surface = surface_point(workspace.world(), workspace.view.look,
                                     PrimaryViewport(workspace.view).ray(workspace.input.pointer));
  return surface ? std::optional(surface->at) : std::nullopt;
}

Vec3 turned_with(const Vec3& direction, const Vec3& from, const Vec3& to) {
  KERF_ASSERT(is_unit(from) && is_unit(to));
  const double w = 1 + glm::dot(from, to);
  if (w < 1e-6) return -to;  // the shortest rotation is not unique
  const glm::dquat turn = glm::normalize(glm::dquat(w, glm::cross(from, to)));
  return turn * direction;
}

std::optional<FaceOfBody> face_at(const World& world, const ViewState& view, Vec2 place) {
  const Vec2 p = view.in_picture(place);
  const std::optional<Pick> seen = pick(world, view.look, view.seen().ray(p.x, p.y));
  return seen ? std::optional(FaceOfBody{seen->body, seen->face}) : std::nullopt;
}

std::optional<FaceOfBody> face_under_pointer(const Workspace& workspace) {
  if (workspace.view.in_second) return std::nullopt;
  return face_at(workspace.world(), workspace.view, workspace.input.pointer);
}

std::optional<PieceId> piece_under_pointer(const Workspace& workspace) {
  const std::optional<FaceOfBody> face = face_under_pointer(workspace);
  if (!face) return std::nullopt;
  return PieceId{face->body, workspace.world().body(face->body).mesh.data(face->face).piece};
}

bool selected_under_pointer(const Workspace& workspace) {
  const auto piece = piece_under_pointer(workspace);
  const PieceMap& looks = workspace.view.look.pieces;
  const auto look = piece ? looks.find(*piece) : looks.end();
  return look != looks.end() && look->second.selected;
}

void select_under_pointer(Workspace& workspace, bool add) {
  if (workspace.view.in_second) return workspace.message.error("Select pieces in the left half.");
  if (const auto piece = piece_under_pointer(workspace)) {
    select_piece(workspace.view.look.pieces, *piece, add);
  } else if (!add) {
    deselect_all(workspace.view.look.pieces);
  }
  workspace.view.picture_old = true;
}

std::vector<PieceId> selected_ids(const PieceMap& looks) {
  std::vector<PieceId> selected;
  for (const auto& [id, look] : looks) {
    if (look.selected) selected.push_back(id);
  }
  return selected;
}

}  // namespace kerf
