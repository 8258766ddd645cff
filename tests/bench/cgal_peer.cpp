#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include "tests/bench/peer.h"
#include "tests/bench/timing.h"

namespace kerf::bench {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangles = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

class Cgal : public Peer {
 public:
  explicit Cgal(const TriangleArrays& arrays) {
    const auto point = [&](uint32_t v) {
      const float* p = &arrays.positions[3 * size_t{v}];
      return Kernel::Point_3(p[0], p[1], p[2]);
    };
    for (size_t i = 0; i < arrays.corners.size(); i += 3) {
      triangles_.emplace_back(point(arrays.corners[i]), point(arrays.corners[i + 1]),
                              point(arrays.corners[i + 2]));
    }
    build_seconds_ = seconds_of([&] {
      tree_.insert(triangles_.begin(), triangles_.end());
      tree_.build();
    });
  }

  size_t all_hits(std::span<const Pose> rays, double reach) override {
    size_t hits = 0;
    std::vector<Primitive::Id> found;
    for (const Pose& ray : rays) {
      found.clear();
      tree_.all_intersected_primitives(segment(ray, reach), std::back_inserter(found));
      hits += found.size();
    }
    return hits;
  }
  size_t nearest_hits(std::span<const Pose> rays, double) override {
    size_t hits = 0;
    for (const Pose& ray : rays) {
      const Vec3 end = ray.origin + ray.direction;
      hits +=
          tree_.first_intersected_primitive(Kernel::Ray_3(point_of(ray.origin), point_of(end))).has_value();
    }
    return hits;
  }

  double build_seconds() const override { return build_seconds_; }

 private:
  static Kernel::Point_3 point_of(const Vec3& p) { return {p.x, p.y, p.z}; }
  static Kernel::Segment_3 segment(const Pose& ray, double reach) {
    return {point_of(ray.origin), point_of(ray.origin + reach * ray.direction)};
  }

  Triangles triangles_;
  Tree tree_;
  double build_seconds_ = 0;
};

}  // namespace

bool has_cgal() { return true; }
std::unique_ptr<Peer> make_cgal(const TriangleArrays& arrays) { return std::make_unique<Cgal>(arrays); }

}  // namespace kerf::bench
