#include "core/edit/detach.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <tuple>

#include "core/cut/knife.h"
#include "core/document/document.h"
#include "core/edit/separation.h"
#include "core/world/body_mass.h"
#include "tests/support/made_meshes.h"
#include "tests/support/mesh_numbers.h"
#include "tests/support/piece_sums.h"
#include "tests/support/same_world.h"
#include "tests/support/strokes.h"

namespace kerf::test {
namespace {

// The corners of all faces of a world, each turned to begin at its least corner, and how often each is there.
std::map<std::array<double, 9>, int> triangles_of(const World& world) {
  const auto less = [](const Vec3& a, const Vec3& b) {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
  };
  std::map<std::array<double, 9>, int> all;
  for (const BodyId id : world.ids()) {
    const Mesh& mesh = world.body(id).mesh;
    for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
      if (!mesh.is_live(FaceId(f))) continue;
      Triangle t = mesh.triangle(FaceId(f));
      std::rotate(t.begin(), std::min_element(t.begin(), t.end(), less), t.end());
      ++all[{t[0].x, t[0].y, t[0].z, t[1].x, t[1].y, t[1].z, t[2].x, t[2].y, t[2].z}];
    }
  }
  return all;
}

double area_of(const World& world) {
  double area = 0;
  for (const BodyId id : world.ids()) {
    for (uint32_t p = 0; p < world.body(id).pieces.size(); ++p) area += world.body(id).pieces[p].area;
  }
  return area;
}

World cut_world(const Soup& soup, uint64_t seed) {
  World world = world_of(soup);
  Random random(seed);
  for (int i = 0; i < 3; ++i) {
    const RandomStroke stroke = random_stroke(world, random, 0.02, i == 1);
    EXPECT_TRUE(cut_whole(world, stroke.settings, stroke.moves).ok());
    continue_separation(world, kNoLimit);
  }
  return world;
}

void expect_whole(const Body& body) {
  EXPECT_EQ(find_fault(body.mesh, true), "");
  EXPECT_EQ(body.tree.leaf_count(), body.mesh.live_faces());
  size_t faces = 0;
  for (uint32_t p = 0; p < body.pieces.size(); ++p) faces += body.pieces[p].faces;
  EXPECT_EQ(faces, body.mesh.live_faces());
}

TEST(Detach, leaves_face_positions_and_other_pieces_unchanged) {
  for (const auto& [name, soup] : mesh_classes()) {
    SCOPED_TRACE(name);
    World world = cut_world(soup, 7);
    const auto before = triangles_of(world);
    const BodyId first = world.ids().front();
    std::vector<uint32_t> labels;
    for (uint32_t p = 0; p < world.body(first).pieces.size(); ++p) {
      if (world.body(first).pieces[p].faces > 0) labels.push_back(p);
    }
    uint32_t generation = 0;
    for (const uint32_t label : labels) {
      ++generation;
      const std::vector<BodyId> ids = world.ids();
      const auto holder = std::find_if(ids.begin(), ids.end(), [&](BodyId id) {
        const auto& pieces = world.body(id).pieces;
        return label < pieces.size() && pieces[label].faces > 0;
      });
      ASSERT_NE(holder, ids.end());
      const Piece piece = world.body(*holder).pieces[label];
      Delta delta;
      const bool alone = is_only_piece(world, {*holder, label});
      const BodyId own = detach(world, {*holder, label}, generation, delta);
      EXPECT_EQ(own, alone ? *holder : BodyId(static_cast<uint32_t>(ids.size()), generation));
      EXPECT_TRUE(is_only_piece(world, {own, label}));
      EXPECT_EQ(world.body(own).mesh.live_faces(), piece.faces);
      EXPECT_EQ(world.body(own).pieces[label].area, piece.area);
    }
    EXPECT_EQ(world.ids().size(), std::max<size_t>(labels.size(), 1));
    EXPECT_EQ(triangles_of(world), before);
    for (const BodyId id : world.ids()) expect_whole(world.body(id));
  }
}

TEST(Detach, a_detached_piece_is_cut_like_the_original) {
  for (uint64_t seed = 1; seed <= 4; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    World together = cut_world(torus(14, 10, 0.5, 0.2), seed), apart = together;
    Delta delta;
    const BodyId first = apart.ids().front();
    for (uint32_t p = 1; p < together.body(first).pieces.size(); ++p) {
      if (together.body(first).pieces[p].faces > 0) detach(apart, {first, p}, p, delta);
    }
    Random random(seed + 50);
    RandomStroke stroke = random_stroke(together, random, 0.02, false);
    stroke.settings.resolution.scheme = Scheme::kLongestEdge;  // green pairs were forgotten
    for (World* world : {&together, &apart}) {
      ASSERT_TRUE(cut_whole(*world, stroke.settings, stroke.moves).ok());
      continue_separation(*world, kNoLimit);
    }
    EXPECT_NEAR(area_of(together), area_of(apart), 1e-3 * area_of(together));
    EXPECT_EQ(together.live_pieces(), apart.live_pieces());
    for (const BodyId id : apart.ids()) expect_whole(apart.body(id));
  }
}

bool contains(const Triangle& large, const Triangle& small) {
  const Vec3 n = glm::cross(large[1] - large[0], large[2] - large[0]);
  for (const Vec3& p : small) {
    for (int i = 0; i < 3; ++i) {
      if (glm::dot(glm::cross(large[(i + 1) % 3] - large[i], p - large[i]), n) < -1e-9 * glm::dot(n, n))
        return false;
    }
  }
  return true;
}

TEST(Detach, keeps_the_loaded_origin_of_every_face) {
  const Soup soup = both(torus(14, 10, 0.5, 0.2), sphere(8, 10, 0.3));
  const Mesh loaded = build(soup).mesh;
  World world = cut_world(soup, 3);
  const BodyId first = world.ids().front();
  for (int round = 1; round <= 2; ++round) {
    const Records<Piece> pieces = world.body(first).pieces;
    Delta delta;
    for (uint32_t p = 1; p < pieces.size(); ++p) {
      const bool now = round == 2 || p % 2 == 1;
      if (now && world.body(first).pieces[p].faces > 0)
        detach(world, {first, p}, static_cast<uint32_t>(round) * 1000 + p, delta);
    }
    for (const BodyId id : world.ids()) {
      const Body& body = world.body(id);
      EXPECT_EQ(body.loaded_as, first);
      for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
        if (!body.mesh.is_live(FaceId(f))) continue;
        const FaceId from = body.loaded_face(body.mesh.data(FaceId(f)).base);
        ASSERT_TRUE(from.valid());
        EXPECT_TRUE(contains(loaded.triangle(from), body.mesh.triangle(FaceId(f))));
      }
    }
  }
}

