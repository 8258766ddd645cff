#include "tests/support/made_meshes.h"

#include <cmath>
#include <stdexcept>

namespace kerf::test {

namespace {

constexpr double kTurn = 6.283185307179586;

Soup finish(Soup soup) {
  soup.format = "made";
  soup.faces_in_file = soup.triangles_in_file = soup.triangles.size();
  return soup;
}

uint32_t add(Soup& soup, const Vec3& p) {
  soup.positions.push_back(p);
  return static_cast<uint32_t>(soup.positions.size() - 1);
}

// Two triangles for each cell of a field of `rows` by `columns` vertices; `wrap` closes the columns.
void add_cells(Soup& soup, uint32_t first, int rows, int columns, bool wrap) {
  const auto at = [&](int r, int c) { return first + static_cast<uint32_t>(r * columns + c % columns); };
  for (int r = 0; r + 1 < rows; ++r) {
    for (int c = 0; c < (wrap ? columns : columns - 1); ++c) {
      soup.triangles.push_back({at(r, c), at(r + 1, c), at(r + 1, c + 1)});
      soup.triangles.push_back({at(r, c), at(r + 1, c + 1), at(r, c + 1)});
    }
  }
}

}  // namespace

Soup plate(double size) { return grid(1, size); }

Soup grid(int cells, double size) {
  Soup soup;
  for (int r = 0; r <= cells; ++r) {
    for (int c = 0; c <= cells; ++c) {
      add(soup,
          {size * (static_cast<double>(c) / cells - 0.5), 0, size * (static_cast<double>(r) / cells - 0.5)});
    }
  }
  add_cells(soup, 0, cells + 1, cells + 1, false);
  return finish(std::move(soup));
}

Soup sphere(int rings, int sectors, double radius) {
  Soup soup;
  const uint32_t top = add(soup, {0, radius, 0}), bottom = add(soup, {0, -radius, 0});
  for (int r = 1; r < rings; ++r) {
    for (int s = 0; s < sectors; ++s) {
      const double a = kTurn / 2 * r / rings, b = kTurn * s / sectors;
      add(soup, radius * Vec3(std::sin(a) * std::sin(b), std::cos(a), std::sin(a) * std::cos(b)));
    }
  }
  add_cells(soup, 2, rings - 1, sectors, true);
  const uint32_t last = 2 + static_cast<uint32_t>((rings - 2) * sectors);
  for (uint32_t s = 0; s < static_cast<uint32_t>(sectors); ++s) {
    const uint32_t n = (s + 1) % static_cast<uint32_t>(sectors);
    soup.triangles.push_back({top, 2 + s, 2 + n});
    soup.triangles.push_back({bottom, last + n, last + s});
  }
  return finish(std::move(soup));
}

Soup torus(int rings, int sectors, double major, double minor) {
  Soup soup;
  const auto point = [&](int r, int s) {
    const double a = kTurn * (r % rings) / rings, b = kTurn * s / sectors;
    return Vec3((major + minor * std::cos(b)) * std::sin(a), minor * std::sin(b),
                (major + minor * std::cos(b)) * std::cos(a));
  };
  for (int r = 0; r <= rings; ++r) {
    for (int s = 0; s < sectors; ++s) add(soup, point(r, s));
  }
  add_cells(soup, 0, rings + 1, sectors, true);
  return finish(std::move(soup));
}

Soup tube(int rings, int sectors, double radius, double length) {
  Soup soup;
  for (int r = 0; r <= rings; ++r) {
    for (int s = 0; s < sectors; ++s) {
      const double a = kTurn * s / sectors;
      add(soup,
          {radius * std::cos(a), length * (0.5 - static_cast<double>(r) / rings), radius * std::sin(a)});
    }
  }
  add_cells(soup, 0, rings + 1, sectors, true);
  return finish(std::move(soup));
}

Soup brick(const Vec3& size) {
  Soup soup;
  for (int i = 0; i < 8; ++i) add(soup, {i & 1 ? size.x : 0, i & 2 ? size.y : 0, i & 4 ? size.z : 0});
  soup.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return finish(std::move(soup));
}

Soup pipe(int sectors, double inner, double outer, double length) {
  Soup soup;
  const auto add_ring = [&](double radius, double y) {
    for (int s = 0; s < sectors; ++s) {
      const double a = kTurn * s / sectors;
      add(soup, {radius * std::cos(a), y, radius * std::sin(a)});
    }
  };
  for (const double radius : {outer, inner, inner, outer, outer})
    add_ring(radius,
             (soup.positions.size() / static_cast<size_t>(sectors)) % 4 < 2 ? length / 2 : -length / 2);
  add_cells(soup, 0, 5, sectors, true);
  return finish(std::move(soup));
}

Soup moebius(int cells) {
  Soup soup;
  for (int c = 0; c < cells; ++c) {
    const double a = kTurn * c / cells;
    for (const double w : {-0.2, 0.2}) {
      const double r = 1 + w * std::cos(a / 2);
      add(soup, {r * std::cos(a), w * std::sin(a / 2), r * std::sin(a)});
    }
  }
  for (int c = 0; c < cells; ++c) {
    const uint32_t a = static_cast<uint32_t>(2 * c), b = a + 1;
    const bool last = c + 1 == cells;
    const uint32_t an = last ? 1 : a + 2,
                   bn = last ? 0 : a + 3;  // the last cell joins the first one turned over
    soup.triangles.push_back({a, b, bn});
    soup.triangles.push_back({a, bn, an});
  }
  return finish(std::move(soup));
}

Soup book(int sheets) {
  Soup soup;
  const uint32_t a = add(soup, {0, 0, 0}), b = add(soup, {0, 1, 0});
  for (int i = 0; i < sheets; ++i) {
    const double angle = kTurn * i / sheets;
    const Vec3 out(std::cos(angle), 0, std::sin(angle));
    const uint32_t c = add(soup, out), d = add(soup, out + Vec3(0, 1, 0));
    soup.triangles.push_back({a, c, d});
    if (i % 2 == 0)
      soup.triangles.push_back({a, d, b});
    else
      soup.triangles.push_back({d, a, b});
  }
  return finish(std::move(soup));
}

Soup random_soup(int triangles, Random& random) {
  Soup soup;
  const std::array<double, 4> lattice = {random.unit(), random.unit(), random.unit(), random.unit()};
  for (int t = 0; t < triangles; ++t) {
    std::array<uint32_t, 3> corners{};
    for (uint32_t& c : corners) {
      // A few planes make shared edges, edges of many faces and copies likely; uneven ones, so that no
      // midpoint falls on another vertex by chance.
      const auto coordinate = [&] { return lattice[random.below(4)]; };
      const Vec3 p = random.below(3) > 0 ? Vec3(coordinate(), coordinate(), coordinate())
                                         : Vec3(random.unit(), random.unit(), random.unit());
      c = add(soup, p);
    }
    soup.triangles.push_back(corners);
  }
  return finish(std::move(soup));
}

Soup pillow() {
  Soup soup;
  soup.positions = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}};
  soup.triangles = {{0, 1, 2}, {0, 1, 2}};
  return finish(std::move(soup));
}

