#include "core/edit/separation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "core/edit/body_edit.h"
#include "core/edit/detach.h"
#include "tests/support/made_meshes.h"
#include "tests/support/piece_sums.h"
#include "tests/support/real_meshes.h"
#include "tests/support/strokes.h"

namespace kerf::test {
namespace {

void remove_face(Body& body, FaceId f) { BodyEdit(body).remove({&f, 1}); }

// Bisects the face over one of its edges, and all faces on that.
void split(Body& body, FaceId f, size_t edge) {
  const auto c = body.mesh.corners(f);
  const VertexId from = c[edge], to = c[(edge + 1) % 3];
  const Vec3 middle = 0.5 * body.mesh.position(from) + 0.5 * body.mesh.position(to);
  if (middle == body.mesh.position(from) || middle == body.mesh.position(to)) return;
  std::vector<Mesh::FaceSplit> splits;
  BodyEdit(body).split_edge_at(f, from, to, middle, splits);
}

FaceId live_face(const Body& body, Random& random) {
  for (;;) {
    const FaceId f(static_cast<uint32_t>(random.below(body.mesh.face_slots())));
    if (body.mesh.is_live(f)) return f;
  }
}

// Each component that the full search finds has one label, and each label but that of the body is on one
// component, that of the body on at most one of each component as loaded; all are counted right.
void expect_labels_of_the_full_search(const Body& body, const std::vector<uint32_t>& loaded) {
  std::vector<uint32_t> component;
  label_components(body.mesh, component);
  std::map<uint32_t, uint32_t> label_of;
  std::set<std::pair<uint32_t, uint32_t>> in_use;
  for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
    if (!body.mesh.is_live(FaceId(f))) continue;
    const FaceData& data = body.mesh.data(FaceId(f));
    const auto [known, fresh] = label_of.try_emplace(component[f], data.piece);
    ASSERT_EQ(known->second, data.piece) << "two labels in one component";
    const uint32_t from = data.piece == 0 ? loaded[data.base.index] : 0;
    if (fresh)
      ASSERT_TRUE(in_use.emplace(data.piece, from).second) << "label " << data.piece << " on two parts";
  }
  expect_piece_sums(body);
}

// Clumps of faces, grown over shared edges: holes, slots that close, islands.
void remove_clump(Body& body, Random& random, uint64_t faces) {
  FaceId f = live_face(body, random);
  std::vector<FaceId> neighbours;
  for (uint64_t i = 0; i < faces && body.mesh.live_faces() > 0; ++i) {
    neighbours.clear();
    body.mesh.append_nearest_neighbours(f, neighbours);
    remove_face(body, f);
    std::erase_if(neighbours, [&](FaceId n) { return !body.mesh.is_live(n); });
    if (neighbours.empty()) return;
    f = neighbours[random.below(neighbours.size())];
  }
}

// Removals and splits in random order. With a limit the searches fall behind, and some catch up.
void edit_at_random(const std::string& name, const Soup& soup, uint64_t seed, size_t most) {
  SCOPED_TRACE(name + ", seed " + std::to_string(seed) + ", looking at " + std::to_string(most) + " a step");
  Body body = make_body(name, build(soup));
  std::vector<uint32_t> loaded;
  label_components(body.mesh, loaded);
  Random random(seed);
  const size_t most_slots = 3 * soup.triangles.size() + 200;
  while (body.mesh.live_faces() > 0) {
    if (body.mesh.face_slots() < most_slots) {
      for (uint64_t i = random.below(4); i > 0; --i) split(body, live_face(body, random), random.below(3));
    }
    for (uint64_t i = random.below(3); i > 0 && body.mesh.live_faces() > 0; --i)
      remove_clump(body, random, 1 + random.below(12));
    settle(body, random.below(8) == 0 ? kNoLimit : most);
    if (is_settled(body)) expect_labels_of_the_full_search(body, loaded);
    if (::testing::Test::HasFatalFailure()) return;
  }
}

TEST(Separation, equals_the_full_search_after_every_step_of_random_edits) {
  for (const auto& [name, soup] : mesh_classes()) {
    for (uint64_t seed = 1; seed <= 6; ++seed) edit_at_random(name, soup, seed, kNoLimit);
    if (HasFatalFailure()) return;
  }
}

TEST(Separation, equals_the_full_search_when_searches_fall_behind) {
  for (const auto& [name, soup] : mesh_classes()) {
    for (uint64_t seed = 1; seed <= 6; ++seed) edit_at_random(name, soup, seed, 1 + seed * seed);
    if (HasFatalFailure()) return;
  }
}

TEST(Separation, equals_the_full_search_on_real_meshes) {
  const auto files = real_meshes(1500);
  if (files.empty()) GTEST_SKIP() << kNoRealMeshes;
  for (const auto& file : files) {
    SCOPED_TRACE(file.string());
    World world = world_of_file(file);
    Body& body = only_body(world);
    std::vector<uint32_t> loaded;
    label_components(body.mesh, loaded);
    Random random(7);
    for (int step = 0; step < 40 && body.mesh.live_faces() > 0; ++step) {
      remove_clump(body, random, 1 + body.mesh.live_faces() / 40);
      settle(body);
      expect_labels_of_the_full_search(body, loaded);
      if (HasFatalFailure()) return;
    }
  }
}

// Removes every face of a band around a tube, in random order, one a step.
struct BandCut {
  size_t in_vain = 0, visited = 0, pieces = 0, smaller = 0;
};
BandCut cut_band(const Soup& soup, double low, double high, uint64_t seed) {
  Body body = make_body("tube", build(soup));
  std::vector<FaceId> band;
  for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
    const Triangle t = body.mesh.triangle(FaceId(f));
    const double y = (t[0].y + t[1].y + t[2].y) / 3;
    if (y > low && y < high) band.emplace_back(f);
  }
  Random random(seed);
  for (size_t i = band.size(); i > 1; --i) std::swap(band[i - 1], band[random.below(i)]);
  BandCut cut;
  for (const FaceId f : band) {
    remove_face(body, f);
    const SettleResult result = settle(body);
    cut.in_vain += result.visited > 0 && result.new_pieces.empty();
    cut.visited = std::max(cut.visited, result.visited);
    cut.pieces += result.new_pieces.size();
    if (!result.relabelled.empty()) cut.smaller = std::max(cut.smaller, result.relabelled.size());
  }
  return cut;
}

