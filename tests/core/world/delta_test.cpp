#include "core/world/world_delta.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>

#include "core/document/document.h"
#include "core/document/scene.h"
#include "tests/support/made_meshes.h"
#include "tests/support/random_edits.h"
#include "tests/support/strokes.h"
#include "tests/support/temporary_folder.h"

namespace kerf::test {
namespace {

constexpr BodyId kA{0, 0}, kB{1, 1}, kC{2, 5};

Delta with(std::vector<BodyId> Delta::*list, BodyId id) {
  Delta delta;
  delta.*list = {id};
  return delta;
}

Delta chained(Delta a, const Delta& b) {
  a.append(b);
  return a;
}

TEST(Delta, created_then_destroyed_is_empty) {
  EXPECT_TRUE(chained(with(&Delta::created, kB), with(&Delta::destroyed, kB)).empty());
  const Delta moved =
      chained(chained(with(&Delta::created, kB), with(&Delta::moved, kB)), with(&Delta::destroyed, kB));
  EXPECT_TRUE(moved.empty());
}

TEST(Delta, destroyed_then_created_is_another_body) {
  const Delta delta = chained(with(&Delta::destroyed, kA), with(&Delta::created, kA));
  EXPECT_EQ(delta.destroyed, std::vector{kA});
  EXPECT_EQ(delta.created, std::vector{kA});
  EXPECT_EQ(chained(delta, with(&Delta::destroyed, kA)).destroyed, std::vector{kA});
  EXPECT_TRUE(chained(delta, with(&Delta::destroyed, kA)).created.empty());
}

TEST(Delta, moved_bodies_are_listed_once_and_not_if_created_or_destroyed) {
  EXPECT_EQ(chained(with(&Delta::moved, kA), with(&Delta::moved, kA)).moved, std::vector{kA});
  EXPECT_TRUE(chained(with(&Delta::created, kA), with(&Delta::moved, kA)).moved.empty());
  EXPECT_TRUE(chained(with(&Delta::moved, kA), with(&Delta::destroyed, kA)).moved.empty());
}

TEST(Delta, left_open_uses_the_last_id_and_volumes_add_up) {
  Delta open, detached;
  open.left_open = {{kA, "first"}};
  open.solid = {3, 0.5, 0.25};
  detached.detached = {{kA, 2, kB, true}};
  detached.left_open = {{kA, "second"}};
  detached.solid = {1, 0.25, 0.5};
  const Delta delta = chained(open, detached);
  ASSERT_EQ(delta.left_open.size(), 2u);
  EXPECT_EQ(delta.left_open[0].body, kB);
  EXPECT_EQ(delta.left_open[1].body, kA);
  EXPECT_EQ(delta.solid.wall_faces, 4u);
  EXPECT_EQ(delta.solid.wall_area, 0.75);
  EXPECT_EQ(delta.solid.removed_volume, 0.75);
}

TEST(Delta, edits_of_a_continued_body_use_its_last_id) {
  Delta edited, detached;
  edited.bodies.push_back({kA, {FaceId(3)}, {}, {}, {}, {}});
  edited.moved = {kA};
  detached.detached = {{kA, 2, kB, true}};
  detached.created = {kA};
  detached.bodies.push_back({kB, {}, {FaceId(3), FaceId(4)}, {}, {}, {}});
  const Delta delta = chained(edited, detached);
  ASSERT_EQ(delta.bodies.size(), 1u);
  EXPECT_EQ(delta.bodies[0].body, kB);
  EXPECT_TRUE(delta.bodies[0].added.empty());
  EXPECT_EQ(delta.bodies[0].dead, (std::vector{FaceId(3), FaceId(4)}));
  EXPECT_EQ(delta.moved, std::vector{kB});
  // And the body that goes is the one that was there before.
  const Delta removed = chained(delta, with(&Delta::destroyed, kB));
  EXPECT_EQ(removed.destroyed, std::vector{kA});
  EXPECT_EQ(removed.created, std::vector{kA});
  EXPECT_TRUE(removed.bodies.empty() && removed.moved.empty());
}

TEST(Delta, undo_and_redo_cancel_except_for_faces) {
  Delta detached;
  detached.detached = {{kA, 2, kC, true}};
  detached.created = {kA};
  detached.moved = {kC};
  const Delta back = inverse_body_changes(detached);
  EXPECT_EQ(back.destroyed, std::vector{kA});
  EXPECT_EQ(back.moved, std::vector{kA});
  const Delta none = chained(detached, back);
  EXPECT_TRUE(none.created.empty() && none.destroyed.empty() && none.detached.empty());
}

// With a cost of the product of the lists, this takes minutes.
TEST(Delta, long_lists_keep_their_order) {
  constexpr uint32_t kCount = 300'000;
  Delta delta, later;
  std::vector<BodyId> wanted;
  for (uint32_t slot = 0; slot < kCount; ++slot) {
    const BodyId own{slot, 0}, next{slot, 1}, other{kCount + slot, 1};
    delta.moved.push_back(own);
    delta.bodies.push_back({own, {FaceId(1)}, {}, {}, {}, {}});
    if (slot % 3 == 0) {
      later.destroyed.push_back(own);
    } else {
      later.detached.push_back({own, 2, next, true});
      wanted.push_back(next);
    }
    later.bodies.push_back({slot % 3 == 0 ? other : next, {FaceId(2)}, {}, {}, {}, {}});
    later.moved.insert(later.moved.end(), {next, other});
  }
  std::ranges::copy_if(later.moved, std::back_inserter(wanted),
                       [](BodyId id) { return id.slot % 3 == 0 || id.slot >= kCount; });
  delta.append(later);
  EXPECT_EQ(delta.moved, wanted);
  EXPECT_EQ(delta.destroyed, later.destroyed);
  ASSERT_EQ(delta.bodies.size(), size_t{kCount});
  EXPECT_EQ(delta.bodies.front().body, (BodyId{1, 1}));
  EXPECT_EQ(delta.bodies.front().added, (std::vector{FaceId(1), FaceId(2)}));
  EXPECT_EQ(delta.bodies.back().body, (BodyId{2 * kCount - 3, 1}));
}

// All that there is to know of a world, kept up by deltas alone where the world was not replaced.
class Follower {
 public:
  explicit Follower(const World& world) { rebuild(world); }

