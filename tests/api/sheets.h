#pragma once

#include <cstdint>
#include <vector>

#include "core/kerf.h"

namespace kerf::test {

// A sheet of n by n squares in the plane y = 0, one metre wide.
inline kerf::Mesh sheet(int n) {
  std::vector<double> vertices;
  std::vector<uint32_t> faces;
  for (int i = 0; i <= n; ++i) {
    for (int k = 0; k <= n; ++k) vertices.insert(vertices.end(), {double(i) / n, 0, double(k) / n});
  }
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k < n; ++k) {
      const auto a = static_cast<uint32_t>(i * (n + 1) + k), b = a + static_cast<uint32_t>(n) + 1;
      faces.insert(faces.end(), {a, a + 1, b, b, a + 1, b + 1});
    }
  }
  return {vertices, faces};
}

inline kerf::Stroke through_the_middle() {
  kerf::Stroke stroke;
  stroke.keys = {{0, {0.5, 1, -1}, {0, -3, 0}}, {1, {0.5, 1, 2}, {0, -3, 0}}};
  stroke.radius = 0.01;
  stroke.range = {0, 2};
  return stroke;
}

// A closed box of n by n by n squares per side, from 0 to 1 m.
inline kerf::Mesh box(int n) {
  std::vector<double> vertices;
  std::vector<uint32_t> faces;
  for (int side = 0; side < 6; ++side) {
    const size_t axis = static_cast<size_t>(side) / 2, u = (axis + 1) % 3, v = (axis + 2) % 3;
    const auto first = static_cast<uint32_t>(vertices.size() / 3);
    for (int i = 0; i <= n; ++i) {
      for (int k = 0; k <= n; ++k) {
        double p[3];
        p[axis] = side % 2;
        p[u] = double(i) / n;
        p[v] = double(k) / n;
        vertices.insert(vertices.end(), p, p + 3);
      }
    }
    for (int i = 0; i < n; ++i) {
      for (int k = 0; k < n; ++k) {
        const auto a = first + static_cast<uint32_t>(i * (n + 1) + k), b = a + static_cast<uint32_t>(n) + 1;
        if (side % 2 == 1) faces.insert(faces.end(), {a, b, a + 1, b, b + 1, a + 1});
        if (side % 2 == 0) faces.insert(faces.end(), {a, a + 1, b, b, a + 1, b + 1});
      }
    }
  }
  return {vertices, faces};
}

}  // namespace kerf::test