TEST(Separation, searches_only_when_a_part_of_a_closed_surface_comes_off) {
  for (uint64_t seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const BandCut cut = cut_band(sphere(40, 60, 1), 0.2, 0.4, seed);
    EXPECT_GT(cut.pieces, 0u);
    EXPECT_EQ(cut.in_vain, 0u);
  }
}

TEST(Separation, visits_at_most_twice_the_smaller_side) {
  for (uint64_t seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const BandCut cut = cut_band(sphere(80, 120, 1), 0.5, 0.6, seed);
    EXPECT_GT(cut.smaller, 1000u);
    constexpr size_t kOneTurn = 128;
    EXPECT_LE(cut.visited, 2 * cut.smaller + kOneTurn);
  }
}

// Removes every face in a band of y, and settles in calls that visit about `most` faces each.
struct Settled {
  Body body;
  size_t visited = 0;
  std::vector<FaceId> relabelled;
};
Settled settle_band(const Body& whole, double low, double high, size_t most, EditPolicy policy) {
  Settled settled{.body = whole, .visited = 0, .relabelled = {}};
  for (uint32_t f = 0; f < whole.mesh.face_slots(); ++f) {
    const Triangle t = whole.mesh.triangle(FaceId(f));
    const double y = (t[0].y + t[1].y + t[2].y) / 3;
    if (y > low && y < high) remove_face(settled.body, FaceId(f));
  }
  do {
    const SettleResult result = settle(settled.body, most, policy);
    settled.visited += result.visited;
    settled.relabelled.insert(settled.relabelled.end(), result.relabelled.begin(), result.relabelled.end());
  } while (!is_settled(settled.body));
  return settled;
}

void expect_same_pieces(const Body& a, const Body& b) {
  ASSERT_EQ(a.pieces.size(), b.pieces.size());
  for (uint32_t label = 0; label < a.pieces.size(); ++label) {
    EXPECT_EQ(a.pieces[label].faces, b.pieces[label].faces);
    EXPECT_EQ(a.pieces[label].area, b.pieces[label].area);  // to the bit
  }
  for (uint32_t f = 0; f < a.mesh.face_slots(); ++f) {
    if (a.mesh.is_live(FaceId(f))) ASSERT_EQ(a.mesh.data(FaceId(f)).piece, b.mesh.data(FaceId(f)).piece);
  }
}

