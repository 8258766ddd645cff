#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/deterministic_math.h"
#include "core/cut/knife.h"
#include "core/document/extract.h"
#include "core/walls/section_walls.h"
#include "core/world/body_mass.h"
#include "tests/support/made_meshes.h"
#include "tests/support/strokes.h"

namespace kerf::test {
namespace {

// The closed form of prisms with kPegSides sides.
double prism(double radius, double height) {
  return kPegSides / 2.0 * std::sin(2 * kPi / kPegSides) * radius * radius * height;
}

double volume_of_piece(const Extract& piece) {
  EXPECT_TRUE(piece.volume);
  return piece.volume.value_or(0);
}

// Halves of a brick, in any placement: pegs add to one and take from the other.
TEST(KnifePegs, join_the_halves_of_a_solid) {
  for (const uint64_t seed : {1, 2, 3, 4}) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const double scale = random.uniform(0.01, 10);
    World world = world_of(moved(brick({4, 3, 2}), Vec3(0), scale));
    Body& body = only_body(world);
    make_solid(body, true);
    body.placement = {scale * random_direction(random),
                      axis_angle(random_direction(random), random.uniform(0, kPi))};
    const Vec3 normal = body.placement.orientation * Vec3(1, 0, 0);
    const Vec3 through = body.placement.to_world(scale * Vec3(1.5, 0, 0));
    const Pegs pegs{4, 0.4 * scale, 0.5 * scale, 0.02 * scale};
    const auto cut = cut_with_plane(world, {normal, glm::dot(normal, through)}, world.ids(),
                                    CutSettings::kMaxFaces, nullptr, pegs);
    ASSERT_TRUE(cut.ok());
    EXPECT_EQ(cut->delta.solid.pegs, 4u);
    EXPECT_EQ(cut->delta.solid.missing_pegs, 0u);
    const Body& halves = only_body(world);
    std::vector<double> volumes;
    for (const std::vector<FaceId>& faces : faces_by_piece(halves, false))
      volumes.push_back(volume_of_piece(extract_faces(halves, faces)));
    std::ranges::sort(volumes);
    ASSERT_EQ(volumes.size(), 2u);
    const double unit = scale * scale * scale;
    // The plane keeps 1.5 of 4 on the side of the pegs.
    const double with_pegs = 9 * unit + 4 * prism(0.2 * scale, 0.5 * scale);
    const double with_holes = 15 * unit - 4 * prism(0.22 * scale, 0.52 * scale);
    EXPECT_NEAR(volumes[0], with_pegs, 1e-12 * unit);
    EXPECT_NEAR(volumes[1], with_holes, 1e-12 * unit);
    EXPECT_NEAR(cut->delta.solid.removed_volume, 24 * unit - with_pegs - with_holes, 1e-11 * unit);
  }
}

// Every half of every solid stays closed, and none of its faces meets a hole.
TEST(KnifePegs, leave_random_solids_closed) {
  for (const uint64_t seed : {1, 2, 3, 4, 5, 6, 7, 8}) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    World world = world_of(seed % 2 == 0 ? torus(24, 36, 1, 0.4)
                                         : both(sphere(20, 30, 1), inside_out(sphere(16, 24, 0.6))));
    make_solid(only_body(world), true);
    const double before = volume_of_piece(extract_faces(only_body(world), only_body(world).faces_of(0)));
    const KnifePlane plane = {random_direction(random), random.uniform(-0.2, 0.2)};
    const Pegs pegs{6, 0.15, 0.1, 0.01};
    const auto cut = cut_with_plane(world, plane, world.ids(), CutSettings::kMaxFaces, nullptr, pegs);
    ASSERT_TRUE(cut.ok());
    EXPECT_EQ(cut->delta.solid.pegs + cut->delta.solid.missing_pegs, 6u);
    double after = 0;
    for (const std::vector<FaceId>& faces : faces_by_piece(only_body(world), false))
      after += volume_of_piece(extract_faces(only_body(world), faces));
    const double lost = static_cast<double>(cut->delta.solid.pegs) * (prism(0.085, 0.11) - prism(0.075, 0.1));
    EXPECT_NEAR(before - after, lost, 1e-9);
  }
}

// A peg in the middle of the square would leave no room for the four.
TEST(KnifePegs, stand_in_rows_if_more_of_them_fit_so) {
  World world = world_of(brick({1, 1, 1}));
  make_solid(only_body(world), true);
  const auto cut = cut_with_plane(world, {{1, 0, 0}, 0.5}, world.ids(), CutSettings::kMaxFaces, nullptr,
                                  {50, 0.3, 0.1, 0.002});
  ASSERT_TRUE(cut.ok());
  EXPECT_EQ(cut->delta.solid.pegs, 4u);
  EXPECT_EQ(cut->delta.solid.missing_pegs, 46u);
  double volume = 0;
  for (const std::vector<FaceId>& faces : faces_by_piece(only_body(world), false))
    volume += volume_of_piece(extract_faces(only_body(world), faces));
  EXPECT_NEAR(volume, 1 + 4 * (prism(0.15, 0.1) - prism(0.152, 0.102)), 1e-12);
}

TEST(KnifePegs, are_left_out_without_room) {
  World world = world_of(brick({4, 3, 2}));
  make_solid(only_body(world), true);
  const Pegs pegs{3, 0.4, 2.4, 0.02};  // deeper than the part above the plane
  const auto cut =
      cut_with_plane(world, {{1, 0, 0}, 1.5}, world.ids(), CutSettings::kMaxFaces, nullptr, pegs);
  ASSERT_TRUE(cut.ok());
  EXPECT_EQ(cut->delta.solid.pegs, 0u);
  EXPECT_EQ(cut->delta.solid.missing_pegs, 3u);
}

// At this distance doubles are an eighth of a metre apart.
TEST(KnifePegs, are_left_out_where_doubles_are_too_coarse_for_their_places) {
  World world = world_of(moved(brick({1, 1, 1}), {1e15, 0, 0}, 1));
  make_solid(only_body(world), true);
  const auto cut = cut_with_plane(world, {{0, 1, 0}, 0.5}, world.ids(), CutSettings::kMaxFaces, nullptr,
                                  {3, 0.1, 0.1, 0.01});
  ASSERT_TRUE(cut.ok());
  EXPECT_EQ(cut->delta.solid.pegs, 0u);
  EXPECT_EQ(cut->delta.solid.missing_pegs, 3u);
}

}  // namespace
}  // namespace kerf::test
