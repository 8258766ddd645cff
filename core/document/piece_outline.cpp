#include "core/document/piece_outline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <set>

#include "core/base/assert.h"
#include "core/base/tolerances.h"
#include "core/document/job_files.h"

namespace kerf {

namespace {

// A side of a triangle, by vertices.
using Edge = std::pair<uint32_t, uint32_t>;

// Sine of the largest angle between coplanar faces.
const double kFlatAngle = std::sqrt(2 * (1 - kCoplanar));

class OutlineTracer {
 public:
  explicit OutlineTracer(const Extract& piece) : piece_(piece) {}

  std::optional<std::vector<DrawnLine>> run() {
    double largest = 0;
    Vec3 best(0);
    for (const Vec3& normal : normals()) {
      if (!is_flat_along(normal) || !(upper_area_ + lower_area_ > largest)) continue;
      largest = upper_area_ + lower_area_;
      best = normal;
    }
    if (!(largest > 0) || !is_flat_along(best)) return std::nullopt;
    set_axes();
    return trace();
  }

 private:
  Vec3 area_of(const std::array<uint32_t, 3>& t) const {
    const Vec3 &a = piece_.positions[t[0]], &b = piece_.positions[t[1]], &c = piece_.positions[t[2]];
    return 0.5 * glm::cross(b - a, c - a);
  }

  // Returns the normals along which most area lies: sides of a plate may have faces larger than its top, and
  // a round plate has many of them.
  std::vector<Vec3> normals() const {
    constexpr size_t kMost = 16, kMaxSides = 256;
    std::vector<Vec3> areas, found;
    for (const auto& t : piece_.triangles) areas.push_back(area_of(t));
    std::ranges::stable_sort(areas, std::greater(), [](const Vec3& area) { return glm::dot(area, area); });
    struct Side {
      Vec3 normal;
      double area;
    };
    std::vector<Side> sides;
    size_t others = 0;  // faces in a row of no side: a curved piece has hardly any others
    for (const Vec3& area : areas) {
      const double length = glm::length(area);
      if (!(length > 0) || others == kMaxSides) break;
      const auto same = std::ranges::find_if(sides, [&](const Side& side) {
        return std::abs(glm::dot(side.normal, area)) >= kCoplanar * length;
      });
      others = same == sides.end() && sides.size() == kMaxSides ? others + 1 : 0;
      if (same != sides.end()) {
        same->area += length;
      } else if (sides.size() < kMaxSides) {
        sides.push_back({area / length, length});
      }
    }
    std::ranges::stable_sort(sides, std::greater(), &Side::area);
    for (size_t i = 0; i < std::min(sides.size(), kMost); ++i) found.push_back(sides[i].normal);
    return found;
  }

  bool is_flat_along(const Vec3& normal) {
    set_normal(normal);
    sort_faces();
    return piece_.volume ? is_plate() : is_flat_sheet();
  }

  // Sets the normal, with a positive largest component.
  void set_normal(const Vec3& normal) {
    normal_ = normal;
    const Vec3 size = glm::abs(normal_);
    axis_ = size.x >= size.y ? (size.x >= size.z ? 0 : 2) : (size.y >= size.z ? 1 : 2);
    if (normal_[axis_] < 0) normal_ = -normal_;
  }

  // Finds the faces along the normal, by the direction in which they face, and the extent along it.
  void sort_faces() {
    upper_.clear();
    lower_.clear();
    upper_area_ = lower_area_ = 0;
    has_others_ = false;
    for (const auto& t : piece_.triangles) {
      const Vec3 area = area_of(t);
      const double length = glm::length(area), along = glm::dot(area, normal_);
      if (along >= kCoplanar * length) {
        upper_.push_back(t);
        upper_area_ += length;
      } else if (along <= -kCoplanar * length) {
        lower_.push_back(t);
        lower_area_ += length;
      } else {
        has_others_ = has_others_ || length > 0;
      }
    }
    low_ = high_ = glm::dot(normal_, piece_.positions.front());
    Bounds bounds = Bounds::none();
    for (const Vec3& p : piece_.positions) {
      low_ = std::min(low_, glm::dot(normal_, p));
      high_ = std::max(high_, glm::dot(normal_, p));
      bounds.add(p);
    }
    size_ = bounds.diagonal();
  }

