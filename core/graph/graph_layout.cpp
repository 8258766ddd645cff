#include "core/graph/drawn_graph.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/deterministic_math.h"
#include "core/base/random.h"

namespace kerf {

namespace {

using Matrix3 = std::array<std::array<double, 3>, 3>;  // rows

constexpr int kSweeps = 12;       // of Jacobi's method, which converges quadratically
constexpr int kTurns = 120;       // iterations of the forces
constexpr double kJitter = 1e-3;  // of the side of the layout, so that no two nodes coincide

std::vector<Vec3> middles_of(const DrawnGraph& graph, bool only_removed) {
  std::vector<Vec3> middles;
  for (const DrawnGraph::Node& n : graph.nodes) {
    if (n.removed || !only_removed) middles.push_back(n.middle);
  }
  return middles;
}

Vec3 mean_of(const std::vector<Vec3>& points) {
  Vec3 mean(0);
  for (size_t i = 0; i < points.size(); ++i) mean += (points[i] - mean) / static_cast<double>(i + 1);
  return mean;
}

Matrix3 covariance(const std::vector<Vec3>& points, const Vec3& mean) {
  Matrix3 sum{};
  for (const Vec3& p : points) {
    const Vec3 d = p - mean;
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < 3; ++k) sum[static_cast<size_t>(i)][static_cast<size_t>(k)] += d[i] * d[k];
    }
  }
  return sum;
}

// One rotation of Jacobi's method: zeroes m[p][q] and rotates the columns of `axes` accordingly.
void rotate(Matrix3& m, Matrix3& axes, size_t p, size_t q) {
  if (m[p][q] == 0) return;
  const double theta = (m[q][q] - m[p][p]) / (2 * m[p][q]);
  const double t = (theta >= 0 ? 1 : -1) / (std::abs(theta) + std::sqrt(theta * theta + 1));
  const double c = 1 / std::sqrt(t * t + 1), s = t * c;
  for (size_t k = 0; k < 3; ++k) {
    const double a = m[k][p], b = m[k][q];
    m[k][p] = c * a - s * b;
    m[k][q] = s * a + c * b;
  }
  for (size_t k = 0; k < 3; ++k) {
    const double a = m[p][k], b = m[q][k];
    m[p][k] = c * a - s * b;
    m[q][k] = s * a + c * b;
  }
  for (size_t k = 0; k < 3; ++k) {
    const double a = axes[k][p], b = axes[k][q];
    axes[k][p] = c * a - s * b;
    axes[k][q] = s * a + c * b;
  }
}

// Returns the eigenvectors of a symmetric matrix by descending eigenvalue, with positive largest components.
std::array<Vec3, 3> main_directions(Matrix3 m) {
  Matrix3 axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    rotate(m, axes, 0, 1);
    rotate(m, axes, 0, 2);
    rotate(m, axes, 1, 2);
  }
  std::array<size_t, 3> order{0, 1, 2};
  std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) { return m[a][a] > m[b][b]; });
  std::array<Vec3, 3> directions;
  for (size_t i = 0; i < 3; ++i) {
    Vec3 v(axes[0][order[i]], axes[1][order[i]], axes[2][order[i]]);
    double largest = v.x;
    for (const double c : {v.y, v.z}) {
      if (std::abs(c) > std::abs(largest)) largest = c;
    }
    directions[i] = largest < 0 ? -v : v;
  }
  return directions;
}

// Scales a layout to the square [-1, 1]^2.
void fit(GraphLayout& places) {
  if (places.empty()) return;
  Vec2 low = places[0], high = places[0];
  for (const Vec2& p : places) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  const double side = std::max(high.x - low.x, high.y - low.y);
  const Vec2 middle = 0.5 * (low + high);
  for (Vec2& p : places) p = side > 0 ? (p - middle) * (2 / side) : Vec2(0);
}

// A grid of square cells of nodes, to find nearby ones.
class Cells {
 public:
  static constexpr int kMaxCells = 64;  // a side

