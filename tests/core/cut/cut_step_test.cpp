#include "core/cut/cut_step.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/document/document.h"
#include "core/edit/separation.h"
#include "core/world/world.h"
#include "tests/support/made_meshes.h"
#include "tests/support/mesh_numbers.h"
#include "tests/support/real_meshes.h"
#include "tests/support/runs.h"
#include "tests/support/strokes.h"

namespace kerf::test {
namespace {

// The pieces that a full search finds: components of the base mesh fall apart into components of what is
// left, and of each the largest keeps the label.
void expect_pieces_equal_full_search(const Body& body, const std::vector<uint32_t>& base_component) {
  std::vector<uint32_t> component;
  const uint32_t count = label_components(body.mesh, component);
  std::vector<uint32_t> piece_of(count, 0xffffffffu);
  std::vector<uint32_t> parts_in_label_0(body.loaded.components, 0);
  std::vector<size_t> faces(body.pieces.size(), 0);
  for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
    if (!body.mesh.is_live(FaceId(f))) continue;
    const FaceData& data = body.mesh.data(FaceId(f));
    ++faces[data.piece];
    uint32_t& piece = piece_of[component[f]];
    if (piece == 0xffffffffu) {
      piece = data.piece;
      if (piece == 0) ++parts_in_label_0[base_component[data.base.index]];
    }
    ASSERT_EQ(piece, data.piece) << "two labels in one component";
  }
  std::vector<uint32_t> off;
  for (const uint32_t piece : piece_of) {
    if (piece != 0) off.push_back(piece);
  }
  std::sort(off.begin(), off.end());
  EXPECT_EQ(std::adjacent_find(off.begin(), off.end()), off.end())
      << "two components in one piece that came off";
  for (const uint32_t parts : parts_in_label_0) EXPECT_LE(parts, 1u) << "a part that came off kept its label";
  for (uint32_t p = 0; p < faces.size(); ++p)
    EXPECT_EQ(faces[p], body.pieces[p].faces) << "faces of piece " << p;
}

void expect_nothing_left_under(const Body& body, const CutSettings& settings, const BeamMove& move) {
  for (const SweptCylinder& part : sweep_beam(settings.laser, move)) {
    for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
      if (body.mesh.is_live(FaceId(f)))
        ASSERT_FALSE(part.touches(body.mesh.triangle(FaceId(f)))) << "face " << f;
    }
  }
}

void expect_tree_answers_as_brute_force(Body& body, Random& random) {
  const Bounds box = body.bounds();
  const double size = glm::length(box.max - box.min);
  for (int i = 0; i < 4; ++i) {
    const Vec3 axis = random_direction(random),
               at = 0.5 * box.min + 0.5 * box.max + 0.2 * size * random_direction(random);
    const Pose from{at - size * axis, axis}, to{from.origin + 0.1 * size * random_direction(random), axis};
    const SweptCylinder beam(from, to, 0.01 * size, {0, 3 * size});
    std::vector<FaceId> found, all;
    body.tree.touched(body.mesh, beam, found);
    for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
      if (body.mesh.is_live(FaceId(f)) && beam.touches(body.mesh.triangle(FaceId(f)))) all.emplace_back(f);
    }
    std::sort(found.begin(), found.end());
    ASSERT_EQ(found, all);
  }
}

// Walks a stroke and holds every invariant after every step; on large real meshes the dear ones only at the
// end.
void cut_and_check(World& world, const RandomStroke& stroke, bool made) {
  Body& body = only_body(world);
  std::vector<uint32_t> base_component;
  label_components(body.mesh, base_component);
  const double area = live_area(body.mesh);
  Random beams(1);
  double removed = 0;
  for (size_t i = 0; i < stroke.moves.size(); ++i) {
    const auto result = cut_whole(world, stroke.settings, {&stroke.moves[i], 1});
    ASSERT_TRUE(result.ok());
    removed += result->delta.removed_area;
    const bool small = body.mesh.live_faces() < 2500;
    if (made || small) {
      ASSERT_EQ(find_fault(body.mesh, !made), "") << "step " << i;
      if (is_settled(world)) expect_pieces_equal_full_search(body, base_component);
    }
    if (made || i % 16 == 0) expect_nothing_left_under(body, stroke.settings, stroke.moves[i]);
    if (::testing::Test::HasFailure()) return;
  }
  continue_separation(world, kNoLimit);
  EXPECT_EQ(find_fault(body.mesh, !made), "");
  EXPECT_EQ(body.tree.leaf_count(), body.mesh.live_faces());
  expect_tree_answers_as_brute_force(body, beams);
  EXPECT_NEAR(removed + live_area(body.mesh), area, 1e-6 * area);
  expect_pieces_equal_full_search(body, base_component);
}

