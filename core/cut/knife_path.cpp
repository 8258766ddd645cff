#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "core/base/assert.h"
#include "core/base/tolerances.h"
#include "core/cut/knife.h"
#include "core/cut/knife_internal.h"
#include "core/mesh/weld.h"

namespace kerf {

namespace {

constexpr uint32_t kNoPlace = 0xffffffffu;

// The part of the surface between two poses, in the frame of a body. The normal points to the left of the
// path, seen along the beam.
struct KnifeStrip {
  WallPlane plane;
  Pose from, to;
  Vec3 after_from{0}, before_to{0};        // unit vectors in the plane, across the poses, into the strip
  Interval range;                          // m
  double on = 0;                           // m; a smaller distance counts as zero
  std::optional<uint32_t> previous, next;  // strips that share the poses
  std::vector<KnifeStrip> parts;           // of a path that bends within the plane, in order; else empty

  // Distances from the lines of the poses, and along the beam from the path of the origin.
  double past_from(const Vec3& p) const { return glm::dot(p - from.origin, after_from); }
  double short_of_to(const Vec3& p) const { return glm::dot(p - to.origin, before_to); }
  double depth(const Vec3& p) const {
    if (!parts.empty()) return parts[part_at(p)].depth(p);
    const Vec3 step = to.origin - from.origin;
    const double before = past_from(p), after = short_of_to(p);
    const double share = before + after > 0 ? std::clamp(before / (before + after), 0.0, 1.0) : 0;
    const Vec3 ray = p - (from.origin + share * step);
    if (step == Vec3(0)) return glm::length(ray);
    return glm::dot(ray, glm::normalize(from.direction + share * (to.direction - from.direction)));
  }
  // Returns the index of the part next to a point. Precondition: there are parts. O(log parts).
  size_t part_at(const Vec3& p) const {
    const auto is_before = [&](const KnifeStrip& part) { return part.short_of_to(p) < 0; };
    const auto at = std::partition_point(parts.begin(), std::prev(parts.end()), is_before);
    return static_cast<size_t>(at - parts.begin());
  }
};

Error not_planar(size_t pose) {
  return bad_input(
      "pose " + std::to_string(pose) +
      " of the knife: the beam turns out of the plane of the pose before; insert a pose between them "
      "so that each strip is planar");
}

// Returns nullopt if the beam moves along itself, which sweeps no surface.
Result<std::optional<KnifeStrip>> strip_between(const Pose& from, const Pose& to, const Interval& range,
                                                size_t number) {
  const Vec3 step = to.origin - from.origin, turn = glm::cross(from.direction, to.direction);
  const double length = glm::length(step);
  Vec3 normal = glm::length(turn) > kUnitSlack ? turn : glm::cross(step, from.direction);
  if (!(glm::length(normal) > kUnitSlack * std::max(length, glm::length(turn))))
    return std::optional<KnifeStrip>();
  normal = glm::normalize(normal);
  if (std::abs(glm::dot(normal, step)) > kUnitSlack * length) return not_planar(number);
  const auto end_of = [&](const Pose& p) { return p.origin + 0.5 * (range.low + range.high) * p.direction; };
  KnifeStrip strip;
  strip.from = from;
  strip.to = to;
  strip.range = range;
  strip.after_from = glm::cross(normal, from.direction);
  strip.before_to = glm::cross(normal, to.direction);
  if (glm::dot(strip.after_from, end_of(to) - from.origin) < 0) strip.after_from = -strip.after_from;
  if (glm::dot(strip.before_to, end_of(from) - to.origin) < 0) strip.before_to = -strip.before_to;
  if (glm::dot(glm::cross(strip.after_from, from.direction), normal) < 0) normal = -normal;
  strip.plane = {normal, glm::dot(normal, from.origin)};
  return std::optional(strip);
}

// Returns true if two strips that share a pose lie in one plane, also if the path returns in it.
bool are_coplanar(const KnifeStrip& a, const KnifeStrip& b) {
  constexpr double kRounding = 0x1p-46;  // of unit normals
  return glm::length(glm::cross(a.plane.normal, b.plane.normal)) <= kRounding;
}

// Returns true if a strip continues the one before in its plane.
bool continues(const KnifeStrip& before, const KnifeStrip& strip) {
  return glm::dot(before.plane.normal, strip.plane.normal) > 0 && are_coplanar(before, strip);
}

// Returns true if depths along two strips that follow each other are those along one from end to end.
bool is_straight(const KnifeStrip& before, const KnifeStrip& strip) {
  if (!before.parts.empty() || !strip.parts.empty() || before.to.origin != strip.from.origin) return false;
  const Vec3 step = before.to.origin - before.from.origin, more = strip.to.origin - strip.from.origin;
  if (step == Vec3(0) && more == Vec3(0)) return true;
  return before.from.direction == before.to.direction && before.to.direction == strip.to.direction &&
         glm::length(glm::cross(step, more)) <= kUnitSlack * glm::length(step) * glm::length(more);
}

// Moves a strip to the end of the parts of another.
void move_parts(KnifeStrip strip, std::vector<KnifeStrip>& parts) {
  if (strip.parts.empty()) return parts.push_back(std::move(strip));
  std::ranges::move(strip.parts, std::back_inserter(parts));
}

Result<std::vector<KnifeStrip>> strips_of(const KnifePath& path, const Body& body) {
  std::vector<KnifeStrip> strips;
  for (size_t i = 1; i < path.poses.size(); ++i) {
    const Placement& placement = body.placement;
    auto strip =
        strip_between(placement.to_body(path.poses[i - 1]), placement.to_body(path.poses[i]), path.range, i);
    if (!strip) return strip.error();
    if (!*strip) continue;
    (*strip)->on = distance_on((*strip)->plane, body);
    if (!strips.empty() && continues(strips.back(), **strip)) {
      KnifeStrip& before = strips.back();
      if (!is_straight(before, **strip)) {
        if (before.parts.empty()) move_parts(KnifeStrip(before), before.parts);
        move_parts(**strip, before.parts);
      }
      before.to = (*strip)->to;
      before.before_to = (*strip)->before_to;
      continue;
    }
    strips.push_back(**strip);
  }
  const auto same = [](const Pose& a, const Pose& b) {
    return a.origin == b.origin && a.direction == b.direction;
  };
  const bool is_closed = strips.size() > 1 && same(strips.back().to, strips.front().from);
  if (is_closed && continues(strips.back(), strips.front())) {
    if (!is_straight(strips.back(), strips.front())) {
      std::vector<KnifeStrip> parts;
      move_parts(strips.back(), parts);
      move_parts(strips.front(), parts);
      strips.front().parts = std::move(parts);
    }
    strips.front().from = strips.back().from;
    strips.front().after_from = strips.back().after_from;
    strips.pop_back();
  }
  for (uint32_t i = 0; i < strips.size(); ++i) {
    const uint32_t next = i + 1 < strips.size() ? i + 1 : 0;
    if (next == i || !same(strips[i].to, strips[next].from) || are_coplanar(strips[i], strips[next]))
      continue;
    strips[i].next = next;
    strips[next].previous = i;
  }
  return strips;
}

// Returns the faces that a thin beam touches along a strip, descending.
std::vector<FaceId> faces_near(const KnifeStrip& strip, const Body& body) {
  constexpr double kThin = 1e-3;  // of the size of the body
  Laser laser;
  laser.range = strip.range;
  laser.radius = std::max(kThin * body.bounds().diagonal(), strip.on);
  std::vector<FaceId> found;
  for (const KnifeStrip& part : strip.parts.empty() ? std::vector{strip} : strip.parts) {
    const BeamMove whole{part.from, part.to};
    const bool turns = part.from.direction != part.to.direction;
    for (const BeamMove& move :
         turns ? subdivide(whole, 0.5 * laser.radius, strip.range.high) : std::vector<BeamMove>{whole}) {
      for (const SweptCylinder& swept : sweep_beam(laser, move)) body.tree.touched(body.mesh, swept, found);
    }
  }
  std::sort(found.begin(), found.end(), std::greater<>());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

uint64_t key_of(VertexId from, VertexId to) { return uint64_t{from.index} << 32 | to.index; }

// A side of a face along the surface.
struct SurfaceSide {
  Mesh::Side side;
  uint32_t strip = 0;
  uint32_t part = 0;
  bool left = false;  // the face lies to the left of the path
};

// The walls on one side of the path, before their vertices are known.
struct SurfaceWalls {
  std::vector<Mesh::Side> sides;
  std::vector<PatchSide> rim;  // the same as indices of `at`, in the direction of the walls
  std::vector<Vec3> at;
  std::vector<std::array<uint32_t, 3>> faces;
};

class PathCut {
 public:
  PathCut(BodyStep& step, std::vector<KnifeStrip> strips) : step_(step), strips_(std::move(strips)) {}

  void run(std::vector<LeftOpen>& left_open) {
    for (uint32_t k = 0; k < strips_.size(); ++k) split_along(k);
    update_tree(step_);
    find_sides();
    if (sides_.empty()) return;
    find_parts();
    if (const std::optional<Vec3> place = find_separated())
      note(left_open, "the part stays connected, because the knife does not pass right through it", *place);
    if (separated_.empty()) return;
    std::vector<SurfaceWalls> walls;
    if (step_.body().solid) walls = make_walls(left_open);
    if (!separated_.empty()) separate_parts(walls);
  }

 private:
  const Mesh& mesh() const { return step_.mesh(); }

  void note(std::vector<LeftOpen>& left_open, const char* why, const Vec3& place) const {
    left_open.push_back({step_.id, kerf::left_open(why, place).message});
  }

  bool is_on(VertexId v, uint32_t strip) const {
    const auto known = planes_.find(v.index);
    return known != planes_.end() && std::ranges::find(known->second, strip) != known->second.end();
  }
  void set_on(VertexId v, uint32_t strip) {
    if (!is_on(v, strip)) planes_[v.index].push_back(strip);
  }
  // Returns 1 to the left of the plane of a strip, -1 to the right, or 0.
  int side(VertexId v, uint32_t strip) {
    if (is_on(v, strip)) return 0;
    const double d = distance_from(strips_[strip].plane, mesh().position(v));
    if (std::abs(d) > strips_[strip].on) return d > 0 ? 1 : -1;
    set_on(v, strip);
    return 0;
  }

  // Splitting along the plane of a strip, in the faces that meet the strip.

  void split_along(uint32_t strip) {
    std::vector<FaceId> waiting = faces_near(strips_[strip], step_.body());
    std::vector<Mesh::FaceSplit> splits;
    while (!waiting.empty()) {
      const FaceId f = waiting.back();
      waiting.pop_back();
      if (!meets(f, strip)) continue;
      met_.push_back(f);
      const auto corners = mesh().corners(f);
      for (size_t i = 0; i < 3; ++i) {
        const VertexId from = corners[i], to = corners[(i + 1) % 3];
        if (side(from, strip) * side(to, strip) >= 0) continue;
        const std::vector<uint32_t> shared = shared_planes(from, to);
        splits.clear();
        step_.edit.split_edge_at(f, from, to, plane_crossing(mesh(), strips_[strip].plane, {f, from, to}),
                                 splits);
        for (const Mesh::FaceSplit& s : splits) {
          set_on(s.midpoint, strip);
          for (const uint32_t other : shared) set_on(s.midpoint, other);
          waiting.insert(waiting.end(), {s.kept, s.added});
          met_.insert(met_.end(), {s.kept, s.added});
        }
        break;
      }
    }
    update_tree(step_);
  }
  std::vector<uint32_t> shared_planes(VertexId a, VertexId b) const {
    std::vector<uint32_t> shared;
    const auto known = planes_.find(a.index);
    if (known == planes_.end()) return shared;
    for (const uint32_t strip : known->second) {
      if (is_on(b, strip)) shared.push_back(strip);
    }
    return shared;
  }
  // Returns true if the section of a face with the plane of a strip may meet the strip.
  bool meets(FaceId f, uint32_t strip) {
    const auto corners = mesh().corners(f);
    std::vector<Vec3> section;
    for (size_t i = 0; i < 3; ++i) {
      const VertexId a = corners[i], b = corners[(i + 1) % 3];
      const int of_a = side(a, strip), of_b = side(b, strip);
      if (of_a == 0) section.push_back(mesh().position(a));
      if (of_a * of_b < 0) section.push_back(plane_crossing(mesh(), strips_[strip].plane, {f, a, b}));
    }
    if (section.size() < 2) return false;
    const KnifeStrip& s = strips_[strip];
    const auto all = [&](auto is_outside) { return std::ranges::all_of(section, is_outside); };
    return !all([&](const Vec3& p) { return s.past_from(p) < -s.on; }) &&
           !all([&](const Vec3& p) { return s.short_of_to(p) < -s.on; }) &&
           !all([&](const Vec3& p) { return s.depth(p) < s.range.low - s.on; }) &&
           !all([&](const Vec3& p) { return s.depth(p) > s.range.high + s.on; });
  }

  // Sides along the surface, and the parts that they bound.

  bool lies_within(VertexId v, uint32_t strip) const {
    const KnifeStrip& s = strips_[strip];
    const Vec3 p = mesh().position(v);
    const double slack = 4 * s.on;
    const auto is_at = [&](std::optional<uint32_t> other) { return other && is_on(v, *other); };
    return (s.past_from(p) >= -slack || is_at(s.previous)) && (s.short_of_to(p) >= -slack || is_at(s.next)) &&
           s.depth(p) >= s.range.low - slack && s.depth(p) <= s.range.high + slack;
  }
  // Returns true if an edge between vertices within a strip lies within its range where the path bends.
  bool stays_within(VertexId from, VertexId to, uint32_t strip) const {
    const KnifeStrip& s = strips_[strip];
    if (s.parts.empty()) return true;
    const Vec3 a = mesh().position(from), b = mesh().position(to);
    const auto [first, last] = std::minmax({s.part_at(a), s.part_at(b)});
    for (size_t i = first; i < last; ++i) {
      const double of_a = s.parts[i].short_of_to(a), of_b = s.parts[i].short_of_to(b);
      if ((of_a < 0) == (of_b < 0)) continue;
      const Vec3 bend = a + of_a / (of_a - of_b) * (b - a);
      for (const double depth : {s.parts[i].depth(bend), s.parts[i + 1].depth(bend)}) {
        if (depth < s.range.low - 4 * s.on || depth > s.range.high + 4 * s.on) return false;
      }
    }
    return true;
  }
  bool is_left(FaceId f, VertexId from, VertexId to, uint32_t strip) {
    for (const VertexId v : mesh().corners(f)) {
      if (v != from && v != to && side(v, strip) != 0) return side(v, strip) > 0;
    }
    const Triangle t = mesh().triangle(f);
    return glm::dot(glm::cross(t[1] - t[0], t[2] - t[0]), strips_[strip].plane.normal) < 0;
  }
  void find_sides() {
    std::sort(met_.begin(), met_.end());
    met_.erase(std::unique(met_.begin(), met_.end()), met_.end());
    for (const FaceId f : met_) {
      const auto corners = mesh().corners(f);
      for (size_t i = 0; i < 3; ++i) {
        const VertexId from = corners[i], to = corners[(i + 1) % 3];
        for (const uint32_t strip : shared_planes(from, to)) {
          if (!lies_within(from, strip) || !lies_within(to, strip) || !stays_within(from, to, strip))
            continue;
          add_side({f, from, to}, strip);
          break;
        }
      }
    }
  }
  // Adds a side and those of all other faces on its edge, if faces lie on both sides of the surface.
  void add_side(const Mesh::Side& side, uint32_t strip) {
    if (is_side_.contains(key_of(side.from, side.to))) return;
    std::vector<Mesh::Side> all{side};
    mesh().append_edge_sides(side.face, side.from, side.to, all);
    std::vector<bool> left;
    for (const Mesh::Side& s : all) left.push_back(is_left(s.face, s.from, s.to, strip));
    if (std::ranges::count(left, left[0]) == static_cast<std::ptrdiff_t>(left.size())) return;
    for (size_t i = 0; i < all.size(); ++i) {
      is_side_.insert(key_of(all[i].from, all[i].to));
      sides_.push_back({all[i], strip, 0, left[i]});
    }
  }

  // Numbers the parts into which the sides divide the mesh.
  void find_parts() {
    part_.assign(mesh().face_slots(), kNoPlace);
    std::vector<FaceId> waiting;
    std::vector<Mesh::Side> others;
    uint32_t parts = 0;
    for (SurfaceSide& seed : sides_) {
      if (part_[seed.side.face.index] == kNoPlace) {
        part_[seed.side.face.index] = parts++;
        waiting.push_back(seed.side.face);
      }
      while (!waiting.empty()) {
        const FaceId f = waiting.back();
        waiting.pop_back();
        const auto corners = mesh().corners(f);
        for (size_t i = 0; i < 3; ++i) {
          const VertexId from = corners[i], to = corners[(i + 1) % 3];
          if (is_side_.contains(key_of(from, to))) continue;
          others.clear();
          mesh().append_edge_sides(f, from, to, others);
          for (const Mesh::Side& s : others) {
            if (part_[s.face.index] != kNoPlace) continue;
            part_[s.face.index] = part_[f.index];
            waiting.push_back(s.face);
          }
        }
      }
      seed.part = part_[seed.side.face.index];
    }
  }
  // Lists the sides whose edges have faces of several parts. Returns a place where both sides are one part.
  std::optional<Vec3> find_separated() {
    std::optional<Vec3> joined;
    std::vector<Mesh::Side> others;
    std::vector<SurfaceSide> kept;
    for (const SurfaceSide& s : sides_) {
      others.clear();
      mesh().append_edge_sides(s.side.face, s.side.from, s.side.to, others);
      if (std::ranges::any_of(others, [&](const Mesh::Side& o) { return part_[o.face.index] != s.part; })) {
        separated_[s.part].push_back(s.side);
        kept.push_back(s);
      } else if (!others.empty() && !joined) {
        joined = mesh().position(s.side.from);
      }
    }
    sides_ = std::move(kept);
    return joined;
  }

  // Walls.

  // Makes the walls of each piece by itself, because pieces that an earlier cut separated touch each other.
  // Keeps the parts of a piece connected for which there are none.
  std::vector<SurfaceWalls> make_walls(std::vector<LeftOpen>& left_open) {
    std::map<uint32_t, std::vector<SurfaceSide>> of_piece;
    for (const SurfaceSide& s : sides_) of_piece[mesh().data(s.side.face).piece].push_back(s);
    std::vector<SurfaceWalls> all;
    for (const auto& [piece, sides] : of_piece) {
      const std::optional<Vec3> crossing = find_crossing(sides);
      std::optional<SurfaceWalls> right, left;
      if (!crossing) right = make_walls(sides, false);
      if (right) left = make_walls(sides, true);
      if (left) {
        all.push_back(std::move(*right));
        all.push_back(std::move(*left));
        continue;
      }
      const Vec3 place = crossing.value_or(mesh().position(sides.front().side.from));
      note(left_open,
           crossing ? "the part stays connected, because the knife crosses its own cut in the solid"
                    : "the part stays connected, because the knife ends inside the solid",
           place);
      for (const SurfaceSide& s : sides) separated_.erase(s.part);
    }
    return all;
  }
  // Returns a place where strips meet that do not follow each other, if there is one.
  std::optional<Vec3> find_crossing(const std::vector<SurfaceSide>& sides) const {
    std::map<uint32_t, std::vector<uint32_t>> strips_at;  // by vertex
    for (const SurfaceSide& s : sides) {
      if (!s.left) continue;
      for (const VertexId v : {s.side.from, s.side.to}) strips_at[v.index].push_back(s.strip);
    }
    for (const auto& [vertex, strips] : strips_at) {
      for (const uint32_t a : strips) {
        const auto follows = [&](uint32_t b) {
          return b == a || strips_[a].next == b || strips_[b].next == a;
        };
        if (!std::ranges::all_of(strips, follows)) return mesh().position(VertexId(vertex));
      }
    }
    return std::nullopt;
  }
  // Triangulates the surface between the sides to the left or right of the path, strip by strip. Returns
  // nullopt if they do not bound a part of the surface.
  std::optional<SurfaceWalls> make_walls(const std::vector<SurfaceSide>& of_one, bool left) const {
    SurfaceWalls walls;
    std::vector<Vec3> ends;
    std::vector<uint32_t> strip_of;
    for (const SurfaceSide& s : of_one) {
      if (s.left != left) continue;
      walls.sides.push_back(s.side);
      strip_of.push_back(s.strip);
      ends.push_back(mesh().position(s.side.to));
      ends.push_back(mesh().position(s.side.from));
    }
    const std::vector<uint32_t> first = weld_positions(ends);
    std::vector<uint32_t> number(ends.size());
    std::vector<VertexId> vertex;
    for (uint32_t i = 0; i < ends.size(); ++i) {
      if (first[i] == i) {
        number[i] = static_cast<uint32_t>(walls.at.size());
        walls.at.push_back(ends[i]);
        vertex.push_back(i % 2 == 0 ? walls.sides[i / 2].to : walls.sides[i / 2].from);
      } else {
        number[i] = number[first[i]];
      }
    }
    std::map<uint32_t, std::vector<PatchSide>> of_strip;
    for (size_t i = 0; i < walls.sides.size(); ++i) {
      walls.rim.emplace_back(number[2 * i], number[2 * i + 1]);
      of_strip[strip_of[i]].push_back(walls.rim.back());
    }
    for (auto& [strip, bounds] : of_strip) {
      if (!close_at_poses(strip, vertex, bounds) || !fill(walls, bounds, strip, left)) return std::nullopt;
    }
    return walls;
  }
  // Appends the sides of a strip along the lines that it shares with its neighbours, between the points where
  // these lines enter and leave the solid.
  bool close_at_poses(uint32_t strip, const std::vector<VertexId>& vertex,
                      std::vector<PatchSide>& bounds) const {
    std::map<uint32_t, int> balance;
    for (const auto& [from, to] : bounds) {
      --balance[from];
      ++balance[to];
    }
    std::erase_if(balance, [](const auto& b) { return b.second == 0; });
    const KnifeStrip& s = strips_[strip];
    for (const bool at_start : {true, false}) {
      const std::optional<uint32_t> other = at_start ? s.previous : s.next;
      if (!other) continue;
      const Pose& pose = at_start ? s.from : s.to;
      std::vector<std::pair<double, uint32_t>> along;
      for (const auto& [v, excess] : balance) {
        if (is_on(vertex[v], *other))
          along.emplace_back(glm::dot(mesh().position(vertex[v]) - pose.origin, pose.direction), v);
      }
      std::sort(along.begin(), along.end());
      if (along.size() % 2 != 0) return false;
      for (size_t i = 0; i < along.size(); i += 2) {
        const uint32_t a = along[i].second, b = along[i + 1].second;
        if (balance[a] + balance[b] != 0 || std::abs(balance[a]) != 1) return false;
        bounds.push_back(balance[a] > 0 ? PatchSide{a, b} : PatchSide{b, a});
        balance.erase(a);
        balance.erase(b);
      }
    }
    return balance.empty();
  }
  bool fill(SurfaceWalls& walls, const std::vector<PatchSide>& bounds, uint32_t strip, bool left) const {
    std::map<uint32_t, uint32_t> local;
    std::vector<uint32_t> global;
    std::vector<Vec3> at;
    std::vector<PatchSide> sides;
    const auto number = [&](uint32_t v) {
      const auto [known, is_new] = local.try_emplace(v, static_cast<uint32_t>(at.size()));
      if (is_new) {
        at.push_back(walls.at[v]);
        global.push_back(v);
      }
      return known->second;
    };
    for (const auto& [from, to] : bounds) {
      const uint32_t a = number(from);
      sides.emplace_back(a, number(to));
    }
    const auto faces = triangulate_section(at, sides, (left ? -1.0 : 1.0) * strips_[strip].plane.normal);
    if (!faces) return false;
    for (const auto& [a, b, c] : *faces) walls.faces.push_back({global[a], global[b], global[c]});
    return true;
  }

  // Separation.

  void separate_parts(const std::vector<SurfaceWalls>& walls) {
    std::vector<FaceId> seeds;
    for (const auto& [part, sides] : separated_) {
      step_.edit.open_edges(present(sides));
      for (const Mesh::Side& s : sides) seeds.push_back(s.face);
    }
    for (const SurfaceWalls& own : walls) {
      if (!own.faces.empty()) add(own);
    }
    step_.edit.refit_tree();
    std::sort(seeds.begin(), seeds.end());
    seeds.erase(std::unique(seeds.begin(), seeds.end()), seeds.end());
    step_.edit.search_from(seeds);
  }
  // Returns sides with their present vertices, which earlier calls of open_edges() may have replaced.
  std::vector<Mesh::Side> present(const std::vector<Mesh::Side>& sides) const {
    std::vector<Mesh::Side> now;
    for (const Mesh::Side& s : sides) {
      const auto corners = mesh().corners(s.face);
      size_t i = 0;
      while (i < 2 && mesh().position(corners[i]) != mesh().position(s.from)) ++i;
      KERF_ASSERT(mesh().position(corners[i]) == mesh().position(s.from));
      now.push_back({s.face, corners[i], corners[(i + 1) % 3]});
    }
    return now;
  }
  void add(const SurfaceWalls& walls) {
    SectionWalls made;
    WallPatch& patch = made.patch;
    patch.faces = walls.faces;
    patch.rim.resize(walls.at.size());
    const std::vector<Mesh::Side> sides = present(walls.sides);
    std::vector<std::pair<uint32_t, VertexId>> all;
    for (size_t i = 0; i < sides.size(); ++i) {
      patch.sides.push_back({sides[i].face, sides[i].from, sides[i].to});
      all.emplace_back(walls.rim[i].first, sides[i].to);
      all.emplace_back(walls.rim[i].second, sides[i].from);
    }
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    for (size_t i = 0; i < all.size(); ++i) {
      const bool is_first = i == 0 || all[i].first != all[i - 1].first;
      if (is_first) patch.rim[all[i].first] = all[i].second;
      if (!is_first) made.welded.push_back(all[i]);
    }
    run_to_completion(separate_walls(patch, walls.rim, patch.sides));
    add_section(step_, made);
  }

  BodyStep& step_;
  std::vector<KnifeStrip> strips_;
  std::unordered_map<uint32_t, std::vector<uint32_t>> planes_;  // by vertex: strips in whose planes it lies
  std::vector<FaceId> met_;                                     // faces that meet a strip, and their parts
  std::unordered_set<uint64_t> is_side_;                        // by key_of(); lookups only
  std::vector<SurfaceSide> sides_;
  std::vector<uint32_t> part_;                             // by face
  std::map<uint32_t, std::vector<Mesh::Side>> separated_;  // by part: sides next to other parts
};

}  // namespace

std::optional<size_t> first_pose_off_plane(const KnifePath& path) {
  for (size_t i = 1; i < path.poses.size(); ++i) {
    if (!strip_between(path.poses[i - 1], path.poses[i], path.range, i)) return i;
  }
  return std::nullopt;
}

Result<StepResult> cut_with_path(World& world, const KnifePath& path, std::span<const BodyId> bodies,
                                 size_t max_faces, const Progress* progress) {
  KERF_ASSERT(is_settled(world) && path.poses.size() >= 2);
  constexpr size_t kMaxNewFaces = 4;  // per face near a strip
  std::vector<std::vector<KnifeStrip>> strips;
  for (const BodyId id : bodies) {
    if (progress && !progress->report(0)) return cancelled();
    const Body& body = world.body(id);
    auto own = strips_of(path, body);
    if (!own) return own.error();
    size_t faces = body.mesh.live_faces();
    for (const KnifeStrip& strip : *own) faces += kMaxNewFaces * faces_near(strip, body).size();
    if (faces > max_faces) return too_many_knife_faces(max_faces);
    strips.push_back(std::move(*own));
  }
  StepResult result;
  for (size_t i = 0; i < bodies.size(); ++i) {
    BodyStep step(bodies[i], world.body(bodies[i]));
    PathCut(step, std::move(strips[i])).run(result.delta.left_open);
    separate(world, step, {}, kNoLimit, EditPolicy::kNoEdits);
    end_step(step, result);
  }
  apply_joints(world, result.delta);
  return result;
}

}  // namespace kerf
