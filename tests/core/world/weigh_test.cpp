#include "core/world/body_mass.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/edit/body_edit.h"
#include "core/edit/detach.h"
#include "core/edit/separation.h"
#include "tests/support/made_meshes.h"
#include "tests/support/piece_sums.h"
#include "tests/support/strokes.h"

namespace kerf::test {
namespace {

// The same triangles in another order, each from another corner.
Soup shuffled(Soup soup, Random& random) {
  for (size_t i = soup.triangles.size(); i > 1; --i)
    std::swap(soup.triangles[i - 1], soup.triangles[random.below(i)]);
  for (auto& t : soup.triangles)
    std::rotate(t.begin(), t.begin() + static_cast<std::ptrdiff_t>(random.below(3)), t.end());
  return soup;
}

// The live faces of a body as a soup.
Soup faces_of(const Body& body) {
  Soup soup;
  for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
    if (!body.mesh.is_live(FaceId(f))) continue;
    const auto first = static_cast<uint32_t>(soup.positions.size());
    for (const Vec3& corner : body.mesh.triangle(FaceId(f))) soup.positions.push_back(corner);
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  return soup;
}

void expect_same_sums(const Piece& a, const Piece& b) {
  EXPECT_EQ(a.area, b.area);
  EXPECT_EQ(a.moments, b.moments);
}

TEST(UpdateMass, matches_sums_maintained_by_edits) {
  for (uint64_t seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    World world = cut_at_random(torus(24, 16, 0.5, 0.2), seed);
    update_mass_properties(only_body(world));
    expect_piece_sums(only_body(world));
  }
}

TEST(UpdateMass, does_not_depend_on_slots_corner_order_or_previous_edits) {
  bool kept_up_differ = false;
  for (uint64_t seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    World world = cut_at_random(sphere(24, 32, 0.5), seed);
    Body& cut = only_body(world);
    Body made = make_body("made", build(shuffled(faces_of(cut), random)));
    made.loaded.min = cut.loaded.min;
    made.loaded.max = cut.loaded.max;
    for (uint32_t f = 0; f < cut.mesh.face_slots(); ++f) {
      if (cut.mesh.is_live(FaceId(f))) cut.mesh.edit_data(FaceId(f)).piece = 0;
    }
    kept_up_differ |= cut.pieces[0].moments != made.pieces[0].moments;
    update_mass_properties(cut);
    update_mass_properties(made);
    expect_same_sums(cut.pieces[0], made.pieces[0]);
  }
  EXPECT_TRUE(kept_up_differ) << "or there is nothing to show here";
}

TEST(UpdateMass, changes_nothing_in_pieces_detached_after_an_update) {
  for (uint64_t seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    World world = cut_at_random(torus(24, 16, 0.5, 0.2), seed);
    update_mass_properties(only_body(world));
    const BodyId whole = world.ids().front();
    const auto pieces = world.body(whole).pieces.size();
    Delta delta;
    for (uint32_t label = 1; label < pieces; ++label) {
      if (world.body(whole).pieces[label].faces > 0) detach(world, {whole, label}, 1, delta);
    }
    for (const BodyId id : world.ids()) {
      Body again = world.body(id);
      update_mass_properties(again);
      for (uint32_t p = 0; p < pieces; ++p) expect_same_sums(again.pieces[p], world.body(id).pieces[p]);
    }
  }
}

// The areas of faces that a search is about to relabel count for their new pieces already, their moments not.
TEST(UpdateMass, does_not_affect_an_open_search) {
  for (uint64_t seed = 1; seed <= 8; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    World world = world_of(torus(24, 16, 0.5, 0.2));
    RandomStroke stroke = random_stroke(world, random, 0.03, true);
    stroke.settings.search_a_move = 1;
    ASSERT_TRUE(cut_whole(world, stroke.settings, stroke.moves).ok());
    Body& body = only_body(world);
    while (!is_settled(body)) {
      update_mass_properties(body);
      continue_separation(world, 1 + random.below(40));
    }
    expect_piece_sums(body);
  }
}

// Lengths that are multiplied by a power of two multiply areas and moments by powers of two.
TEST(UpdateMass, scales_exactly_to_any_size_and_position) {
  const auto measured = [](const Soup& soup) {
    Body body = make_body("sphere", build(soup));
    update_mass_properties(body);
    return body.pieces[0];
  };
  const Soup soup = sphere(12, 16, 0.5);
  const Piece one = measured(soup);
  EXPECT_NEAR(one.area, 3.0, 0.2);
  for (const int power : {-120, -20, 20, 120}) {
    SCOPED_TRACE("2^" + std::to_string(power));
    const Piece scaled = measured(moved(soup, Vec3(0), std::ldexp(1.0, power)));
    EXPECT_EQ(scaled.area, std::ldexp(one.area, 2 * power));
    for (int k = 0; k < 3; ++k)
      EXPECT_EQ(scaled.moments.first[k], std::ldexp(one.moments.first[k], 3 * power));
    for (size_t i = 0; i < one.moments.second.size(); ++i)
      EXPECT_EQ(scaled.moments.second[i], std::ldexp(one.moments.second[i], 4 * power));
  }
  const Piece far = measured(moved(soup, {1e6, 0, -1e6}, 1));
  EXPECT_NEAR(far.area, one.area, 1e-8);
  for (size_t i = 0; i < 3; ++i) EXPECT_NEAR(far.moments.second[i], one.moments.second[i], 1e-8);
}

// What is known of the only piece of a solid body.
const EnclosedPiece* enclosed_of(const Body& body) { return enclosed_piece(body, 0); }

Body solid_body(const Soup& soup) {
  Body body = make_body("solid", build(soup));
  body.solid = true;
  update_mass_properties(body);
  return body;
}

TEST(UpdateSolidMass, computes_volume_centre_and_inertia_of_closed_pieces) {
  const Vec3 s(1, 2, 3), at(20, 0, -7);
  const Body box = solid_body(moved(brick(s), at, 1));
  ASSERT_NE(enclosed_of(box), nullptr);
  const MassProperties& solid = enclosed_of(box)->solid;
  EXPECT_NEAR(solid.mass, 6, 1e-13);
  EXPECT_NEAR(glm::distance(solid.centre, at + 0.5 * s), 0, 1e-13);
  EXPECT_NEAR(solid.inertia[2][2], 6.0 / 12 * (s.x * s.x + s.y * s.y), 1e-12);
  EXPECT_NEAR(solid.inertia[0][1], 0, 1e-12);
}

TEST(UpdateSolidMass, has_no_value_for_open_flat_or_non_solid_pieces) {
  EXPECT_EQ(enclosed_of(solid_body(tube(3, 12, 1, 1))), nullptr);
  EXPECT_EQ(enclosed_of(solid_body(pillow())), nullptr);
  Body box = solid_body(brick({1, 1, 1}));
  ASSERT_NE(enclosed_of(box), nullptr);
  box.solid = false;
  EXPECT_EQ(enclosed_of(box), nullptr);
}

TEST(UpdateSolidMass, has_no_value_for_faces_changed_since) {
  World world = world_of(sphere(12, 16, 0.5));
  Body& body = only_body(world);
  body.solid = true;
  update_mass_properties(body);
  ASSERT_NE(enclosed_of(body), nullptr);
  const double area = body.pieces[0].area;
  body.pieces.edit(0).area = 0.999 * area;
  EXPECT_EQ(enclosed_of(body), nullptr);
  body.pieces.edit(0).area = area;
  ASSERT_NE(enclosed_of(body), nullptr);
  { BodyEdit(body).remove(std::vector{FaceId(3)}); }
  EXPECT_EQ(enclosed_of(body), nullptr);
  update_mass_properties(body);
  EXPECT_EQ(enclosed_of(body), nullptr);
}

TEST(UpdateSolidMass, depends_only_on_the_faces_bit_for_bit) {
  const Soup soup = moved(torus(24, 16, 0.5, 0.2), {3, 1, -2}, 1);
  const Body one = solid_body(soup);
  for (uint64_t seed = 1; seed <= 4; ++seed) {
    Random random(seed);
    const Body other = solid_body(shuffled(soup, random));
    ASSERT_TRUE(enclosed_of(one) && enclosed_of(other));
    EXPECT_EQ(enclosed_of(other)->solid.mass, enclosed_of(one)->solid.mass);
    EXPECT_EQ(enclosed_of(other)->solid.centre, enclosed_of(one)->solid.centre);
    EXPECT_EQ(enclosed_of(other)->solid.inertia, enclosed_of(one)->solid.inertia);
  }
}

// A grain that is left of a large part is weighed from its own middle.
TEST(UpdateSolidMass, of_a_small_remnant_of_a_large_part_is_as_exact) {
  World world = world_of(both(brick(Vec3(1000)), moved(brick(Vec3(1)), {400, 700, 1200}, 1e-3)));
  Body& body = only_body(world);
  body.solid = true;
  std::vector<FaceId> large;
  for (uint32_t f = 0; f < 12; ++f) large.emplace_back(f);
  { BodyEdit(body).remove(large); }
  update_mass_properties(body);
  ASSERT_NE(enclosed_of(body), nullptr);
  EXPECT_NEAR(enclosed_of(body)->solid.mass / 1e-9, 1, 1e-8);
  EXPECT_NEAR(enclosed_of(body)->solid.inertia[0][0] / (1e-15 / 6), 1, 1e-8);
}

TEST(UpdateSolidMass, is_passed_on_to_detached_pieces) {
  World world = world_of(both(brick({1, 2, 3}), moved(brick({1, 1, 1}), {5, 0, 0}, 1)));
  Body& body = only_body(world);
  body.solid = true;
  body.pieces.push_back({});
  for (uint32_t f = 12; f < 24; ++f) body.mesh.edit_data(FaceId(f)).piece = 1;
  body.pieces.edit(0).faces = body.pieces.edit(1).faces = 12;
  update_mass_properties(body);
  Delta delta;
  const BodyId whole = world.ids().front(), own = detach(world, {whole, 1}, 1, delta);
  ASSERT_NE(whole, own);
  ASSERT_NE(enclosed_piece(world.body(whole), 0), nullptr);
  ASSERT_NE(enclosed_piece(world.body(own), 1), nullptr);
  EXPECT_NEAR(enclosed_piece(world.body(whole), 0)->solid.mass, 6, 1e-12);
  EXPECT_NEAR(enclosed_piece(world.body(own), 1)->solid.mass, 1, 1e-12);
}

}  // namespace
}  // namespace kerf::test