TEST(CutStep, keeps_every_invariant_after_each_step_on_all_mesh_classes) {
  for (const auto& [name, soup] : mesh_classes()) {
    for (uint64_t seed = 1; seed <= 3; ++seed) {
      SCOPED_TRACE(name + ", seed " + std::to_string(seed));
      World world = world_of(soup);
      Random random(seed);
      cut_and_check(world, random_stroke(world, random, 0.03, seed == 3), true);
    }
  }
}

// A half that was left alone would be halved once too often for a split in four.
TEST(CutStep, removes_both_halves_of_a_green_pair) {
  for (uint64_t seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    World world =
        world_of(sphere(9, 12, 0.5));  // faces of many sizes, so that fine ones lie beside finer ones
    const Body& body = only_body(world);
    std::vector<double> base_area;
    for (uint32_t f = 0; f < body.mesh.face_slots(); ++f)
      base_area.push_back(triangle_area(body.mesh.triangle(FaceId(f))));
    Random random(seed);
    RandomStroke stroke = random_stroke(world, random, 0.03, false);
    stroke.settings.resolution.scheme = Scheme::kOneToFour;
    for (const BeamMove& move : stroke.moves) ASSERT_TRUE(cut_whole(world, stroke.settings, {&move, 1}).ok());
    for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
      if (!body.mesh.is_live(FaceId(f))) continue;
      const FaceData& data = body.mesh.data(FaceId(f));
      const double area = std::ldexp(base_area[data.base.index], -data.halvings);
      ASSERT_EQ(data.halvings % 2 == 1, data.element != FaceData::kNoElement);
      ASSERT_NEAR(triangle_area(body.mesh.triangle(FaceId(f))), area, 1e-9 * area);
    }
  }
}

TEST(CutStep, continues_across_rims_of_older_cuts) {
  for (uint64_t seed = 1; seed <= runs(4); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    World world = world_of(torus(14, 10, 0.5, 0.2));
    Random random(seed);
    std::vector<uint32_t> ignored;
    for (int stroke = 0; stroke < 3; ++stroke) {
      const RandomStroke s = random_stroke(world, random, 0.015, stroke == 1);
      for (const BeamMove& move : s.moves) {
        ASSERT_TRUE(cut_whole(world, s.settings, {&move, 1}).ok());
        ASSERT_EQ(find_fault(only_body(world).mesh), "");
      }
    }
  }
}

// The search for what came apart falls behind, so that splits, removals and further cuts come in between.
TEST(CutStep, finds_the_pieces_of_a_full_search_over_many_steps) {
  for (const auto& [name, soup] : mesh_classes()) {
    for (uint64_t seed = 11; seed < 11 + runs(8); ++seed) {
      SCOPED_TRACE(name + ", seed " + std::to_string(seed));
      World world = world_of(soup);
      Random random(seed);
      RandomStroke stroke = random_stroke(world, random, 0.02, seed >= 12);
      stroke.settings.search_a_move = 1 + random.below(40);
      stroke.settings.resolution.scheme = seed == 12 ? Scheme::kOneToFour : Scheme::kLongestEdge;
      cut_and_check(world, stroke, true);
    }
  }
}

TEST(CutStep, cuts_real_meshes_into_the_pieces_of_a_full_search) {
  const auto files = real_meshes(14000);
  if (files.empty()) GTEST_SKIP() << kNoRealMeshes;
  uint64_t seed = 100;
  for (const auto& file : files) {
    SCOPED_TRACE(file.string() + ", seed " + std::to_string(++seed));
    World world = world_of_file(file);
    Random random(seed);
    cut_and_check(world, random_stroke(world, random, 0.006, false), false);
    if (HasFailure()) return;
  }
}

