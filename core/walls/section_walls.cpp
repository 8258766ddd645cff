#include "core/walls/section_walls.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <tuple>

#include "core/base/assert.h"
#include "core/base/containers.h"
#include "core/base/deterministic_math.h"
#include "core/mesh/files/triangulation.h"
#include "core/mesh/weld.h"
#include "core/walls/wall_mesh_internal.h"
#include "core/walls/wall_side_internal.h"

namespace kerf {

namespace {

constexpr uint32_t kNoSuccessor = 0xffffffffu;

using Faces = std::vector<std::array<uint32_t, 3>>;

// A closed chain of sides, in the direction of the walls, i.e. opposite to the sides.
struct SectionLoop {
  std::vector<uint32_t> sides;
  Vec2 low{std::numeric_limits<double>::infinity()}, high{-std::numeric_limits<double>::infinity()};
};

bool boxes_meet(const SectionLoop& a, const SectionLoop& b) {
  return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y;
}

// The projection of a plane along the coordinate axis nearest to its normal, which preserves the orientation
// of faces with this normal.
struct Projection {
  explicit Projection(const Vec3& normal) {
    int axis = 0;
    for (int k = 1; k < 3; ++k) {
      if (std::abs(normal[k]) > std::abs(normal[axis])) axis = k;
    }
    first = (axis + 1) % 3;
    second = (axis + 2) % 3;
    if (normal[axis] < 0) std::swap(first, second);
  }
  Vec2 operator()(const Vec3& p) const { return {p[first], p[second]}; }

  int first = 0, second = 0;  // axes
};

class SectionMaker {
 public:
  SectionMaker(const Mesh& mesh, std::span<const RimSide> sides, const WallPlane& plane,
               std::span<const SectionPeg> pegs)
      : mesh_(mesh), sides_(sides), plane_(plane), pegs_(pegs), flat_(plane.normal) {}

  Section make(bool closes) {
    trace();
    if (!closes) {
      section_.left_open.clear();
      return std::move(section_);
    }
    std::map<uint32_t, std::vector<uint32_t>> of_piece;
    for (uint32_t i = 0; i < loops_.size(); ++i)
      of_piece[mesh_.data(sides_[loops_[i].sides[0]].face).piece].push_back(i);
    for (const auto& [piece, loops] : of_piece) close(loops);
    return std::move(section_);
  }

 private:
  Vec3 start_of(uint32_t side) const { return mesh_.position(sides_[side].to); }

  // Divides the sides into chains, each of which follows the boundary of one sheet.
  void trace() {
    find_successors();
    std::vector<bool> has_predecessor(sides_.size()), is_traced(sides_.size());
    for (const uint32_t next : next_) {
      if (next != kNoSuccessor) has_predecessor[next] = true;
    }
    for (const bool is_loop : {false, true}) {
      for (uint32_t i = 0; i < sides_.size(); ++i) {
        if (is_traced[i] || (!is_loop && has_predecessor[i])) continue;
        SectionLoop chain;
        for (uint32_t at = i; at != kNoSuccessor && !is_traced[at]; at = next_[at]) {
          is_traced[at] = true;
          chain.sides.push_back(at);
          chain.low = glm::min(chain.low, flat_(start_of(at)));
          chain.high = glm::max(chain.high, flat_(start_of(at)));
        }
        record(std::move(chain), is_loop);
      }
    }
  }
  void find_successors() {
    std::vector<std::pair<VertexId, uint32_t>> starts;
    for (uint32_t i = 0; i < sides_.size(); ++i) starts.emplace_back(sides_[i].to, i);
    std::sort(starts.begin(), starts.end());
    for (const RimSide& side : sides_) {
      const auto next = std::lower_bound(starts.begin(), starts.end(), std::pair(side.from, 0u));
      next_.push_back(next != starts.end() && next->first == side.from ? next->second : kNoSuccessor);
    }
  }
  void record(SectionLoop chain, bool is_loop) {
    section_.seeds.push_back(sides_[chain.sides[0]].face);
    if (is_loop && chain.sides.size() >= 3) {
      loops_.push_back(std::move(chain));
    } else {
      section_.left_open.push_back(left_open("the section does not close", start_of(chain.sides[0])).message);
    }
  }

