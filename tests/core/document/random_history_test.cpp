#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>

#include "core/document/document.h"
#include "core/edit/separation.h"
#include "tests/support/mesh_numbers.h"
#include "tests/support/random_edits.h"
#include "tests/support/ring_and_book.h"
#include "tests/support/runs.h"
#include "tests/support/same_world.h"
#include "tests/support/strokes.h"

namespace kerf::test {
namespace {

// Of a solid ring, most are closed by walls.
std::vector<Command> next_stroke(bool solid, Random& random) {
  const bool closes = solid && random.below(8) > 0;
  return random_stroke_commands(random, closes ? Beam::kStraight : Beam::kTurning);
}

// What the tests of mesh and graph ask of a world, after whatever way it came to.
void expect_whole(const World& world) {
  for (const BodyId id : world.ids()) {
    const Body& body = world.body(id);
    EXPECT_EQ(find_fault(body.mesh, true), "");
    std::vector<uint32_t> component;
    label_components(body.mesh, component);
    EXPECT_EQ(body.tree.leaf_count(), body.mesh.live_faces());
    std::map<uint32_t, size_t> faces;
    for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
      if (body.mesh.is_live(FaceId(f))) ++faces[body.mesh.data(FaceId(f)).piece];
    }
    for (const auto& [piece, count] : faces) EXPECT_EQ(body.pieces[piece].faces, count);
  }
}

// The command with steps of whole moves.
Command with_unlimited_steps(Command command) {
  if (auto* begin = std::get_if<BeginStroke>(&command))
    begin->settings.faces_per_step = std::numeric_limits<size_t>::max();
  return command;
}

uint32_t place_of(const World& world, BodyId id) {
  const std::vector<BodyId> ids = world.ids();
  return static_cast<uint32_t>(std::find(ids.begin(), ids.end(), id) - ids.begin());
}

// The command, of which the piece names its body by its place among all.
Command with_id(Command command, const World& world) {
  std::visit(
      [&](auto& c) {
        if constexpr (requires { c.piece; }) c.piece.body = world.ids()[c.piece.body.slot];
      },
      command);
  return command;
}

// A history as it should be: what was done, each with the commands that do it from scratch.
struct Model {
  bool solid = false;  // the ring
  struct Step {
    std::vector<Command> commands;
    bool again = false;  // cuts the step before it again
  };
  std::vector<Step> steps;
  size_t at = 0;

