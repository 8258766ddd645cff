#include "core/world/rigid_body.h"

#include "core/base/assert.h"
#include "core/world/world.h"

namespace kerf {

namespace {

// The two axes of each product in AreaMoments::second.
constexpr std::array<std::array<int, 2>, 6> kAxes{{{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}}};

// The two axes of each product in VolumeMoments::second.
constexpr std::array<std::array<int, 2>, 6> kProducts{{{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}}};

// Returns the inertia of a point mass about a point at this offset.
glm::dmat3 inertia_of_point(double mass, const Vec3& offset) {
  return mass * (glm::dmat3(glm::dot(offset, offset)) - glm::outerProduct(offset, offset));
}

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

VolumeMoments& VolumeMoments::operator+=(const VolumeMoments& other) {
  volume += other.volume;
  first += other.first;
  for (size_t i = 0; i < second.size(); ++i) second[i] += other.second[i];
  return *this;
}

VolumeMoments volume_moments(const Triangle& t, const Vec3& origin) {
  const Vec3 p = t[0] - origin, q = t[1] - origin, r = t[2] - origin, s = p + q + r;
  VolumeMoments moments;
  moments.volume = glm::dot(p, glm::cross(q, r)) / 6;
  moments.first = moments.volume / 4 * s;
  for (size_t i = 0; i < kProducts.size(); ++i) {
    const auto [a, b] = kProducts[i];
    moments.second[i] = moments.volume / 20 * (p[a] * p[b] + q[a] * q[b] + r[a] * r[b] + s[a] * s[b]);
  }
  return moments;
}

MassProperties solid_mass(const VolumeMoments& moments, const Vec3& origin, double density) {
  KERF_ASSERT(density > 0);
  MassProperties solid{0, origin, glm::dmat3(0.0)};
  if (!(moments.volume > 0)) return solid;
  const Vec3 offset = moments.first / moments.volume;
  solid.mass = density * moments.volume;
  solid.centre = origin + offset;
  glm::dmat3 spread(0.0);  // second moments about the centre
  for (size_t i = 0; i < kProducts.size(); ++i) {
    const auto [a, b] = kProducts[i];
    spread[a][b] = spread[b][a] = moments.second[i] - moments.first[a] * offset[b];
  }
  const double trace = spread[0][0] + spread[1][1] + spread[2][2];
  solid.inertia = density * (glm::dmat3(trace) - spread);
  return solid;
}

MassProperties combine(const MassProperties& a, const MassProperties& b) {
  if (!(b.mass > 0)) return a;
  if (!(a.mass > 0)) return b;
  MassProperties both;
  both.mass = a.mass + b.mass;
  both.centre = a.centre + b.mass / both.mass * (b.centre - a.centre);
  both.inertia = a.inertia + inertia_of_point(a.mass, a.centre - both.centre) + b.inertia +
                 inertia_of_point(b.mass, b.centre - both.centre);
  return both;
}

std::vector<BodyState> moved_bodies(const World& world, bool in_time) {
  std::vector<BodyState> states;
  for (const BodyId id : world.ids()) {
    const Body& body = world.body(id);
    const bool may_have_moved = in_time && body.placement != Placement{};
    if (may_have_moved || body.motion != Motion{}) states.push_back({id, body.placement, body.motion});
  }
  return states;
}

std::vector<NearPair> known_pairs(const World& world) {
  std::vector<NearPair> pairs;
  for (const PairMemory& m : world.contact_memory())
    pairs.push_back({m.first, m.second, m.touching, m.crossed});
  return pairs;
}

void set_known_pairs(World& world, std::span<const NearPair> pairs) {
  ContactMemory memory;
  for (const NearPair& p : pairs) {
    PairMemory& m = memory.emplace_back();
    m.first = p.first;
    m.second = p.second;
    m.touching = p.touching;
    m.crossed = p.crossed;
  }
  world.set_contact_memory(std::move(memory));
}

}  // namespace kerf
