#include "core/laser/spline.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/assert.h"

namespace kerf {

namespace {

constexpr int kMaxSplineDegree = 10;
constexpr int kMaxSplineHalvings = 20;

double distance_from_chord(Vec2 point, Vec2 begin, Vec2 end) {
  const Vec2 chord = end - begin;
  const double length2 = glm::dot(chord, chord);
  const double t = length2 > 0 ? std::clamp(glm::dot(point - begin, chord) / length2, 0.0, 1.0) : 0.0;
  return glm::length(point - begin - t * chord);
}

// Adds the points of a span after its begin.
void add_span(const Spline& spline, double begin, double end, int halvings, DrawingBuilder& builder) {
  const Vec2 from = spline_point(spline, begin), to = spline_point(spline, end);
  const auto deviates = [&](double share) {
    const Vec2 point = spline_point(spline, begin + share * (end - begin));
    return distance_from_chord(point, from, to) > 0.5 * builder.tolerance();
  };
  // A span of a higher degree may cross its chord, so it is halved at least once.
  const bool is_fine =
      halvings == kMaxSplineHalvings || !builder.fault().empty() ||
      ((halvings > 0 || spline.degree == 1) && !deviates(0.25) && !deviates(0.5) && !deviates(0.75));
  if (is_fine) {
    builder.line_to(to);
    return;
  }
  const double middle = 0.5 * begin + 0.5 * end;
  add_span(spline, begin, middle, halvings + 1, builder);
  add_span(spline, middle, end, halvings + 1, builder);
}

}  // namespace

std::optional<std::string> spline_fault(const Spline& spline) {
  if (spline.degree < 1 || spline.degree > kMaxSplineDegree) return "the degree must be from 1 to 10";
  const size_t controls = spline.controls.size(), degree = static_cast<size_t>(spline.degree);
  if (controls < degree + 1) return "there must be more control points than the degree";
  if (spline.knots.size() != controls + degree + 1)
    return "there must be as many knots as control points, plus the degree, plus 1";
  if (!std::ranges::is_sorted(spline.knots) || !(spline.knots[degree] < spline.knots[controls]))
    return "the knots must ascend";
  if (!spline.weights.empty() && spline.weights.size() != controls)
    return "each control point must have a weight";
  for (const double weight : spline.weights) {
    if (!(weight > 1e-9)) return "the weights must be greater than zero";
  }
  return std::nullopt;
}

Vec2 spline_point(const Spline& spline, double t) {
  const size_t degree = static_cast<size_t>(spline.degree), controls = spline.controls.size();
  const std::vector<double>& knots = spline.knots;
  KERF_ASSERT(knots[degree] <= t && t <= knots[controls]);
  // The span of the parameter: the last one that is not empty and begins at or before it.
  const auto first = knots.begin() + static_cast<std::ptrdiff_t>(degree);
  const auto last = knots.begin() + static_cast<std::ptrdiff_t>(controls);
  size_t span = static_cast<size_t>(std::upper_bound(first, last, t) - knots.begin()) - 1;
  while (span > degree && knots[span] == knots[span + 1]) --span;
  std::array<Vec3, kMaxSplineDegree + 1> d;  // in homogeneous coordinates
  for (size_t i = 0; i <= degree; ++i) {
    const size_t k = span - degree + i;
    const double weight = spline.weights.empty() ? 1 : spline.weights[k];
    d[i] = Vec3(weight * spline.controls[k], weight);
  }
  for (size_t r = 1; r <= degree; ++r) {
    for (size_t i = degree; i >= r; --i) {
      const double low = knots[span - degree + i], high = knots[span + 1 + i - r];
      const double share = high > low ? (t - low) / (high - low) : 0;
      d[i] = (1 - share) * d[i - 1] + share * d[i];
    }
  }
  return Vec2(d[degree]) / d[degree].z;
}

void add_spline(const Spline& spline, const std::string& layer, DrawingBuilder& builder) {
  KERF_ASSERT(!spline_fault(spline));
  const size_t degree = static_cast<size_t>(spline.degree);
  builder.move_to(spline_point(spline, spline.knots[degree]), layer);
  for (size_t k = degree; k < spline.controls.size(); ++k) {
    if (spline.knots[k] < spline.knots[k + 1])
      add_span(spline, spline.knots[k], spline.knots[k + 1], 0, builder);
  }
}

}  // namespace kerf
