#include "tests/support/piece_sums.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/edit/separation.h"

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

size_t expect_part_counts(const Body& body) {
  std::vector<uint32_t> part;
  std::vector<FaceCounts> counts(label_components(body.mesh, part));
  for (uint32_t f = 0; f < part.size(); ++f) {
    if (!body.mesh.is_live(FaceId(f))) continue;
    ++counts[part[f]].faces;
    counts[part[f]].area += triangle_area(body.mesh.triangle(FaceId(f)));
  }
  for (uint32_t f = 0; f < part.size(); ++f) {
    if (!body.mesh.is_live(FaceId(f))) continue;
    const FaceCounts &kept = body.whole_of(FaceId(f)), &expected = counts[part[f]];
    const bool are_equal =
        kept.faces == expected.faces && std::abs(kept.area - expected.area) <= kTolerance * body.loaded.area;
    EXPECT_TRUE(are_equal) << "face " << f << " is in a part of " << expected.faces << " faces, not "
                           << kept.faces;
    if (!are_equal) break;
  }
  expect_piece_sums(body);
  return counts.size();
}

}  // namespace kerf::test
