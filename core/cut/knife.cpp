#include "core/cut/knife.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "core/base/assert.h"
#include "core/base/tolerances.h"
#include "core/cut/cut_stages.h"
#include "core/cut/knife_internal.h"
#include "core/joints/joined_parts.h"
#include "core/walls/section_walls.h"

namespace kerf {

namespace {

WallPlane plane_in_body(const KnifePlane& plane, const Placement& placement) {
  const Vec3 size = glm::abs(plane.normal);
  const double largest = std::max({size.x, size.y, size.z});
  KERF_ASSERT(largest > 0 && std::isfinite(largest) && std::isfinite(plane.distance));
  const Vec3 normal = plane.normal / largest;
  const double length = glm::length(normal);
  const Vec3 unit = normal / length;
  // Beyond the range of double the plane still lies on one side of all vertices.
  constexpr double kFarthest = std::numeric_limits<double>::max();
  const double distance = std::clamp(plane.distance / largest / length, -kFarthest, kFarthest);
  return {glm::conjugate(placement.orientation) * unit, distance - glm::dot(unit, placement.position)};
}

// Moves a point by units in the last place towards an end of its edge until it differs from all others: two
// sides of a face without area may cross a plane at one point.
Vec3 apart_from(Vec3 at, const Vec3& end, const std::vector<Vec3>& others) {
  const Vec3 reach = glm::abs(end - at);
  int axis = 0;
  for (int k = 1; k < 3; ++k) {
    if (reach[k] > reach[axis]) axis = k;
  }
  while (std::ranges::find(others, at) != others.end()) at[axis] = std::nextafter(at[axis], end[axis]);
  return at;
}

std::vector<Vec3> opposite_corners(const Mesh& mesh, const Mesh::Side& edge) {
  std::vector<Mesh::Side> sides{edge};
  mesh.append_edge_sides(edge.face, edge.from, edge.to, sides);
  std::vector<Vec3> positions;
  for (const Mesh::Side& s : sides) {
    for (const VertexId v : mesh.corners(s.face)) {
      if (v != s.from && v != s.to) positions.push_back(mesh.position(v));
    }
  }
  return positions;
}

// Sides of two faces on one edge, on different sides of the knife.
struct KnifeSides {
  std::vector<Mesh::Side> above, below;
};

class KnifeCut {
 public:
  KnifeCut(BodyStep& step, const WallPlane& plane, const Pegs& pegs)
      : step_(step), plane_(plane), pegs_(pegs) {
    sort_vertices();
  }

  // Number of faces that the plane crosses.
  size_t crossed() const { return crossed_.size(); }

  void run(std::vector<LeftOpen>& left_open, SolidChange& solid) {
    split();
    update_tree(step_);
    const KnifeSides sides = find_sides();
    KERF_ASSERT(sides.above.empty() == sides.below.empty());
    if (sides.above.empty()) return;
    step_.edit.open_edges(sides.above);
    std::vector<FaceId> seeds;
    auto [above, below] = sections(sides, seeds, solid);
    for (const Section* section : {&above, &below}) {
      for (const SectionWalls& walls : section->walls) add_section(step_, walls);
      seeds.insert(seeds.end(), section->seeds.begin(), section->seeds.end());
    }
    std::vector<std::string>& open = above.left_open.empty() ? below.left_open : above.left_open;
    for (std::string& why : open) left_open.push_back({step_.id, std::move(why)});
    step_.edit.refit_tree();
    step_.edit.search_from(seeds);
  }

 private:
  // Makes the walls of both sides of the plane, above and below, with pegs if both sides have room for them.
  std::pair<Section, Section> sections(const KnifeSides& sides, std::vector<FaceId>& seeds,
                                       SolidChange& solid) {
    const std::vector<RimSide> above = open_sides(mesh(), sides.above, seeds),
                               below = open_sides(mesh(), sides.below, seeds);
    const WallPlane down{-plane_.normal, -plane_.distance};
    const bool closes = step_.body().solid;
    const std::vector<Vec3> centres =
        closes && pegs_.count > 0 ? find_pegs(sides.below) : std::vector<Vec3>();
    std::vector<SectionPeg> pegs, holes;
    for (const Vec3& centre : centres) {
      pegs.push_back({centre, pegs_.diameter / 2, pegs_.depth});
      holes.push_back({centre, pegs_.diameter / 2 + pegs_.tolerance, -(pegs_.depth + pegs_.tolerance)});
    }
    std::pair<Section, Section> made{make_section(mesh(), above, down, closes, holes),
                                     make_section(mesh(), below, plane_, closes, pegs)};
    if (made.first.pegs != centres.size() || made.second.pegs != centres.size())
      made = {make_section(mesh(), above, down, closes), make_section(mesh(), below, plane_, closes)};
    if (closes) {
      solid.pegs += made.first.pegs;
      KERF_ASSERT(made.first.pegs <= static_cast<size_t>(pegs_.count));
      solid.missing_pegs += static_cast<size_t>(pegs_.count) - made.first.pegs;
    }
    return made;
  }

