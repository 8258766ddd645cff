#include "core/shadow/shadow_volume.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <tuple>

#include "tests/support/made_meshes.h"
#include "tests/support/strokes.h"

namespace kerf {
namespace {

using Point = std::array<float, 3>;
Point point(const glm::vec3& p) { return {p.x, p.y, p.z}; }

FloatFrame frame_of(const Mesh& mesh) {
  const AabbTree tree(mesh);
  return FloatFrame::around(tree.bounds().min, tree.bounds().max);
}

// A volume as a set that does not depend on slots: the ends of its edges and their pieces with their
// multiplicities.
std::map<std::tuple<Point, Point, uint32_t>, int> silhouette_of(const ShadowCaster& caster,
                                                                const ShadowVolume& volume) {
  std::map<std::tuple<Point, Point, uint32_t>, int> all;
  for (const SilhouetteEdge& e : volume.silhouette()) {
    const ShadowCaster::Ends ends = caster.ends(e.edge);
    all[{point(ends.low), point(ends.high), ends.piece}] += e.multiplicity;
  }
  return all;
}

ShadowVolume volume_of(const ShadowCaster& caster, const LightPoint& light,
                       ShadowMethod method = ShadowMethod::kRobust) {
  ShadowVolume volume(method);
  volume.rebuild(caster, {light, {}});
  return volume;
}

// How often each multiplicity stands in a silhouette.
std::map<int, size_t> multiplicities(const ShadowVolume& volume) {
  std::map<int, size_t> counts;
  for (const SilhouetteEdge& e : volume.silhouette()) ++counts[std::abs(e.multiplicity)];
  return counts;
}

const LightPoint kSun{{0.3, 1, 0.2}, 0};
const LightPoint kLamp{{0.4, 2.5, -0.7}, 1};

// By hand, in whole numbers: the plane 2x + 3y + 6z = 12 through (6,0,0), (0,4,0), (0,0,2).
TEST(ShadowVolume, the_sign_is_the_side_of_the_plane_facing_the_light) {
  const std::array<glm::vec3, 3> t{glm::vec3(6, 0, 0), glm::vec3(0, 4, 0), glm::vec3(0, 0, 2)};
  EXPECT_EQ(light_side(t, {{3, 3, 3}, 1}), 1);
  EXPECT_EQ(light_side(t, {{1, 1, 1}, 1}), -1);
  EXPECT_EQ(light_side(t, {{3, 2, 0}, 1}), 0);
  EXPECT_EQ(light_side(t, {{2, 2, 1}, 0}), 1);
  EXPECT_EQ(light_side(t, {{-3, 0, 0}, 0}), -1);
  EXPECT_EQ(light_side(t, {{3, -2, 0}, 0}), 0);
  EXPECT_EQ(light_side({t[0], t[2], t[1]}, {{3, 3, 3}, 1}), -1);
}

TEST(ShadowVolume, is_closed_at_every_vertex_of_all_mesh_classes) {
  for (const test::NamedSoup& named : test::mesh_classes()) {
    const BuiltMesh built = test::build(named.soup);
    const ShadowCaster caster(built.mesh, frame_of(built.mesh));
    for (const LightPoint& light : {kSun, kLamp}) {
      std::map<Point, int> leaving;
      const ShadowVolume volume = volume_of(caster, light);
      for (const SilhouetteEdge& e : volume.silhouette()) {
        const ShadowCaster::Ends ends = caster.ends(e.edge);
        leaving[point(ends.low)] += e.multiplicity;
        leaving[point(ends.high)] -= e.multiplicity;
      }
      for (const auto& [at, sum] : leaving) EXPECT_EQ(sum, 0) << named.name;
    }
  }
}

TEST(ShadowVolume, a_closed_surface_has_double_edges_and_a_sheet_single_ones) {
  const BuiltMesh ball = test::build(test::sphere(12, 16, 1));
  const auto of_ball = multiplicities(volume_of(ShadowCaster(ball.mesh, frame_of(ball.mesh)), kSun));
  EXPECT_EQ(of_ball.size(), 1u);
  EXPECT_GT(of_ball.at(2), 10u);
  const BuiltMesh sheet = test::build(test::grid(5, 1));
  const auto of_sheet = multiplicities(volume_of(ShadowCaster(sheet.mesh, frame_of(sheet.mesh)), kSun));
  EXPECT_EQ(of_sheet, (std::map<int, size_t>{{1, 20}}));
}

// Five sheets on one edge, the light straight over it: whatever their winding, each spans its volume on one
// side.
TEST(ShadowVolume, counts_every_sheet_on_an_edge) {
  const BuiltMesh book = test::build(test::book(5));
  const ShadowCaster caster(book.mesh, frame_of(book.mesh));
  for (const Vec3& from : {Vec3(1, 0.2, 0.1), Vec3(0.1, 1, 0.3), Vec3(-0.4, 0.1, 1)}) {
    const ShadowVolume volume = volume_of(caster, {from, 0});
    for (const SilhouetteEdge& e : volume.silhouette()) {
      int faces = 0;
      caster.for_each_face_on(e.edge, [&](uint32_t, int) { ++faces; });
      const int sum = std::abs(e.multiplicity);
      EXPECT_GE(sum, 1);
      EXPECT_LE(sum, faces);
      EXPECT_EQ(sum % 2, faces % 2);
    }
  }
}

TEST(ShadowVolume, the_paper_method_drops_edges_shared_by_two_polygons) {
  const BuiltMesh ball = test::build(test::sphere(12, 16, 1));
  const ShadowCaster caster(ball.mesh, frame_of(ball.mesh));
  const ShadowVolume one = volume_of(caster, kSun, ShadowMethod::kPaperOneVolume);
  const ShadowVolume two = volume_of(caster, kSun, ShadowMethod::kPaperTwoVolumes);
  const ShadowVolume robust = volume_of(caster, kSun);
  EXPECT_EQ(multiplicities(one), (std::map<int, size_t>{{1, robust.silhouette().size()}}));
  EXPECT_EQ(silhouette_of(caster, two), silhouette_of(caster, robust));
}

TEST(ShadowVolume, a_light_in_the_plane_of_a_sheet_casts_no_shadow) {
  const BuiltMesh sheet = test::build(test::grid(3, 1));
  const ShadowCaster caster(sheet.mesh, frame_of(sheet.mesh));
  const ShadowVolume volume = volume_of(caster, {{5, 0, 1}, 0});
  EXPECT_TRUE(volume.silhouette().empty());
  EXPECT_EQ(std::count(volume.signs().begin(), volume.signs().end(), 0),
            static_cast<long>(caster.face_slots()));
}

TEST(ShadowCaster, the_lowest_of_coinciding_triangles_casts) {
  Soup twice = test::both(test::plate(1), test::plate(1));
  BuiltMesh built = test::build(twice);
  const FloatFrame frame = frame_of(built.mesh);
  ShadowCaster caster(built.mesh, frame);
  EXPECT_TRUE(caster.casts(0) && caster.casts(1));
  EXPECT_FALSE(caster.casts(2) || caster.casts(3));
  const auto both = silhouette_of(caster, volume_of(caster, kSun));
  const BuiltMesh one = test::build(test::plate(1));
  const ShadowCaster alone(one.mesh, frame);
  EXPECT_EQ(both, silhouette_of(alone, volume_of(alone, kSun)));
  // Its copy takes over when it goes.
  built.mesh.remove_face(FaceId(0));
  const std::array<uint32_t, 1> dead{0};
  const ShadowCaster::Change change = caster.update(built.mesh, dead);
  EXPECT_FALSE(caster.casts(0));
  EXPECT_TRUE(caster.casts(2));
  EXPECT_EQ(change.faces, (std::vector<uint32_t>{0, 2}));
}

TEST(ShadowVolume, a_hidden_piece_casts_no_shadow) {
  const BuiltMesh ball = test::build(test::sphere(6, 8, 1));
  const ShadowCaster caster(ball.mesh, frame_of(ball.mesh));
  ShadowVolume volume;
  volume.rebuild(caster, {kLamp, {std::nullopt}});
  EXPECT_TRUE(volume.silhouette().empty());
}

// Counted, not timed: what a removed of fifty faces of a hundred thousand looks at.
TEST(ShadowVolume, an_update_visits_only_changed_faces_and_edges) {
  BuiltMesh built = test::build(test::torus(250, 200, 1, 0.4));
  ShadowCaster caster(built.mesh, frame_of(built.mesh));
  ShadowVolume volume = volume_of(caster, kLamp);
  const ShadowVolume::Effort whole = volume.effort();
  EXPECT_EQ(whole.faces, built.mesh.face_slots());
  EXPECT_EQ(whole.edges, caster.edge_slots());
  std::vector<uint32_t> removed;
  for (uint32_t f = 700; f < 750; ++f) removed.push_back(f);
  for (const uint32_t f : removed) built.mesh.remove_face(FaceId(f));
  volume.follow(caster, caster.update(built.mesh, removed));
  EXPECT_LE(volume.effort().faces - whole.faces, 50u);
  EXPECT_LE(volume.effort().edges - whole.edges, 150u);
}

// Counted: no vertex and no edge is made for a piece that comes off and is put back.
TEST(ShadowCaster, relabelling_a_whole_piece_keeps_vertices_and_edges) {
  BuiltMesh built =
      test::build(test::both(test::torus(20, 30, 1, 0.4), test::moved(test::grid(9, 1), {0, 2, 0}, 1)));
  ShadowCaster caster(built.mesh, frame_of(built.mesh));
  const uint32_t edges = caster.edge_slots();
  std::vector<uint32_t> sheet;
  for (uint32_t f = 0; f < built.mesh.face_slots(); ++f) {
    if (built.mesh.triangle(FaceId(f))[0].y > 1) sheet.push_back(f);
  }
  ASSERT_EQ(sheet.size(), 2u * 9 * 9);
  for (const uint32_t label : {3u, 0u, 7u}) {
    for (const uint32_t f : sheet) built.mesh.edit_data(FaceId(f)).piece = label;
    const ShadowCaster::Change change = caster.update(built.mesh, sheet);
    EXPECT_EQ(change.faces, sheet);
    EXPECT_EQ(caster.edge_slots(), edges);
    for (const uint32_t f : sheet) EXPECT_EQ(caster.piece(f), label);
  }
}

// By patches that meet at edges and corners, some of faces that lie on one another.
TEST(ShadowCaster, random_relabelling_matches_a_rebuild) {
  const Soup soup = test::both(test::both(test::grid(6, 2), test::grid(6, 2)), test::sphere(6, 8, 1));
  for (uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    BuiltMesh built = test::build(soup);
    const FloatFrame frame = frame_of(built.mesh);
    ShadowCaster caster(built.mesh, frame);
    ShadowVolume followed = volume_of(caster, kLamp);
    for (int step = 0; step < 12; ++step) {
      const uint32_t faces = built.mesh.face_slots();
      const auto first = static_cast<uint32_t>(random.below(faces));
      const auto end = first + static_cast<uint32_t>(random.below(faces - first + 1));
      const uint32_t more = random.below(2) > 0 ? 1 : 0;
      std::vector<uint32_t> slots;
      for (uint32_t f = first; f < end; ++f) {
        built.mesh.edit_data(FaceId(f)).piece = static_cast<uint32_t>(step % 3 + (more * f / 5) % 2);
        slots.push_back(f);
        if (random.below(9) == 0) slots.push_back(f);
      }
      followed.follow(caster, caster.update(built.mesh, slots));
      const ShadowCaster fresh(built.mesh, frame);
      const ShadowVolume rebuilt = volume_of(fresh, kLamp);
      ASSERT_EQ(silhouette_of(caster, followed), silhouette_of(fresh, rebuilt));
      ASSERT_TRUE(std::equal(rebuilt.signs().begin(), rebuilt.signs().end(), followed.signs().begin()));
      for (uint32_t f = 0; f < faces; ++f) {
        ASSERT_EQ(caster.casts(f), fresh.casts(f));
        if (caster.casts(f)) ASSERT_EQ(caster.piece(f), fresh.piece(f));
      }
    }
  }
}

// After every step of many strokes the volumes that were followed are those that are built from nothing.
TEST(ShadowVolume, incremental_updates_match_a_rebuild) {
  Random random(11);
  const Soup plates = test::both(test::grid(8, 2), test::moved(test::sphere(8, 12, 1), {0.3, 0.2, 0}, 0.7));
  for (const Soup& soup :
       {test::torus(10, 16, 1, 0.4), plates, test::book(5), test::random_soup(60, random)}) {
    World world = test::world_of(soup);
    Body& body = test::only_body(world);
    const FloatFrame frame = FloatFrame::around(body.bounds().min, body.bounds().max);
    ShadowCaster caster(body.mesh, frame);
    std::vector<ShadowVolume> followed;
    for (const ShadowMethod m :
         {ShadowMethod::kRobust, ShadowMethod::kPaperOneVolume, ShadowMethod::kPaperTwoVolumes}) {
      followed.push_back(volume_of(caster, kLamp, m));
    }
    for (int stroke = 0; stroke < 4; ++stroke) {
      const test::RandomStroke cut = test::random_stroke(world, random, 0.04, stroke % 2 == 1);
      for (const BeamMove& move : cut.moves) {
        const auto step = test::cut_whole(world, cut.settings, {&move, 1});
        ASSERT_TRUE(step.ok());
        std::vector<uint32_t> slots, labels;
        for (const BodyDelta& d : step->delta.bodies) {
          for (const FaceId f : d.added) slots.push_back(f.index);
          for (const FaceId f : d.dead) slots.push_back(f.index);
          for (const FaceId f : d.relabelled) labels.push_back(f.index);
        }
        const ShadowCaster::Change change = caster.update(body.mesh, slots, labels);
        for (ShadowVolume& volume : followed) volume.follow(caster, change);
      }
      const ShadowCaster fresh(body.mesh, frame);
      for (const ShadowVolume& volume : followed) {
        const ShadowVolume rebuilt = volume_of(fresh, kLamp, volume.method());
        EXPECT_EQ(silhouette_of(caster, volume), silhouette_of(fresh, rebuilt));
        EXPECT_TRUE(std::equal(rebuilt.signs().begin(), rebuilt.signs().end(), volume.signs().begin()));
      }
    }
  }
}

}  // namespace
}  // namespace kerf
