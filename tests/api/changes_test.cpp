#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "core/kerf.h"
#include "tests/api/sheets.h"

namespace kerf::test {
namespace {

struct Face {
  std::array<double, 9> corners;
  uint32_t piece;
  friend bool operator==(const Face&, const Face&) = default;
};
using MirroredBody = std::map<uint32_t, Face>;
using Mirror = std::map<BodyId, MirroredBody>;

void fetch(const World& world, BodyId body, std::span<const uint32_t> faces, MirroredBody& to) {
  const std::vector<double> corners = world.corners(body, faces);
  const std::vector<uint32_t> pieces = world.piece_labels(body, faces);
  for (size_t i = 0; i < faces.size(); ++i) {
    Face& face = to[faces[i]];
    std::copy_n(&corners[9 * i], 9, face.corners.begin());
    face.piece = pieces[i];
  }
}

Mirror fetch_all(const World& world) {
  Mirror mirror;
  for (const BodyId body : world.bodies()) fetch(world, body, world.faces(body), mirror[body]);
  return mirror;
}

// Applies the changes since the last call, as kerf_changes tells it. Returns the number of changed faces.
size_t update(World& world, Mirror& mirror) {
  const Changes changes = world.take_changes();
  if (changes.everything) {
    mirror = fetch_all(world);
    return 0;
  }
  size_t count = 0;
  const std::span bodies(changes.bodies, changes.body_count);
  for (const kerf_body_changes& b : bodies) {
    if (b.flags & KERF_BODY_DESTROYED) mirror.erase(b.body);
  }
  for (const kerf_detached& d : std::span(changes.detached, changes.detached_count)) {
    if (!d.keeps_faces || !mirror.contains(d.from)) continue;
    mirror[d.to] = std::move(mirror.at(d.from));
    mirror.erase(d.from);
  }
  for (const kerf_body_changes& b : bodies) {
    if (b.flags & KERF_BODY_DESTROYED) continue;
    MirroredBody& own = mirror[b.body];
    if (b.flags & KERF_BODY_CREATED) own.clear();
    for (const uint32_t f : std::span(b.removed, b.removed_count)) own.erase(f);
    fetch(world, b.body, {b.added, b.added_count}, own);
    for (size_t i = 0; i < b.added_count; ++i) EXPECT_EQ(own.at(b.added[i]).piece, b.added_pieces[i]);
    for (size_t i = 0; i < b.moved_count; ++i) own.at(b.moved[i]).piece = b.moved_pieces[i];
    count += b.added_count + b.removed_count + b.moved_count;
  }
  return count;
}

Stroke random_stroke(std::mt19937& random) {
  const auto between = [&](double a, double b) { return std::uniform_real_distribution(a, b)(random); };
  Stroke stroke;
  stroke.keys = {{0, {between(-0.2, 1.2), 2, -0.2}, {0, -1, 0}},
                 {1, {between(-0.2, 1.2), 2, 1.2}, {0, -1, 0}}};
  stroke.radius = between(0.01, 0.03);
  stroke.range = {0, 4};
  return stroke;
}

// Changes a world at random.
void change(World& world, std::mt19937& random) {
  const std::vector<BodyId> bodies = world.bodies();
  const BodyId body = bodies[random() % bodies.size()];
  const uint32_t piece = world.piece_labels(body, std::array{world.faces(body).back()})[0];
  switch (random() % 8) {
    case 0:
    case 1:
      world.cut(random_stroke(random), {.rim = random() % 2 ? KERF_RIM_SMOOTH : KERF_RIM_FACES});
      break;
    case 2:
      world.begin_stroke(random_stroke(random));
      for (auto i = random() % 20; i > 0; --i) world.step_stroke(100, 1);
      if (random() % 2) return world.cancel_stroke();
      world.end_stroke();
      world.step_stroke(std::numeric_limits<size_t>::max(), std::numeric_limits<double>::infinity());
      break;
    case 3:
      world.move(body, piece, {0, 0.1, 0});
      break;
    case 4:
      world.simulate(0.02);
      break;
    case 5:
      world.undo();
      break;
    case 6:
      world.redo();
      break;
    default:
      BodyDesc desc;
      desc.position[1] = 3.0 * double(1 + random() % 100);
      world.add(sheet(3), desc);
  }
}

TEST(Changes, a_mirror_that_applies_them_equals_the_world) {
  for (unsigned seed = 1; seed <= 4; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    World world;
    world.add(sheet(20));
    Mirror mirror;
    update(world, mirror);
    for (int i = 0; i < 30; ++i) {
      for (auto k = random() % 3; k > 0; --k) change(world, random);
      if (random() % 3 == 0) continue;
      update(world, mirror);
      ASSERT_EQ(mirror, fetch_all(world)) << "after " << i << " changes";
    }
  }
}

TEST(Changes, between_steps_of_a_stroke_are_only_those_of_the_steps) {
  World world;
  world.add(sheet(50));
  Mirror mirror;
  update(world, mirror);
  EXPECT_EQ(update(world, mirror), 0u);
  world.begin_stroke(through_the_middle());
  world.end_stroke();
  size_t total = 0;
  for (bool finished = false; !finished;) {
    finished = world.step_stroke(300, 1).is_finished;
    total += update(world, mirror);
    ASSERT_EQ(mirror, fetch_all(world));
  }
  EXPECT_GT(total, 1000u);
}

TEST(Changes, pieces_are_created_and_destroyed) {
  World world;
  const BodyId body = world.add(sheet(20));
  EXPECT_TRUE(world.take_changes().everything);
  world.cut(through_the_middle());
  Changes changes = world.take_changes();
  ASSERT_EQ(changes.body_count, 1u);
  EXPECT_EQ(changes.bodies->body, body);
  ASSERT_EQ(changes.bodies->new_piece_count, 1u);
  const uint32_t piece = changes.bodies->new_pieces->piece;
  EXPECT_EQ(changes.bodies->new_pieces->from, 0u);
  world.undo();
  changes = world.take_changes();
  ASSERT_EQ(changes.bodies->destroyed_piece_count, 1u);
  EXPECT_EQ(*changes.bodies->destroyed_pieces, piece);
  world.redo();
  const BodyId now = world.move(body, piece, {0, 1, 0});
  changes = world.take_changes();
  EXPECT_NE(now, body);
  ASSERT_EQ(changes.detached_count, 1u);
  EXPECT_EQ(changes.detached->from, body);
  EXPECT_EQ(changes.detached->to, now);
  EXPECT_EQ(changes.detached->piece, piece);
}

// Returns the origins of all pieces that are new since the last call.
std::vector<uint32_t> origins_of_new_pieces(World& world) {
  const Changes changes = world.take_changes();
  std::vector<uint32_t> origins;
  for (const kerf_body_changes& b : std::span(changes.bodies, changes.body_count)) {
    for (const kerf_new_piece& piece : std::span(b.new_pieces, b.new_piece_count))
      origins.push_back(piece.from);
  }
  return origins;
}

TEST(Changes, a_piece_that_a_stroke_in_steps_cuts_off_has_its_origin) {
  World world;
  world.add(sheet(4));
  (void)world.take_changes();
  world.begin_stroke(through_the_middle(), {.target_edge = 0.05});
  world.end_stroke();
  std::vector<uint32_t> origins;
  size_t steps = 0;
  for (bool finished = false; !finished; ++steps) {
    finished = world.step_stroke(0, 0).is_finished;
    const std::vector<uint32_t> more = origins_of_new_pieces(world);
    if (steps == 0) {
      EXPECT_TRUE(more.empty());
    }
    origins.insert(origins.end(), more.begin(), more.end());
  }
  EXPECT_GT(steps, 2u);
  ASSERT_FALSE(origins.empty());
  EXPECT_EQ(origins.front(), 0u);
}

TEST(Changes, a_piece_that_is_cut_off_after_an_undo_has_its_origin) {
  World world;
  const BodyId body = world.add(sheet(20));
  world.rename(body, 0, "plate");
  (void)world.take_changes();
  EXPECT_TRUE(world.undo());
  world.cut(through_the_middle());
  EXPECT_EQ(origins_of_new_pieces(world), std::vector<uint32_t>{0});
}

TEST(Changes, a_piece_that_is_cut_off_and_detached_has_its_origin) {
  World world;
  const BodyId body = world.add(sheet(20));
  (void)world.take_changes();
  Stroke stroke = through_the_middle();
  for (Keyframe& key : stroke.keys) key.origin[0] = 0.3;
  world.cut(stroke);
  const std::vector<uint32_t> labels = world.piece_labels(body, world.faces(body));
  const uint32_t piece = *std::max_element(labels.begin(), labels.end());
  ASSERT_GT(piece, 0u);
  EXPECT_NE(world.move(body, piece, {0, 1, 0}), body);
  const std::vector<uint32_t> origins = origins_of_new_pieces(world);
  EXPECT_EQ(std::count(origins.begin(), origins.end(), 0u), 1);
}

TEST(Changes, a_removed_piece_is_not_listed_as_detached) {
  World world;
  const BodyId body = world.add(sheet(20));
  Stroke stroke = through_the_middle();
  for (Keyframe& key : stroke.keys) key.origin[0] = 0.3;
  world.cut(stroke);
  const std::vector<uint32_t> labels = world.piece_labels(body, world.faces(body));
  const std::set<uint32_t> pieces(labels.begin(), labels.end());
  ASSERT_EQ(pieces.size(), 2u);
  Mirror mirror;
  update(world, mirror);
  for (const uint32_t piece : pieces) {
    SCOPED_TRACE("piece " + std::to_string(piece));
    world.remove(body, piece);
    const Changes changes = world.take_changes();
    EXPECT_FALSE(changes.everything);
    EXPECT_EQ(changes.detached_count, 0u);
    EXPECT_TRUE(world.undo());
    (void)world.take_changes();
    world.remove(body, piece);
    EXPECT_TRUE(world.undo());
    update(world, mirror);
    EXPECT_EQ(mirror, fetch_all(world));
  }
}

TEST(Changes, a_body_that_takes_the_name_of_its_only_piece_is_listed) {
  World world;
  const BodyId body = world.add(sheet(20), "plate");
  Stroke stroke = through_the_middle();
  for (Keyframe& key : stroke.keys) key.origin[0] = 0.3;
  world.cut(stroke);
  std::map<uint32_t, size_t> sizes;
  for (const uint32_t label : world.piece_labels(body, world.faces(body))) ++sizes[label];
  ASSERT_EQ(sizes.size(), 2u);
  const bool is_first_larger = sizes.begin()->second > sizes.rbegin()->second;
  const uint32_t larger = is_first_larger ? sizes.begin()->first : sizes.rbegin()->first,
                 smaller = is_first_larger ? sizes.rbegin()->first : sizes.begin()->first;
  world.rename(body, larger, "lid");
  (void)world.take_changes();
  const auto expect_renamed = [&](const char* name) {
    EXPECT_EQ(world.name(body), name);
    const Changes changes = world.take_changes();
    ASSERT_EQ(changes.body_count, 1u);
    EXPECT_EQ(changes.bodies->body, body);
    EXPECT_TRUE(changes.bodies->flags & KERF_BODY_PROPERTIES);
  };
  world.remove(body, smaller);
  expect_renamed("lid");
  EXPECT_TRUE(world.undo());
  expect_renamed("plate");
}

TEST(Changes, a_detached_piece_is_listed_if_a_part_of_it_was_removed) {
  for (const bool removes_larger : {false, true}) {
    SCOPED_TRACE(removes_larger);
    World world;
    const BodyId body = world.add(sheet(20));
    world.cut(through_the_middle());
    const std::vector<uint32_t> labels = world.piece_labels(body, world.faces(body));
    const uint32_t piece = *std::max_element(labels.begin(), labels.end());
    (void)world.take_changes();
    const BodyId now = world.move(body, piece, {0, 0.5, 0});
    const bool is_left = world.corners(now, world.faces(now))[0] < 0.5;
    Stroke stroke = through_the_middle();
    for (Keyframe& key : stroke.keys) key.origin[0] = is_left ? 0.15 : 0.85;
    world.cut(stroke);
    std::map<uint32_t, size_t> sizes;
    for (const uint32_t label : world.piece_labels(now, world.faces(now))) ++sizes[label];
    ASSERT_EQ(sizes.size(), 2u);
    const bool is_first_larger = sizes.begin()->second > sizes.rbegin()->second;
    world.remove(now, is_first_larger == removes_larger ? sizes.begin()->first : sizes.rbegin()->first);
    const Changes changes = world.take_changes();
    ASSERT_EQ(changes.detached_count, 1u);
    EXPECT_EQ(changes.detached->from, body);
    EXPECT_EQ(changes.detached->to, now);
    EXPECT_EQ(changes.detached->piece, piece);
  }
}

TEST(Changes, a_detached_piece_keeps_the_order_of_its_faces) {
  World world;
  const BodyId body = world.add(sheet(20));
  world.cut(through_the_middle());
  const std::vector<uint32_t> faces = world.faces(body), labels = world.piece_labels(body, faces);
  const uint32_t piece = *std::max_element(labels.begin(), labels.end());
  std::vector<uint32_t> of_piece;
  for (size_t i = 0; i < faces.size(); ++i) {
    if (labels[i] == piece) of_piece.push_back(faces[i]);
  }
  const std::vector<double> before = world.corners(body, of_piece);
  world.take_changes();
  const BodyId now = world.move(body, piece, {0, 1, 0});
  const Changes changes = world.take_changes();
  ASSERT_EQ(changes.detached_count, 1u);
  EXPECT_EQ(world.corners(now, changes.detached->keeps_faces ? of_piece : world.faces(now)), before);
}

}  // namespace
}  // namespace kerf::test
