#include "core/joints/joined_parts.h"

#include <gtest/gtest.h>

#include "core/edit/separation.h"
#include "tests/support/made_meshes.h"
#include "tests/support/strokes.h"

namespace kerf::test {
namespace {

// A sheet of size 2 in y = 0 with small balls above and below it, cut in two along x = 0.
Body cut_sheet(const std::vector<Vec3>& balls) {
  Soup soup = grid(20, 2);
  for (const Vec3& at : balls) soup = both(soup, moved(sphere(6, 8, 0.05), at, 1));
  Document document(world_of(soup));
  CutSettings settings;
  settings.laser.radius = settings.resolution.target_edge = 0.02;
  const Vec3 down(0, -1, 0);
  document.apply(BeginStroke{settings, {{0, 3, -1.3}, down}});
  document.apply(MoveBeam{{{0, 3, 1.3}, down}});
  document.apply(EndStroke{});
  EXPECT_TRUE(run_all(document).ok());
  return document.world().body(document.world().ids().front());
}

// The label of the largest piece of the sheet on each side.
uint32_t label_at(const Body& body, double side) {
  for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
    if (!body.mesh.is_live(FaceId(f))) continue;
    const Triangle t = body.mesh.triangle(FaceId(f));
    if (t[0].y == 0 && t[1].y == 0 && side * t[0].x > 0.5) return body.mesh.data(FaceId(f)).piece;
  }
  ADD_FAILURE() << "no face of the sheet there";
  return 0;
}

uint32_t goes_with(const Body& body, const PieceGroups& groups, FaceId f) {
  const uint32_t group = groups.of(body.mesh, f);
  return group < body.pieces.size() ? group : groups.loose.at(group - body.pieces.size()).goes_with;
}

TEST(PieceGroups, loose_parts_belong_to_the_nearer_half) {
  for (uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    std::vector<Vec3> balls;
    for (int i = 0; i < 6; ++i) {
      const double side = random.below(2) == 0 ? -1 : 1, up = random.below(2) == 0 ? -1 : 1;
      const double x = random.uniform(0.2, 0.9), y = random.uniform(0.1, 0.4);
      balls.push_back({side * x, up * y, random.uniform(-0.9, 0.9)});
    }
    const Body body = cut_sheet(balls);
    ASSERT_EQ(body.pieces.size(), 2u);
    const PieceGroups groups = group_pieces(body);
    for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
      if (!body.mesh.is_live(FaceId(f))) continue;
      const double x = body.mesh.triangle(FaceId(f))[0].x;
      ASSERT_EQ(goes_with(body, groups, FaceId(f)), label_at(body, x > 0 ? 1 : -1))
          << "face " << f << " at x = " << x;
    }
  }
}

TEST(PieceGroups, the_centre_of_a_piece_includes_its_loose_parts) {
  const Body body = cut_sheet({{0.5, 0.3, 0.2}, {-0.6, 0.2, -0.4}, {-0.3, -0.3, 0.5}});
  const PieceGroups groups = group_pieces(body);
  std::vector<double> area(body.pieces.size());
  std::vector<Vec3> moment(body.pieces.size(), Vec3(0));
  for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
    if (!body.mesh.is_live(FaceId(f))) continue;
    const Triangle t = body.mesh.triangle(FaceId(f));
    const uint32_t with = goes_with(body, groups, FaceId(f));
    area[with] += triangle_area(t);
    moment[with] += (t[0] + t[1] + t[2]) / 3.0 * triangle_area(t);
  }
  for (size_t label = 0; label < area.size(); ++label)
    EXPECT_LT(glm::length(groups.middles[label] - moment[label] / area[label]), 1e-12);
}

TEST(PieceGroups, an_uncut_body_has_no_loose_parts) {
  const Body body = make_body("balls", build(both(sphere(6, 8, 1), moved(sphere(6, 8, 1), {3, 0, 0}, 1))));
  const PieceGroups groups = group_pieces(body);
  EXPECT_TRUE(groups.loose.empty() && groups.of_face.empty());
  EXPECT_LT(glm::length(groups.middles.at(0) - Vec3(1.5, 0, 0)), 1e-12);
}

TEST(PieceGroups, regrouped_faces_are_those_with_a_different_group) {
  const Body body = cut_sheet({{0.5, 0.3, 0.2}, {-0.6, 0.2, -0.4}});
  const PieceGroups groups = group_pieces(body);
  ASSERT_FALSE(groups.loose.empty());
  std::vector<FaceId> expected;
  for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
    if (body.mesh.is_live(FaceId(f)) && groups.of(body.mesh, FaceId(f)) != body.mesh.data(FaceId(f)).piece)
      expected.emplace_back(f);
  }
  EXPECT_FALSE(expected.empty());
  EXPECT_EQ(regrouped(body.mesh, nullptr, &groups), expected);
  EXPECT_EQ(regrouped(body.mesh, &groups, nullptr), expected);
  EXPECT_TRUE(regrouped(body.mesh, &groups, &groups).empty());
}

}  // namespace
}  // namespace kerf::test
