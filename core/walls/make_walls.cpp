#include "core/walls/make_walls.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/assert.h"
#include "core/base/containers.h"
#include "core/base/tolerances.h"
#include "core/walls/chart_region_internal.h"
#include "core/walls/wall_chart_internal.h"
#include "core/walls/wall_mesh_internal.h"
#include "core/walls/wall_side_internal.h"

namespace kerf {

Task<std::optional<PatchFault>> fault_of(const WallPatch& patch, std::span<const PatchSide> rim) {
  const size_t vertices = patch.rim.size() + patch.added.size();
  const auto joins_rim = [&](const PatchSide& s) { return std::max(s.first, s.second) < patch.rim.size(); };
  KERF_ASSERT(std::ranges::all_of(rim, joins_rim));
  const SideIndex sides(patch.faces, vertices);
  co_await yield_after(patch.faces.size() / 16);
  std::vector<PatchSide> at_rim(rim.begin(), rim.end());
  std::sort(at_rim.begin(), at_rim.end());
  if (const auto twice = std::adjacent_find(at_rim.begin(), at_rim.end()); twice != at_rim.end())
    co_return PatchFault{"the rim runs along one edge twice", twice->first};
  co_await yield_after(rim.size() / 8);
  for (const PatchSide& s : at_rim) {
    if (!sides.find(s.first, s.second)) co_return PatchFault{"a part of the rim belongs to no wall", s.first};
  }
  for (uint32_t v = 0; v < vertices; ++v) {
    for (const SideIndex::Side& s : sides.from(v)) {
      if (sides.find(v, s.to) != &s) co_return PatchFault{"two walls meet in one edge", v};
      const bool is_inner = sides.find(s.to, v) != nullptr;
      const bool is_at_rim = v < patch.rim.size() && s.to < patch.rim.size() &&
                             std::binary_search(at_rim.begin(), at_rim.end(), PatchSide{v, s.to});
      if (is_at_rim == is_inner) co_return PatchFault{"a wall ends inside the part", v};
    }
    co_await yield_after(1);
  }
  co_return std::nullopt;
}

Task<Done> separate_walls(WallPatch& patch, std::span<const PatchSide> rim, std::span<const RimSide> sides) {
  KERF_ASSERT(rim.size() == sides.size());
  UnionFind together(patch.rim.size() + patch.added.size());
  for (const auto& f : patch.faces) {
    together.unite(f[0], f[1]);
    together.unite(f[1], f[2]);
    co_await yield_after(1);
  }
  std::map<uint32_t, uint32_t> number;
  for (size_t i = 0; i < sides.size(); ++i) {
    const auto [at, is_new] =
        number.try_emplace(together.find(rim[i].first), static_cast<uint32_t>(patch.beside_wall.size()));
    if (is_new) patch.beside_wall.push_back(sides[i].face);
    patch.wall_of_side.push_back(at->second);
    co_await yield_after(1);
  }
  for (const auto& f : patch.faces) {
    patch.wall_of_face.push_back(number.at(together.find(f[0])));
    co_await yield_after(1);
  }
  co_return Done{};
}

namespace {

// Max height of a triangle that is cut off the rim, in radii.
constexpr double kMaxCutHeight = 0.03;
// Min distance from the ends of the range in the chart of a vertex that is not at a corner, in radii.
constexpr double kWithinRange = 1e-6;
// Min length of an edge of a wall, in radii.
constexpr double kShortest = 1e-9;
// Max ratio of added vertices to vertices of the rim.
constexpr size_t kMaxAdded = 2;

// Max distance of the middle of an edge round an axis from its place in the chart, as a share of its length.
constexpr double kMaxAside = 0.15;

// Curve of vertices that are on no side.
constexpr uint32_t kNoCurve = 0xffffffffu;

// Returns true if a face belongs to the current solid.
using OwnFaces = std::function<bool(FaceId)>;

// Makes the walls of one solid, or of several whose walls do not meet.
class WallMaker {
 public:
  WallMaker(const Mesh& mesh, std::span<const RimSide> sides, const WallStroke& stroke,
            const SweptSides& swept, const OwnFaces& own)
      : mesh_(mesh),
        sides_(sides),
        stroke_(stroke),
        own_(own),
        reach_(swept.reach),
        pencil_(&swept.pencil),
        chart_(&swept.chart),
        ends_(swept.ends),
        depths_(swept.depths) {}