Soup both(const Soup& a, const Soup& b) {
  Soup soup = a;
  const uint32_t offset = static_cast<uint32_t>(a.positions.size());
  soup.positions.insert(soup.positions.end(), b.positions.begin(), b.positions.end());
  for (const auto& t : b.triangles) soup.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
  return finish(std::move(soup));
}

Soup moved(Soup soup, const Vec3& by, double scale) {
  for (Vec3& p : soup.positions) p = p * scale + by;
  return soup;
}

Soup inside_out(Soup soup) {
  for (auto& t : soup.triangles) std::swap(t[1], t[2]);
  return soup;
}

std::vector<NamedSoup> mesh_classes() {
  Random random(7);
  return {
      {"plate", plate(1)},
      {"grid", grid(6, 1)},
      {"sphere", sphere(8, 12, 0.5)},
      {"torus", torus(12, 8, 0.5, 0.2)},
      {"tube", tube(3, 8, 0.4, 1)},
      {"moebius", moebius(12)},
      {"book", book(5)},
      {"pillow", pillow()},
      {"random soup", random_soup(60, random)},
      {"two spheres", both(sphere(6, 8, 0.3), moved(sphere(6, 8, 0.3), {0.7, 0, 0.1}, 1))},
      {"nested spheres", both(sphere(6, 8, 0.5), sphere(6, 8, 0.3))},
      {"thin tube", tube(1, 64, 0.4, 1)},
      {"far sphere", moved(sphere(8, 12, 0.5), {1e6, -1e6, 1e6}, 1)},
      {"tiny torus", moved(torus(12, 8, 0.5, 0.2), {0, 0, 0}, 1e-6)},
      {"huge grid", moved(grid(4, 1), {0, 0, 0}, 1e30)},
  };
}

BuiltMesh build(const Soup& soup) {
  auto built = build_mesh(soup);
  if (!built) throw std::runtime_error(built.error().message);
  return std::move(*built);
}

}  // namespace kerf::test
