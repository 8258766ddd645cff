#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>

#include "core/document/document.h"
#include "tests/support/made_meshes.h"
#include "tests/support/mesh_numbers.h"
#include "tests/support/runs.h"
#include "tests/support/same_world.h"
#include "tests/support/strokes.h"

namespace kerf::test {
namespace {

constexpr size_t kUnbounded = std::numeric_limits<size_t>::max();

// Bodies of several classes beside one another, one of them hidden.
World several_bodies() {
  World world;
  world.add(make_body("torus", build(torus(16, 10, 0.5, 0.2))));
  world.add(make_body("book", build(moved(book(5), {0.3, 0.1, 0}, 0.6))));
  world.add(make_body("hidden", build(moved(sphere(9, 12, 0.4), {0, 0.1, 0}, 1))));
  world.add(make_body("sheet", build(moved(grid(30, 1.2), {0, -0.3, 0}, 1))));
  world.body(world.ids()[2]).hidden = true;
  return world;
}

struct Drawn {
  CutSettings settings;
  std::vector<Pose> poses;
};

// A few strokes of every kind that cross one another.
std::vector<Drawn> random_strokes(uint64_t seed) {
  Random random(seed);
  std::vector<Drawn> strokes(3);
  for (size_t i = 0; i < strokes.size(); ++i) {
    CutSettings& s = strokes[i].settings;
    s.laser.radius = random.uniform(0.03, 0.1);
    s.laser.range = {0, 6};
    s.laser.pattern = random.below(3) == 0 ? Pattern::kRays4 : Pattern::kVolume;
    s.resolution.scheme = (seed + i) % 2 == 0 ? Scheme::kOneToFour : Scheme::kLongestEdge;
    s.resolution.rim = random.below(2) == 0 ? Rim::kSmooth : Rim::kFaces;
    s.resolution.target_edge = s.laser.radius * random.uniform(0.15, 0.6);
    s.search_a_move = 1 + random.below(300);
    for (size_t n = random.below(2) + 2; n > 0; --n) {
      const Vec3 d = glm::normalize(Vec3(random.uniform(-0.4, 0.4), -1, random.uniform(-0.4, 0.4)));
      const Vec3 at(random.uniform(-0.7, 0.7), 0, random.uniform(-0.7, 0.7));
      strokes[i].poses.push_back({at - 2.0 * d, d});
    }
  }
  return strokes;
}

struct Walked {
  World world;
  size_t steps = 0, left_half_way = 0;
  double largest_cosine = -1;  // of a new face
};

// Queues some strokes before others are walked, and walks by random numbers of moves.
Walked cut_in_steps_of(const std::vector<Drawn>& strokes, size_t faces_per_step, uint64_t seed) {
  Random random(seed);
  Document document(several_bodies());
  Walked walked;
  const auto step = [&] {
    const auto result = document.step(1 + random.below(6));
    EXPECT_TRUE(result.ok());
    ++walked.steps;
    walked.largest_cosine = std::max(walked.largest_cosine, result->statistics.largest_cosine);
    walked.left_half_way +=
        document.queue().pending().next_move(document.world()).has_value() && result->moves == 0;
  };
  for (Drawn stroke : strokes) {
    stroke.settings.faces_per_step = faces_per_step;
    document.apply(BeginStroke{stroke.settings, stroke.poses.front()});
    for (size_t i = 1; i < stroke.poses.size(); ++i) {
      document.apply(MoveBeam{stroke.poses[i]});
      for (size_t n = random.below(20); n > 0; --n) step();
    }
    document.apply(EndStroke{});
  }
  while (document.waiting() > 0) step();
  walked.world = document.world();
  return walked;
}

TEST(StepSize, does_not_change_the_resulting_world) {
  for (uint64_t seed = 1; seed <= runs(10); ++seed) {
    const auto strokes = random_strokes(seed);
    const Walked whole = cut_in_steps_of(strokes, kUnbounded, seed);
    EXPECT_GT(whole.world.live_pieces(), 4u);
    for (const size_t faces_per_step : {1u, 7u, 100u, 1000u}) {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", faces_per_step " + std::to_string(faces_per_step));
      const Walked stepped = cut_in_steps_of(strokes, faces_per_step, seed + faces_per_step);
      expect_same_world(whole.world, stepped.world);
      EXPECT_GT(stepped.left_half_way, 0u);
      // Faces that a later part of the step splits or moves again are not measured with a large
      // faces_per_step.
      EXPECT_GE(stepped.largest_cosine, whole.largest_cosine);
      if (HasFailure()) return;
    }
  }
}

// What follows a world by deltas alone: its live faces with their corners and labels.
class Follower {
 public:
  explicit Follower(const World& world) {
    for (const BodyId id : world.ids()) bodies_[id] = all_of(world.body(id).mesh);
  }