  Task<Result<WallPatch>> make() {
    co_await number_rim();
    if (const auto loose = loose_end())
      co_return left_open("the rim ends at an edge of three or more faces", rim_at(*loose));
    if (const Status placed = co_await place_rim(); !placed) co_return placed.error();
    for (uint32_t c = 0; c < chart_->curves(); ++c) {
      if (const Status made = co_await make_side(c); !made) co_return made.error();
    }
    for (const bool is_high : {false, true}) {
      if (const Status made = co_await make_cap(is_high); !made) co_return made.error();
    }
    const auto fault = co_await fault_of(patch_, rim_);
    if (fault) co_return left_open(fault->why, at(fault->vertex));
    co_await separate_walls(patch_, rim_, sides_);
    patch_.sides.assign(sides_.begin(), sides_.end());
    co_return std::move(patch_);
  }

 private:
  Vec3 rim_at(uint32_t i) const { return mesh_.position(patch_.rim[i]); }
  Vec3 at(uint32_t i) const {
    const auto rim = static_cast<uint32_t>(patch_.rim.size());
    return i < rim ? rim_at(i) : patch_.added[i - rim];
  }
  uint32_t add(const Vec3& p) {
    patch_.added.push_back(p);
    return static_cast<uint32_t>(patch_.rim.size() + patch_.added.size() - 1);
  }

  // Sides of the walls along the rim run opposite to those of the adjacent faces.
  Task<Done> number_rim() {
    patch_.rim = vertices_of(sides_);
    const auto index = [&](VertexId v) {
      return static_cast<uint32_t>(std::lower_bound(patch_.rim.begin(), patch_.rim.end(), v) -
                                   patch_.rim.begin());
    };
    co_await yield_after(sides_.size() / 4);
    for (const RimSide& s : sides_) {
      rim_.emplace_back(index(s.to), index(s.from));
      co_await yield_after(1);
    }
    co_return Done{};
  }

  // Returns a vertex at which the rim ends; nullopt if it consists of loops.
  std::optional<uint32_t> loose_end() const {
    std::vector<int> balance(patch_.rim.size());
    for (const auto& [from, to] : rim_) {
      ++balance[from];
      --balance[to];
    }
    const auto loose = std::ranges::find_if(balance, [](int b) { return b != 0; });
    if (loose == balance.end()) return std::nullopt;
    return static_cast<uint32_t>(loose - balance.begin());
  }

  Task<Status> place_rim() {
    std::vector<NearBoundary> near;
    for (uint32_t i = 0; i < patch_.rim.size(); ++i) {
      co_await yield_after(2);
      near.push_back(near_boundary(*chart_, ends_, rim_at(i), pencil_->see(rim_at(i)).depth, reach_));
      if (!near[i].place && near[i].end == BoundaryPart::kSide)
        co_return left_open("the rim leaves the sides of the beam", rim_at(i));
      places_.push_back(near[i].place.value_or(WallChart::Place{kNoCurve, 0, 0}));
    }
    std::vector<bool> on_side(patch_.rim.size());
    std::vector<BoundaryPart> on_end(patch_.rim.size(), BoundaryPart::kSide);
    for (const PatchSide& s : rim_) {
      const auto part = part_along(near[s.first], near[s.second]);
      if (!part) co_return left_open("the rim leaves the sides of the beam", rim_at(s.first));
      if (*part == BoundaryPart::kSide) rim_on_sides_.push_back(s);
      if (*part == BoundaryPart::kLowEnd) low_end_.push_back(s);
      if (*part == BoundaryPart::kHighEnd) high_end_.push_back(s);
      for (const uint32_t v : {s.first, s.second}) {
        if (*part == BoundaryPart::kSide) on_side[v] = true;
        if (*part != BoundaryPart::kSide) on_end[v] = *part;
      }
    }
    for (uint32_t i = 0; i < patch_.rim.size(); ++i) place_at_end(i, on_side[i], on_end[i]);
    co_await yield_after(rim_.size());
    co_return Done{};
  }

