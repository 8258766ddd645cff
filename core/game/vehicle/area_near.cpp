#include "core/game/vehicle/area_near.h"

#include <algorithm>

#include "core/mesh/point_to_triangle.h"

namespace kerf {

namespace {

// Whether the triangle lies in the ball because its corners do.
bool is_inside(const Triangle& t, const Ball& ball) {
  return std::all_of(t.begin(), t.end(),
                     [&](const Vec3& p) { return glm::distance(p, ball.centre) <= ball.radius; });
}

}  // namespace

double area_within(const Triangle& t, const Ball& ball) {
  if (squared_distance(ball.centre, t) > ball.radius * ball.radius) return 0;
  if (is_inside(t, ball)) return triangle_area(t);
  size_t longest = 0;
  for (size_t i = 1; i < 3; ++i) {
    if (glm::distance(t[i], t[(i + 1) % 3]) > glm::distance(t[longest], t[(longest + 1) % 3])) longest = i;
  }
  const Vec3 &a = t[longest], &b = t[(longest + 1) % 3], &c = t[(longest + 2) % 3];
  if (glm::distance(a, b) < 0.2 * ball.radius) return 0.5 * triangle_area(t);
  const Vec3 middle = 0.5 * (a + b);
  return area_within({a, middle, c}, ball) + area_within({middle, b, c}, ball);
}

}  // namespace kerf
