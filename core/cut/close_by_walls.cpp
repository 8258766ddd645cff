#include "core/cut/close_by_walls_internal.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <tuple>

#include "core/base/tolerances.h"
#include "core/cut/rim_stages_internal.h"
#include "core/mesh/sheet_sides.h"

namespace kerf {

SpeckSearch::SpeckSearch(const SweptDistance& distance, std::span<const RimSide> sides)
    : distance_(distance) {
  for (const RimSide& s : sides) at_rim_.insert(at_rim_.end(), {s.from, s.to});
  std::sort(at_rim_.begin(), at_rim_.end());
}

void SpeckSearch::append(RimState& rim, FaceId start, std::vector<FaceId>& specks) const {
  constexpr size_t kMaxFaces = 64;
  std::vector<FaceId> part{start}, neighbours;
  for (size_t i = 0; i < part.size(); ++i) {
    if (part.size() > kMaxFaces || !lies_along(rim, part[i])) return;
    neighbours.clear();
    rim.mesh().append_nearest_neighbours(part[i], neighbours);
    for (const FaceId n : neighbours) {
      if (std::find(part.begin(), part.end(), n) == part.end()) part.push_back(n);
    }
  }
  specks.insert(specks.end(), part.begin(), part.end());
}

bool SpeckSearch::lies_along(RimState& rim, FaceId f) const {
  const double most = kRimNear * rim.radius();
  const auto corners = rim.mesh().corners(f);
  const Triangle t = rim.mesh().triangle(f);
  const auto is_near = [&](const Vec3& p) { return std::abs(distance_(p)) <= most; };
  for (size_t i = 0; i < 3; ++i) {
    if (std::binary_search(at_rim_.begin(), at_rim_.end(), corners[i])) continue;
    const bool is_known = rim.region.is_near(f);  // no further test for distant vertices
    if ((is_known && std::abs(rim.distance(corners[i], f)) > 2 * most) || !is_near(t[i])) return false;
  }
  const Vec3 between[] = {0.5 * (t[0] + t[1]), 0.5 * (t[1] + t[2]), 0.5 * (t[2] + t[0]),
                          (t[0] + t[1] + t[2]) / 3.0};
  return std::all_of(std::begin(between), std::end(between), is_near);
}

namespace {

void sort_faces(std::vector<FaceId>& faces) {
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
}

}  // namespace

Task<Done> WallClosing::find_open_faces() {
  constexpr uint32_t kTogether = 4096;
  std::vector<SheetSide> open;
  for (uint32_t edge = 0; edge < mesh().edge_slots(); edge += kTogether) {
    append_sheet_sides_in(mesh(), edge, edge + kTogether, open);
    co_await yield_after(kTogether / 32);
  }
  for (const SheetSide& s : open) open_faces_.push_back(s.side.face);
  sort_faces(open_faces_);
  co_return Done{};
}

// A flipped face may be near more parts of the region than its list holds.
bool WallClosing::is_at_rim(const Mesh::Side& side) {
  const double most = kRimNear * rim_->radius();
  const auto lies_there = [&](VertexId v) {
    if (rim_->region.is_near(side.face) && std::abs(rim_->distance(v, side.face)) <= most) return true;
    return std::abs((*distance_)(mesh().position(v))) <= most;
  };
  return lies_there(side.from) && lies_there(side.to);
}

// Returns true if the faces on an edge of several sheets bound no solids: more run one way than the other.
bool WallClosing::is_unmatched(const Mesh::Side& side, SidesOfRings& seen) const {
  if (seen.contains({side.face, side.from})) return false;
  std::vector<Mesh::Side> others;
  mesh().append_edge_sides(side.face, side.from, side.to, others);
  int balance = 1;
  for (const Mesh::Side& s : others) {
    seen.insert({s.face, s.from});
    balance += mesh().position(s.from) == mesh().position(side.from) ? 1 : -1;
  }
  return balance != 0;
}

// Finds the sides along the rim of parts closed before the stroke; reports where others are open.
Task<Done> WallClosing::find_sides() {
  sides_.clear();
  left_open_.clear();
  std::vector<FaceId> elsewhere;
  std::optional<Mesh::Side> open_side, unmatched;
  std::vector<SheetSide> open;
  SidesOfRings seen;
  for (const FaceId f : open_faces_) {
    co_await yield_after(1);
    open.clear();
    append_sheet_sides_of(mesh(), f, open);
    for (const auto& [s, is_shared] : open) {
      if (is_at_rim(s)) {
        sides_.push_back({s.face, s.from, s.to});
      } else if (!is_shared) {
        elsewhere.push_back(s.face);
        if (!open_side) open_side = s;
      } else if (!unmatched && is_unmatched(s, seen)) {
        unmatched = s;
      }
    }
  }
  std::sort(sides_.begin(), sides_.end(), [](const RimSide& a, const RimSide& b) {
    return std::tie(a.face, a.from) < std::tie(b.face, b.from);
  });
  if (sides_.empty()) co_return Done{};
  if (unmatched)
    left_open_.push_back(
        left_open("an edge has three or more faces that bound no solid", mesh().position(unmatched->from))
            .message);
  if (elsewhere.empty()) co_return Done{};
  const std::vector<bool> was_open = co_await parts_around(elsewhere);
  std::erase_if(sides_, [&](const RimSide& s) { return was_open[s.face.index]; });
  const Vec3 there = mesh().position(open_side->from);
  left_open_.push_back(sides_.empty() ? "it was open before the stroke"
                                      : left_open("a part was open before the stroke", there).message);
  co_return Done{};
}

// Appends the adjacent faces of the same part: those on the face's sheet and, if its sheet ends at an edge
// of several sheets away from the rim, those of the other sheets that end there.
void WallClosing::append_connected(FaceId f, SidesOfRings& seen, std::vector<FaceId>& out) {
  append_sheet_neighbours(mesh(), f, out);
  std::vector<SheetSide> ends, beyond;
  append_sheet_sides_of(mesh(), f, ends);
  for (const auto& [side, is_shared] : ends) {
    if (!is_shared || seen.contains({f, side.from}) || is_at_rim(side)) continue;
    std::vector<Mesh::Side> others;
    mesh().append_edge_sides(f, side.from, side.to, others);
    for (const Mesh::Side& other : others) {
      seen.insert({other.face, other.from});
      beyond.clear();
      append_sheet_sides_of(mesh(), other.face, beyond);
      const bool ends_there = std::ranges::any_of(
          beyond, [&](const SheetSide& s) { return s.side.from == other.from && s.side.to == other.to; });
      if (ends_there) out.push_back(other.face);
    }
  }
}

// Returns the faces of the connected parts that contain the given faces.
Task<std::vector<bool>> WallClosing::parts_around(const std::vector<FaceId>& faces) {
  std::vector<bool> reached(mesh().face_slots());
  SidesOfRings seen;
  std::vector<FaceId> waiting, neighbours;
  const auto reach = [&](FaceId f) {
    if (reached[f.index]) return;
    reached[f.index] = true;
    waiting.push_back(f);
  };
  for (const FaceId f : faces) reach(f);
  while (!waiting.empty()) {
    const FaceId f = waiting.back();
    waiting.pop_back();
    neighbours.clear();
    append_connected(f, seen, neighbours);
    for (const FaceId n : neighbours) reach(n);
    co_await yield_after(1);
  }
  co_return reached;
}

// Returns the index of the connected part of each face, for parts with sides along the rim.
Task<std::vector<uint32_t>> WallClosing::parts_with_sides() {
  std::vector<uint32_t> part(mesh().face_slots(), kNoPart);
  SidesOfRings seen;
  std::vector<FaceId> waiting, neighbours;
  uint32_t parts = 0;
  for (const RimSide& side : sides_) {
    if (part[side.face.index] != kNoPart) continue;
    part[side.face.index] = parts;
    waiting.push_back(side.face);
    while (!waiting.empty()) {
      const FaceId f = waiting.back();
      waiting.pop_back();
      neighbours.clear();
      append_connected(f, seen, neighbours);
      for (const FaceId n : neighbours) {
        if (part[n.index] != kNoPart) continue;
        part[n.index] = parts;
        waiting.push_back(n);
      }
      co_await yield_after(1);
    }
    ++parts;
  }
  co_return part;
}

// Returns true if all sides of a face are open, or two are and the third one lies on the boundary too.
bool WallClosing::is_ear(std::span<const RimSide> of_face) const {
  if (of_face.size() != 2) return of_face.size() == 3;
  const auto c = mesh().corners(of_face[0].face);
  const auto is_open = [&](VertexId from) { return of_face[0].from == from || of_face[1].from == from; };
  const size_t k = is_open(c[0]) ? is_open(c[1]) ? 2 : 1 : 0;
  const Vec3 middle = 0.5 * mesh().position(c[k]) + 0.5 * mesh().position(c[(k + 1) % 3]);
  return std::abs((*distance_)(middle)) <= kRimNear * rim_->radius();
}

// Removes ears: faces along the rim that have all corners on the rim and all sides open, or all but one
// that lies on the boundary too. Without them the rim is as near to the boundary; with them it would turn
// back on itself. Removes specks too. Returns true if any face was removed.
Task<bool> WallClosing::remove_ears() {
  std::vector<FaceId> ears;
  const SpeckSearch specks(*distance_, sides_);
  for (size_t i = 0; i < sides_.size();) {
    const FaceId f = sides_[i].face;
    size_t end = i + 1;
    while (end < sides_.size() && sides_[end].face == f) ++end;
    if (is_ear(std::span(sides_).subspan(i, end - i))) ears.push_back(f);
    specks.append(*rim_, f, ears);
    i = end;
    co_await yield_after(2);
  }
  if (ears.empty()) co_return false;
  sort_faces(ears);
  remove(std::move(ears));
  co_return true;
}

void WallClosing::remove(std::vector<FaceId> faces) {
  for (const FaceId f : faces) mesh().append_nearest_neighbours(f, open_faces_);
  remove_faces(rim_->step, faces);
  rim_->work.removed = true;
  sort_faces(open_faces_);
  std::erase_if(open_faces_, [&](FaceId f) { return !mesh().is_live(f); });
}

const Mesh& WallClosing::mesh() const { return rim_->mesh(); }

bool WallClosing::resume(RimState& rim) {
  rim_ = &rim;
  if (!distance_) distance_.emplace(rim.region, moves_);
  if (!closing_) closing_.emplace(close());
  return closing_->resume();
}

Task<ClosedRim> WallClosing::close() {
  constexpr int kMaxRounds = 8;
  ClosedRim closed;
  co_await find_open_faces();
  co_await find_sides();
  for (int i = 0; i < kMaxRounds && !sides_.empty(); ++i) {
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
    co_await yield_after(kPartOfWork);
    const std::vector<FaceId> walls = co_await add(patch);
    closed.walls.insert(closed.walls.end(), walls.begin(), walls.end());
    beside.insert(beside.end(), patch.beside_wall.begin(), patch.beside_wall.end());
  }
  // The wall connects the faces next to it.
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

// Returns true if one wall would be adjacent to faces of two pieces.
bool WallClosing::joins_pieces(const WallPatch& patch) const {
  for (size_t i = 0; i < patch.sides.size(); ++i) {
    const FaceId beside = patch.beside_wall[patch.wall_of_side[i]];
    if (mesh().data(patch.sides[i].face).piece != mesh().data(beside).piece) return true;
  }
  return false;
}

Task<std::vector<FaceId>> WallClosing::add(const WallPatch& patch) {
  constexpr size_t kTogether = 256;
  std::vector<VertexId> vertices = patch.rim;
  for (const Vec3& p : patch.added) vertices.push_back(rim_->step.edit.add_vertex(p));
  co_await yield_after(vertices.size() / 4);
  FaceAddition addition(std::move(vertices), patch.faces);
  std::vector<FaceId> walls, beside;
  is_adding_ = true;
  while (walls.size() < patch.faces.size()) {
    beside.clear();
    for (size_t i = walls.size(); i < std::min(walls.size() + kTogether, patch.faces.size()); ++i)
      beside.push_back(patch.beside_wall[patch.wall_of_face[i]]);
    const std::vector<FaceId> added = rim_->step.edit.add_walls(addition, beside);
    walls.insert(walls.end(), added.begin(), added.end());
    co_await yield_after(4 * added.size());
  }
  while (!rim_->step.edit.part_fans(addition, kTogether)) co_await yield_after(kTogether / 2);
  for (size_t i = 0; i < patch.sides.size(); ++i) {
    co_await yield_after(1);
    rim_->step.edit.join_parts(patch.sides[i].face, patch.beside_wall[patch.wall_of_side[i]]);
  }
  is_adding_ = false;
  co_return walls;
}

}  // namespace kerf