// A ring cut along its whole length has four fronts, two of which belong to the same part until they meet.
TEST(Separation, finds_the_same_parts_with_fewer_visits_without_concurrent_edits) {
  const Body shapes[] = {make_body("ball", build(sphere(200, 240, 1))),
                         make_body("ring", build(torus(300, 160, 1, 0.4)))};
  for (uint64_t seed = 1; seed <= 6; ++seed) {
    Random random(seed);
    const double low = random.uniform(-0.3, 0.25), high = low + 0.03;
    const size_t most = random.below(2) == 0 ? 1'000 : kNoLimit;
    for (const Body& shape : shapes) {
      SCOPED_TRACE(shape.name + ", seed " + std::to_string(seed));
      const Settled edits = settle_band(shape, low, high, most, EditPolicy::kAllowEdits);
      const Settled calm = settle_band(shape, low, high, most, EditPolicy::kNoEdits);
      ASSERT_GE(calm.body.pieces.size(), 2u);
      expect_same_pieces(edits.body, calm.body);
      EXPECT_EQ(edits.relabelled, calm.relabelled);
      EXPECT_LE(calm.visited, edits.visited);
      if (shape.name == "ball") EXPECT_LE(calm.visited, calm.relabelled.size() * 5 / 4 + 4 * 4096);
    }
  }
}

TEST(Separation, treats_each_boundary_as_one_place) {
  // A slot along a tube joins its two boundaries and separates nothing; a second one cuts it in two.
  Body body = make_body("tube", build(tube(30, 24, 0.3, 2)));
  size_t searches = 0, pieces = 0;
  for (const int side : {1, -1}) {
    for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
      if (!body.mesh.is_live(FaceId(f))) continue;
      const Triangle t = body.mesh.triangle(FaceId(f));
      const Vec3 middle = (t[0] + t[1] + t[2]) / 3.0;
      if (std::abs(middle.z) < 0.06 && middle.x * side > 0) remove_face(body, FaceId(f));
    }
    const SettleResult result = settle(body);
    searches += result.visited > 0;
    pieces += result.new_pieces.size();
    if (side == 1) EXPECT_EQ(searches, 0u);
  }
  EXPECT_EQ(searches, 1u);
  EXPECT_EQ(pieces, 1u);
}

// Two rings are taken out of a tube at once: the fronts of the middle part meet, and the search has to go on
// with those beyond either ring, however often it pauses.
TEST(Separation, finds_all_parts_between_several_cuts_when_interrupted) {
  for (const double middle : {0.2, 0.5, 0.8}) {
    for (const size_t most : {1u, 40u, 400u, 4000u}) {
      SCOPED_TRACE("middle " + std::to_string(middle) + ", looking at " + std::to_string(most));
      Body body = make_body("tube", build(tube(60, 24, 0.3, 2)));
      std::vector<uint32_t> loaded;
      label_components(body.mesh, loaded);
      const double low = body.loaded.min.y, length = body.loaded.max.y - low;
      for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
        const Triangle t = body.mesh.triangle(FaceId(f));
        const double share = ((t[0].y + t[1].y + t[2].y) / 3 - low) / length;
        if (std::abs(share - 0.5 + middle / 2) < 0.03 || std::abs(share - 0.5 - middle / 2) < 0.03)
          remove_face(body, FaceId(f));
      }
      do {
        settle(body, most);
      } while (!is_settled(body));
      expect_labels_of_the_full_search(body, loaded);
      EXPECT_EQ(body.pieces.size(), 3u);
    }
  }
}

TEST(Separation, keeps_the_label_on_the_part_of_largest_area) {
  // A strip: many small faces, one that is taken away, and one large one.
  Soup soup = grid(6, 1);
  const uint32_t n = static_cast<uint32_t>(soup.positions.size());
  soup.positions.push_back({0.6, 0, -0.5});
  soup.positions.push_back({50, 0, 50});
  const uint32_t corner = 6, below = 13;  // the right border of the grid's first row
  soup.triangles.push_back({corner, below, n});
  soup.triangles.push_back({n, below, n + 1});
  soup.faces_in_file = soup.triangles_in_file = soup.triangles.size();
  Body body = make_body("strip", build(soup));
  const FaceId bridge(static_cast<uint32_t>(soup.triangles.size() - 2)), large(bridge.index + 1);
  remove_face(body, bridge);
  const auto result = settle(body);
  ASSERT_EQ(result.new_pieces.size(), 1u);
  EXPECT_EQ(body.mesh.data(large).piece, 0u);
  EXPECT_EQ(body.mesh.data(FaceId(0)).piece, 1u);
  EXPECT_EQ(result.relabelled.size(), 72u);
}

