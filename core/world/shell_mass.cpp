#include "core/world/shell_mass.h"

#include "core/base/assert.h"

namespace kerf {

namespace {

// The two axes of each product in AreaMoments::second.
constexpr std::array<std::array<int, 2>, 6> kAxes{{{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}}};

}  // namespace

AreaMoments& AreaMoments::operator+=(const AreaMoments& other) {
  first += other.first;
  for (size_t i = 0; i < second.size(); ++i) second[i] += other.second[i];
  return *this;
}

AreaMoments& AreaMoments::operator-=(const AreaMoments& other) {
  first -= other.first;
  for (size_t i = 0; i < second.size(); ++i) second[i] -= other.second[i];
  return *this;
}

AreaMoments area_moments(const Triangle& t, double area, const Vec3& origin) {
  const Vec3 p = t[0] - origin, q = t[1] - origin, r = t[2] - origin, s = p + q + r;
  AreaMoments moments;
  moments.first = area / 3 * s;
  for (size_t i = 0; i < kAxes.size(); ++i) {
    const auto [a, b] = kAxes[i];
    moments.second[i] = area / 12 * (p[a] * p[b] + q[a] * q[b] + r[a] * r[b] + s[a] * s[b]);
  }
  return moments;
}

MassProperties shell_mass(double area, const AreaMoments& moments, const Vec3& origin, double thickness,
                          double density) {
  KERF_ASSERT(thickness > 0 && density > 0);
  MassProperties shell{0, origin, glm::dmat3(0.0)};
  if (!(area > 0)) return shell;
  const double sigma = thickness * density;  // kg/m^2
  const Vec3 offset = moments.first / area;
  shell.mass = sigma * area;
  shell.centre = origin + offset;
  glm::dmat3 spread(0.0);  // second moments about the centre
  for (size_t i = 0; i < kAxes.size(); ++i) {
    const auto [a, b] = kAxes[i];
    spread[a][b] = spread[b][a] = moments.second[i] - moments.first[a] * offset[b];
  }
  const double trace = spread[0][0] + spread[1][1] + spread[2][2];
  shell.inertia = sigma * (glm::dmat3(trace) - spread);
  return shell;
}

}  // namespace kerf
