#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <tuple>

#include "core/base/tolerances.h"
#include "core/cut/rim_state.h"
#include "core/cut/swept_distance.h"
#include "core/walls/make_walls.h"

namespace kerf {

namespace {

// What is near a face that was flipped may be more than is known of it.
bool is_at_rim(RimState& rim, const SweptDistance& distance, const Mesh::Side& side) {
  const double most = kRimNear * rim.radius();
  const auto lies_there = [&](VertexId v) {
    if (rim.region.is_near(side.face) && std::abs(rim.distance(v, side.face)) <= most) return true;
    return std::abs(distance(rim.mesh().position(v))) <= most;
  };
  return lies_there(side.from) && lies_there(side.to);
}

// The faces of the connected parts that hold some faces.
std::vector<bool> parts_around(const Mesh& mesh, const std::vector<FaceId>& faces) {
  std::vector<bool> reached(mesh.face_slots());
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
    mesh.append_nearest_neighbours(f, neighbours);
    for (const FaceId n : neighbours) reach(n);
  }
  return reached;
}

// The sides along the rim of parts that were closed before the stroke.
Result<std::vector<RimSide>> sides_at_rim(RimState& rim, const SweptDistance& distance) {
  std::vector<Mesh::Side> open;
  rim.mesh().append_open_sides(open);
  std::vector<RimSide> sides;
  std::vector<FaceId> elsewhere;
  for (const Mesh::Side& s : open) {
    if (is_at_rim(rim, distance, s)) {
      sides.push_back({s.face, s.from, s.to});
    } else {
      elsewhere.push_back(s.face);
    }
  }
  std::sort(sides.begin(), sides.end(), [](const RimSide& a, const RimSide& b) {
    return std::tie(a.face, a.from) < std::tie(b.face, b.from);
  });
  if (elsewhere.empty() || sides.empty()) return sides;
  const std::vector<bool> was_open = parts_around(rim.mesh(), elsewhere);
  std::erase_if(sides, [&](const RimSide& s) { return was_open[s.face.index]; });
  if (sides.empty()) return failed("it was open before the stroke");
  return sides;
}

// Finds connected parts of a few faces that lie along the boundary everywhere. With walls they would enclose
// next to nothing.
class SpeckSearch {
 public:
  SpeckSearch(RimState& rim, const SweptDistance& distance, const std::vector<RimSide>& sides)
      : rim_(rim), mesh_(rim.mesh()), distance_(distance), near_(kRimNear * rim.radius()) {
    for (const RimSide& s : sides) at_rim_.insert(at_rim_.end(), {s.from, s.to});
    std::sort(at_rim_.begin(), at_rim_.end());
  }

  // Appends the faces of the part of a face, if it is such a one.
  void append(FaceId start, std::vector<FaceId>& specks) {
    constexpr size_t kMostFaces = 64;
    std::vector<FaceId> part{start}, neighbours;
    for (size_t i = 0; i < part.size(); ++i) {
      if (part.size() > kMostFaces || !lies_along(part[i])) return;
      neighbours.clear();
      mesh_.append_nearest_neighbours(part[i], neighbours);
      for (const FaceId n : neighbours) {
        if (std::find(part.begin(), part.end(), n) == part.end()) part.push_back(n);
      }
    }
    specks.insert(specks.end(), part.begin(), part.end());
  }

 private:
  bool lies_along(FaceId f) {
    const auto corners = mesh_.corners(f);
    const Triangle t = mesh_.triangle(f);
    const auto is_near = [&](const Vec3& p) { return std::abs(distance_(p)) <= near_; };
    for (size_t i = 0; i < 3; ++i) {
      if (std::binary_search(at_rim_.begin(), at_rim_.end(), corners[i])) continue;
      const bool is_known = rim_.region.is_near(f);  // what is far away needs no further look
      if ((is_known && std::abs(rim_.distance(corners[i], f)) > 2 * near_) || !is_near(t[i])) return false;
    }
    const Vec3 between[] = {0.5 * (t[0] + t[1]), 0.5 * (t[1] + t[2]), 0.5 * (t[2] + t[0]),
                            (t[0] + t[1] + t[2]) / 3.0};
    return std::all_of(std::begin(between), std::end(between), is_near);
  }