// A world cut along a straight stroke, straight down.
struct StraightCut {
  double removed_area = 0;
  size_t removed_faces = 0;
  uint64_t hash = 0;
};
StraightCut cut_straight(const Soup& soup, const Vec3& a, const Vec3& b, const CutSettings& settings,
                         size_t steps) {
  Document document(world_of(soup));
  document.apply(BeginStroke{settings, {a, {0, -1, 0}}});
  document.apply(MoveBeam{{b, {0, -1, 0}}});
  document.apply(EndStroke{});
  StraightCut cut;
  const size_t moves = document.waiting();
  for (size_t i = 0; i < steps; ++i) {
    const auto result = run_moves(document, moves * (i + 1) / steps - moves * i / steps);
    EXPECT_TRUE(result.ok());
    cut.removed_area += result->delta.removed_area;
    cut.removed_faces += result->delta.removed_faces;
  }
  cut.hash = state_hash(document.world());
  return cut;
}

TEST(CutStep, kerf_fits_the_beam_on_plates) {
  Random random(5);
  for (int i = 0; i < 12; ++i) {
    const double size = random.uniform(0.8, 2), r = random.uniform(0.012, 0.035);
    const double angle = random.uniform(0, 6.28), half = 0.3 * size;
    const Vec3 along(half * std::cos(angle), 0, half * std::sin(angle));
    const Vec3 middle(random.uniform(-0.05, 0.05), 1, random.uniform(-0.05, 0.05));
    const double swept = 2 * r * 2 * half + 3.14159265358979 * r * r;
    for (const auto& [share, most] : {std::pair(4.0, 1.13), std::pair(16.0, 1.035)}) {
      CutSettings settings;
      settings.laser.radius = r;
      settings.resolution.target_edge = r / share;
      const double ratio =
          cut_straight(plate(size), middle - along, middle + along, settings, 1).removed_area / swept;
      EXPECT_GE(ratio, 1.0) << "plate " << i << " at r/" << share;
      EXPECT_LE(ratio, most) << "plate " << i << " at r/" << share;
    }
  }
}

TEST(CutStep, removes_the_same_faces_in_1_10_and_1000_steps) {
  CutSettings settings;
  settings.laser.radius = 0.02;
  settings.resolution.target_edge = 0.005;
  for (const Soup& soup : {plate(1), sphere(12, 16, 0.5), both(sphere(8, 9, 0.4), grid(3, 1))}) {
    const Vec3 a(-0.3, 1, 0.013), b(0.31, 1, 0.057);
    const StraightCut one = cut_straight(soup, a, b, settings, 1);
    EXPECT_GT(one.removed_faces, 100u);
    for (const size_t steps : {size_t{10}, size_t{1000}}) {
      const StraightCut many = cut_straight(soup, a, b, settings, steps);
      EXPECT_EQ(many.removed_faces, one.removed_faces);
      EXPECT_NEAR(many.removed_area, one.removed_area, 1e-12);
      EXPECT_EQ(many.hash, one.hash);
    }
  }
}

TEST(CutStep, removes_whole_base_faces_at_depth_0) {
  CutSettings settings;
  settings.laser.radius = 0.01;
  settings.resolution = {.rule = Resolution::Rule::kDepth, .depth = 0};
  World world = world_of(grid(4, 1));
  const BeamMove still{{{0.1, 1, 0.05}, {0, -1, 0}}, {{0.1, 1, 0.05}, {0, -1, 0}}};
  const auto result = cut_whole(world, settings, {&still, 1});
  ASSERT_TRUE(result.ok());
  EXPECT_EQ(result->statistics.faces_made, 0u);
  EXPECT_EQ(result->delta.removed_faces, 1u);
}