  void follow(const World& world, const Delta& delta) {
    if (delta.replaced) return rebuild(world);
    for (const BodyId id : delta.destroyed) ASSERT_EQ(known_.erase(id), 1u);
    for (const Detached& d : delta.detached) {
      if (!d.keeps_slots || !known_.contains(d.from)) continue;
      known_[d.to] = std::move(known_[d.from]);
      known_.erase(d.from);
    }
    for (const BodyId id : delta.created) ASSERT_TRUE(known_.emplace(id, whole(world.body(id))).second);
    for (const BodyDelta& d : delta.bodies) follow_faces(world.body(d.body).mesh, d);
    for (const BodyId id : delta.moved) known_.at(id).placement = world.body(id).placement;
    for (const BodyId id : delta.visibility_changed) known_.at(id).hidden = world.body(id).hidden;
    for (const BodyId id : delta.renamed) known_.at(id).name = world.body(id).name;
  }

  void expect_knows(const World& world) const {
    ASSERT_EQ(known_.size(), world.ids().size());
    for (const BodyId id : world.ids()) {
      ASSERT_TRUE(known_.contains(id));
      const Known &known = known_.at(id), now = whole(world.body(id));
      EXPECT_EQ(known.name, now.name);
      EXPECT_EQ(known.hidden, now.hidden);
      EXPECT_EQ(known.placement.position, now.placement.position);
      ASSERT_TRUE(known.faces == now.faces) << "body " << id.slot;
    }
  }