  // Closes loops of one piece together if they do not cross; otherwise those whose boxes meet, or each one.
  void close(const std::vector<uint32_t>& loops) {
    if (std::optional<SectionWalls> walls = cap(loops)) {
      section_.pegs += walls->patch.added.size() / (2 * kPegSides);
      section_.walls.push_back(std::move(*walls));
      return;
    }
    const std::vector<std::vector<uint32_t>> groups = groups_of(loops);
    for (const std::vector<uint32_t>& group : groups) {
      if (groups.size() > 1) {
        close(group);
      } else {
        for (const uint32_t loop : group) section_.walls.push_back(clip_ears(loops_[loop]));
      }
    }
  }
  std::vector<std::vector<uint32_t>> groups_of(const std::vector<uint32_t>& loops) const {
    UnionFind together(loops.size());
    for (uint32_t i = 0; i < loops.size(); ++i) {
      for (uint32_t k = 0; k < i; ++k) {
        if (boxes_meet(loops_[loops[i]], loops_[loops[k]])) together.unite(i, k);
      }
    }
    std::map<uint32_t, std::vector<uint32_t>> groups;
    for (uint32_t i = 0; i < loops.size(); ++i) groups[together.find(i)].push_back(loops[i]);
    std::vector<std::vector<uint32_t>> all;
    for (auto& [first, group] : groups) all.push_back(std::move(group));
    return all;
  }

  std::optional<SectionWalls> cap(const std::vector<uint32_t>& loops) const {
    SectionWalls made;
    WallPatch& patch = made.patch;
    for (const uint32_t loop : loops) {
      for (const uint32_t side : loops_[loop].sides) patch.sides.push_back(sides_[side]);
    }
    const std::vector<VertexId> vertices = vertices_of(patch.sides);
    std::vector<Vec3> positions, at;
    for (const VertexId v : vertices) positions.push_back(mesh_.position(v));
    const std::vector<uint32_t> first = weld_positions(positions);
    std::vector<uint32_t> number(vertices.size());
    for (uint32_t i = 0; i < vertices.size(); ++i) {
      if (first[i] != i) {
        number[i] = number[first[i]];
        made.welded.emplace_back(number[i], vertices[i]);
        continue;
      }
      number[i] = static_cast<uint32_t>(at.size());
      patch.rim.push_back(vertices[i]);
      at.push_back(positions[i]);
    }
    const auto numbered = [&](VertexId v) {
      return number[static_cast<size_t>(std::ranges::lower_bound(vertices, v) - vertices.begin())];
    };
    std::vector<PatchSide> rim;
    for (const RimSide& side : patch.sides) rim.emplace_back(numbered(side.to), numbered(side.from));
    std::vector<PatchSide> border = rim;
    const std::vector<uint32_t> rings = add_rings(loops, patch, at, border);
    KERF_ASSERT(at.size() == patch.rim.size() + patch.added.size() / 2);
    auto faces = triangulate_section(at, border, plane_.normal);
    if (!faces) return std::nullopt;
    patch.faces = std::move(*faces);
    for (const uint32_t ring : rings) add_peg_faces(ring, patch);
    if (run_to_completion(fault_of(patch, rim))) return std::nullopt;
    run_to_completion(separate_walls(patch, rim, patch.sides));
    return made;
  }

  // Returns true if a point of the plane lies within loops, by the even-odd rule.
  bool is_within(const std::vector<uint32_t>& loops, const Vec3& point) const {
    const Vec2 p = flat_(point);
    bool inside = false;
    for (const uint32_t loop : loops) {
      for (const uint32_t side : loops_[loop].sides) {
        const Vec2 a = flat_(mesh_.position(sides_[side].from)), b = flat_(mesh_.position(sides_[side].to));
        if ((a.y > p.y) == (b.y > p.y)) continue;
        if ((cross2(b - a, p - a) > 0) == (b.y > a.y)) inside = !inside;
      }
    }
    return inside;
  }