TEST(Detach, is_not_needed_to_rename_a_piece_and_keeps_the_name) {
  Document document(cut_world(torus(14, 10, 0.5, 0.2), 7));
  const BodyId first = document.world().ids().front();
  const World before = document.world();
  const std::string name = document.world().body(first).name;
  const Outcome renamed = document.apply(RenamePiece{{first, 1}, "door"});
  ASSERT_TRUE(renamed.ok());
  EXPECT_TRUE(renamed.delta.created.empty() && renamed.delta.detached.empty());
  EXPECT_EQ(renamed.delta.renamed, std::vector<BodyId>{first});
  EXPECT_EQ(document.world().ids(), before.ids());
  EXPECT_EQ(document.world().body(first).name_of(0), name);
  EXPECT_EQ(document.world().body(first).name_of(1), "door");
  EXPECT_TRUE(document.apply(RenamePiece{{first, 1}, "door"}).delta.empty());
  for (const bool piece_goes : {true, false}) {
    SCOPED_TRACE(piece_goes);
    const uint32_t label = piece_goes ? 1 : 0;
    ASSERT_TRUE(document.apply(HidePiece{{first, label}, true}).ok());
    size_t doors = 0;
    for (const BodyId id : document.world().ids()) {
      const Body& body = document.world().body(id);
      if (body.pieces[1].faces == 0) continue;
      ++doors;
      EXPECT_EQ(body.name_of(1), "door");
      if (piece_goes) EXPECT_EQ(body.name_of(5), "door 5");
    }
    EXPECT_EQ(doors, 1u);
    ASSERT_TRUE(document.apply(Undo{}).ok());
  }
  ASSERT_TRUE(document.apply(Undo{}).ok());
  expect_same_world(document.world(), before);
}