  // In the chart, a vertex at a corner lies on the end, and none beyond it.
  void place_at_end(uint32_t i, bool on_side, BoundaryPart on_end) {
    if (!on_side) {
      places_[i].curve = kNoCurve;
      return;
    }
    const double within = kWithinRange * stroke_.radius;
    if (ends_.low) places_[i].depth = std::max(places_[i].depth, *ends_.low + within);
    if (ends_.high) places_[i].depth = std::min(places_[i].depth, *ends_.high - within);
    if (on_end == BoundaryPart::kLowEnd) places_[i].depth = *ends_.low;
    if (on_end == BoundaryPart::kHighEnd) places_[i].depth = *ends_.high;
  }

  // A side with the patch indices of its vertices, those of the rim first.
  struct Side {
    WallSide wall;
    std::vector<uint32_t> of_patch;
  };

  // Returns the vertices and edges of the rim around a curve.
  Result<Side> side_of(uint32_t curve) const {
    Side side{WallSide(*chart_, curve, depths_), {}};
    std::vector<uint32_t> local(patch_.rim.size());
    for (uint32_t i = 0; i < patch_.rim.size(); ++i) {
      if (places_[i].curve != curve) continue;
      local[i] = side.wall.add_vertex(places_[i]);
      side.of_patch.push_back(i);
    }
    for (const auto& [from, to] : rim_on_sides_) {
      if (places_[from].curve != places_[to].curve)
        return left_open("the rim crosses from one side of the beam to another", rim_at(from));
      if (places_[from].curve == curve) side.wall.add_edge(local[from], local[to]);
    }
    return side;
  }

  // Adds the vertices along the ends to the patch.
  void add_new_vertices(Side& side) {
    for (size_t i = side.of_patch.size(); i < side.wall.places().size(); ++i)
      side.of_patch.push_back(add(chart_->point_at(side.wall.places()[i])));
  }

  // Records the sides that caps must close.
  void record_caps(const Side& side) {
    for (const bool is_high : {false, true}) {
      for (const auto& [from, to] : side.wall.cap(is_high))
        (is_high ? high_end_ : low_end_).emplace_back(side.of_patch[from], side.of_patch[to]);
    }
  }

  // Returns the winding number of the part around the end of a side, seen away from the beam.
  int winds_at(const Side& side, double depth, double sign) const {
    KERF_ASSERT(!side.wall.places().empty());
    WallChart::Place place = side.wall.places().front();
    place.depth = depth;
    int winding = 0;
    for (const auto& [face, sense] : stroke_.crossings(chart_->point_at(place), sign * pencil_->axis())) {
      if (own_(face)) winding += sense;
    }
    return winding;
  }

  // Returns the position of a vertex of a side, e.g. of the first in a conflict.
  Vec3 place_of(const Side& side, uint32_t v) const { return at(side.of_patch[v]); }
  Vec3 place_of(const Side& side, const std::vector<uint32_t>& conflict) const {
    return place_of(side, conflict.empty() ? 0 : conflict.front());
  }

  // Returns nullopt if edges cross; `conflict` then holds vertices of these.
  Task<std::optional<ChartRegion::Winding>> untangle_side(Side& side, std::vector<uint32_t>& conflict) {
    KERF_ASSERT(side.of_patch.size() == side.wall.placed().size());
    std::vector<Vec3> positions;
    for (const uint32_t i : side.of_patch) positions.push_back(at(i));
    RimInChart rim{side.wall.placed(), positions, std::move(side.wall.edges()), SideChart::kSize};
    std::vector<std::array<uint32_t, 3>> cut_off;
    const std::function<bool(uint32_t, uint32_t)> joined = [&](uint32_t a, uint32_t b) {
      return are_joined(side.of_patch[a], side.of_patch[b]);
    };
    const auto winding = co_await untangle(rim, kMaxCutHeight * stroke_.radius, joined, cut_off, conflict);
    side.wall.edges() = std::move(rim.edges);
    append_faces(side.of_patch, cut_off);
    co_return winding;
  }