  RimState& rim_;
  const Mesh& mesh_;
  const SweptDistance& distance_;
  double near_;
  std::vector<VertexId> at_rim_;  // ascending, with repeats
};

// Removes faces that lie along the rim, beyond which the rim is as near to the boundary as it was: those of
// which all corners are on the rim, and all sides but one are open, if that one lies on the boundary too.
// Left in place, they make the rim turn back on itself. Specks go as well. Returns whether there were any.
bool remove_ears(RimState& rim, const SweptDistance& distance, const std::vector<RimSide>& sides) {
  std::vector<FaceId> ears;
  SpeckSearch specks(rim, distance, sides);
  for (size_t i = 0; i < sides.size();) {
    size_t end = i + 1;
    while (end < sides.size() && sides[end].face == sides[i].face) ++end;
    const FaceId f = sides[i].face;
    const auto is_open = [&](VertexId from) {
      return std::any_of(sides.begin() + i, sides.begin() + end,
                         [&](const RimSide& s) { return s.from == from; });
    };
    if (end - i == 3) ears.push_back(f);
    if (end - i == 2) {
      const auto c = rim.mesh().corners(f);
      const size_t k = is_open(c[0]) ? is_open(c[1]) ? 2 : 1 : 0;
      const Vec3 middle = 0.5 * rim.mesh().position(c[k]) + 0.5 * rim.mesh().position(c[(k + 1) % 3]);
      if (std::abs(distance(middle)) <= kRimNear * rim.radius()) ears.push_back(f);
    }
    specks.append(f, ears);
    i = end;
  }
  std::sort(ears.begin(), ears.end());
  ears.erase(std::unique(ears.begin(), ears.end()), ears.end());
  remove_faces(rim.step, ears);
  rim.work.removed = rim.work.removed || !ears.empty();
  return !ears.empty();
}

int winding_of(const Body& body, const Vec3& p, const Vec3& direction) {
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
bool touches_ring(const Mesh& mesh, const WallPatch& patch) {
  Mesh::Star star;
  return std::any_of(patch.rim.begin(), patch.rim.end(), [&](VertexId v) {
    mesh.star(v, star);
    return !star.alone;
  });
}

// Whether faces of two pieces are beside one wall.
bool joins_pieces(const Mesh& mesh, const std::vector<RimSide>& sides, const WallPatch& patch) {
  for (size_t i = 0; i < sides.size(); ++i) {
    if (mesh.data(sides[i].face).piece != mesh.data(patch.beside_wall[patch.wall_of_side[i]]).piece)
      return true;
  }
  return false;
}

std::vector<FaceId> add(RimState& rim, const std::vector<RimSide>& sides, const WallPatch& patch) {
  std::vector<VertexId> vertices = patch.rim;
  for (const Vec3& p : patch.added) vertices.push_back(rim.step.edit.add_vertex(p));
  std::vector<std::array<VertexId, 3>> corners;
  std::vector<FaceId> beside;
  for (size_t i = 0; i < patch.faces.size(); ++i) {
    const auto& f = patch.faces[i];
    corners.push_back({vertices[f[0]], vertices[f[1]], vertices[f[2]]});
    beside.push_back(patch.beside_wall[patch.wall_of_face[i]]);
  }
  std::vector<FaceId> seeds;
  for (size_t i = 0; i < sides.size(); ++i) {
    seeds.push_back(sides[i].face);
    rim.step.edit.join_parts(sides[i].face, patch.beside_wall[patch.wall_of_side[i]]);
  }
  const std::vector<FaceId> walls = rim.step.edit.add_walls(corners, beside);
  std::sort(seeds.begin(), seeds.end());
  seeds.erase(std::unique(seeds.begin(), seeds.end()), seeds.end());
  rim.step.edit.search_from(seeds);
  return walls;
}

}  // namespace

Result<std::vector<FaceId>> close_by_walls(RimState& rim, std::span<const BeamMove> moves) {
  constexpr int kMostRounds = 8;
  const SweptDistance swept(rim.region, moves);
  Result<std::vector<RimSide>> sides = sides_at_rim(rim, swept);
  for (int i = 0; i < kMostRounds && sides && remove_ears(rim, swept, *sides); ++i)
    sides = sides_at_rim(rim, swept);
  if (!sides) return sides.error();
  if (sides->empty()) return std::vector<FaceId>();
  const auto winding = [&](const Vec3& p, const Vec3& direction) {
    return winding_of(rim.step.body(), p, direction);
  };
  const Result<WallPatch> patch = make_walls(
      rim.mesh(), *sides, {moves, rim.radius(), rim.settings.laser.range, std::cref(swept), winding});
  if (!patch) return patch.error();
  if (touches_ring(rim.mesh(), *patch)) return failed("more than two faces share an edge at the rim");
  if (joins_pieces(rim.mesh(), *sides, *patch)) return failed("a wall would join two pieces");
  return add(rim, *sides, *patch);
}

}  // namespace kerf
