#include "core/walls/make_walls.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <sstream>

#include "core/base/angle.h"
#include "core/base/assert.h"
#include "core/base/tolerances.h"
#include "core/base/union_find.h"
#include "core/walls/chart_region.h"
#include "core/walls/wall_chart.h"
#include "core/walls/wall_mesh.h"

namespace kerf {

namespace {

// The width of a chart and the largest y.
constexpr int64_t kChartSize = int64_t{1} << 30;
// How far a vertex of the rim may lie from the outline, relative to the radius: by the errors that the rim
// may have, and for beams through an apex also by what the inclined beam's ellipse differs from a circle.
constexpr double kReachParallel = 0.03, kReachFan = 0.3;
// Two corners of the end of a wall, as seen from the middle of an arc: their chord lies kRimChord from it.
constexpr double kTurnOfEnd = 0.0979;
// // A triangle that is cut off the rim is no higher, relative to the radius.
constexpr double kHighestCut = 0.03;
// How often a wall may have more vertices than its rim.
constexpr size_t kMostAdded = 2;

std::string at_place(const Vec3& p) {
  std::ostringstream text;
  text.precision(3);
  text << " near (" << p.x << ", " << p.y << ", " << p.z << ") m";
  return text.str();
}

Error left_open(const char* why, const Vec3& p) { return failed(why + at_place(p)); }

// A side of the walls, as indices of vertices of the patch.
using PatchSide = std::pair<uint32_t, uint32_t>;

class WallMaker {
 public:
  WallMaker(const Mesh& mesh, std::span<const RimSide> sides, const WallStroke& stroke)
      : mesh_(mesh), sides_(sides), stroke_(stroke) {}

