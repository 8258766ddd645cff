#include <cmath>

#include "core/mesh/mesh.h"

namespace kerf {

double triangle_area(const Triangle& t) { return 0.5 * glm::length(glm::cross(t[1] - t[0], t[2] - t[0])); }

double longest_edge2(const Triangle& t) {
  double longest = 0;
  for (int i = 0; i < 3; ++i) {
    const Vec3 edge = t[(i + 1) % 3] - t[i];
    longest = std::max(longest, glm::dot(edge, edge));
  }
  return longest;
}

double largest_cosine(const Triangle& t) {
  double largest = -1;
  for (int i = 0; i < 3; ++i) {
    const Vec3 u = t[(i + 1) % 3] - t[i], w = t[(i + 2) % 3] - t[i];
    const double lengths = std::sqrt(glm::dot(u, u)) * std::sqrt(glm::dot(w, w));
    largest = std::max(largest, lengths > 0 ? std::min(1.0, glm::dot(u, w) / lengths) : 1.0);
  }
  return largest;
}

}  // namespace kerf
