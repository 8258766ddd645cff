#include "core/world/weigh.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/fixed_sum.h"
#include "core/mesh/triangle_batch.h"
#include "core/world/weigh_solid.h"

namespace kerf {

namespace {

// Lengths in units of 2^exponent m, in which a body as loaded reaches from -1 to 1 around its middle: then
// all its areas and moments are in the range of FixedSum.
struct Unit {
  explicit Unit(const Body& body) : origin(body.middle()) {
    const Vec3 reach = 0.5 * body.loaded.max - 0.5 * body.loaded.min;
    const double most = std::max({reach.x, reach.y, reach.z});
    (void)std::frexp(most, &exponent);
    exponent = std::clamp(exponent, -kMostExponent, kMostExponent);  // the scale and its inverse are finite
    scale = std::ldexp(1.0, -exponent);
  }
  Triangle from_middle(const Triangle& t) const {
    return {scale * (t[0] - origin), scale * (t[1] - origin), scale * (t[2] - origin)};
  }
  double area(const Triangle& t) const { return triangle_area({scale * t[0], scale * t[1], scale * t[2]}); }

  static constexpr int kMostExponent = 1000;
  Vec3 origin;
  int exponent = 0;
  double scale = 1;
};

// The corners in an order that depends on their positions alone, and so the rounding of what follows.
Triangle sorted(Triangle t) {
  if (precedes(t[1], t[0])) std::swap(t[0], t[1]);
  if (precedes(t[2], t[1])) std::swap(t[1], t[2]);
  if (precedes(t[1], t[0])) std::swap(t[0], t[1]);
  return t;
}

struct FixedSums {
  FixedSum area;
  std::array<FixedSum, 3> first;
  std::array<FixedSum, 6> second;

  void add(const AreaMoments& moments) {
    for (int k = 0; k < 3; ++k) first[static_cast<size_t>(k)].add(moments.first[k]);
    for (size_t i = 0; i < second.size(); ++i) second[i].add(moments.second[i]);
  }
  AreaMoments moments(const Unit& unit) const {
    AreaMoments moments;
    for (int k = 0; k < 3; ++k) moments.first[k] = first[static_cast<size_t>(k)].value(3 * unit.exponent);
    for (size_t i = 0; i < second.size(); ++i) moments.second[i] = second[i].value(4 * unit.exponent);
    return moments;
  }
};

}  // namespace

void weigh(Body& body) {
  const Unit unit(body);
  std::vector<FixedSums> sums(body.pieces.size());
  for_each_triangle(body.mesh, 0, body.mesh.face_slots(), [&](FaceId f, const Triangle& corners) {
    const Triangle t = sorted(corners);
    const double area = unit.area(t);
    sums[body.label(f)].area.add(area);
    sums[body.mesh.data(f).piece].add(area_moments(unit.from_middle(t), area, Vec3(0)));
  });
  for (uint32_t label = 0; label < body.pieces.size(); ++label) {
    const double area = sums[label].area.value(2 * unit.exponent);
    const AreaMoments moments = sums[label].moments(unit);
    const Piece& before = body.pieces[label];
    if (before.area == area && before.moments == moments) continue;
    Piece& piece = body.pieces.edit(label);
    piece.area = area;
    piece.moments = moments;
  }
  if (body.solid) weigh_solid(body);
}

}  // namespace kerf
