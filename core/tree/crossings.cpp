#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/tolerances.h"
#include "core/tree/aabb_tree.h"

namespace kerf {

namespace {

// A ray in coordinates in which it runs along +z: an axis is exchanged and the others sheared (S. Woop,
// C. Benthin, I. Wald: Watertight ray/triangle intersection, 2013). A corner has the same image in every
// face, and signs of edges are antisymmetric to the bit, so neighbours agree on which side of their edge the
// ray is.
class ShearedRay {
 public:
  explicit ShearedRay(const Pose& ray) : origin_(ray.origin) {
    const Vec3 d = ray.direction, size = glm::abs(d);
    z_ = size.x >= size.y && size.x >= size.z ? 0 : (size.y >= size.z ? 1 : 2);
    x_ = (z_ + 1) % 3;
    y_ = (z_ + 2) % 3;
    shear_ = {d[x_] / d[z_], d[y_] / d[z_]};
    per_z_ = 1.0 / d[z_];
  }

  // Length along the unit direction at which the ray crosses the triangle.
  std::optional<double> cross(const Triangle& t) const {
    Vec2 p[3];
    double z[3];
    for (int i = 0; i < 3; ++i) {
      const Vec3 v = t[i] - origin_;
      p[i] = {v[x_] - shear_.x * v[z_], v[y_] - shear_.y * v[z_]};
      z[i] = v[z_];
    }
    const bool left = is_left(p[0], p[1]);
    if (is_left(p[1], p[2]) != left || is_left(p[2], p[0]) != left) return std::nullopt;
    const double a = cross2(p[1], p[2]), b = cross2(p[2], p[0]), c = cross2(p[0], p[1]), sum = a + b + c;
    if (sum == 0) return std::nullopt;
    return (a * z[0] + b * z[1] + c * z[2]) / sum * per_z_;
  }

 private:
  // Whether the ray passes left of a -> b. A tie is settled as if the ray stood a hair towards +x, and less
  // towards +y (simulation of simplicity), so that each surface is crossed exactly once.
  static bool is_left(Vec2 a, Vec2 b) {
    const double side = cross2(a, b);
    if (side != 0) return side > 0;
    return a.y != b.y ? a.y > b.y : a.x < b.x;
  }

  Vec3 origin_;
  Vec2 shear_;
  double per_z_ = 1;
  int x_ = 0, y_ = 1, z_ = 2;
};

}  // namespace

void AabbTree::crossings(const Mesh& mesh, const Pose& ray, Interval range, std::vector<RayHit>& out) const {
  if (root_ == kNone) return;
  const ShearedRay sheared(ray);
  const Vec3 start = (ray.origin - origin_) * scale_, d = ray.direction;
  const double slack = kBoxSlack * (8 + std::abs(start.x) + std::abs(start.y) + std::abs(start.z));
  const size_t first = out.size();
  // A line meets a box unless an axis of the box or a product of such an axis with the line keeps them apart.
  const auto meets = [&](const Node& n) {
    Vec3 c, h;
    for (int k = 0; k < 3; ++k) {
      c[k] = 0.5 * (double{n.low[k]} + n.high[k]) - start[k];
      h[k] = 0.5 * (double{n.high[k]} - n.low[k]) + slack;
    }
    const double depth = glm::dot(c, d), reach = glm::dot(glm::abs(d), h) + slack;
    if (depth + reach < range.low * scale_ - slack || depth - reach > range.high * scale_ + slack)
      return false;
    const Vec3 apart = glm::abs(glm::cross(d, c)), size = glm::abs(d);
    return apart.x <= size.y * h.z + size.z * h.y + slack && apart.y <= size.z * h.x + size.x * h.z + slack &&
           apart.z <= size.x * h.y + size.y * h.x + slack;
  };
  std::vector<uint32_t> stack{root_};
  while (!stack.empty()) {
    const Node& node = nodes_[stack.back()];
    stack.pop_back();
    if (!meets(node)) continue;
    if (!node.leaf()) {
      stack.push_back(node.child[1]);
      stack.push_back(node.child[0]);
      continue;
    }
    const FaceId face(node.child[0]);
    const auto length = sheared.cross(mesh.triangle(face));
    if (length && *length >= range.low && *length <= range.high) out.push_back({face, *length});
  }
  std::sort(out.begin() + static_cast<std::ptrdiff_t>(first), out.end(),
            [](const RayHit& a, const RayHit& b) {
              return a.length != b.length ? a.length < b.length : a.face < b.face;
            });
}

}  // namespace kerf