  Task<Status> make_side(uint32_t curve) {
    Result<Side> found = side_of(curve);
    if (!found) co_return found.error();
    Side& side = *found;
    co_await yield_after(side.wall.edges().size());
    if (side.wall.edges().empty()) co_return Done{};
    Interval depths = depths_;
    if (ends_.low && !low_end_.empty()) depths.low = *ends_.low;
    if (ends_.high && !high_end_.empty()) depths.high = *ends_.high;
    side.wall.place_within(depths);
    uint32_t corner = 0;
    const auto low = ends_.low ? side.wall.close_between_corners(*ends_.low, false, corner) : false;
    const auto high = low && ends_.high ? side.wall.close_between_corners(*ends_.high, true, corner) : false;
    if (!low || !high)
      co_return left_open("the rim does not match at an end of the beam's range", place_of(side, corner));
    add_new_vertices(side);
    std::vector<uint32_t> conflict;
    const auto winding = co_await untangle_side(side, conflict);
    if (!winding) co_return left_open("the rim crosses itself", place_of(side, conflict));
    if (side.wall.edges().empty()) {
      record_caps(side);
      co_return Done{};
    }
    const int below = -winding->least, above = winding->above + below;
    const Vec3 here = place_of(side, winding->largest + below > 1 ? winding->largest_at : winding->least_at);
    if (below > (*high ? 0 : 1) || above < 0 || above > (*low ? 0 : 1) || winding->largest + below > 1)
      co_return left_open("the part intersects itself", here);
    if ((below > 0 && (!ends_.high || *ends_.high < depths.high)) ||
        (above > 0 && (!ends_.low || *ends_.low > depths.low)))
      co_return left_open(
          "the range of the beam ends inside the part at a depth that varies along the stroke", here);
    if ((below > 0 && winds_at(side, *ends_.high, 1) != 1) ||
        (above > 0 && winds_at(side, *ends_.low, -1) != 1))
      co_return left_open("the part is turned inside out, or not closed", here);
    if (below > 0) depths.high = *ends_.high;
    if (above > 0) depths.low = *ends_.low;
    if (below + above > 0) side.wall.place_within(depths);
    if (below > 0) side.wall.close_all_around(*ends_.high, true);
    if (above > 0) side.wall.close_all_around(*ends_.low, false);
    add_new_vertices(side);
    record_caps(side);
    co_return co_await triangulate(side);
  }

  // Returns a vertex at which two triangles have the same side, or one has a corner twice, as around a ring
  // with few corners; nullopt if there is none.
  static std::optional<uint32_t> meeting_vertex(std::span<const ChartTriangle> triangles, size_t vertices) {
    std::vector<WallMesh::Corners> corners;
    for (const ChartTriangle& t : triangles) corners.push_back(t.corners);
    const SideIndex sides(corners, vertices);
    const SideIndex::Side* const repeated = sides.find_repeated();
    if (repeated == nullptr) return std::nullopt;
    return repeated->to;
  }

  Task<Status> triangulate(const Side& side) {
    std::vector<uint32_t> conflict;
    const auto triangles =
        co_await ChartRegion(side.wall.placed(), side.wall.edges(), SideChart::kSize).triangles(&conflict);
    if (!triangles) co_return left_open("the rim crosses itself", place_of(side, conflict));
    if (const auto v = meeting_vertex(*triangles, side.wall.placed().size()))
      co_return left_open("the wall is so narrow that its edges meet", place_of(side, *v));
    co_await yield_after(triangles->size() / 8);
    // The chart may map several points to one place; the retry without vertices for shape may avoid these.
    Vec3 here = place_of(side, 0);
    for (const bool graded : {true, false}) {
      const std::optional<WallMesh> wall = co_await fill(side, *triangles, graded);
      if (!wall) break;
      const auto short_edge = wall->edge_below(kShortest * stroke_.radius);
      if (short_edge) {
        here = wall->vertices()[*short_edge].at;
      } else {
        append(side.of_patch, *wall);
        co_await yield_after(wall->triangles().size() / 4);
        co_return Done{};
      }
    }
    co_return left_open("the outline of the swept beam differs too much between depths of the part", here);
  }