  // Covers all places by cells of at least this width. Precondition: there is a place, and width > 0.
  Cells(const GraphLayout& places, double width) : low_(places[0]) {
    Vec2 high = places[0];
    for (const Vec2& p : places) {
      low_ = glm::min(low_, p);
      high = glm::max(high, p);
    }
    width_ = std::max(width, std::max(high.x - low_.x, high.y - low_.y) / kMaxCells);
    in_.resize(size_t{kMaxCells} * kMaxCells);
    for (uint32_t i = 0; i < places.size(); ++i)
      in_[at(column(places[i].x, low_.x), column(places[i].y, low_.y))].push_back(i);
  }

  // Calls visit(node) for all nodes nearer to a place than the width of a cell, and some others.
  template <typename Visit>
  void for_each_near(const Vec2& place, const Visit& visit) const {
    const int x = column(place.x, low_.x), y = column(place.y, low_.y);
    for (int v = std::max(0, y - 1); v <= std::min(kMaxCells - 1, y + 1); ++v) {
      for (int u = std::max(0, x - 1); u <= std::min(kMaxCells - 1, x + 1); ++u) {
        for (const uint32_t node : in_[at(u, v)]) visit(node);
      }
    }
  }

 private:
  int column(double x, double low) const {
    return std::clamp(static_cast<int>((x - low) / width_), 0, kMaxCells - 1);
  }
  static size_t at(int x, int y) { return static_cast<size_t>(y) * kMaxCells + static_cast<size_t>(x); }

  Vec2 low_;
  double width_ = 1;
  std::vector<std::vector<uint32_t>> in_;
};

class Forces {
 public:
  Forces(const DrawnGraph& graph, GraphLayout& places)
      : graph_(graph),
        places_(places),
        force_(places.size()),
        spring_(2 / std::sqrt(static_cast<double>(places.size()))) {}

  // Moves each node by its force, at most by `farthest`.
  void turn(double farthest) {
    std::fill(force_.begin(), force_.end(), Vec2(0));
    const Cells cells(places_, 2 * spring_);
    for (uint32_t i = 0; i < places_.size(); ++i)
      cells.for_each_near(places_[i], [&](uint32_t k) { repel(i, k); });
    attract();
    for (size_t i = 0; i < places_.size(); ++i) {
      const double length = glm::length(force_[i]);
      if (length > 0) places_[i] += force_[i] * (std::min(length, farthest) / length);
    }
  }

 private:
  void repel(uint32_t i, uint32_t k) {
    const Vec2 away = places_[i] - places_[k];
    const double distance2 = glm::dot(away, away);
    if (i == k || !(distance2 > 0) || distance2 > 4 * spring_ * spring_) return;
    force_[i] += away * (spring_ * spring_ / distance2);
  }

  void attract() {
    for (const auto& [a, b] : graph_.edges) {
      const Vec2 to = places_[b] - places_[a];
      const Vec2 pull = to * (glm::length(to) / spring_);
      force_[a] += pull;
      force_[b] -= pull;
    }
  }

  const DrawnGraph& graph_;
  GraphLayout& places_;
  std::vector<Vec2> force_;
  double spring_;
};

// A ring around the middle of the removed faces, in the plane in which these extend most.
class Ring {
 public:
  explicit Ring(const std::vector<Vec3>& removed)
      : middle_(mean_of(removed)), directions_(main_directions(covariance(removed, middle_))) {
    for (const Vec3& p : removed) {
      turns_.push_back(doubled_area(p));
      radius_ += glm::length(flat(p)) / static_cast<double>(removed.size());
    }
    for (const Vec3& p : removed) inside_ += glm::length(flat(p)) < kInside * radius_ ? 1 : 0;
    std::sort(turns_.begin(), turns_.end());
    for (size_t i = 0; i < turns_.size(); ++i) {
      const double next = i + 1 < turns_.size() ? turns_[i + 1] : turns_.front() + kTurn;
      if (next - turns_[i] <= gap_) continue;
      gap_ = next - turns_[i];
      seam_ = turns_[i] + 0.5 * gap_;
    }
  }