 private:
  struct Face {
    Triangle corners;
    uint32_t label;
    friend bool operator==(const Face&, const Face&) = default;
  };
  struct Known {
    std::string name;
    bool hidden = false;
    Placement placement;
    std::map<uint32_t, Face> faces;
  };

  Known whole(const Body& body) const {
    Known known{body.name, body.hidden, body.placement, {}};
    for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
      if (body.mesh.is_live(FaceId(f))) known.faces[f] = face(body.mesh, FaceId(f));
    }
    return known;
  }
  Face face(const Mesh& mesh, FaceId f) const { return {mesh.triangle(f), mesh.data(f).piece}; }

  void rebuild(const World& world) {
    known_.clear();
    for (const BodyId id : world.ids()) known_.emplace(id, whole(world.body(id)));
  }
  void follow_faces(const Mesh& mesh, const BodyDelta& delta) {
    Known& known = known_.at(delta.body);
    for (const FaceId f : delta.added) known.faces[f.index] = face(mesh, f);
    for (const FaceId f : delta.dead) known.faces.erase(f.index);
    for (const FaceId f : delta.relabelled) known.faces.at(f.index).label = mesh.data(f).piece;
  }

  std::map<BodyId, Known> known_;
};

World plates(const std::filesystem::path& mesh) {
  write_text(mesh, kPlateObj);
  SceneDescription scene;
  scene.bodies = {body_of_file(mesh), body_of_file(mesh)};
  scene.bodies[1].placement.position.y = -0.5;
  return std::move(load_scene(scene)->world);
}

void append_steps(Document& document, Delta& delta) {
  while (document.waiting() > 0) {
    auto step = document.step(1);
    ASSERT_TRUE(step.ok());
    delta.append(std::move(step->delta));
  }
}

// One delta after several edits says what those did together; moves of the beam wait meanwhile, so that some
// edits walk them.
TEST(Delta, applying_every_delta_reproduces_the_world) {
  const TemporaryFolder folder;
  const auto mesh = folder / "plate.obj";
  for (uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    Document document(plates(mesh));
    Follower follower(document.world());
    for (int round = 0; round < 12; ++round) {
      Delta delta;
      for (size_t edits = 1 + random.below(4); edits > 0; --edits) {
        for (const Command& command : random_edit(document.world(), mesh, random)) {
          // The moves before a command may remove the piece that it names, so that it fails.
          delta.append(document.apply(command).delta);
        }
        if (random.below(3) == 0) append_steps(document, delta);
      }
      follower.follow(document.world(), delta);
      follower.expect_knows(document.world());
      if (testing::Test::HasFailure()) return;
    }
  }
}

// A label is no corner: undo of a cut says which faces only go by another label again.
TEST(Delta, undo_of_a_cut_lists_the_faces_of_the_piece_as_relabelled) {
  Document document(world_of(grid(20, 1)));
  CutSettings settings;
  settings.laser.radius = 0.03;
  settings.resolution.target_edge = 0.03;
  document.apply(BeginStroke{settings, {{0.26, 3, -0.7}, {0, -1, 0}}});
  document.apply(MoveBeam{{{0.26, 3, 0.7}, {0, -1, 0}}});
  document.apply(EndStroke{});
  ASSERT_TRUE(run_all(document).ok());
  ASSERT_EQ(document.world().live_pieces(), 2u);
  const Delta back = document.apply(Undo{}).delta, again = document.apply(Redo{}).delta;
  for (const Delta* delta : {&back, &again}) {
    size_t relabelled = 0;
    for (const BodyDelta& b : delta->bodies) {
      relabelled += b.relabelled.size();
      for (const FaceId f : b.relabelled) EXPECT_FALSE(std::binary_search(b.added.begin(), b.added.end(), f));
    }
    EXPECT_GT(relabelled, 0u);
  }
}

}  // namespace
}  // namespace kerf::test