  // Returns the wall between the vertices of the rim; nullopt if it would need too many further ones.
  Task<std::optional<WallMesh>> fill(const Side& side, std::span<const ChartTriangle> triangles,
                                     bool graded) const {
    std::vector<WallMesh::Vertex> vertices;
    for (size_t i = 0; i < side.wall.placed().size(); ++i)
      vertices.push_back({at(side.of_patch[i]), side.wall.placed()[i]});
    WallMesh wall(
        std::move(vertices), triangles, SideChart::kSize,
        [&](const WallMesh::Vertex& a, const WallMesh::Vertex& b) { return deviation(side, a, b); },
        kRimNear * stroke_.radius);
    co_await yield_after(triangles.size());
    co_await wall.improve();
    const size_t most = kMaxAdded * (side.wall.placed().size() + 1024);
    size_t added = 0;
    const WallMesh::Middle at_middle = [&](const ChartVertex& v) {
      return on_boundary(side.wall.side_chart().point(v));
    };
    const WallMesh::Middle at_next_middle = [&](const ChartVertex& v) {
      return added++ < most ? at_middle(v) : std::nullopt;
    };
    co_await wall.refine(at_next_middle);
    if (added > most) co_return std::nullopt;
    if (graded) co_await wall.grade(kRimLeastEdge * stroke_.radius, at_middle);
    const std::function<bool(uint32_t, uint32_t)> joined = [&](uint32_t a, uint32_t b) {
      return are_joined(side.of_patch[a], side.of_patch[b]);
    };
    co_await wall.split_between(static_cast<uint32_t>(side.of_patch.size()), joined, at_middle);
    co_return wall;
  }

  // Returns the deviation of the chord of an edge from the boundary (m).
  double deviation(const Side& side, const WallMesh::Vertex& a, const WallMesh::Vertex& b) const {
    if (glm::length(b.at - a.at) <= kRimLeastEdge * stroke_.radius) return 0;
    const Vec3 chord = 0.5 * (a.at + b.at);
    if (pencil_->parallel()) {
      // The point of the chart between the ends is not the nearest one.
      const double most =
          glm::length(side.wall.side_chart().point(SideChart::middle(a.chart, b.chart)) - chord);
      if (most <= kRimNear * stroke_.radius) return most;
    }
    const double off = std::abs(stroke_.distance(chord));
    if (pencil_->kind() != BeamPencil::Kind::kTurning) return off;
    // A chord may lie in a flat wall, but on another side of the axis.
    const double aside =
        glm::length(side.wall.side_chart().point(SideChart::middle(a.chart, b.chart)) - chord);
    return aside > kMaxAside * glm::length(b.at - a.at) + kMaxAside * stroke_.radius ? std::max(off, aside)
                                                                                     : off;
  }

  // Moves a point of the chart, which is exact only for parallel beams, onto the boundary.
  Vec3 on_boundary(Vec3 p) const {
    if (pencil_->parallel()) return p;
    const double step = kRimOn * stroke_.radius, exact = 0.01 * step;
    double d = stroke_.distance(p);
    Vec3 slope(0);
    for (int k = 0; k < 3 && std::abs(d) > exact; ++k) {
      Vec3 aside(0);
      aside[k] = step;
      slope[k] = (stroke_.distance(p + aside) - d) / step;
    }
    const double steepness2 = glm::dot(slope, slope);
    constexpr int kMaxSteps = 6;
    for (int i = 0; i < kMaxSteps && std::abs(d) > exact && steepness2 > 0.25; ++i) {
      p -= d / steepness2 * slope;
      d = stroke_.distance(p);
    }
    return p;
  }

  // Returns true if two vertices of the patch form an edge of the mesh.
  bool are_joined(uint32_t i, uint32_t k) const {
    if (std::max(i, k) >= patch_.rim.size()) return false;
    Mesh::Star star;
    mesh_.star(patch_.rim[i], star);
    return std::any_of(star.faces.begin(), star.faces.end(), [&](FaceId f) {
      const auto c = mesh_.corners(f);
      return std::find(c.begin(), c.end(), patch_.rim[k]) != c.end();
    });
  }

  void append(std::vector<uint32_t> of_patch, const WallMesh& wall) {
    KERF_ASSERT(of_patch.size() <= wall.vertices().size());
    for (size_t i = of_patch.size(); i < wall.vertices().size(); ++i)
      of_patch.push_back(add(wall.vertices()[i].at));
    append_faces(of_patch, wall.triangles());
  }

  void append_faces(const std::vector<uint32_t>& of_patch,
                    std::span<const std::array<uint32_t, 3>> triangles) {
    for (const auto& t : triangles) patch_.faces.push_back({of_patch[t[0]], of_patch[t[1]], of_patch[t[2]]});
  }

