#include <algorithm>
#include <cmath>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <map>

#include "core/base/assert.h"
#include "core/base/deterministic_math.h"
#include "core/base/tolerances.h"
#include "core/walls/wall_chart_internal.h"

namespace kerf {

namespace {

// Directions that differ by less are parallel: over the longest ranges lines deviate by 1e-3 radii at most.
constexpr double kParallel = 1e-9;
// Max distance of a line from the apex, in radii.
constexpr double kAtApex = 1e-3;
// Min cosine of the angle between a direction and the middle one.
constexpr double kMinCosine = 0.3;

template <typename Visit>
void for_each_pose(std::span<const BeamMove> moves, Visit visit) {
  for (const BeamMove& m : moves) {
    visit(m.from);
    visit(m.to);
  }
}

// Returns the point with the smallest sum of squared distances from the lines.
Vec3 nearest_to_lines(std::span<const BeamMove> moves) {
  glm::dmat3 sum(0.0);
  Vec3 right(0);
  const Vec3 near = moves.front().from.origin;
  for_each_pose(moves, [&](const Pose& pose) {
    const glm::dmat3 across = glm::dmat3(1.0) - glm::outerProduct(pose.direction, pose.direction);
    sum += across;
    right += across * (pose.origin - near);
  });
  return near + glm::inverse(sum) * right;
}

// For beams through an apex: the number of depths, and the length below which curves are ignored, in radii,
// since small gaps between strokes appear and disappear with the depth.
constexpr size_t kSlices = 17;
constexpr double kMinCurve = 1;

// Returns the nearest point of a piece, as a share of its length.
double nearest_share(const OutlinePiece& piece, Vec2 p) {
  if (piece.radius > 0) {
    const Vec2 from = p - piece.centre;
    double turned = wrapped(det::atan2(from.y, from.x) - piece.angle);
    if (turned < 0) turned += 2 * kPi;
    if (turned <= piece.turn) return turned / piece.turn;
    return turned - piece.turn < 2 * kPi - turned ? 1 : 0;
  }
  const Vec2 way = piece.to - piece.from;
  const double length2 = glm::dot(way, way);
  return length2 > 0 ? std::clamp(glm::dot(p - piece.from, way) / length2, 0.0, 1.0) : 0;
}

double modulo(double x, double period) {
  const double rest = x - std::floor(x / period) * period;
  return rest < period ? rest : 0;
}

std::optional<double> end_at(const BeamPencil& pencil, std::span<const BeamMove> moves, double along,
                             double radius) {
  const auto depth_of = [&](const Pose& p) { return pencil.see(p.origin).depth + along; };
  const double depth = depth_of(moves.front().from);
  for (const BeamMove& m : moves) {
    for (const Pose* p : {&m.from, &m.to}) {
      if (std::abs(depth_of(*p) - depth) > kRimOn * radius) return std::nullopt;
    }
  }
  return depth;
}

double from_corner(const NearBoundary& n) { return std::max(n.from_side, n.from_end); }

bool is_on_end_alone(const NearBoundary& n) {
  return n.end != BoundaryPart::kSide && n.from_end < n.from_side;
}

}  // namespace

std::optional<BeamPencil> BeamPencil::of(std::span<const BeamMove> moves, double radius) {
  KERF_ASSERT(!moves.empty());
  BeamPencil pencil;
  const Vec3 first = moves.front().from.direction;
  Vec3 sum(0);
  pencil.parallel_ = true;
  pencil.origin_ = moves.front().from.origin;
  for_each_pose(moves, [&](const Pose& pose) {
    sum += pose.direction;
    pencil.parallel_ = pencil.parallel_ && glm::length(pose.direction - first) <= kParallel;
  });
  if (!(glm::length(sum) > 0)) return std::nullopt;
  pencil.axis_ = pencil.parallel_ ? first : glm::normalize(sum);
  pencil.right_ = across(pencil.axis_);
  pencil.up_ = glm::cross(pencil.axis_, pencil.right_);
  if (pencil.parallel_) return pencil;
  const Vec3 apex = nearest_to_lines(moves);
  bool meet = true;
  for_each_pose(moves, [&](const Pose& pose) {
    const Vec3 from = apex - pose.origin;
    const double distance = glm::length(from - glm::dot(from, pose.direction) * pose.direction);
    meet = meet && distance <= kAtApex * radius && glm::dot(pose.direction, pencil.axis_) > kMinCosine;
  });
  if (!meet) return std::nullopt;
  pencil.origin_ = apex;
  return pencil;
}

BeamPencil::Seen BeamPencil::see(const Vec3& p) const {
  const Vec3 a = p - origin_;
  return {{glm::dot(a, right_), glm::dot(a, up_)}, glm::dot(a, axis_)};
}

Vec3 BeamPencil::point(Vec2 place, double depth) const {
  return origin_ + depth * axis_ + place.x * right_ + place.y * up_;
}

double BeamPencil::longest_ellipse(std::span<const BeamMove> moves) const {
  double longest = 1;
  for_each_pose(moves,
                [&](const Pose& pose) { longest = std::max(longest, 1 / glm::dot(pose.direction, axis_)); });
  return longest;
}

DiscMove BeamPencil::at_depth(const BeamMove& move, double depth) const {
  const auto centre = [&](const Pose& pose) {
    if (parallel_) return see(pose.origin).place;
    const Vec3 d = pose.direction * (depth / glm::dot(pose.direction, axis_));
    return Vec2(glm::dot(d, right_), glm::dot(d, up_));
  };
  return {centre(move.from), centre(move.to)};
}

void WallChart::Curve::set_outline(OutlineCurve curve) {
  outline = std::move(curve);
  starts = {0};
  for (size_t i = 0; i < outline.pieces.size(); ++i) {
    const OutlinePiece& p = outline.pieces[i];
    starts.push_back(starts.back() + p.length);
    if (i % kTogether == 0) boxes.push_back({p.from, p.from});
    Box& box = boxes.back();
    const Vec2 low = p.radius > 0 ? p.centre - p.radius : glm::min(p.from, p.to);
    const Vec2 high = p.radius > 0 ? p.centre + p.radius : glm::max(p.from, p.to);
    box = {glm::min(box.low, low), glm::max(box.high, high)};
  }
  period = starts.back();
}

double WallChart::Curve::place(double length) const {
  if (marks.empty()) return length;
  const double beyond = modulo(length - first_mark, starts.back());
  const auto after = std::upper_bound(marks.begin() + 1, marks.end(), beyond);
  const double start = *(after - 1), end = after == marks.end() ? starts.back() : *after;
  return static_cast<double>(after - 1 - marks.begin()) + (beyond - start) / (end - start);
}

double WallChart::Curve::length(double place) const {
  place = modulo(place, period);
  if (marks.empty()) return place;
  const size_t i = std::min(static_cast<size_t>(place), marks.size() - 1);
  const double end = i + 1 < marks.size() ? marks[i + 1] : starts.back();
  return modulo(first_mark + marks[i] + (place - static_cast<double>(i)) * (end - marks[i]), starts.back());
}

Vec2 WallChart::Curve::at(double place) const {
  const double l = length(place);
  const auto after = std::upper_bound(starts.begin(), starts.end() - 1, l);
  const size_t i = static_cast<size_t>(after - starts.begin()) - 1;
  const OutlinePiece& piece = outline.pieces[i];
  return piece.at(piece.length > 0 ? std::min((l - starts[i]) / piece.length, 1.0) : 0);
}

std::optional<WallChart::Near> WallChart::nearest(const Slice& slice, Vec2 p, double reach) {
  std::optional<uint32_t> curve_of_best;
  double best = reach, length = 0;  // along the curve
  for (uint32_t c = 0; c < slice.curves.size(); ++c) {
    const Curve& curve = slice.curves[c];
    for (size_t i = 0; i < curve.outline.pieces.size(); ++i) {
      const Box& box = curve.boxes[i / kTogether];
      if (i % kTogether == 0 && glm::length(p - glm::clamp(p, box.low, box.high)) > best) {
        i += kTogether - 1;
        continue;
      }
      const OutlinePiece& piece = curve.outline.pieces[i];
      const double share = nearest_share(piece, p), distance = glm::length(piece.at(share) - p);
      if (!(curve_of_best ? distance < best : distance <= best)) continue;
      curve_of_best = c;
      best = distance;
      length = curve.starts[i] + share * piece.length;
    }
  }
  if (!curve_of_best) return std::nullopt;
  const Curve& own = slice.curves[*curve_of_best];
  return Near{*curve_of_best, modulo(own.place(length), own.period)};
}

// Makes sides that are one piece of every slice landmarks. Returns true if the curves correspond.
bool WallChart::set_landmarks(std::vector<Slice>& slices) {
  std::vector<std::map<uint32_t, std::pair<uint32_t, double>>> of_side(
      slices.size());  // curve, length of middle
  for (size_t s = 0; s < slices.size(); ++s) {
    std::map<uint32_t, int> count;
    for (uint32_t c = 0; c < slices[s].curves.size(); ++c) {
      const Curve& curve = slices[s].curves[c];
      for (size_t i = 0; i < curve.outline.pieces.size(); ++i) {
        const OutlinePiece& piece = curve.outline.pieces[i];
        ++count[piece.side];
        of_side[s][piece.side] = {c, curve.starts[i] + 0.5 * piece.length};
      }
    }
    for (const auto& [side, times] : count) {
      if (times > 1) of_side[s].erase(side);
    }
  }
  const size_t curves = slices[0].curves.size();
  std::vector<std::vector<uint32_t>> shared(curves);  // sides, in the order of the first slice
  for (uint32_t c = 0; c < curves; ++c) {
    for (const OutlinePiece& piece : slices[0].curves[c].outline.pieces) {
      const bool everywhere = std::all_of(of_side.begin(), of_side.end(),
                                          [&](const auto& sides) { return sides.contains(piece.side); });
      if (everywhere) shared[c].push_back(piece.side);
    }
    if (shared[c].empty()) return false;
  }
  std::vector<std::vector<Curve>> ordered(slices.size());
  for (uint32_t c = 0; c < curves; ++c) {
    std::vector<double> reached(slices.size(), -1);  // from the first landmark
    for (size_t s = 0; s < slices.size(); ++s) {
      const auto& [curve, length] = of_side[s].at(shared[c][0]);
      ordered[s].push_back(slices[s].curves[curve]);
      ordered[s].back().first_mark = length;
    }
    const auto from_first = [&](size_t s, uint32_t side) {
      return modulo(of_side[s].at(side).second - of_side[s].at(shared[c][0]).second,
                    ordered[s][c].starts.back());
    };
    for (const uint32_t side : shared[c]) {
      bool in_order = true;
      for (size_t s = 0; s < slices.size(); ++s) {
        in_order = in_order && of_side[s].at(side).first == of_side[s].at(shared[c][0]).first &&
                   from_first(s, side) > reached[s];
      }
      if (!in_order) continue;
      for (size_t s = 0; s < slices.size(); ++s) {
        reached[s] = from_first(s, side);
        ordered[s][c].marks.push_back(reached[s]);
      }
    }
  }
  for (size_t s = 0; s < slices.size(); ++s) {
    for (Curve& curve : ordered[s]) curve.period = static_cast<double>(curve.marks.size());
    slices[s].curves = std::move(ordered[s]);
  }
  return true;
}

Task<std::optional<WallChart>> WallChart::make(const BeamPencil& pencil, std::span<const BeamMove> moves,
                                               double radius, Interval depths) {
  KERF_ASSERT(radius > 0);
  WallChart chart(pencil);
  const size_t slices = pencil.parallel() ? 1 : kSlices;
  std::vector<DiscMove> discs(moves.size());
  for (size_t s = 0; s < slices; ++s) {
    Slice slice;
    slice.depth = depths.low;
    if (slices > 1)
      slice.depth += (depths.high - depths.low) * static_cast<double>(s) / static_cast<double>(slices - 1);
    if (!pencil.parallel() && !(slice.depth > radius)) co_return std::nullopt;
    for (size_t i = 0; i < moves.size(); ++i) discs[i] = pencil.at_depth(moves[i], slice.depth);
    std::vector<OutlineCurve> outlines = co_await outline_of(discs, radius);
    for (OutlineCurve& outline : outlines) {
      if (!pencil.parallel() && outline.length < kMinCurve * radius) continue;
      Curve curve;
      curve.set_outline(std::move(outline));
      slice.curves.push_back(std::move(curve));
    }
    if (slice.curves.empty() ||
        slice.curves.size() != (s > 0 ? chart.slices_[0].curves.size() : slice.curves.size()))
      co_return std::nullopt;
    chart.slices_.push_back(std::move(slice));
    co_await yield_after(moves.size());
  }
  if (slices > 1 && !set_landmarks(chart.slices_)) co_return std::nullopt;
  co_return chart;
}

std::pair<size_t, double> WallChart::slice_below(double depth) const {
  if (slices_.size() == 1) return {0, 0};
  const double first = slices_.front().depth, last = slices_.back().depth;
  const auto parts = static_cast<double>(slices_.size() - 1);
  const double at = last > first ? std::clamp((depth - first) / (last - first) * parts, 0.0, parts) : 0;
  const size_t below = std::min(static_cast<size_t>(at), slices_.size() - 2);
  return {below, at - static_cast<double>(below)};
}

std::optional<WallChart::Place> WallChart::place_of(const Vec3& p, double reach) const {
  const BeamPencil::Seen seen = pencil_.see(p);
  const auto [below, share] = slice_below(seen.depth);
  const auto near = [&](size_t s) {
    // Towards an apex everything but the radius shrinks.
    const double scale = pencil_.parallel() ? 1 : slices_[s].depth / seen.depth;
    return nearest(slices_[s], seen.place * scale, reach);
  };
  const auto a = near(below);
  if (!a) return std::nullopt;
  if (slices_.size() == 1) return Place{a->curve, a->place, seen.depth};
  const auto b = near(below + 1);
  if (!b || a->curve != b->curve) return std::nullopt;
  const double whole = period(a->curve);
  double way = b->place - a->place;
  way -= std::round(way / whole) * whole;
  return Place{a->curve, modulo(a->place + share * way, whole), seen.depth};
}

Vec3 WallChart::point_at(const Place& place) const {
  const auto [below, share] = slice_below(place.depth);
  const Vec2 a = slices_[below].curves[place.curve].at(place.around);
  if (slices_.size() == 1) return pencil_.point(a, place.depth);
  const Vec2 b = slices_[below + 1].curves[place.curve].at(place.around);
  return pencil_.point(a + share * (b - a), place.depth);
}

std::vector<double> WallChart::corners(uint32_t curve, double turn) const {
  const Curve& own = slices_.front().curves[curve];
  std::vector<double> places;
  for (size_t i = 0; i < own.outline.pieces.size(); ++i) {
    const OutlinePiece& piece = own.outline.pieces[i];
    const int parts = piece.radius > 0 ? static_cast<int>(std::ceil(piece.turn / turn)) : 1;
    for (int k = 0; k < parts; ++k)
      places.push_back(modulo(own.place(own.starts[i] + piece.length * k / parts), own.period));
  }
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  return places;
}

RangeEnds range_ends(const BeamPencil& pencil, std::span<const BeamMove> moves, Interval range,
                     double radius) {
  KERF_ASSERT(!moves.empty() && radius > 0);
  if (!pencil.parallel()) return {};
  return {end_at(pencil, moves, range.low, radius), end_at(pencil, moves, range.high, radius)};
}

NearBoundary near_boundary(const WallChart& chart, const RangeEnds& ends, const Vec3& p, double depth,
                           double reach) {
  KERF_ASSERT(reach > 0);
  NearBoundary near;
  near.place = chart.place_of(p, reach);
  if (near.place) near.from_side = glm::length(chart.point_at(*near.place) - p);
  for (const auto& [end, part] :
       {std::pair(ends.low, BoundaryPart::kLowEnd), std::pair(ends.high, BoundaryPart::kHighEnd)}) {
    if (!end || std::abs(depth - *end) >= near.from_end) continue;
    near.from_end = std::abs(depth - *end);
    near.end = part;
  }
  if (near.from_end > reach) near.end = BoundaryPart::kSide;
  return near;
}

std::optional<BoundaryPart> part_along(const NearBoundary& a, const NearBoundary& b) {
  if (!is_on_end_alone(a) && !is_on_end_alone(b)) {
    if (!a.place || !b.place) return std::nullopt;
    return BoundaryPart::kSide;
  }
  const bool first_on_end = is_on_end_alone(a);
  const NearBoundary &at_end = first_on_end ? a : b, &other = first_on_end ? b : a;
  if (other.end == at_end.end && (is_on_end_alone(other) || from_corner(other) <= from_corner(at_end)))
    return at_end.end;
  if (!at_end.place) return std::nullopt;
  return BoundaryPart::kSide;
}

}  // namespace kerf