  void add(std::vector<Command> commands, bool again = false) {
    steps.resize(at);
    steps.push_back({std::move(commands), again});
    ++at;
  }
  // Time belongs to the stroke before it, cut again or not, and to other time; to an edit where it joins it.
  void pass(const AdvanceTime& time) {
    const bool joins = time.joins && !time.bodies;
    const auto is_edit = [](const Command& first) {
      return std::visit(
          Overloaded{[](const ImmediateCommand auto&) { return true; }, [](const auto&) { return false; }},
          first);
    };
    const bool own = at == 0 || (!joins && is_edit(steps[at - 1].commands.front()));
    if (own) return add({time});
    steps.resize(at);
    steps.back().commands.emplace_back(time);
  }
  World world() const {
    Document fresh(ring_and_book(solid));
    for (size_t i = 0; i < at; ++i) {
      if (i + 1 < at && steps[i + 1].again) continue;
      for (const Command& c : steps[i].commands)
        EXPECT_TRUE(fresh.apply(with_id(with_unlimited_steps(c), fresh.world())).ok());
      finish(fresh);
    }
    return fresh.world();
  }
};

Command random_piece_command(const PieceId& piece, Random& random) {
  switch (random.below(8)) {
    case 0:
      return MovePiece{piece, {{random.uniform(-0.2, 0.2), 0.1, 0}, {1, 0, 0, 0}}};
    case 1:
      return HidePiece{piece, random.below(2) == 0};
    case 2:
      return DeletePiece{piece};
    case 3:
      return DuplicatePiece{piece, {{0, random.uniform(-0.2, 0.2), 0.1}, {1, 0, 0, 0}}};
    case 4:
      return SimplifyPiece{piece, {.faces = 1 + random.below(300)}};
    case 5:
      return SubdividePiece{piece, random.below(2) == 0 ? Subdivision::kSqrt3 : Subdivision::kMidpoint};
    case 6:
      return SmoothPiece{piece, 1 + random.below(3)};
    default:
      return RenamePiece{piece, "part " + std::to_string(random.below(100))};
  }
}

// Bodies move in some of it.
AdvanceTime random_time(Random& random) {
  if (random.below(2) == 0) return {1 + random.below(300), false, random.below(2) == 0};
  return {1 + random.below(12), true};
}

// The stroke with ticks between its commands.
std::vector<Command> with_time(const std::vector<Command>& stroke, Random& random) {
  std::vector<Command> all;
  for (const Command& c : stroke) {
    all.push_back(c);
    while (random.below(3) == 0) all.emplace_back(random_time(random));
  }
  return all;
}

// A random command, undo or redo on both; strokes may still wait afterwards.
void act(Document& document, Model& model, Random& random) {
  const size_t what = random.below(15);
  if (what < 4) {
    auto stroke = with_time(next_stroke(model.solid, random), random);
    for (const Command& c : stroke) {
      ASSERT_TRUE(document.apply(c).ok());
      if (random.below(2) == 0) {
        ASSERT_TRUE(document.step(random.below(8)).ok());
      }
    }
    const auto here = document.queue().stop_here();
    if (here && random.below(3) == 0) {
      ASSERT_TRUE(document.apply(*here).ok());
      stroke.emplace_back(*here);
    }
    model.add(stroke);
  } else if (what < 7) {
    ASSERT_TRUE(document.apply(Undo{}).ok());
    if (model.at > 0) --model.at;
  } else if (what < 9) {
    ASSERT_TRUE(document.apply(Redo{}).ok());
    if (model.at < model.steps.size()) ++model.at;
  } else if (what == 9 && can_recut(document)) {
    const auto other = next_stroke(model.solid, random);
    const CutSettings settings = std::get<BeginStroke>(other.front()).settings;
    ASSERT_TRUE(document.apply(Recut{settings}).ok());
    // The stroke is executed first where bodies move in it, and a small window may let its images go then.
    if (document.history().position() == model.at) return;
    std::vector<Command> stroke = model.steps[model.at - 1].commands;
    std::get<BeginStroke>(stroke.front()).settings = settings;
    model.add(stroke, true);
  } else if (what == 10) {
    finish(document);
    if (const auto piece = random_piece(document.world(), random)) {
      // Ids depend on the journal, and the model's is another: it names bodies by their places among all.
      const PieceId by_place{{place_of(document.world(), piece->body)}, piece->label};
      Random same = random;
      const Command command = random_piece_command(*piece, random);
      const Outcome outcome = document.apply(command);
      ASSERT_TRUE(outcome.ok());
      if (!outcome.delta.empty()) model.add({random_piece_command(by_place, same)});
    }
  } else if (what == 11) {
    model.at = random.below(model.steps.size() + 1);
    ASSERT_TRUE(document.travel(model.at).ok());
  } else if (what == 12) {
    const AdvanceTime time{1 + random.below(12), true};
    document.apply(Play{});
    document.apply(time);
    model.add({Play{}, time});
  } else if (what >= 13) {
    const AdvanceTime time = random_time(random);
    document.apply(time);
    model.pass(time);
  }
}

// With a solid ring if the seed is odd.
void run_at_random(uint64_t seed, size_t window) {
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  Model model;
  model.solid = seed % 2 == 1;
  const auto origin = [&](const Progress*) { return Result<World>(ring_and_book(model.solid)); };
  Document document(ring_and_book(model.solid), origin);
  document.set_window(window);
  for (int i = 0; i < 25; ++i) {
    SCOPED_TRACE("command " + std::to_string(i));
    act(document, model, random);
    if (testing::Test::HasFatalFailure()) return;
    if (random.below(3) != 0) continue;
    finish(document);
    ASSERT_EQ(document.history().position(), model.at);
    expect_same_bodies(document.world(), model.world());
    expect_whole(document.world());
    if (testing::Test::HasFailure()) return;
  }
}

TEST(RandomHistory, with_undo_and_redo_matches_a_fresh_replay) {
  for (uint64_t seed = 1; seed <= runs(12); ++seed) {
    run_at_random(seed, size_t{1} << 30);
    if (HasFailure()) return;
  }
}

TEST(RandomHistory, states_beyond_the_undo_memory_are_restored_by_replay) {
  for (uint64_t seed = 101; seed <= 100 + runs(6); ++seed) {
    run_at_random(seed, 200'000);
    if (HasFailure()) return;
  }
}

TEST(RandomHistory, a_journal_with_undos_and_recuts_replays_to_the_same_world) {
  for (uint64_t seed = 201; seed <= 200 + runs(4); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    Model model;
    model.solid = seed % 2 == 1;
    Document document(ring_and_book(model.solid));
    for (int i = 0; i < 20; ++i) act(document, model, random);
    finish(document);
    Document again(ring_and_book(model.solid));
    for (const Command& c : document.journal()) ASSERT_TRUE(again.apply(c).ok());
    finish(again);
    expect_same_world(document.world(), again.world());
  }
}

}  // namespace
}  // namespace kerf::test
