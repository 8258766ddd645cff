#include "tests/ui/render/shadow_scenes.h"

#include <cmath>

#include "core/base/random.h"

namespace kerf::test {

namespace {

constexpr double kNearOfFocus = 0.004;  // as the renderer places its near plane

Soup made(Soup soup) {
  soup.format = "made";
  soup.faces_in_file = soup.triangles_in_file = soup.triangles.size();
  return soup;
}

Vec3 middle_of(const Soup& soup, const Soup::Triangle& t) {
  return (soup.positions[t[0]] + soup.positions[t[1]] + soup.positions[t[2]]) / 3.0;
}

template <typename Predicate>
Soup without(Soup soup, const Predicate& is_removed) {
  std::erase_if(soup.triangles, [&](const Soup::Triangle& t) { return is_removed(middle_of(soup, t)); });
  return made(std::move(soup));
}

// A flat grid of cells from one corner along two sides.
void add_sheet(Soup& soup, const Vec3& corner, const Vec3& u, const Vec3& v, int cells) {
  const auto first = static_cast<uint32_t>(soup.positions.size());
  const auto row = static_cast<uint32_t>(cells + 1);
  for (int j = 0; j <= cells; ++j) {
    for (int i = 0; i <= cells; ++i)
      soup.positions.push_back(corner + u * (double(i) / cells) + v * (double(j) / cells));
  }
  for (uint32_t j = 0; j + 1 < row; ++j) {
    for (uint32_t i = 0; i + 1 < row; ++i) {
      const uint32_t a = first + j * row + i;
      soup.triangles.push_back({a, a + 1, a + row + 1});
      soup.triangles.push_back({a, a + row + 1, a + row});
    }
  }
}

Soup gridded_box(const Vec3& middle, const Vec3& size, int cells) {
  const Vec3 h = size * 0.5, x(size.x, 0, 0), y(0, size.y, 0), z(0, 0, size.z), low = middle - h,
             high = middle + h;
  Soup soup;
  add_sheet(soup, low, y, x, cells);
  add_sheet(soup, low, z, y, cells);
  add_sheet(soup, low, x, z, cells);
  add_sheet(soup, high, -x, -y, cells);
  add_sheet(soup, high, -y, -z, cells);
  add_sheet(soup, high, -z, -x, cells);
  return made(std::move(soup));
}

}  // namespace

Light lamp_at(const Vec3& position) {
  Light light;
  light.kind = Light::Kind::kPoint;
  light.at = position;
  return light;
}

Light sun_from(const Vec3& direction) {
  Light light;
  light.at = direction;
  return light;
}

CameraView shadow_view(const Vec3& eye, const Vec3& target, double near) {
  CameraView view = look_at(eye, target, static_cast<double>(kShadowWidth) / kShadowHeight);
  view.focus = near / kNearOfFocus;
  return view;
}

Soup box(const Vec3& middle, const Vec3& size) { return gridded_box(middle, size, 1); }

Soup floor_at(double y, double size) { return moved(plate(size), {0, y, 0}, 1); }

Soup opened_ball(const Vec3& direction, double cosine) {
  const Vec3 d = glm::normalize(direction);
  return without(sphere(20, 28, 1), [&](const Vec3& p) { return glm::dot(glm::normalize(p), d) > cosine; });
}

Soup windowed_box() {
  return without(gridded_box({0, 0, 0}, {2, 2, 2}, 8), [](const Vec3& p) {
    return std::abs(p.z) > 0.99 && std::max(std::abs(p.x), std::abs(p.y)) < 0.5;
  });
}

Soup wall_with_tees(int count, bool split) {
  Soup soup;
  const Vec3 top(0.31, 1.53, -0.72), foot(-0.29, 0.013, 0.83), left(-1.21, 0.87, -0.31),
      right(1.13, 0.71, 0.37);
  soup.positions = {top, foot, left, right};
  for (int i = 1; i <= count; ++i)
    soup.positions.push_back(top + (foot - top) * (static_cast<double>(i) / (count + 1)));
  const auto along = [&](int i) { return i == 0 ? 0u : i > count ? 1u : static_cast<uint32_t>(3 + i); };
  for (int i = 0; i <= count; ++i) soup.triangles.push_back({along(i), along(i + 1), 3});
  if (!split) soup.triangles.push_back({0, 2, 1});
  for (int i = 0; split && i <= count; ++i) soup.triangles.push_back({along(i + 1), along(i), 2});
  return made(std::move(soup));
}

Soup stack(int sheets) {
  Soup soup;
  for (int i = 0; i < sheets; ++i) add_sheet(soup, {-0.5, 1 + 0.002 * i, -0.5}, {0, 0, 1}, {1, 0, 0}, 1);
  return made(std::move(soup));
}

Soup triangles(int count, uint64_t seed) {
  Random random(seed);
  const auto near = [&](double size) {
    return Vec3(random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size));
  };
  Soup soup;
  for (int i = 0; i < count; ++i) {
    const Vec3 middle = near(1);
    const auto first = static_cast<uint32_t>(soup.positions.size());
    for (int k = 0; k < 3; ++k) soup.positions.push_back(middle + near(0.45));
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  return made(std::move(soup));
}

Soup turned_at_random(Soup soup, uint64_t seed) {
  Random random(seed);
  for (Soup::Triangle& t : soup.triangles) {
    if (random.below(2) == 0) std::swap(t[1], t[2]);
  }
  return soup;
}

Soup mirrored(Soup soup) {
  for (Vec3& p : soup.positions) p.x = -p.x;
  return soup;
}

World world_of_all(const std::vector<Soup>& soups) {
  World world;
  for (const Soup& soup : soups) world.add(make_body("body", build(soup)));
  return world;
}

}  // namespace kerf::test