TEST(Detach, keeps_the_piece_name_and_derives_names_of_later_pieces) {
  Document document(cut_world(torus(14, 10, 0.5, 0.2), 7));
  const BodyId first = document.world().ids().front();
  const std::string name = document.world().body(first).name;
  ASSERT_GT(document.world().body(first).pieces[1].faces, 0u);
  EXPECT_EQ(document.world().body(first).name_of(0), name);
  EXPECT_EQ(document.world().body(first).name_of(1), name + " 1");
  const World before = document.world();
  ASSERT_TRUE(document.apply(HidePiece{{first, 1}, true}).ok());
  const auto own = [&]() -> const Body& { return document.world().body(document.world().ids().back()); };
  EXPECT_EQ(own().own_name(), name + " 1");
  EXPECT_EQ(own().name_of(5), name + " 5");
  EXPECT_EQ(document.world().body(first).name_of(0), name);
  ASSERT_TRUE(document.apply(RenamePiece{{document.world().ids().back(), 1}, "door"}).ok());
  EXPECT_EQ(own().own_name(), "door");
  EXPECT_EQ(own().name_of(5), "door 5");
  EXPECT_EQ(document.world().body(first).name_of(0), name);
  ASSERT_TRUE(document.apply(Undo{}).ok());
  EXPECT_EQ(own().own_name(), name + " 1");
  ASSERT_TRUE(document.apply(Undo{}).ok());
  expect_same_world(document.world(), before);
}

// A plate of which a strip came off, either side of which is the larger one.
World plate_in_two(double x) {
  World world = world_of(plate(1));
  CutSettings settings;
  settings.laser.radius = 0.02;
  settings.resolution.target_edge = 0.05;
  const BeamMove across{{{x, 1, -0.7}, {0, -1, 0}}, {{x, 1, 0.7}, {0, -1, 0}}};
  EXPECT_TRUE(cut_whole(world, settings, {&across, 1}).ok());
  continue_separation(world, kNoLimit);
  EXPECT_EQ(world.live_pieces(), 2u);
  return world;
}

TEST(Detach, gives_the_piece_the_new_id_for_either_copied_side_and_undoes_exactly) {
  for (const double x : {-0.3, 0.3}) {
    for (const uint32_t label : {0u, 1u}) {
      for (const bool removed : {false, true}) {
        SCOPED_TRACE(std::to_string(x) + " label " + std::to_string(label) + (removed ? " removed" : ""));
        World world = plate_in_two(x);
        const World before = world;
        const BodyId first = world.ids().front();
        world.begin_change();
        Delta delta;
        const BodyId own = detach(world, {first, label}, 5, delta);
        EXPECT_EQ(own, BodyId(1, 5));
        EXPECT_TRUE(is_only_piece(world, {own, label}));
        EXPECT_TRUE(is_only_piece(world, {first, 1 - label}));
        world.body(own).placement.position = {1, 2, 3};
        if (removed) world.remove(own);
        World::Change change = world.end_change();
        const World after = world;
        for (int i = 0; i < 2; ++i) {
          world.exchange(change);
          expect_same_world(world, before);
          world.exchange(change);
          expect_same_world(world, after);
        }
      }
    }
  }
}

TEST(Detach, lists_the_faces_that_left_the_larger_side) {
  for (const double x : {-0.3, 0.3}) {
    for (const uint32_t label : {0u, 1u}) {
      SCOPED_TRACE(std::to_string(x) + " label " + std::to_string(label));
      World world = plate_in_two(x);
      const BodyId first = world.ids().front();
      const Mesh before = world.body(first).mesh;
      Delta delta;
      detach(world, {first, label}, 5, delta);
      ASSERT_EQ(delta.created.size(), 1u);
      ASSERT_EQ(delta.bodies.size(), 1u);
      const BodyDelta& larger = delta.bodies.front();
      EXPECT_NE(larger.body, delta.created.front());
      const Mesh& after = world.body(larger.body).mesh;
      std::vector<FaceId> left;
      for (uint32_t f = 0; f < before.face_slots(); ++f) {
        if (before.is_live(FaceId(f)) && !after.is_live(FaceId(f))) left.emplace_back(f);
      }
      EXPECT_FALSE(left.empty());
      EXPECT_EQ(larger.dead, left);
      EXPECT_TRUE(larger.added.empty() && larger.relabelled.empty());
    }
  }
}