  // Returns true if the removed faces run around: the widest gap between them is less than a quarter turn,
  // and few of them are near the middle, through which a cut across a sheet runs.
  bool is_round() const {
    return radius_ > 0 && gap_ < kTurn / 4 &&
           static_cast<double>(inside_) < 0.05 * static_cast<double>(turns_.size());
  }
  // Returns the position of a point on the unrolled ring in radii: path from the seam, signed distance.
  Vec2 unrolled(const Vec3& p) const {
    double turn = doubled_area(p) - seam_;
    while (turn < 0) turn += kTurn;
    while (turn >= kTurn) turn -= kTurn;
    const double up = glm::dot(p - middle_, directions_[2]), off = glm::length(flat(p)) - radius_;
    const double away = std::sqrt(up * up + off * off) / radius_;
    return {kCircle * turn / kTurn, up < 0 ? -away : away};
  }

 private:
  static constexpr double kTurn = 4;      // of an angle as doubled_area() measures it
  static constexpr double kInside = 0.3;  // of the mean radius
  static constexpr double kCircle = 2 * kPi;

  Vec2 flat(const Vec3& p) const {
    return {glm::dot(p - middle_, directions_[0]), glm::dot(p - middle_, directions_[1])};
  }
  // From 0 to kTurn, monotone in the angle and equal to it, in quarter turns, at multiples of an eighth.
  double doubled_area(const Vec3& p) const {
    const Vec2 v = flat(p);
    const double size = std::abs(v.x) + std::abs(v.y);
    if (!(size > 0)) return 0;
    const double quarter = v.y / size;
    if (v.x < 0) return 2 - quarter;
    return quarter < 0 ? kTurn + quarter : quarter;
  }

  Vec3 middle_;
  std::array<Vec3, 3> directions_;
  std::vector<double> turns_;
  double radius_ = 0, gap_ = 0, seam_ = 0;
  size_t inside_ = 0;  // removed faces near the middle
};

}  // namespace

std::optional<GraphLayout> lay_out_unrolled(const DrawnGraph& graph) {
  constexpr double kMinHeight = 0.4;  // of the width
  const std::vector<Vec3> removed = middles_of(graph, true);
  if (removed.size() < 3) return std::nullopt;
  const Ring ring(removed);
  if (!ring.is_round()) return std::nullopt;
  GraphLayout places;
  double width = 0, height = 0;
  for (const DrawnGraph::Node& n : graph.nodes) {
    places.push_back(ring.unrolled(n.middle));
    width = std::max(width, places.back().x);
    height = std::max(height, 2 * std::abs(places.back().y));
  }
  const double stretch = height > 0 ? std::max(1.0, kMinHeight * width / height) : 1;
  for (Vec2& p : places) p.y *= stretch;
  fit(places);
  return places;
}

GraphLayout lay_out_by_position(const DrawnGraph& graph) {
  const std::vector<Vec3> middles = middles_of(graph, false);
  const Vec3 mean = mean_of(middles);
  const std::array<Vec3, 3> directions = main_directions(covariance(middles, mean));
  GraphLayout places;
  for (const DrawnGraph::Node& n : graph.nodes)
    places.emplace_back(glm::dot(n.middle - mean, directions[0]), glm::dot(n.middle - mean, directions[1]));
  fit(places);
  return places;
}

GraphLayout lay_out_by_force(const DrawnGraph& graph) {
  GraphLayout places = lay_out_by_position(graph);
  if (places.empty()) return places;
  Random random(1);
  for (Vec2& p : places) p += kJitter * Vec2(random.uniform(-1, 1), random.uniform(-1, 1));
  Forces forces(graph, places);
  for (int i = 0; i < kTurns; ++i) forces.turn(0.1 * (kTurns - i) / kTurns);
  fit(places);
  return places;
}

}  // namespace kerf