TEST(CutStep, removes_faces_inside_the_beam_without_splitting_them) {
  CutSettings settings;
  settings.laser.radius = 0.5;
  settings.resolution.target_edge = 0.001;
  World world = world_of(sphere(10, 12, 0.2));
  const BeamMove still{{{0, 1, 0}, {0, -1, 0}}, {{0, 1, 0}, {0, -1, 0}}};
  const auto result = cut_whole(world, settings, {&still, 1});
  ASSERT_TRUE(result.ok());
  EXPECT_EQ(result->statistics.faces_made, 0u);
  EXPECT_EQ(world.live_faces(), 0u);
}

TEST(CutStep, four_rays_pierce_exactly_four_holes) {
  CutSettings settings;
  settings.laser.radius = 0.1;
  settings.laser.range = {0, 5};
  settings.laser.pattern = Pattern::kRays4;
  settings.resolution.target_edge = 0.005;
  World world = world_of(plate(1));
  const BeamMove still{{{0.02, 1, 0.01}, {0, -1, 0}}, {{0.02, 1, 0.01}, {0, -1, 0}}};
  ASSERT_TRUE(cut_whole(world, settings, {&still, 1}).ok());
  const Body& body = only_body(world);
  EXPECT_EQ(count_numbers(body.mesh).boundary_loops, 5u);  // the plate's own and four small holes
  EXPECT_GT(live_area(body.mesh), 1 - 4 * 0.01 * 0.01);
}

TEST(CutStep, cuts_all_layers_within_its_range_and_none_beyond) {
  Soup stack = plate(1);
  for (int layer = 1; layer < 4; ++layer) stack = both(stack, moved(plate(1), {0, -0.5 * layer, 0}, 1));
  CutSettings settings;
  settings.laser.radius = 0.05;
  settings.laser.range = {0, 2.1};  // from y = 1: layers at 0, -0.5 and -1
  settings.resolution.target_edge = 0.02;
  World world = world_of(stack);
  const BeamMove still{{{0.1, 1, 0}, {0, -1, 0}}, {{0.1, 1, 0}, {0, -1, 0}}};
  ASSERT_TRUE(cut_whole(world, settings, {&still, 1}).ok());
  EXPECT_EQ(count_numbers(only_body(world).mesh).boundary_loops, 4u + 3u);
}

TEST(CutStep, fails_with_a_message_if_too_many_faces_would_be_created) {
  CutSettings settings;
  settings.laser.radius = 0.02;
  settings.resolution.target_edge = 1e-6;
  settings.max_faces = 20000;
  World world = world_of(plate(1));
  const BeamMove still{{{0, 1, 0}, {0, -1, 0}}, {{0, 1, 0}, {0, -1, 0}}};
  const auto result = cut_whole(world, settings, {&still, 1});
  ASSERT_FALSE(result.ok());
  EXPECT_NE(result.error().message.find("20000 faces"), std::string::npos);
  EXPECT_EQ(find_fault(only_body(world).mesh), "");
}

TEST(CutStep, lists_every_changed_face_in_its_delta) {
  Random random(9);
  World world = world_of(sphere(10, 12, 0.5));
  const RandomStroke stroke = random_stroke(world, random, 0.04, false);
  Body& body = only_body(world);
  std::vector<Triangle> before;
  std::vector<bool> live;
  const auto remember = [&] {
    before.clear();
    live.clear();
    for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
      live.push_back(body.mesh.is_live(FaceId(f)));
      before.push_back(live.back() ? body.mesh.triangle(FaceId(f)) : Triangle{});
    }
  };
  for (const BeamMove& move : stroke.moves) {
    remember();
    const auto result = cut_whole(world, stroke.settings, {&move, 1});
    ASSERT_TRUE(result.ok());
    std::vector<int> reported(body.mesh.face_slots(), 0);
    for (const BodyDelta& d : result->delta.bodies) {
      for (const FaceId f : d.added) reported[f.index] = 1;
      for (const FaceId f : d.dead) reported[f.index] = 2;
    }
    for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
      const bool was = f < live.size() && live[f], is = body.mesh.is_live(FaceId(f));
      if (was && !is) EXPECT_EQ(reported[f], 2);
      if (is && (!was || longest_edge2(before[f]) != longest_edge2(body.mesh.triangle(FaceId(f)))))
        EXPECT_EQ(reported[f], 1);
    }
  }
}

}  // namespace
}  // namespace kerf::test