TEST(Separation, keeps_the_label_on_the_part_with_the_lowest_face_among_equals) {
  Body body = make_body("strip", build(tube(9, 12, 0.3, 0.9)));
  for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
    const Triangle t = body.mesh.triangle(FaceId(f));
    const double y = (t[0].y + t[1].y + t[2].y) / 3, middle = (body.loaded.min.y + body.loaded.max.y) / 2;
    if (std::abs(y - middle) < 0.05) remove_face(body, FaceId(f));
  }
  ASSERT_EQ(settle(body).new_pieces.size(), 1u);
  uint32_t lowest = 0;
  while (!body.mesh.is_live(FaceId(lowest))) ++lowest;
  EXPECT_EQ(body.mesh.data(FaceId(lowest)).piece, 0u);
  EXPECT_EQ(body.pieces[0].faces, body.pieces[1].faces);
}

TEST(Separation, does_not_separate_parts_that_were_never_connected) {
  Body body = make_body("two", build(both(sphere(5, 6, 0.3), moved(sphere(5, 6, 0.3), {1, 0, 0}, 1))));
  for (const uint32_t f : {0u, 1u, 60u, 61u}) {
    if (body.mesh.is_live(FaceId(f))) remove_face(body, FaceId(f));
  }
  EXPECT_TRUE(settle(body).new_pieces.empty());
}

TEST(Separation, gives_the_same_result_after_its_state_is_discarded) {
  for (uint64_t seed = 1; seed <= 8; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Body body = make_body("torus", build(torus(14, 10, 0.5, 0.2)));
    std::vector<uint32_t> loaded;
    label_components(body.mesh, loaded);
    Random random(seed);
    while (body.mesh.live_faces() > 0) {
      remove_clump(body, random, 1 + random.below(12));
      settle(body);
      expect_labels_of_the_full_search(body, loaded);
      if (HasFatalFailure()) return;
      if (random.below(3) == 0) forget_removals(body);
    }
  }
}

TEST(Separation, does_not_connect_across_a_vertex) {
  Soup soup;
  soup.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
  soup.triangles = {{0, 1, 2}, {0, 3, 4}};
  std::vector<uint32_t> label;
  EXPECT_EQ(label_components(build(soup).mesh, label), 2u);
}

// One side of the cut has the majority of the faces, the other that of the area.
TEST(Separation, keeps_the_label_on_the_largest_part_if_it_has_fewer_faces) {
  constexpr int kCells = 120, kColumn = 40;
  Soup soup = grid(kCells, 2);
  const double edge = 2.0 * (kColumn + 1) / kCells - 1;
  for (Vec3& p : soup.positions) {
    if (p.x > edge) p.x = edge + 0.1 * (p.x - edge);
  }
  const Body whole = make_body("strip", build(soup));
  for (const EditPolicy policy : {EditPolicy::kAllowEdits, EditPolicy::kNoEdits}) {
    Body body = whole;
    for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
      const Triangle t = body.mesh.triangle(FaceId(f));
      const double middle = (t[0].x + t[1].x + t[2].x) / 3;
      if (middle < edge && middle > edge - 2.0 / kCells) remove_face(body, FaceId(f));
    }
    ASSERT_EQ(settle(body, kNoLimit, policy).new_pieces.size(), 1u);
    EXPECT_EQ(body.mesh.data(FaceId(0)).piece, 0u);
    EXPECT_EQ(body.pieces[0].faces, 2u * kCells * kColumn);
    EXPECT_EQ(body.pieces[1].faces, 2u * kCells * (kCells - kColumn - 1));
  }
}

// Removes a column of cells from a grid of 12 by 12 cells, the first faces of a body.
void remove_grid_column(Body& body, uint32_t column) {
  std::vector<FaceId> faces;
  for (uint32_t row = 0; row < 12; ++row) {
    const uint32_t first = 2 * (12 * row + column);
    faces.insert(faces.end(), {FaceId(first), FaceId(first + 1)});
  }
  BodyEdit(body).remove(faces);
}

