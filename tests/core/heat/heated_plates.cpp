#include "tests/core/heat/heated_plates.h"

#include <cmath>
#include <numbers>

#include "core/base/random.h"
#include "tests/support/made_meshes.h"

namespace kerf::test {
namespace {

// The mean of a density over a triangle, by the midpoints of the edges of its 4^levels parts.
double mean_over(const std::function<double(const Vec3&)>& density, const Triangle& t, int levels) {
  const Vec3 ab = 0.5 * (t[0] + t[1]), bc = 0.5 * (t[1] + t[2]), ca = 0.5 * (t[2] + t[0]);
  if (levels == 0) return (density(ab) + density(bc) + density(ca)) / 3;
  return 0.25 *
         (mean_over(density, {t[0], ab, ca}, levels - 1) + mean_over(density, {ab, t[1], bc}, levels - 1) +
          mean_over(density, {ca, bc, t[2]}, levels - 1) + mean_over(density, {ab, bc, ca}, levels - 1));
}

// Whether the fourth corner lies inside the circle of a triangle that is counter-clockwise seen against y.
bool in_circle(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const auto cosine = [](const Vec3& at, const Vec3& p, const Vec3& q) {
    return glm::dot(glm::normalize(p - at), glm::normalize(q - at));
  };
  return std::acos(cosine(c, a, b)) + std::acos(cosine(d, a, b)) > std::numbers::pi * (1 + 1e-9);
}

void make_delaunay(Mesh& mesh) {
  std::vector<Mesh::Side> sides;
  const auto far_corner = [&](FaceId f, VertexId a, VertexId b) {
    for (const VertexId v : mesh.corners(f)) {
      if (v != a && v != b) return v;
    }
    return VertexId();
  };
  for (bool turned = true; turned;) {
    turned = false;
    for_each_face(mesh, [&](FaceId f) {
      for (int i = 0; i < 3; ++i) {
        const VertexId a = mesh.corners(f)[i], b = mesh.corners(f)[(i + 1) % 3];
        sides.clear();
        mesh.append_edge_sides(f, a, b, sides);
        if (sides.size() != 1 || !mesh.can_flip_edge(f, a, b)) continue;
        const Vec3 c = mesh.position(far_corner(f, a, b)), d = mesh.position(far_corner(sides[0].face, a, b));
        if (!in_circle(mesh.position(a), mesh.position(b), c, d)) continue;
        mesh.flip_edge(f, a, b);
        turned = true;
      }
    });
  }
}

}  // namespace

Substance reference_steel() {
  return {.density = 7800,
          .heat_solid = 600,
          .heat_liquid = 600,
          .conductivity = 30,
          .transition = 1e6,
          .latent = 0,
          .emissivity = 0,
          .absorptivity_fibre = 1};
}

Soup plate_of(const std::vector<double>& xs, const std::vector<double>& zs, Diagonals diagonals) {
  Soup soup;
  for (const double x : xs) {
    for (const double z : zs) soup.positions.push_back({x, 0, z});
  }
  const auto columns = static_cast<uint32_t>(zs.size());
  for (uint32_t i = 0; i + 1 < xs.size(); ++i) {
    for (uint32_t j = 0; j + 1 < columns; ++j) {
      const uint32_t a = i * columns + j, b = a + 1, c = a + columns, d = c + 1;
      const bool other = diagonals == Diagonals::kAlternating && (i + j) % 2 == 1;
      soup.triangles.push_back(other ? Soup::Triangle{a, b, d} : Soup::Triangle{a, b, c});
      soup.triangles.push_back(other ? Soup::Triangle{a, d, c} : Soup::Triangle{b, d, c});
    }
  }
  return soup;
}

std::vector<double> graded(double from, double to, double step, double beyond) {
  std::vector<double> inside, left, right;
  const int count = static_cast<int>(std::lround((to - from) / step));
  for (int i = 0; i <= count; ++i) inside.push_back(from + (to - from) * i / count);
  for (double reached = 0, wide = 1.1 * step; reached < beyond; wide *= 1.1) {
    reached += wide;
    right.push_back(to + reached);
    left.insert(left.begin(), from - reached);
  }
  left.insert(left.end(), inside.begin(), inside.end());
  left.insert(left.end(), right.begin(), right.end());
  return left;
}

Mesh jittered_plate(double half, double step, double jitter, uint64_t seed) {
  Random random(seed);
  const double row = step * std::sqrt(0.75);
  const int rows = static_cast<int>(half / row), columns = static_cast<int>(half / step);
  std::vector<double> xs, zs;
  for (int i = -columns; i <= columns; ++i) xs.push_back(i * step);
  for (int j = -rows; j <= rows; ++j) zs.push_back(j * row);
  Soup soup = plate_of(xs, zs, Diagonals::kOneWay);
  for (Vec3& p : soup.positions) {
    if (static_cast<int>(std::lround(p.z / row)) % 2 != 0) p.x += 0.5 * step;
    p.x += jitter * step * random.uniform(-1, 1);
    p.z += jitter * step * random.uniform(-1, 1);
  }
  Mesh mesh = build(soup).mesh;
  make_delaunay(mesh);
  return mesh;
}

void HeatedMesh::deposit(const std::function<double(const Vec3&)>& density, const Vec3& centre,
                         double reach) {
  for_each_face(mesh, [&](FaceId f) {
    if (glm::length(centroid(mesh, f) - centre) > reach) return;
    const Triangle t = mesh.triangle(f);
    heat.set_energy(mesh, f, heat.energy_of(mesh, f) + triangle_area(t) * mean_over(density, t, 2));
  });
}

double HeatedMesh::rise_over(const std::function<double(const Vec3&)>& expected, const Vec3& at,
                             double within) const {
  double sum = 0;
  int count = 0;
  for_each_face(mesh, [&](FaceId f) {
    const Vec3 c = centroid(mesh, f);
    if (glm::length(c - at) > within) return;
    sum += rise(f) / expected(c);
    ++count;
  });
  return sum / count;
}

void HeatedMesh::conduct_in_steps(double seconds, double step, const HeatLoss& loss) {
  const int steps = static_cast<int>(std::lround(seconds / step));
  for (int i = 0; i < steps; ++i) conduct(seconds / steps, loss);
}

double gaussian(double distance2, double w) {
  return 2 / (std::numbers::pi * w * w) * std::exp(-2 * distance2 / (w * w));
}

Vec3 centroid(const Mesh& mesh, FaceId f) {
  const Triangle t = mesh.triangle(f);
  return (t[0] + t[1] + t[2]) / 3.0;
}

}  // namespace kerf::test
