#include "core/cut/close_by_walls.h"

#include <algorithm>
#include <functional>
#include <limits>

#include "core/cut/rim_state.h"

namespace kerf {

const Mesh& WallClosing::mesh() const { return rim_->mesh(); }

bool WallClosing::go_on(RimState& rim) {
  rim_ = &rim;
  if (!distance_) distance_.emplace(rim.region, moves_);
  if (!closing_) closing_.emplace(close());
  return closing_->go_on();
}

Resumable<ClosedRim> WallClosing::close() {
  constexpr int kMostRounds = 8;
  ClosedRim closed;
  co_await find_open_faces();
  co_await find_sides();
  for (int i = 0; i < kMostRounds && !sides_.empty(); ++i) {
    if (!co_await remove_ears()) break;
    co_await find_sides();
  }
  closed.left_open = std::move(left_open_);
  if (sides_.empty()) co_return closed;
  const WallStroke stroke{moves_,
                          rim_->radius(),
                          rim_->settings.laser.range,
                          std::cref(*distance_),
                          [this](const Vec3& p, const Vec3& direction) { return crossings(p, direction); },
                          [this] { return parts_with_sides(); }};
  const MadeWalls made = co_await make_walls(mesh(), sides_, stroke);
  closed.left_open.insert(closed.left_open.end(), made.left_open.begin(), made.left_open.end());
  std::vector<FaceId> beside;
  for (const WallPatch& patch : made.patches) {
    if (joins_pieces(patch)) {
      closed.left_open.push_back(
          left_open("a wall would join two pieces", mesh().position(patch.rim[0])).message);
      continue;
    }
    co_await worked(kPartOfWork);
    const std::vector<FaceId> walls = co_await add(patch);
    closed.walls.insert(closed.walls.end(), walls.begin(), walls.end());
    beside.insert(beside.end(), patch.beside_wall.begin(), patch.beside_wall.end());
  }
  // The faces beside a wall are connected by it.
  if (!beside.empty()) rim_->step.edit.search_from(beside);
  co_return closed;
}

std::vector<std::pair<FaceId, int>> WallClosing::crossings(const Vec3& p, const Vec3& direction) const {
  const Body& body = rim_->step.body();
  std::vector<RayHit> hits;
  body.tree.crossings(body.mesh, {p, direction}, {0, std::numeric_limits<double>::max()}, hits);
  std::vector<std::pair<FaceId, int>> crossed;
  for (const RayHit& hit : hits) {
    const Triangle t = body.mesh.triangle(hit.face);
    crossed.emplace_back(hit.face, glm::dot(glm::cross(t[1] - t[0], t[2] - t[0]), direction) > 0 ? 1 : -1);
  }
  return crossed;
}

// Whether faces of two pieces are beside one wall.
bool WallClosing::joins_pieces(const WallPatch& patch) const {
  for (size_t i = 0; i < patch.sides.size(); ++i) {
    const FaceId beside = patch.beside_wall[patch.wall_of_side[i]];
    if (mesh().data(patch.sides[i].face).piece != mesh().data(beside).piece) return true;
  }
  return false;
}

Resumable<std::vector<FaceId>> WallClosing::add(const WallPatch& patch) {
  constexpr size_t kTogether = 256;
  std::vector<VertexId> vertices = patch.rim;
  for (const Vec3& p : patch.added) vertices.push_back(rim_->step.edit.add_vertex(p));
  co_await worked(vertices.size() / 4);
  FaceAddition addition(std::move(vertices), patch.faces);
  std::vector<FaceId> walls, beside;
  is_adding_ = true;
  while (walls.size() < patch.faces.size()) {
    beside.clear();
    for (size_t i = walls.size(); i < std::min(walls.size() + kTogether, patch.faces.size()); ++i)
      beside.push_back(patch.beside_wall[patch.wall_of_face[i]]);
    const std::vector<FaceId> added = rim_->step.edit.add_walls(addition, beside);
    walls.insert(walls.end(), added.begin(), added.end());
    co_await worked(4 * added.size());
  }
  while (!rim_->step.edit.part_fans(addition, kTogether)) co_await worked(kTogether / 2);
  for (size_t i = 0; i < patch.sides.size(); ++i) {
    co_await worked(1);
    rim_->step.edit.join_parts(patch.sides[i].face, patch.beside_wall[patch.wall_of_side[i]]);
  }
  is_adding_ = false;
  co_return walls;
}

}  // namespace kerf