TEST(Separation, starts_one_front_at_each_face_when_it_searches_again) {
  Body body = make_body("grid", build(grid(12, 1)));
  std::vector<uint32_t> loaded;
  label_components(body.mesh, loaded);
  const OpenSearch& search = body.separation.search;
  const auto settle_some = [&] {
    settle(body, 20);
    if (search.stage != OpenSearch::Stage::kGrow) return;
    for (size_t i = 1; i < search.seed.size(); ++i) ASSERT_LT(search.seed[i - 1], search.seed[i]);
  };
  remove_grid_column(body, 8);
  ASSERT_NO_FATAL_FAILURE(settle_some());
  remove_grid_column(body, 2);
  ASSERT_NO_FATAL_FAILURE(settle_some());
  ASSERT_TRUE(search.restart_requested);
  while (!is_settled(body)) ASSERT_NO_FATAL_FAILURE(settle_some());
  expect_labels_of_the_full_search(body, loaded);
  EXPECT_EQ(body.pieces.size(), 3u);
}

TEST(Separation, finishes_an_open_search_and_the_next_one_in_one_call) {
  Body body = make_body("grid", build(grid(12, 1)));
  std::vector<uint32_t> loaded;
  label_components(body.mesh, loaded);
  remove_grid_column(body, 8);
  settle(body, 20);
  ASSERT_FALSE(is_settled(body));
  remove_grid_column(body, 2);
  const SettleResult result = settle(body);
  EXPECT_TRUE(is_settled(body));
  EXPECT_EQ(result.new_pieces.size(), 2u);
  EXPECT_EQ(result.relabelled.size(), 24u * (3 + 2)) << "the columns beyond each cut";
  expect_labels_of_the_full_search(body, loaded);
}

// Two cuts along rows of cells, each but for a bridge whose removal starts a search with three or two fronts.
TEST(Separation, visits_few_faces_of_the_larger_part_also_in_a_later_search) {
  constexpr uint32_t kCells = 120, kMiddle = 60;
  Body body = make_body("grid", build(grid(kCells, 1)));
  const auto cut = [&](uint32_t row, const std::set<uint32_t>& bridge, uint32_t last) {
    const uint32_t begin = 2 * kCells * row, middle = begin + 2 * kMiddle;
    for (uint32_t f = begin; f < begin + 2 * kCells; ++f) {
      if (!bridge.contains(f - middle)) remove_face(body, FaceId(f));
    }
    EXPECT_TRUE(settle(body, kNoLimit, EditPolicy::kNoEdits).new_pieces.empty());
    remove_face(body, FaceId(middle + last));
    return settle(body, kNoLimit, EditPolicy::kNoEdits);
  };
  EXPECT_EQ(cut(8, {0xffffffffu, 0, 1}, 0).relabelled.size(), 2u * kCells * 8 + 2);
  const SettleResult result = cut(50, {0, 1}, 1);
  ASSERT_EQ(result.relabelled.size(), 2u * kCells * 41);
  EXPECT_LT(result.visited, result.relabelled.size() * 17 / 10);
}

TEST(JoinParts, adds_a_loaded_component_to_the_part_cut_off_that_it_joins) {
  Body body = make_body("two", build(both(grid(12, 1), moved(grid(2, 0.1), {0, 1, 0}, 1))));
  remove_grid_column(body, 8);
  ASSERT_EQ(settle(body).new_pieces.size(), 1u);
  move_components({}, body, std::map<uint32_t, uint32_t>{{1, 1}});
  const FaceId cut_off(2 * 9), component(2 * 12 * 12);
  ASSERT_EQ(body.label(cut_off), 1u);
  ASSERT_EQ(body.label(component), 1u);
  const FaceCounts former = body.whole_of(cut_off), added = body.whole_of(component);
  EXPECT_EQ(former.faces, 24u * 3);
  EXPECT_EQ(added.faces, 8u);
  join_parts(body, cut_off, component);
  for (const FaceId f : {cut_off, component}) {
    EXPECT_EQ(body.whole_of(f).faces, former.faces + added.faces);
    EXPECT_DOUBLE_EQ(body.whole_of(f).area, former.area + added.area);
  }
  EXPECT_EQ(body.components.left[1].faces, 0u);
}

}  // namespace
}  // namespace kerf::test