  // Makes the cap: the region of the plane at an end of the range that is bounded by the ends of the sides.
  // Its faces are counter-clockwise seen from the beam, i.e. from lower depths for the higher end.
  Task<Status> make_cap(bool is_high) {
    const std::vector<PatchSide>& sides = is_high ? high_end_ : low_end_;
    if (sides.empty()) co_return Done{};
    std::map<uint32_t, uint32_t> local;
    std::vector<uint32_t> of_patch;
    std::vector<Vec2> places;
    std::vector<Vec3> positions;
    for (const auto& [v, to] : sides) {
      if (!local.try_emplace(v, static_cast<uint32_t>(of_patch.size())).second) continue;
      const Vec2 place = pencil_->see(at(v)).place;
      of_patch.push_back(v);
      positions.push_back(at(v));
      places.emplace_back(place.x, is_high ? -place.y : place.y);
    }
    std::vector<PatchSide> bounds;
    for (const auto& [from, to] : sides) bounds.emplace_back(local.at(from), local.at(to));
    const double depth = is_high ? *ends_.high : *ends_.low;
    const std::function<Vec3(Vec2)> lift = [&](Vec2 p) {
      return pencil_->point({p.x, is_high ? -p.y : p.y}, depth);
    };
    uint32_t conflict = 0;
    const auto cap =
        co_await triangulate_cap(places, positions, bounds, kRimLeastEdge * stroke_.radius, lift, conflict);
    if (!cap)
      co_return left_open("the range of the beam ends in only a part of the kerf", positions[conflict]);
    append(of_patch, *cap);
    co_return Done{};
  }

  const Mesh& mesh_;
  std::span<const RimSide> sides_;
  const WallStroke& stroke_;
  const OwnFaces& own_;
  double reach_;  // m
  const BeamPencil* pencil_;
  const WallChart* chart_;
  RangeEnds ends_;
  Interval depths_;  // of the rim
  WallPatch patch_;
  std::vector<PatchSide> rim_;                 // sides of walls along the rim, in the order of sides_
  std::vector<PatchSide> rim_on_sides_;        // those along the sides of the beam
  std::vector<WallChart::Place> places_;       // by vertex of the rim
  std::vector<PatchSide> low_end_, high_end_;  // sides of caps, along the rim and along the ends of walls
};

}  // namespace

Task<MadeWalls> make_walls(const Mesh& mesh, std::span<const RimSide> sides, const WallStroke& stroke) {
  KERF_ASSERT(!sides.empty() && !stroke.moves.empty() && stroke.radius > 0);
  MadeWalls made;
  const std::vector<VertexId> vertices = vertices_of(sides);
  co_await yield_after(sides.size() / 4);
  const Result<SweptSides> swept = co_await swept_sides(mesh, vertices, stroke);
  if (!swept) {
    made.left_open.push_back(swept.error().message);
    co_return made;
  }
  const OwnFaces all = [](FaceId) { return true; };
  WallMaker together(mesh, sides, stroke, *swept, all);
  Result<WallPatch> whole = co_await together.make();
  if (whole) {
    made.patches.push_back(std::move(*whole));
    co_return made;
  }
  const std::vector<uint32_t> part_of_face = co_await stroke.parts();
  const auto groups = co_await group_rims(mesh, sides, part_of_face, stroke, *swept);
  if (groups.size() == 1) {
    made.left_open.push_back(whole.error().message);
    co_return made;
  }
  for (const std::vector<RimSide>& group : groups) {
    std::vector<uint32_t> parts;
    for (const RimSide& s : group) parts.push_back(part_of_face[s.face.index]);
    std::sort(parts.begin(), parts.end());
    parts.erase(std::unique(parts.begin(), parts.end()), parts.end());
    const OwnFaces own = [&](FaceId f) {
      return std::binary_search(parts.begin(), parts.end(), part_of_face[f.index]);
    };
    WallMaker one(mesh, group, stroke, *swept, own);
    Result<WallPatch> patch = co_await one.make();
    if (patch) {
      made.patches.push_back(std::move(*patch));
    } else {
      made.left_open.push_back(patch.error().message);
    }
  }
  co_return made;
}

}  // namespace kerf
