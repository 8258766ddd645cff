#include "tests/support/sheets.h"

#include <cmath>

#include "core/world/body_creation.h"
#include "tests/support/made_meshes.h"

namespace kerf::test {

namespace {

constexpr double kFullTurn = 6.283185307179586;

uint32_t add_point(Soup& soup, const Vec3& p) {
  soup.positions.push_back(p);
  return static_cast<uint32_t>(soup.positions.size() - 1);
}

void add_quad(Soup& soup, uint32_t a, uint32_t b, uint32_t c, uint32_t d) {
  soup.triangles.push_back({a, b, c});
  soup.triangles.push_back({a, c, d});
}

void add_ring_point(Soup& soup, double radius, double y, int i, int sectors) {
  const double angle = kFullTurn * i / sectors;
  add_point(soup, {radius * std::sin(angle), y, radius * std::cos(angle)});
}

}  // namespace

Soup rectangle(double width, double depth, int cells) {
  Soup soup = grid(cells, 1);
  for (Vec3& p : soup.positions) p = {width * p.x, 0, depth * p.z};
  return soup;
}

Soup disc(double radius, int sectors) {
  Soup soup;
  add_point(soup, Vec3(0));
  for (int i = 0; i < sectors; ++i) add_ring_point(soup, radius, 0, i, sectors);
  for (int i = 0; i < sectors; ++i) {
    soup.triangles.push_back({0, static_cast<uint32_t>(1 + i), static_cast<uint32_t>(1 + (i + 1) % sectors)});
  }
  return soup;
}

Soup plate_with_hole(double size, double hole_radius, int sectors) {
  Soup soup;
  for (int i = 0; i < sectors; ++i) {
    const double angle = kFullTurn * i / sectors, x = std::sin(angle), z = std::cos(angle);
    add_point(soup, {hole_radius * x, 0, hole_radius * z});
    const double far = 0.5 * size / std::max(std::abs(x), std::abs(z));
    add_point(soup, {far * x, 0, far * z});
  }
  for (int i = 0; i < sectors; ++i) {
    const auto a = static_cast<uint32_t>(2 * i), b = static_cast<uint32_t>(2 * ((i + 1) % sectors));
    add_quad(soup, a, a + 1, b + 1, b);
  }
  return soup;
}

Soup closed_box(const Vec3& size) {
  Soup soup;
  for (int i = 0; i < 8; ++i) {
    add_point(soup, 0.5 * size * Vec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1));
  }
  add_quad(soup, 0, 2, 3, 1);
  add_quad(soup, 4, 5, 7, 6);
  add_quad(soup, 0, 1, 5, 4);
  add_quad(soup, 2, 6, 7, 3);
  add_quad(soup, 0, 4, 6, 2);
  add_quad(soup, 1, 3, 7, 5);
  return soup;
}

Soup rod(double radius, double length, int sectors) {
  Soup soup;
  const uint32_t bottom = add_point(soup, {0, -0.5 * length, 0}), top = add_point(soup, {0, 0.5 * length, 0});
  for (int i = 0; i < sectors; ++i) {
    add_ring_point(soup, radius, -0.5 * length, i, sectors);
    add_ring_point(soup, radius, 0.5 * length, i, sectors);
  }
  for (int i = 0; i < sectors; ++i) {
    const auto a = static_cast<uint32_t>(2 + 2 * i), b = static_cast<uint32_t>(2 + 2 * ((i + 1) % sectors));
    add_quad(soup, a, b, b + 1, a + 1);
    soup.triangles.push_back({bottom, b, a});
    soup.triangles.push_back({top, a + 1, b + 1});
  }
  return soup;
}

BodyId add(World& world, const Soup& soup, const Vec3& position, const glm::dquat& orientation) {
  Body body = make_body("sheet", build(soup));
  body.placement = {position, orientation};
  return world.add(std::move(body));
}

}  // namespace kerf::test
