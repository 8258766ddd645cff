#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/assert.h"
#include "core/base/deterministic_math.h"
#include "core/base/tolerances.h"
#include "core/walls/wall_chart_internal.h"

namespace kerf {

namespace {

// For beams that are not parallel: the number of depths, and the length below which curves are ignored, in
// radii, since small gaps between strokes appear and disappear with the depth.
constexpr size_t kSlices = 17;
constexpr double kMinCurve = 1;
// Min way round the axis of turning beams, in radii.
constexpr double kMinAround = 4 * kPi;

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

// Replaces `found` by the nearest place that is nearer than `best`, or as near if there is none.
void WallChart::nearest_to(const Slice& slice, Vec2 p, std::optional<Near>& found, double& best) {
  std::optional<uint32_t> curve_of_best;
  double length = 0;  // along the curve
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
      if (!(curve_of_best || found ? distance < best : distance <= best)) continue;
      curve_of_best = c;
      best = distance;
      length = curve.starts[i] + share * piece.length;
    }
  }
  if (!curve_of_best) return;
  const Curve& own = slice.curves[*curve_of_best];
  found = Near{*curve_of_best, modulo(own.place(length), own.period)};
}

std::optional<WallChart::Near> WallChart::nearest(const Slice& slice, Vec2 p, double reach) {
  std::optional<Near> found;
  double best = reach;
  if (slice.around == 0) nearest_to(slice, p, found, best);
  for (double k = slice.first_turn; slice.around > 0 && k <= slice.last_turn; ++k)
    nearest_to(slice, {p.x, modulo(p.y, slice.around) + k * slice.around}, found, best);
  return found;
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

WallChart::Guides WallChart::guides_of(std::vector<DiscMove> discs) {
  Guides guides;
  for (size_t i = 0; i < discs.size(); ++i) {
    const DiscMove& m = discs[i];
    if (i % kTogether == 0) guides.boxes.push_back({m.from, m.from});
    Box& box = guides.boxes.back();
    box = {glm::min(box.low, glm::min(m.from, m.to)), glm::max(box.high, glm::max(m.from, m.to))};
  }
  guides.moves = std::move(discs);
  return guides;
}

Task<std::optional<WallChart::Slice>> WallChart::make_slice(std::span<const BeamMove> moves,
                                                            std::span<const BeamPencil::Hit> hits,
                                                            double radius, double depth) const {
  Slice slice;
  slice.depth = depth;
  slice.around = pencil_.around(depth);
  if (pencil_.kind() == BeamPencil::Kind::kApex && !(depth > radius)) co_return std::nullopt;
  auto discs = pencil_.at_depth(moves, hits, depth);
  if (!discs || discs->empty()) co_return std::nullopt;
  std::vector<OutlineCurve> outlines;
  if (slice.around > 0) {
    if (!(slice.around > kMinAround * radius)) co_return std::nullopt;
    outlines = co_await outline_around(*discs, radius, slice.around);
    for (const DiscMove& m : *discs) {
      slice.first_turn =
          std::min(slice.first_turn, std::floor(std::min(m.from.y, m.to.y) / slice.around) - 1);
      slice.last_turn = std::max(slice.last_turn, std::ceil(std::max(m.from.y, m.to.y) / slice.around) + 2);
    }
  } else {
    outlines = co_await outline_of(*discs, radius);
  }
  for (OutlineCurve& outline : outlines) {
    if (!pencil_.parallel() && outline.length < kMinCurve * radius) continue;
    Curve curve;
    curve.set_outline(std::move(outline));
    slice.curves.push_back(std::move(curve));
  }
  if (slice.curves.empty()) co_return std::nullopt;
  if (!pencil_.parallel() && !has_apex()) slice.guides = guides_of(std::move(*discs));
  co_await yield_after(moves.size());
  co_return slice;
}

Task<std::optional<WallChart>> WallChart::make(const BeamPencil& pencil, std::span<const BeamMove> moves,
                                               double radius, Interval depths, Interval range) {
  KERF_ASSERT(radius > 0);
  WallChart chart(pencil);
  const size_t slices = pencil.parallel() ? 1 : kSlices;
  const std::vector<BeamPencil::Hit> hits = pencil.hits(moves, range, 0.5 * depths.low + 0.5 * depths.high);
  for (size_t s = 0; s < slices; ++s) {
    double depth = depths.low;
    if (slices > 1)
      depth += (depths.high - depths.low) * static_cast<double>(s) / static_cast<double>(slices - 1);
    auto slice = co_await chart.make_slice(moves, hits, radius, depth);
    if (!slice || (s > 0 && slice->curves.size() != chart.slices_[0].curves.size())) co_return std::nullopt;
    chart.slices_.push_back(std::move(*slice));
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

// The distance from the axis stays the same along the beam. Round an axis, arcs are compared as angles.
std::pair<Vec2, Vec2> WallChart::along_beam(const BeamPencil::Seen& seen, size_t below, double share) const {
  const Slice &a = slices_[below], &b = slices_[below + 1];
  KERF_ASSERT(a.guides.moves.size() == b.guides.moves.size());
  const double around = pencil_.around(seen.depth);
  const auto scale = [&](const Slice& slice) { return Vec2(1, around > 0 ? around / slice.around : 1); };
  const Vec2 scale_a = scale(a), scale_b = scale(b);
  const auto between = [&](Vec2 at_a, Vec2 at_b) {
    return (1 - share) * scale_a * at_a + share * scale_b * at_b;
  };
  double best = std::numeric_limits<double>::infinity();
  std::pair<Vec2, Vec2> found;
  const auto visit = [&](Vec2 p, size_t i) {
    const DiscMove &in_a = a.guides.moves[i], &in_b = b.guides.moves[i];
    const Vec2 from = between(in_a.from, in_b.from), way = between(in_a.to, in_b.to) - from;
    const double length2 = glm::dot(way, way);
    const double along = length2 > 0 ? std::clamp(glm::dot(p - from, way) / length2, 0.0, 1.0) : 0;
    const Vec2 aside = p - (from + along * way);
    if (!(glm::dot(aside, aside) < best)) return;
    best = glm::dot(aside, aside);
    found = {in_a.from + along * (in_a.to - in_a.from) + aside,
             in_b.from + along * (in_b.to - in_b.from) + aside};
  };
  for (double k = a.first_turn; k <= a.last_turn; ++k) {
    const Vec2 p(seen.place.x, around > 0 ? modulo(seen.place.y, around) + k * around : seen.place.y);
    for (size_t i = 0; i < a.guides.moves.size(); ++i) {
      if (i % kTogether == 0) {
        const Box &in_a = a.guides.boxes[i / kTogether], &in_b = b.guides.boxes[i / kTogether];
        const Vec2 nearest = glm::clamp(p, between(in_a.low, in_b.low), between(in_a.high, in_b.high));
        if (glm::dot(p - nearest, p - nearest) > best) {
          i += kTogether - 1;
          continue;
        }
      }
      visit(p, i);
    }
  }
  return found;
}

std::optional<WallChart::Place> WallChart::place_of(const Vec3& p, double reach) const {
  const BeamPencil::Seen seen = pencil_.see(p);
  const auto [below, share] = slice_below(seen.depth);
  if (slices_.size() == 1) {
    const auto only = nearest(slices_[0], seen.place, reach);
    if (!only) return std::nullopt;
    return Place{only->curve, only->place, seen.depth};
  }
  std::pair<Vec2, Vec2> at;
  if (has_apex()) {
    // Towards an apex everything but the radius shrinks.
    at = {seen.place * (slices_[below].depth / seen.depth),
          seen.place * (slices_[below + 1].depth / seen.depth)};
  } else {
    at = along_beam(seen, below, share);
  }
  const auto a = nearest(slices_[below], at.first, reach);
  if (!a) return std::nullopt;
  const auto b = nearest(slices_[below + 1], at.second, reach);
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
  Vec2 b = slices_[below + 1].curves[place.curve].at(place.around);
  const double around = pencil_.around(place.depth);
  if (around == 0) return pencil_.point(a + share * (b - a), place.depth);
  const double turn_a = a.y / slices_[below].around;
  double turns = b.y / slices_[below + 1].around - turn_a;
  turns -= std::round(turns);
  return pencil_.point({a.x + share * (b.x - a.x), (turn_a + share * turns) * around}, place.depth);
}

std::vector<double> WallChart::corners(uint32_t curve, double turn) const {
  KERF_ASSERT(curve < curves() && turn > 0);
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