TEST(Duplicate, adds_a_separate_body_with_the_same_faces) {
  for (uint64_t seed = 1; seed <= 6; ++seed) {
    World world = cut_world(both(torus(14, 10, 0.5, 0.2), sphere(8, 10, 0.3)), seed);
    const World before = world;
    const BodyId first = world.ids().front();
    for (uint32_t p = 0; p < before.body(first).pieces.size(); ++p) {
      if (before.body(first).pieces[p].faces == 0) continue;
      SCOPED_TRACE("seed " + std::to_string(seed) + ", piece " + std::to_string(p));
      Delta delta;
      const BodyId copy = duplicate(world, {first, p}, 100 + p, delta);
      EXPECT_EQ(delta.created, std::vector{copy});
      EXPECT_TRUE(delta.bodies.empty() && delta.detached.empty());
      expect_whole(world.body(copy));
      EXPECT_EQ(world.body(copy).own_name(), before.body(first).name_of(p) + " copy");
      EXPECT_EQ(world.body(copy).pieces[p].area, before.body(first).pieces[p].area);

      World alone, detached = before;
      Delta ignored;
      const BodyId own = detach(detached, {first, p}, 1, ignored);
      alone.add(world.body(copy));
      World expected;
      expected.add(detached.body(own));
      EXPECT_EQ(triangles_of(alone), triangles_of(expected));
      world.remove(copy);
    }
    EXPECT_EQ(triangles_of(world), triangles_of(before));
  }
}

TEST(Duplicate, undoes_and_redoes_and_its_copy_can_be_cut) {
  Document document(cut_world(torus(14, 10, 0.5, 0.2), 7));
  const BodyId first = document.world().ids().front();
  const World before = document.world();
  ASSERT_TRUE(document.apply(DuplicatePiece{{first, 1}, {{0, 1, 0}, {1, 0, 0, 0}}}).ok());
  const World after = document.world();
  ASSERT_EQ(after.ids().size(), 2u);
  EXPECT_EQ(after.body(after.ids().back()).placement.position, Vec3(0, 1, 0));
  ASSERT_TRUE(document.apply(Undo{}).ok());
  expect_same_world(document.world(), before);
  ASSERT_TRUE(document.apply(Redo{}).ok());
  expect_same_world(document.world(), after);

  World cut = after;
  cut.remove(first);
  const size_t faces = cut.live_faces();
  Random random(3);
  const RandomStroke stroke = random_stroke(cut, random, 0.05, true);
  ASSERT_TRUE(cut_whole(cut, stroke.settings, stroke.moves).ok());
  EXPECT_NE(cut.live_faces(), faces);
  expect_whole(cut.body(cut.ids().front()));

  const Outcome none = document.apply(DuplicatePiece{{first, 4000}, {}});
  EXPECT_FALSE(none.ok());
  expect_same_world(document.world(), after);
}

TEST(MoveComponents, adds_pieces_up_to_the_new_label) {
  Body body = make_body("two", build(both(sphere(5, 6, 0.3), moved(sphere(5, 6, 0.3), {1, 0, 0}, 1))));
  const size_t faces = body.mesh.live_faces();
  const BodyDelta delta = move_components({}, body, std::map<uint32_t, uint32_t>{{1, 2}});
  EXPECT_EQ(delta.new_pieces, (std::vector<uint32_t>{1, 2}));
  EXPECT_EQ(delta.relabelled.size(), faces / 2);
  ASSERT_NO_FATAL_FAILURE(expect_piece_sums(body));
}

// A ball with a cavity above its middle, cut between both and then through the cavity, or only through it.
TEST(AssignCavities, moves_a_cavity_with_the_piece_around_it_until_a_wall_joins_them) {
  const Vec3 middle(0, 0.3, 0);
  for (const bool cuts_below : {true, false}) {
    SCOPED_TRACE(cuts_below);
    World world = world_of(both(sphere(16, 24, 0.5), inside_out(moved(sphere(12, 16, 0.1), middle, 1))));
    make_solid(only_body(world), true);
    const std::vector<BodyId> ids = world.ids();
    if (cuts_below) {
      ASSERT_TRUE(cut_with_plane(world, {{0, 1, 0}, 0.1}, ids).ok());
      const Body& body = only_body(world);
      for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
        if (!body.mesh.is_live(FaceId(f))) continue;
        const bool of_cavity = glm::distance(body.mesh.triangle(FaceId(f))[0], middle) < 0.101;
        if (of_cavity) ASSERT_EQ(body.mesh.data(FaceId(f)).piece, 1u);
      }
      ASSERT_EQ(expect_part_counts(body), 3u);
    }
    ASSERT_TRUE(cut_with_plane(world, {{0, 1, 0}, 0.31}, ids).ok());
    ASSERT_EQ(expect_part_counts(only_body(world)), cuts_below ? 3u : 2u);
  }
}

}  // namespace
}  // namespace kerf::test
