#include "tests/support/piece_sums.h"

#include <gtest/gtest.h>

namespace kerf::test {

namespace {

constexpr double kTolerance = 1e-9;

void expect_near(const AreaMoments& expected, const AreaMoments& found, double area, double reach) {
  const double first = kTolerance * area * reach, second = first * reach;
  for (int k = 0; k < 3; ++k) ASSERT_NEAR(expected.first[k], found.first[k], first);
  for (size_t i = 0; i < expected.second.size(); ++i)
    ASSERT_NEAR(expected.second[i], found.second[i], second);
}

}  // namespace

void expect_piece_sums(const Body& body) {
  std::vector<Piece> sums(body.pieces.size());
  for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
    if (!body.mesh.is_live(FaceId(f))) continue;
    const Triangle t = body.mesh.triangle(FaceId(f));
    Piece& sum = sums[body.mesh.data(FaceId(f)).piece];
    ++sum.faces;
    sum.area += triangle_area(t);
    sum.moments += area_moments(t, triangle_area(t), body.middle());
  }
  const double area = body.loaded.area, reach = 0.5 * glm::length(body.loaded.max - body.loaded.min);
  for (uint32_t p = 0; p < sums.size(); ++p) {
    SCOPED_TRACE("piece " + std::to_string(p));
    ASSERT_EQ(sums[p].faces, body.pieces[p].faces);
    ASSERT_NEAR(sums[p].area, body.pieces[p].area, kTolerance * area);
    expect_near(sums[p].moments, body.pieces[p].moments, area, reach);
  }
}

}  // namespace kerf::test