  // The faces of a sheet may face in both directions.
  bool is_flat_sheet() {
    upper_.insert(upper_.end(), lower_.begin(), lower_.end());
    return !has_others_ && high_ - low_ <= kFlatAngle * size_;
  }
  bool is_plate() const {
    KERF_ASSERT(piece_.volume.has_value());
    constexpr double kSlack = 0.01;
    const double volume = upper_area_ * (high_ - low_);
    return std::abs(lower_area_ - upper_area_) <= kSlack * upper_area_ &&
           std::abs(volume - *piece_.volume) <= kSlack * volume;
  }

  void set_axes() {
    constexpr std::array kBeams{"-x", "-y", "-z"};
    const JobPlane plane = *plane_onto(kBeams[static_cast<size_t>(axis_)]);
    right_ = glm::normalize(plane.right - glm::dot(plane.right, normal_) * normal_);
    up_ = glm::cross(normal_, right_);
  }
  Vec2 flat(uint32_t vertex) const {
    const Vec3& p = piece_.positions[vertex];
    return {glm::dot(p, right_), glm::dot(p, up_)};
  }

  // Returns the loops of the edges of faces that no other face of the set has.
  std::vector<DrawnLine> trace() const {
    std::multiset<Edge> edges;
    for (const auto& t : upper_) {
      const bool upward = glm::dot(area_of(t), normal_) > 0;
      for (size_t i = 0; i < 3; ++i) {
        const Edge edge = upward ? Edge(t[i], t[(i + 1) % 3]) : Edge(t[(i + 1) % 3], t[i]);
        if (const auto twin = edges.find({edge.second, edge.first}); twin != edges.end())
          edges.erase(twin);
        else
          edges.insert(edge);
      }
    }
    std::vector<DrawnLine> lines;
    while (!edges.empty()) {
      DrawnLine& line = lines.emplace_back();
      line.closed = true;
      const uint32_t start = edges.begin()->first;
      for (auto edge = edges.begin(); edge != edges.end();) {
        line.points.push_back(flat(edge->first));
        const uint32_t to = edge->second;
        edges.erase(edge);
        edge = to == start ? edges.end() : edges.lower_bound({to, 0});
        if (edge != edges.end() && edge->first != to) edge = edges.end();
      }
      drop_collinear(line.points);
      if (line.points.size() < 3) lines.pop_back();
    }
    return lines;
  }

  // Drops points on the straight line between their neighbours.
  static void drop_collinear(std::vector<Vec2>& points) {
    std::vector<Vec2> kept;
    for (size_t i = 0; i < points.size(); ++i) {
      const Vec2 before = kept.empty() ? points.back() : kept.back(), after = points[(i + 1) % points.size()];
      const Vec2 in = points[i] - before, out = after - points[i];
      const double turn = std::abs(cross2(in, out)), size = glm::length(in) * glm::length(out);
      if (turn > kFlatAngle * size || glm::dot(in, out) < 0) kept.push_back(points[i]);
    }
    points = std::move(kept);
  }

  const Extract& piece_;
  Vec3 normal_{0}, right_{0}, up_{0};
  int axis_ = 0;  // of the largest component of the normal
  std::vector<std::array<uint32_t, 3>> upper_, lower_;
  double upper_area_ = 0, lower_area_ = 0;  // m^2
  double low_ = 0, high_ = 0;               // along the normal, m
  double size_ = 0;                         // diagonal of the bounding box, m
  bool has_others_ = false;                 // faces in other directions
};

}  // namespace

std::optional<std::vector<DrawnLine>> flat_outline(const Extract& piece) {
  return OutlineTracer(piece).run();
}

}  // namespace kerf
