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

Resumable<Result<std::vector<FaceId>>> WallClosing::close() {
  constexpr int kMostRounds = 8;
  co_await find_open_faces();
  Status found = co_await find_sides();
  for (int i = 0; i < kMostRounds && found; ++i) {
    if (!co_await remove_ears()) break;
    found = co_await find_sides();
  }
  if (!found) co_return found.error();
  if (sides_.empty()) co_return std::vector<FaceId>();
  const WallStroke stroke{moves_, rim_->radius(), rim_->settings.laser.range, std::cref(*distance_),
                          [this](const Vec3& p, const Vec3& direction) { return winding(p, direction); }};
  const Result<WallPatch> patch = co_await make_walls(mesh(), sides_, stroke);
  if (!patch) co_return patch.error();
  if (co_await touches_ring(*patch)) co_return failed("more than two faces share an edge at the rim");
  if (joins_pieces(*patch)) co_return failed("a wall would join two pieces");
  co_await worked(kPartOfWork);
  co_return co_await add(*patch);
}

int WallClosing::winding(const Vec3& p, const Vec3& direction) const {
  const Body& body = rim_->step.body();
  std::vector<RayHit> hits;
  body.tree.crossings(body.mesh, {p, direction}, {0, std::numeric_limits<double>::max()}, hits);
  int winding = 0;
  for (const RayHit& hit : hits) {
    const Triangle t = body.mesh.triangle(hit.face);
    winding += glm::dot(glm::cross(t[1] - t[0], t[2] - t[0]), direction) > 0 ? 1 : -1;
  }
  return winding;
}

// Whether a wall would touch an edge that three or more faces share.
Resumable<bool> WallClosing::touches_ring(const WallPatch& patch) const {
  Mesh::Star star;
  for (const VertexId v : patch.rim) {
    mesh().star(v, star);
    if (!star.alone) co_return true;
    co_await worked(1);
  }
  co_return false;
}

// Whether faces of two pieces are beside one wall.
bool WallClosing::joins_pieces(const WallPatch& patch) const {
  for (size_t i = 0; i < sides_.size(); ++i) {
    const FaceId beside = patch.beside_wall[patch.wall_of_side[i]];
    if (mesh().data(sides_[i].face).piece != mesh().data(beside).piece) return true;
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
  for (size_t i = 0; i < sides_.size(); ++i) {
    co_await worked(1);
    rim_->step.edit.join_parts(sides_[i].face, patch.beside_wall[patch.wall_of_side[i]]);
  }
  is_adding_ = false;
  rim_->step.edit.search_from(patch.beside_wall);  // all that is beside a wall hangs together by it
  co_return walls;
}

}  // namespace kerf