  // Adds the corners of the pegs within loops, in the plane to `at` and at both ends to the patch, and their
  // sides in the plane to `border`, clockwise seen against the normal. Returns the first corner of each.
  std::vector<uint32_t> add_rings(const std::vector<uint32_t>& loops, WallPatch& patch, std::vector<Vec3>& at,
                                  std::vector<PatchSide>& border) const {
    std::vector<const SectionPeg*> within;
    for (const SectionPeg& peg : pegs_) {
      if (is_within(loops, peg.centre)) within.push_back(&peg);
    }
    const Vec3 size = glm::abs(plane_.normal);
    const Vec3 least = size.x <= size.y && size.x <= size.z ? Vec3(1, 0, 0)
                       : size.y <= size.z                   ? Vec3(0, 1, 0)
                                                            : Vec3(0, 0, 1);
    // Planes of opposite normals have the same corners, because their number is even.
    const Vec3 u = glm::normalize(glm::cross(plane_.normal, least)), v = glm::cross(plane_.normal, u);
    std::vector<uint32_t> rings;
    for (const SectionPeg* peg : within) {
      const auto first = static_cast<uint32_t>(at.size());
      rings.push_back(first);
      for (uint32_t k = 0; k < kPegSides; ++k) {
        const auto [sin, cos] = sin_cos(2 * kPi * k / kPegSides);
        patch.added.push_back(peg->centre + peg->radius * (cos * u + sin * v));
        at.push_back(patch.added.back());
        border.emplace_back(first + (k + 1) % kPegSides, first + k);
      }
    }
    for (const SectionPeg* peg : within) {
      for (uint32_t k = 0; k < kPegSides; ++k) {
        const auto [sin, cos] = sin_cos(2 * kPi * k / kPegSides);
        patch.added.push_back(peg->centre + peg->radius * (cos * u + sin * v) + peg->height * plane_.normal);
      }
    }
    return rings;
  }

  // Adds the sides and the end of the peg whose corners in the plane begin at `ring`.
  static void add_peg_faces(uint32_t ring, WallPatch& patch) {
    const auto end = static_cast<uint32_t>(ring + patch.added.size() / 2);
    for (uint32_t k = 0; k < kPegSides; ++k) {
      const uint32_t next = (k + 1) % kPegSides;
      patch.faces.push_back({ring + k, ring + next, end + next});
      patch.faces.push_back({ring + k, end + next, end + k});
      if (k > 0 && next > 0) patch.faces.push_back({end, end + k, end + next});
    }
  }

  SectionWalls clip_ears(const SectionLoop& loop) const {
    KERF_ASSERT(loop.sides.size() >= 3);
    SectionWalls made;
    WallPatch& patch = made.patch;
    std::vector<Vec2> points;
    for (const uint32_t side : loop.sides) {
      patch.sides.push_back(sides_[side]);
      patch.rim.push_back(sides_[side].to);
      points.push_back(flat_(start_of(side)));
    }
    double area = 0;
    for (size_t i = 1; i + 1 < points.size(); ++i)
      area += cross2(points[i] - points[0], points[i + 1] - points[0]);
    if (area < 0) std::reverse(points.begin(), points.end());
    EarClipper().clip(points, patch.faces);
    const auto last = static_cast<uint32_t>(points.size() - 1);
    for (auto& [a, b, c] : patch.faces) {
      if (area < 0) std::tie(a, b, c) = std::tuple(last - c, last - b, last - a);
    }
    patch.wall_of_face.assign(patch.faces.size(), 0);
    patch.wall_of_side.assign(patch.sides.size(), 0);
    patch.beside_wall = {patch.sides[0].face};
    return made;
  }