  void follow(const World& world, const Delta& delta) {
    for (const BodyDelta& d : delta.bodies) {
      const Mesh& mesh = world.body(d.body).mesh;
      Faces& faces = bodies_[d.body];
      for (const FaceId f : d.dead) faces.erase(f.index);
      for (const auto* changed : {&d.added, &d.relabelled}) {
        for (const FaceId f : *changed) faces[f.index] = look(mesh, f);
      }
    }
  }

  void expect_up_to_date(const World& world) const {
    for (const BodyId id : world.ids()) EXPECT_TRUE(bodies_.at(id) == all_of(world.body(id).mesh));
  }

 private:
  using Face = std::pair<std::array<VertexId, 3>, uint32_t>;
  using Faces = std::map<uint32_t, Face>;

  static Face look(const Mesh& mesh, FaceId f) { return {mesh.corners(f), mesh.data(f).piece}; }
  static Faces all_of(const Mesh& mesh) {
    Faces faces;
    for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
      if (mesh.is_live(FaceId(f))) faces[f] = look(mesh, FaceId(f));
    }
    return faces;
  }

  std::map<BodyId, Faces> bodies_;
};

// Every face is found in the middle of its own place.
void expect_tree_follows(const Body& body) {
  ASSERT_EQ(body.tree.leaf_count(), body.mesh.live_faces());
  AabbTree tree = body.tree;
  std::vector<FaceId> found;
  for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
    if (!body.mesh.is_live(FaceId(f))) continue;
    const Triangle t = body.mesh.triangle(FaceId(f));
    const Pose down{(t[0] + t[1] + t[2]) / 3.0 + Vec3(0, 1, 0), {0, -1, 0}};
    found.clear();
    tree.touched(body.mesh, SweptCylinder(down, down, 1e-6, {0, 2}), found);
    ASSERT_NE(std::find(found.begin(), found.end(), FaceId(f)), found.end()) << "face " << f;
  }
}

TEST(StepSize, leaves_a_valid_world_and_complete_delta_after_every_step) {
  for (uint64_t seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Drawn stroke = random_strokes(seed).front();
    stroke.settings.faces_per_step = 1;
    Document document(several_bodies());
    Follower follower(document.world());
    document.apply(BeginStroke{stroke.settings, stroke.poses[0]});
    document.apply(MoveBeam{stroke.poses[1]});
    document.apply(EndStroke{});
    for (size_t steps = 0; document.waiting() > 0; ++steps) {
      const auto result = document.step(1);
      ASSERT_TRUE(result.ok());
      follower.follow(document.world(), result->delta);
      if (result->delta.bodies.empty() || steps % 5 != 0) continue;
      follower.expect_up_to_date(document.world());
      for (const BodyDelta& d : result->delta.bodies) {
        ASSERT_EQ(find_fault(document.world().body(d.body).mesh, true), "");
        expect_tree_follows(document.world().body(d.body));
      }
      if (HasFailure()) return;
    }
    follower.expect_up_to_date(document.world());
  }
}

TEST(StepSize, a_step_stays_within_its_budget_for_a_large_move) {
  CutSettings settings;
  settings.laser.radius = 0.4;
  settings.resolution.target_edge = 0.002;
  settings.faces_per_step = 300;
  World world = world_of(plate(1));
  const BeamMove still{{{0, 1, 0}, {0, -1, 0}}, {{0, 1, 0}, {0, -1, 0}}};
  UnfinishedMove unfinished;
  size_t steps = 0, made = 0, removed = 0;
  for (size_t moves = 0; moves == 0; ++steps) {
    const auto result = cut_step(world, settings, {&still, 1}, unfinished);
    ASSERT_TRUE(result.ok());
    EXPECT_LE(result->statistics.faces_made,
              3 * settings.faces_per_step);  // each looked at is split in four at most
    EXPECT_LE(result->delta.removed_faces, settings.faces_per_step);
    moves = result->moves;
    made += result->statistics.faces_made;
    removed += result->delta.removed_faces;
  }
  EXPECT_GT(made, 20 * settings.faces_per_step);
  EXPECT_GT(removed, 20 * settings.faces_per_step);
  EXPECT_GT(steps, 80u);
}

TEST(StepSize, an_unfinished_move_stays_in_the_queue) {
  CutSettings settings;
  settings.laser.radius = 0.1;
  settings.resolution.target_edge = 0.005;
  settings.faces_per_step = 1;
  Document document(world_of(plate(1)));
  document.apply(BeginStroke{settings, {{0, 1, 0}, {0, -1, 0}}});
  document.apply(EndStroke{});
  for (int i = 0; i < 5; ++i) {
    const auto result = document.step(1);
    ASSERT_TRUE(result.ok());
    EXPECT_EQ(result->moves, 0u);
    EXPECT_EQ(document.waiting(), 1u);
    EXPECT_TRUE(document.queue().pending().next_move(document.world()).has_value());
  }
  ASSERT_TRUE(run_all(document).ok());
  EXPECT_EQ(document.waiting(), 0u);
  EXPECT_FALSE(document.queue().pending().next_move(document.world()).has_value());
}

}  // namespace
}  // namespace kerf::test