  // A peg needs room in the part above the plane; its faces are cut at the plane.
  std::vector<Vec3> find_pegs(std::span<const Mesh::Side> sides) {
    return peg_centres(mesh(), sides, plane_, pegs_, [&](const Vec3& centre, double radius) {
      const Pose pose{centre, plane_.normal};
      const double reach = pegs_.depth + pegs_.tolerance + radius - pegs_.diameter / 2;
      std::vector<FaceId> touched;
      step_.body().tree.touched(mesh(), SweptCylinder(pose, pose, radius, {0, reach}), touched);
      return touched.empty();
    });
  }

  const Mesh& mesh() const { return step_.mesh(); }
  int side(VertexId v) const { return v.index < side_.size() ? side_[v.index] : 0; }

  // Determines the sides of all vertices, and the faces that the plane crosses.
  void sort_vertices() {
    const double on = distance_on(plane_, step_.body());
    const Positions positions = mesh().positions();
    side_.resize(mesh().vertex_slots());
    for (uint32_t v = 0; v < side_.size(); ++v) {
      const double d = distance_from(plane_, positions[v]);
      if (!(std::abs(d) <= on)) side_[v] = d > 0 ? 1 : -1;
    }
    for (uint32_t slot = 0; slot < mesh().face_slots(); ++slot) {
      if (mesh().is_live(FaceId(slot)) && is_crossed(FaceId(slot))) crossed_.emplace_back(slot);
    }
  }
  bool is_crossed(FaceId f) const {
    const auto [a, b, c] = mesh().corners(f);
    const auto [low, high] = std::minmax({side(a), side(b), side(c)});
    return low < 0 && high > 0;
  }

  void split() {
    std::vector<FaceId> waiting(crossed_.rbegin(), crossed_.rend());
    std::vector<Mesh::FaceSplit> splits;
    while (!waiting.empty()) {
      const FaceId f = waiting.back();
      waiting.pop_back();
      const auto corners = mesh().corners(f);
      for (size_t i = 0; i < 3; ++i) {
        const VertexId from = corners[i], to = corners[(i + 1) % 3];
        if (side(from) * side(to) >= 0) continue;
        splits.clear();
        step_.edit.split_edge_at(f, from, to, plane_crossing(mesh(), plane_, {f, from, to}), splits);
        for (const Mesh::FaceSplit& s : splits) waiting.insert(waiting.end(), {s.kept, s.added});
        break;
      }
    }
  }

  // Returns 1 or -1, the side on which a face lies that the plane does not cross; 0 for a face in the plane
  // without area.
  int side(FaceId f) const {
    const auto [a, b, c] = mesh().corners(f);
    const auto [low, high] = std::minmax({side(a), side(b), side(c)});
    if (low != 0 || high != 0) return low + high;
    const Triangle t = mesh().triangle(f);
    const double facing = glm::dot(glm::cross(t[1] - t[0], t[2] - t[0]), plane_.normal);
    return facing > 0 ? -1 : facing < 0 ? 1 : 0;
  }
  // Likewise; a face without area takes the side of a neighbour.
  bool is_above(FaceId f) const {
    if (const int own = side(f); own != 0) return own > 0;
    std::vector<FaceId> neighbours;
    mesh().append_neighbours(f, neighbours);
    return std::ranges::any_of(neighbours, [&](FaceId n) { return side(n) > 0; });
  }

  // Finds the sides along edges that have faces on both sides of the plane.
  KnifeSides find_sides() const {
    KnifeSides found;
    std::vector<Mesh::Side> others;
    for (uint32_t slot = 0; slot < mesh().face_slots(); ++slot) {
      const FaceId f(slot);
      if (!mesh().is_live(f)) continue;
      const auto corners = mesh().corners(f);
      for (size_t i = 0; i < 3; ++i) {
        const VertexId from = corners[i], to = corners[(i + 1) % 3];
        if (side(from) != 0 || side(to) != 0) continue;
        others.clear();
        mesh().append_edge_sides(f, from, to, others);
        const bool above = is_above(f);
        if (std::ranges::any_of(others, [&](const Mesh::Side& s) { return is_above(s.face) != above; }))
          (above ? found.above : found.below).push_back({f, from, to});
      }
    }
    return found;
  }