  Result<WallPatch> make() {
    number_rim();
    pencil_ = BeamPencil::of(stroke_.moves, stroke_.radius);
    if (!pencil_) return left_open("the beam turned about no single point", rim_at(0));
    measure_depths();
    chart_ = WallChart::make(*pencil_, stroke_.moves, stroke_.radius, depths_);
    if (!chart_) return left_open("the sides of the beam at different depths do not correspond", rim_at(0));
    if (const Status placed = place_rim(); !placed) return placed.error();
    for (uint32_t c = 0; c < chart_->curves(); ++c) {
      if (const Status made = make_side(c); !made) return made.error();
    }
    for (const std::vector<PatchSide>* end : {&low_end_, &high_end_}) {
      if (const Status made = make_cap(*end, end == &high_end_); !made) return made.error();
    }
    if (const Status whole = check(); !whole) return whole.error();
    tell_walls_apart();
    return std::move(patch_);
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

  // The sides of the walls along the rim run against those of the faces there.
  void number_rim() {
    for (const RimSide& s : sides_) {
      patch_.rim.push_back(s.from);
      patch_.rim.push_back(s.to);
    }
    std::sort(patch_.rim.begin(), patch_.rim.end());
    patch_.rim.erase(std::unique(patch_.rim.begin(), patch_.rim.end()), patch_.rim.end());
    const auto index = [&](VertexId v) {
      return static_cast<uint32_t>(std::lower_bound(patch_.rim.begin(), patch_.rim.end(), v) -
                                   patch_.rim.begin());
    };
    for (const RimSide& s : sides_) rim_.emplace_back(index(s.to), index(s.from));
  }

  void measure_depths() {
    depths_ = {pencil_->see(rim_at(0)).depth, pencil_->see(rim_at(0)).depth};
    for (uint32_t i = 1; i < patch_.rim.size(); ++i) {
      const double depth = pencil_->see(rim_at(i)).depth;
      depths_ = {std::min(depths_.low, depth), std::max(depths_.high, depth)};
    }
  }

  Status place_rim() {
    const double reach = stroke_.radius * (pencil_->parallel() ? kReachParallel : kReachFan);
    for (uint32_t i = 0; i < patch_.rim.size(); ++i) {
      const auto place = chart_->place_of(rim_at(i), reach);
      if (!place) return left_open("the rim leaves the sides of the beam", rim_at(i));
      places_.push_back(*place);
    }
    return Done{};
  }

  // The depth at which the range of the beam begins or ends, the same for all moves; nothing if there is
  // none.
  std::optional<double> end_of_range(double along) const {
    if (!pencil_->parallel()) return std::nullopt;
    const auto depth_of = [&](const Pose& p) { return pencil_->see(p.origin).depth + along; };
    const double depth = depth_of(stroke_.moves.front().from);
    for (const BeamMove& m : stroke_.moves) {
      for (const Pose* p : {&m.from, &m.to}) {
        if (std::abs(depth_of(*p) - depth) > kRimOn * stroke_.radius) return std::nullopt;
      }
    }
    return depth;
  }

  // Beams through an apex see straight lines as such where depth is measured by its reciprocal.
  double height(double depth) const { return pencil_->parallel() ? -depth : 1 / depth; }
  double depth_at(double height) const { return pencil_->parallel() ? -height : 1 / height; }

  // The chart of one curve in whole numbers. The beam is on the left of the outline, so that with y against
  // the depth, walls whose outside faces the beam are counter-clockwise.
  struct Side {
    uint32_t curve = 0;
    double lowest = 0, scale = 1;     // of heights
    std::vector<uint32_t> of_patch;   // vertices by local number; those of the rim come first
    std::vector<ChartVertex> placed;  // by local number
    std::vector<ChartEdge> edges;
  };

  int64_t y_of(const Side& side, double depth) const {
    return static_cast<int64_t>((height(depth) - side.lowest) * side.scale + 0.5);
  }
  int64_t x_of(const Side& side, double around) const {
    const double share = around / chart_->period(side.curve);
    return std::min(static_cast<int64_t>(share * static_cast<double>(kChartSize)), kChartSize - 1);
  }
  WallChart::Place place_of(const Side& side, const ChartVertex& v) const {
    const double around =
        static_cast<double>(v.x) / static_cast<double>(kChartSize) * chart_->period(side.curve);
    return {side.curve, around, depth_at(side.lowest + static_cast<double>(v.y) / side.scale)};
  }

  void scale(Side& side, Interval depths) const {
    const double low = std::min(height(depths.low), height(depths.high));
    const double high = std::max(height(depths.low), height(depths.high));
    side.lowest = low;
    side.scale = high > low ? static_cast<double>(kChartSize - 2) / (high - low) : 1;
  }

  // By how much x grows along an edge of the rim, which goes the shorter way around the beam.
  static int64_t x_between(const ChartVertex& from, const ChartVertex& to) {
    const int64_t way = to.x - from.x;
    if (way > kChartSize / 2) return way - kChartSize;
    return way < -kChartSize / 2 ? way + kChartSize : way;
  }

  // The edges of a curve along the rim.
  Status place_edges(Side& side, Interval depths) const {
    scale(side, depths);
    side.of_patch.clear();
    side.placed.clear();
    side.edges.clear();
    std::vector<uint32_t> local(patch_.rim.size());
    for (uint32_t i = 0; i < patch_.rim.size(); ++i) {
      if (places_[i].curve != side.curve) continue;
      local[i] = static_cast<uint32_t>(side.placed.size());
      side.of_patch.push_back(i);
      side.placed.push_back({x_of(side, places_[i].around), y_of(side, places_[i].depth)});
    }
    for (const auto& [from, to] : rim_) {
      if (places_[from].curve != places_[to].curve)
        return left_open("the rim crosses from one side of the beam to another", rim_at(from));
      if (places_[from].curve != side.curve) continue;
      side.edges.push_back(
          {local[from], local[to], x_between(side.placed[local[from]], side.placed[local[to]])});
    }
    return Done{};
  }

  // Closes a side where the range of the beam ends in the solid.
  void add_end(Side& side, double depth, bool is_high) {
    const auto first = static_cast<uint32_t>(side.placed.size());
    for (const double around : chart_->corners(side.curve, kTurnOfEnd)) {
      side.of_patch.push_back(add(chart_->point_at({side.curve, around, depth})));
      side.placed.push_back({x_of(side, around), y_of(side, depth)});
    }
    const auto end = static_cast<uint32_t>(side.placed.size());
    std::vector<PatchSide>& sides = is_high ? high_end_ : low_end_;
    for (uint32_t i = first; i < end; ++i) {
      const uint32_t next = i + 1 < end ? i + 1 : first;
      int64_t dx = side.placed[next].x - side.placed[i].x;
      if (dx < 0) dx += kChartSize;
      if (is_high) {
        side.edges.push_back({i, next, dx});
        sides.emplace_back(side.of_patch[next], side.of_patch[i]);
      } else {
        side.edges.push_back({next, i, -dx});
        sides.emplace_back(side.of_patch[i], side.of_patch[next]);
      }
    }
  }

  // How often the part winds around the end of a side, as seen away from the beam.
  int winds_at(const Side& side, double depth, double sign) const {
    const WallChart::Place& place = places_[side.of_patch.front()];
    return stroke_.winding(chart_->point_at({side.curve, place.around, depth}), sign * pencil_->axis());
  }

  // The windings of the edges around the points of the chart. The rim may be off the boundary by a little,
  // and
  // its edges are chords: where some cross or touch, small triangles are cut off at vertices there, which
  // become faces of the wall. Nothing where that does not help.
  std::optional<ChartRegion::Winding> untangle(Side& side) {
    constexpr int kMostCuts = 256;
    std::vector<uint32_t> conflict;
    for (int i = 0; i < kMostCuts; ++i) {
      const auto winding = ChartRegion(side.placed, side.edges, kChartSize).winding(&conflict);
      if (winding || !cut_off_smallest(side, conflict)) return winding;
    }
    return std::nullopt;
  }

  // The edges before and after a vertex through which the rim goes once.
  struct Passage {
    size_t in, out;
  };
  static std::optional<Passage> passage(const Side& side, uint32_t v) {
    std::optional<size_t> in, out;
    for (size_t i = 0; i < side.edges.size(); ++i) {
      for (const auto& [end, edge] :
           {std::pair(side.edges[i].to, &in), std::pair(side.edges[i].from, &out)}) {
        if (end != v) continue;
        if (*edge) return std::nullopt;
        *edge = i;
      }
    }
    if (!in || !out) return std::nullopt;
    return Passage{*in, *out};
  }

  bool cut_off_smallest(Side& side, const std::vector<uint32_t>& vertices) {
    const double most = kHighestCut * stroke_.radius;
    std::optional<Passage> best;
    double least = std::numeric_limits<double>::infinity();
    for (const uint32_t v : vertices) {
      const auto p = passage(side, v);
      if (!p) continue;
      const uint32_t a = side.of_patch[side.edges[p->in].from], c = side.of_patch[side.edges[p->out].to];
      if (a == c) continue;
      const Triangle t{rim_at(a), rim_at(side.of_patch[v]), rim_at(c)};
      const double area = triangle_area(t), height = 2 * area / std::sqrt(longest_edge2(t));
      if (!(height <= most) || !(area < least)) continue;
      if (are_joined(patch_.rim[a], patch_.rim[c]) && !closes(side, *p)) continue;
      best = p;
      least = area;
    }
    if (best) cut_off(side, *best);
    return best.has_value();
  }

  // The edge from the end of a passage to its start, which makes a triangle of the three.
  static std::optional<size_t> closes(const Side& side, const Passage& p) {
    for (size_t i = 0; i < side.edges.size(); ++i) {
      if (side.edges[i].from == side.edges[p.out].to && side.edges[i].to == side.edges[p.in].from) return i;
    }
    return std::nullopt;
  }

  void cut_off(Side& side, const Passage& p) {
    ChartEdge &in = side.edges[p.in], &out = side.edges[p.out];
    patch_.faces.push_back({side.of_patch[in.from], side.of_patch[in.to], side.of_patch[out.to]});
    std::vector<size_t> gone{p.out};
    if (const auto third = closes(side, p)) {
      gone.insert(gone.end(), {p.in, *third});
    } else {
      in.dx += out.dx;
      in.to = out.to;
    }
    std::sort(gone.begin(), gone.end());
    for (size_t i = gone.size(); i-- > 0;)
      side.edges.erase(side.edges.begin() + static_cast<std::ptrdiff_t>(gone[i]));
  }

  // Places the vertices in a chart of other depths.
  void place_again(Side& side, Interval depths) const {
    scale(side, depths);
    for (size_t i = 0; i < side.placed.size(); ++i)
      side.placed[i].y = y_of(side, places_[side.of_patch[i]].depth);
  }

  Status make_side(uint32_t curve) {
    Side side;
    side.curve = curve;
    if (const Status placed = place_edges(side, depths_); !placed) return placed.error();
    if (side.edges.empty()) return Done{};
    const Vec3 here = rim_at(side.of_patch.front());
    const auto winding = untangle(side);
    if (!winding) return left_open("the rim crosses itself", here);
    if (side.edges.empty()) return Done{};
    const int below = -winding->least, above = winding->above + below;
    if (below > 1 || above < 0 || above > 1 || winding->largest + below > 1)
      return left_open("the part passes through itself", here);
    Interval depths = depths_;
    const auto low = end_of_range(stroke_.range.low), high = end_of_range(stroke_.range.high);
    if ((below > 0 && (!high || *high < depths.high)) || (above > 0 && (!low || *low > depths.low)))
      return left_open("the range of the beam ends in the part at no single depth", here);
    if ((below > 0 && winds_at(side, *high, 1) != 1) || (above > 0 && winds_at(side, *low, -1) != 1))
      return left_open("the part is turned inside out, or not closed", here);
    if (below > 0) depths.high = *high;
    if (above > 0) depths.low = *low;
    if (below + above > 0) {
      place_again(side, depths);
      if (below > 0) add_end(side, *high, true);
      if (above > 0) add_end(side, *low, false);
    }
    return triangulate(side, here);
  }

  // Whether two triangles have the same side, or one has a corner twice, as around a ring with few corners.
  static bool meet_twice(std::span<const ChartTriangle> triangles) {
    std::vector<PatchSide> sides;
    for (const ChartTriangle& t : triangles) {
      for (size_t i = 0; i < 3; ++i) {
        if (t.corners[i] == t.corners[(i + 1) % 3]) return true;
        sides.emplace_back(t.corners[i], t.corners[(i + 1) % 3]);
      }
    }
    std::sort(sides.begin(), sides.end());
    return std::adjacent_find(sides.begin(), sides.end()) != sides.end();
  }

  Status triangulate(const Side& side, const Vec3& here) {
    const auto triangles = ChartRegion(side.placed, side.edges, kChartSize).triangles();
    if (!triangles) return left_open("the rim crosses itself", here);
    if (meet_twice(*triangles)) return left_open("the wall is so narrow that its edges meet", here);
    std::vector<WallMesh::Vertex> vertices;
    for (size_t i = 0; i < side.placed.size(); ++i)
      vertices.push_back({at(side.of_patch[i]), side.placed[i]});
    WallMesh wall(
        std::move(vertices), *triangles, kChartSize,
        [&](const WallMesh::Vertex& a, const WallMesh::Vertex& b) { return deviation(side, a, b); });
    wall.improve();
    const size_t most = kMostAdded * (side.placed.size() + 1024);
    size_t added = 0;
    const auto at_middle = [&](const ChartVertex& v) {
      return on_boundary(chart_->point_at(place_of(side, v)));
    };
    wall.refine([&](const ChartVertex& v) -> std::optional<Vec3> {
      if (added++ >= most) return std::nullopt;
      return at_middle(v);
    });
    if (added > most) return left_open("the sides of the beam at different depths do not correspond", here);
    const auto rim = static_cast<uint32_t>(patch_.rim.size());
    const auto are_joined_already = [&](uint32_t a, uint32_t b) {
      const uint32_t i = side.of_patch[a], k = side.of_patch[b];
      return i < rim && k < rim && are_joined(patch_.rim[i], patch_.rim[k]);
    };
    wall.split_between(static_cast<uint32_t>(side.of_patch.size()), are_joined_already,
                       [&](const ChartVertex& v) { return std::optional(at_middle(v)); });
    append(side, wall);
    return Done{};
  }

  // By how much the chord of an edge deviates from the boundary beyond what it may.
  double deviation(const Side& side, const WallMesh::Vertex& a, const WallMesh::Vertex& b) const {
    const double most = kRimNear * stroke_.radius;
    if (glm::length(b.at - a.at) <= kRimLeastEdge * stroke_.radius) return 0;
    const Vec3 chord = 0.5 * (a.at + b.at);
    // The point of the chart between the ends is not the nearest one, nor exact for beams through an apex.
    if (pencil_->parallel()) {
      const int64_t x = (a.chart.x + b.chart.x) / 2, y = (a.chart.y + b.chart.y) / 2;
      const ChartVertex middle{(x % kChartSize + kChartSize) % kChartSize, y};
      if (glm::length(chart_->point_at(place_of(side, middle)) - chord) <= most) return 0;
    }
    return std::max(std::abs(stroke_.distance(chord)) - most, 0.0);
  }

  // Moves a point of the chart, which is exact for parallel beams alone, to the boundary.
  Vec3 on_boundary(Vec3 p) const {
    if (pencil_->parallel()) return p;
    const double step = kRimOn * stroke_.radius;
    for (int i = 0; i < 4; ++i) {
      const double d = stroke_.distance(p);
      Vec3 slope(0);
      for (int k = 0; k < 3; ++k) {
        Vec3 aside(0);
        aside[k] = step;
        slope[k] = (stroke_.distance(p + aside) - stroke_.distance(p - aside)) / (2 * step);
      }
      const double steepness2 = glm::dot(slope, slope);
      if (!(steepness2 > 0.25)) return p;
      p -= d / steepness2 * slope;
    }
    return p;
  }

  bool are_joined(VertexId a, VertexId b) const {
    Mesh::Star star;
    mesh_.star(a, star);
    return std::any_of(star.faces.begin(), star.faces.end(), [&](FaceId f) {
      const auto c = mesh_.corners(f);
      return std::find(c.begin(), c.end(), b) != c.end();
    });
  }

  void append(const Side& side, const WallMesh& wall) {
    std::vector<uint32_t> of_patch = side.of_patch;
    for (size_t i = of_patch.size(); i < wall.vertices().size(); ++i)
      of_patch.push_back(add(wall.vertices()[i].at));
    for (const WallMesh::Corners& t : wall.triangles())
      patch_.faces.push_back({of_patch[t[0]], of_patch[t[1]], of_patch[t[2]]});
  }

  // The part of the plane at an end of the range that the ends of the sides bound. Seen from the beam, i.e.
  // from lower depths for the higher end, its faces are counter-clockwise.
  Status make_cap(const std::vector<PatchSide>& sides, bool is_high) {
    if (sides.empty()) return Done{};
    std::map<uint32_t, uint32_t> local;
    std::vector<uint32_t> of_patch;
    for (const auto& [from, to] : sides) {
      if (local.try_emplace(from, static_cast<uint32_t>(of_patch.size())).second) of_patch.push_back(from);
    }
    std::vector<Vec2> places;
    for (const uint32_t v : of_patch) {
      const Vec2 place = pencil_->see(at(v)).place;
      places.emplace_back(place.x, is_high ? -place.y : place.y);
    }
    Vec2 low = places[0], high = places[0];
    for (const Vec2 p : places) {
      low = glm::min(low, p);
      high = glm::max(high, p);
    }
    const double scale = static_cast<double>(kChartSize - 2) / std::max(high.x - low.x, high.y - low.y);
    std::vector<ChartVertex> placed;
    for (const Vec2 p : places) {
      placed.push_back({static_cast<int64_t>((p.x - low.x) * scale + 0.5),
                        static_cast<int64_t>((p.y - low.y) * scale + 0.5)});
    }
    std::vector<ChartEdge> edges;
    for (const auto& [from, to] : sides)
      edges.push_back({local.at(from), local.at(to), placed[local.at(to)].x - placed[local.at(from)].x});
    constexpr int64_t kWidth = 4 * kChartSize;
    const auto triangles = ChartRegion(placed, edges, kWidth).triangles();
    if (!triangles)
      return left_open("the range of the beam ends in a part of the kerf only", at(of_patch[0]));
    std::vector<WallMesh::Vertex> vertices;
    for (size_t i = 0; i < placed.size(); ++i) vertices.push_back({at(of_patch[i]), placed[i]});
    WallMesh cap(std::move(vertices), *triangles, kWidth,
                 [](const WallMesh::Vertex&, const WallMesh::Vertex&) { return 0.0; });
    cap.improve();
    for (const WallMesh::Corners& t : cap.triangles())
      patch_.faces.push_back({of_patch[t[0]], of_patch[t[1]], of_patch[t[2]]});
    return Done{};
  }

  // Whether every side of the patch has another face, and none is there already.
  Status check() const {
    std::set<PatchSide> sides;
    for (const auto& f : patch_.faces) {
      for (size_t i = 0; i < 3; ++i) {
        if (!sides.insert({f[i], f[(i + 1) % 3]}).second)
          return left_open("two walls meet in one edge", at(f[i]));
      }
    }
    std::set<PatchSide> rim(rim_.begin(), rim_.end());
    if (rim.size() != rim_.size()) return left_open("the rim runs along one edge twice", rim_at(0));
    for (const PatchSide& s : rim) {
      if (!sides.contains(s)) return left_open("a part of the rim belongs to no wall", rim_at(s.first));
    }
    for (const auto& [from, to] : sides) {
      if (rim.contains({from, to}) == sides.contains({to, from}))
        return left_open("a wall ends in the part", at(from));
    }
    return Done{};
  }

  void tell_walls_apart() {
    UnionFind together(patch_.rim.size() + patch_.added.size());
    for (const auto& f : patch_.faces) {
      together.unite(f[0], f[1]);
      together.unite(f[1], f[2]);
    }
    std::map<uint32_t, uint32_t> number;
    for (size_t i = 0; i < sides_.size(); ++i) {
      const auto [at, is_new] =
          number.try_emplace(together.find(rim_[i].first), static_cast<uint32_t>(patch_.beside_wall.size()));
      if (is_new) patch_.beside_wall.push_back(sides_[i].face);
      patch_.wall_of_side.push_back(at->second);
    }
    for (const auto& f : patch_.faces) patch_.wall_of_face.push_back(number.at(together.find(f[0])));
  }

  const Mesh& mesh_;
  std::span<const RimSide> sides_;
  const WallStroke& stroke_;
  std::optional<BeamPencil> pencil_;
  std::optional<WallChart> chart_;
  WallPatch patch_;
  std::vector<PatchSide> rim_;                 // sides of walls along the rim, in the order of sides_
  std::vector<WallChart::Place> places_;       // by vertex of the rim
  Interval depths_;                            // of the rim
  std::vector<PatchSide> low_end_, high_end_;  // sides of caps along the ends of walls
};

}  // namespace

Result<WallPatch> make_walls(const Mesh& mesh, std::span<const RimSide> sides, const WallStroke& stroke) {
  KERF_ASSERT(!sides.empty() && !stroke.moves.empty() && stroke.radius > 0);
  return WallMaker(mesh, sides, stroke).make();
}

}  // namespace kerf