  const Mesh& mesh_;
  std::span<const RimSide> sides_;
  const WallPlane& plane_;
  std::span<const SectionPeg> pegs_;
  Projection flat_;
  std::vector<uint32_t> next_;  // by side: the following one of its wall
  std::vector<SectionLoop> loops_;
  Section section_;
};

// Replaces sides that are shorter than the grid of triangulate_cap() resolves, each with the side after it,
// by the third side of a face, which is appended to `faces`. Returns false if a side has no single side after
// it, or if none is so short.
bool cut_off_short_sides(std::span<const Vec2> places, std::vector<PatchSide>& sides, Faces& faces) {
  constexpr double kCells = 4, kGrid = 0x1p30;
  Vec2 low = places[0], high = places[0];
  for (const Vec2 p : places) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  const double least = kCells * std::max(high.x - low.x, high.y - low.y) / kGrid;
  std::map<uint32_t, std::vector<size_t>> from;
  for (size_t i = 0; i < sides.size(); ++i) from[sides[i].first].push_back(i);
  std::vector<bool> is_cut_off(sides.size(), false);
  for (size_t i = 0; i < sides.size(); ++i) {
    while (!is_cut_off[i]) {
      const auto [a, b] = sides[i];
      const Vec2 reach = glm::abs(places[b] - places[a]);
      if (std::max(reach.x, reach.y) > least) break;
      std::vector<size_t>& next = from[b];
      if (next.size() != 1 || next[0] == i || sides[next[0]].second == a) return false;
      faces.push_back({a, b, sides[next[0]].second});
      sides[i].second = sides[next[0]].second;
      is_cut_off[next[0]] = true;
      next.clear();
    }
  }
  std::vector<PatchSide> kept;
  for (size_t i = 0; i < sides.size(); ++i) {
    if (!is_cut_off[i]) kept.push_back(sides[i]);
  }
  sides = std::move(kept);
  return !faces.empty();
}

std::optional<Faces> triangulate(std::span<const Vec3> at, std::span<const Vec2> places,
                                 std::span<const PatchSide> sides) {
  if (std::ranges::any_of(sides, [&](const PatchSide& s) { return places[s.first] == places[s.second]; }))
    return std::nullopt;
  constexpr double kNoGrading = std::numeric_limits<double>::infinity();
  const std::function<Vec3(Vec2)> no_vertex = [](Vec2) { return Vec3(0); };
  uint32_t conflict = 0;
  const std::optional<WallMesh> mesh =
      run_to_completion(triangulate_cap(places, at, sides, kNoGrading, no_vertex, conflict));
  if (!mesh || mesh->vertices().size() != places.size()) return std::nullopt;
  return mesh->triangles();
}

// Returns only the places that sides name, and numbers the sides by them.
std::vector<uint32_t> renumber(std::vector<PatchSide>& sides) {
  std::map<uint32_t, uint32_t> number;
  for (const auto& [a, b] : sides) number.emplace(a, 0);
  std::vector<uint32_t> used;
  for (auto& [place, own] : number) {
    own = static_cast<uint32_t>(used.size());
    used.push_back(place);
  }
  for (auto& [a, b] : sides) a = number.at(a), b = number.at(b);
  return used;
}

}  // namespace

std::optional<std::vector<std::array<uint32_t, 3>>> triangulate_section(std::span<const Vec3> at,
                                                                        std::span<const PatchSide> sides,
                                                                        const Vec3& normal) {
  KERF_ASSERT(!sides.empty());
  const Projection flat(normal);
  std::vector<Vec2> places;
  for (const Vec3& p : at) places.push_back(flat(p));
  if (auto faces = triangulate(at, places, sides)) return faces;
  Faces thin;
  std::vector<PatchSide> longer(sides.begin(), sides.end());
  if (!cut_off_short_sides(places, longer, thin)) return std::nullopt;
  const std::vector<uint32_t> used = renumber(longer);
  std::vector<Vec3> used_at;
  std::vector<Vec2> used_places;
  for (const uint32_t place : used) {
    used_at.push_back(at[place]);
    used_places.push_back(places[place]);
  }
  const auto faces = triangulate(used_at, used_places, longer);
  if (!faces) return std::nullopt;
  for (const auto& [a, b, c] : *faces) thin.push_back({used[a], used[b], used[c]});
  return thin;
}

Section make_section(const Mesh& mesh, std::span<const RimSide> sides, const WallPlane& plane, bool closes,
                     std::span<const SectionPeg> pegs) {
  KERF_ASSERT(is_unit(plane.normal));
  return SectionMaker(mesh, sides, plane, pegs).make(closes);
}

}  // namespace kerf