  BodyStep& step_;
  WallPlane plane_;
  const Pegs& pegs_;
  std::vector<int8_t> side_;  // of the vertices before the cut: 1 above the plane, -1 below, 0 on it
  std::vector<FaceId> crossed_;
};

}  // namespace

// To bring a plane into the frame of a moved body cancels numbers of the size of its position.
double distance_on(const WallPlane& plane, const Body& body) {
  const Bounds bounds = body.bounds();
  const Vec3 largest = glm::max(glm::abs(bounds.min), glm::abs(bounds.max));
  const Vec3 in_world = body.placement.orientation * plane.normal;
  const double moved = 2 * glm::dot(glm::abs(in_world), glm::abs(body.placement.position));
  return kOnKnife * (glm::dot(glm::abs(plane.normal), largest) + std::abs(plane.distance) + moved);
}

Vec3 plane_crossing(const Mesh& mesh, const WallPlane& plane, const Mesh::Side& edge) {
  Vec3 a = mesh.position(edge.from), b = mesh.position(edge.to);
  if (lexicographic_less(b, a)) std::swap(a, b);
  double of_a = distance_from(plane, a), of_b = distance_from(plane, b);
  KERF_ASSERT((of_a < 0) != (of_b < 0));
  if (std::abs(of_b) < std::abs(of_a)) {
    std::swap(a, b);
    std::swap(of_a, of_b);
  }
  const Vec3 at = a + (b - a) * (of_a / (of_a - of_b));
  return apart_from(glm::clamp(at, glm::min(a, b), glm::max(a, b)), b, opposite_corners(mesh, edge));
}

std::vector<RimSide> open_sides(const Mesh& mesh, std::span<const Mesh::Side> sides,
                                std::vector<FaceId>& others) {
  std::vector<RimSide> found;
  std::vector<SheetSide> open;
  for (const Mesh::Side& s : sides) {
    open.clear();
    append_sheet_sides_of(mesh, s.face, open);
    const auto own = std::ranges::find_if(open, [&](const SheetSide& o) {
      return mesh.position(o.side.from) == mesh.position(s.from) &&
             mesh.position(o.side.to) == mesh.position(s.to);
    });
    if (own != open.end()) {
      found.push_back({s.face, own->side.from, own->side.to});
    } else {
      others.push_back(s.face);
    }
  }
  return found;
}

void add_section(BodyStep& step, const SectionWalls& walls) {
  const WallPatch& patch = walls.patch;
  KERF_ASSERT(patch.faces.size() == patch.wall_of_face.size());
  KERF_ASSERT(patch.sides.size() == patch.wall_of_side.size());
  std::vector<VertexId> vertices = patch.rim;
  for (const Vec3& p : patch.added) vertices.push_back(step.edit.add_vertex(p));
  FaceAddition addition(vertices, patch.faces);
  for (const auto& [at, other] : walls.welded) step.edit.weld(addition, at, other);
  std::vector<FaceId> beside;
  for (const uint32_t wall : patch.wall_of_face) beside.push_back(patch.beside_wall[wall]);
  step.edit.add_walls(addition, beside);
  step.edit.split_fans(addition, vertices.size());
  for (size_t i = 0; i < patch.sides.size(); ++i)
    step.edit.join_parts(patch.sides[i].face, patch.beside_wall[patch.wall_of_side[i]]);
}

Error too_many_knife_faces(size_t max_faces) {
  return failed("the cut would make more than " + std::to_string(max_faces) + " faces: simplify the mesh");
}

Result<StepResult> cut_with_plane(World& world, const KnifePlane& plane, std::span<const BodyId> bodies,
                                  size_t max_faces, const Progress* progress, const Pegs& pegs) {
  KERF_ASSERT(is_settled(world));
  KERF_ASSERT(pegs.count == 0 ||
              (pegs.count > 0 && pegs.diameter > 0 && pegs.depth > 0 && pegs.tolerance >= 0));
  // A crossed face becomes three, and a solid gets two walls of at most one face per crossed face.
  constexpr size_t kMaxNewFaces = 4;
  std::vector<BodyStep> steps;
  std::vector<KnifeCut> cuts;
  steps.reserve(bodies.size());
  for (const BodyId id : bodies) {
    if (progress && !progress->report(0)) return cancelled();
    BodyStep& step = steps.emplace_back(id, world.body(id));
    cuts.emplace_back(step, plane_in_body(plane, step.body().placement), pegs);
    const size_t of_pegs = 2 * 4 * static_cast<size_t>(pegs.count) * kPegSides;
    if (step.mesh().live_faces() + kMaxNewFaces * cuts.back().crossed() + of_pegs > max_faces)
      return failed("the cut would make more than " + std::to_string(max_faces) +
                    " faces: simplify the mesh");
  }
  StepResult result;
  for (size_t i = 0; i < steps.size(); ++i) {
    cuts[i].run(result.delta.left_open, result.delta.solid);
    separate(world, steps[i], {}, kNoLimit, EditPolicy::kNoEdits);
    end_step(steps[i], result);
  }
  apply_joints(world, result.delta);
  return result;
}

}  // namespace kerf
