#include "core/tree/swept_cylinder.h"

#include <array>
#include <cmath>
#include <limits>

#include "core/base/assert.h"
#include "core/base/tolerances.h"

namespace kerf {

namespace {

// Returns a unit vector perpendicular to d, built from the coordinate axis least parallel to d.
Vec3 any_across(const Vec3& d) {
  int least = 0;
  for (int i = 1; i < 3; ++i) {
    if (std::abs(d[i]) < std::abs(d[least])) least = i;
  }
  Vec3 e{0};
  e[least] = 1;
  return glm::normalize(glm::cross(d, e));
}

// Returns the squared distance of the origin from the segment a b, in the plane.
double distance2_to_segment(Vec2 a, Vec2 b) {
  const Vec2 ab = b - a;
  const double length2 = glm::dot(ab, ab), along = -glm::dot(a, ab);
  if (!(along > 0)) return glm::dot(a, a);
  if (along >= length2) return glm::dot(b, b);
  const double area = cross2(a, b), square = area * area;
  // Products of four lengths leave the range of doubles beyond 1e77 m and below 1e-68 m.
  constexpr double kMinPlain = 0x1p-900;  // m^4
  if (square >= kMinPlain && std::isfinite(square)) return square / length2;
  const double distance = area / std::sqrt(length2);
  return distance * distance;
}

// Returns true if the closed triangle contains the origin; false for a degenerate triangle.
bool holds_origin(Vec2 a, Vec2 b, Vec2 c) {
  const double ab = cross2(a, b), bc = cross2(b, c), ca = cross2(c, a);
  const bool left = ab >= 0 && bc >= 0 && ca >= 0, right = ab <= 0 && bc <= 0 && ca <= 0;
  return left != right;
}

// A triangle clipped by two parallel planes; it has at most five corners.
template <typename Point>
struct Polygon {
  std::array<Point, 5> points;
  int count = 0;
  void add(const Point& p) {
    assert(count < static_cast<int>(points.size()));
    points[count++] = p;
  }
};

// Returns the part of the polygon where sign * (depth - limit) >= 0.
template <typename Point>
Polygon<Point> clip(const Polygon<Point>& in, double limit, double sign) {
  Polygon<Point> out;
  for (int i = 0; i < in.count; ++i) {
    const Point &a = in.points[i], &b = in.points[(i + 1) % in.count];
    const double da = sign * (a.depth - limit), db = sign * (b.depth - limit);
    if (da >= 0) out.add(a);
    if ((da > 0 && db < 0) || (da < 0 && db > 0)) {
      const double t = da / (da - db);
      out.add({a.start + t * (b.start - a.start), a.end + t * (b.end - a.end), limit});
    }
  }
  return out;
}

// Returns true if the disc of this squared radius around the origin meets the region swept by the polygon.
template <typename Point>
bool disc_meets_sweep(const Polygon<Point>& p, double radius2, bool tilts) {
  for (int i = 0; i < p.count; ++i) {
    const Point &a = p.points[i], &b = p.points[(i + 1) % p.count];
    if (distance2_to_segment(a.start, b.start) <= radius2 || distance2_to_segment(a.end, b.end) <= radius2 ||
        distance2_to_segment(a.start, a.end) <= radius2) {
      return true;
    }
    if (holds_origin(a.start, b.start, b.end) || holds_origin(a.start, b.end, a.end)) return true;
    // An edge that turns while it moves sweeps more than a parallelogram.
    if (tilts && (holds_origin(a.start, b.start, a.end) || holds_origin(b.start, b.end, a.end))) return true;
  }
  for (int i = 2; i < p.count; ++i) {
    const Point &a = p.points[0], &b = p.points[i - 1], &c = p.points[i];
    if (holds_origin(a.start, b.start, c.start) || holds_origin(a.end, b.end, c.end)) return true;
  }
  return false;
}

Interval around(std::initializer_list<double> values, double margin) {
  return {std::min(values) - margin, std::max(values) + margin};
}

}  // namespace

SweptCylinder::SweptCylinder(const Pose& from, const Pose& to, double radius, Interval range)
    : from_origin_(from.origin), to_origin_(to.origin), radius_(radius), range_(range) {
  KERF_ASSERT(is_unit(from.direction) && is_unit(to.direction));
  KERF_ASSERT(radius >= 0);
  tilts_ = from.direction != to.direction;
  KERF_ASSERT(!are_opposite(from.direction, to.direction));
  axis_ = tilts_ ? glm::normalize(from.direction + to.direction) : from.direction;
  const Vec3 motion = to.origin - from.origin;
  shift_ = glm::dot(motion, axis_);
  const Vec3 sideways = motion - shift_ * axis_;
  const double length = glm::length(sideways);
  along_ = length > kMinSideways * glm::length(motion) ? sideways / length : any_across(axis_);
  across_ = glm::cross(axis_, along_);
  if (tilts_) {
    const auto tilt = [&](const Vec3& d) {
      return Vec2(glm::dot(d, along_), glm::dot(d, across_)) / glm::dot(d, axis_);
    };
    from_tilt_ = tilt(from.direction);
    to_tilt_ = tilt(to.direction);
    steepest_ = 1 + std::max(glm::length(from_tilt_), glm::length(to_tilt_));
  }
}

[[gnu::always_inline]] inline SweptCylinder::Seen SweptCylinder::see(const Vec3& p) const {
  const Vec3 a = p - from_origin_, b = p - to_origin_;
  const double depth = glm::dot(a, axis_);
  Seen seen{{glm::dot(a, along_), glm::dot(a, across_)}, {glm::dot(b, along_), glm::dot(b, across_)}, depth};
  if (tilts_) {
    seen.start -= depth * from_tilt_;
    seen.end -= (depth - shift_) * to_tilt_;
  }
  return seen;
}

Interval SweptCylinder::depth_touched() const {
  return {range_.low + std::min(0.0, shift_), range_.high + std::max(0.0, shift_)};
}

Interval SweptCylinder::depth_contained() const {
  return {range_.low + std::max(0.0, shift_), range_.high + std::min(0.0, shift_)};
}

bool SweptCylinder::touches(const Triangle& t, double radius) const {
  Polygon<Seen> polygon;
  for (const Vec3& p : t) polygon.add(see(p));
  const Interval depth = depth_touched();
  const auto [low, high] =
      std::minmax({polygon.points[0].depth, polygon.points[1].depth, polygon.points[2].depth});
  if (low > depth.high || high < depth.low) return false;
  if (low < depth.low) polygon = clip(polygon, depth.low, 1.0);
  if (high > depth.high) polygon = clip(polygon, depth.high, -1.0);
  return polygon.count > 0 && disc_meets_sweep(polygon, radius * radius, tilts_);
}

bool SweptCylinder::touches_exactly(const Triangle& t) const {
  if (tilts_) return false;
  if (shift_ == 0) return true;
  const Interval depth = depth_contained();
  return std::all_of(t.begin(), t.end(), [&](const Vec3& p) {
    const double own = glm::dot(p - from_origin_, axis_);
    return own >= depth.low && own <= depth.high;
  });
}

bool SweptCylinder::contains(const Triangle& t) const {
  if (!(radius_ > 0)) return false;
  const Interval depth = depth_contained();
  return std::all_of(t.begin(), t.end(), [&](const Vec3& p) {
    const Seen seen = see(p);
    return seen.depth >= depth.low && seen.depth <= depth.high &&
           distance2_to_segment(seen.start, seen.end) <= radius_ * radius_;
  });
}

// Returns the minimum over the motion of measure(distance from the axis minus the radius, depth beyond the
// ends of the range). Both arguments are convex functions of time, so that ternary search finds the minimum;
// it is skipped if the ends of the range do not move, or never affect the measure.
template <typename Measure>
double SweptCylinder::least_over_motion(const Seen& seen, Measure measure) const {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const Interval depth = depth_contained();
  const double lateral = std::sqrt(distance2_to_segment(seen.start, seen.end)) - radius_;
  const double beyond = std::max(seen.depth - depth.high, depth.low - seen.depth);
  // Bounds of the minimum: with the deepest ends of all moments, and without ends.
  const double upper = measure(lateral, beyond), lower = measure(lateral, -kInfinity);
  if (shift_ == 0 || (beyond <= 0 && upper == lower)) return upper;
  const auto at = [&](double s) {
    const Vec2 offset = seen.start + s * (seen.end - seen.start);
    const double d = seen.depth - s * shift_;
    return measure(glm::length(offset) - radius_, std::max(d - range_.high, range_.low - d));
  };
  constexpr int kThirds = 80;  // (2/3)^80 is below 1e-14
  double low = 0, high = 1;
  for (int i = 0; i < kThirds; ++i) {
    const double third = (high - low) / 3;
    const bool is_early = at(low + third) <= at(high - third);
    (is_early ? high : low) = is_early ? high - third : low + third;
  }
  return std::min({at(0), at(1), at(0.5 * (low + high))});
}

double SweptCylinder::overshoot(const Triangle& t) const {
  double most = 0;
  for (const Vec3& p : t) {
    const auto distance = [](double lateral, double beyond) {
      return glm::length(Vec2(std::max(0.0, lateral), std::max(0.0, beyond)));
    };
    most = std::max(most, least_over_motion(see(p), distance));
  }
  return most;
}

double SweptCylinder::signed_distance(const Vec3& p) const {
  return least_over_motion(see(p), [](double lateral, double beyond) { return std::max(lateral, beyond); });
}

SweptCylinder::Slab SweptCylinder::slab(Interval depths) const {
  const Interval own = depth_touched();
  const double low = std::max(own.low, depths.low), high = std::min(own.high, depths.high);
  const Vec3 motion = to_origin_ - from_origin_;
  const Vec2 end(glm::dot(motion, along_), glm::dot(motion, across_));
  const auto spread = [&](int k) {
    return around({low * from_tilt_[k], high * from_tilt_[k], end[k] + (low - shift_) * to_tilt_[k],
                   end[k] + (high - shift_) * to_tilt_[k]},
                  radius_);
  };
  return {axis_, along_, across_, from_origin_, {low, high}, spread(0), spread(1)};
}

}  // namespace kerf
