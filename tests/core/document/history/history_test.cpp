#include <gtest/gtest.h>

#include "core/document/history/document.h"
#include "core/edit/separation.h"
#include "core/world/state_hash.h"
#include "tests/support/made_meshes.h"
#include "tests/support/mesh_numbers.h"
#include "tests/support/random_edits.h"
#include "tests/support/runs.h"
#include "tests/support/same_world.h"
#include "tests/support/strokes.h"

namespace kerf::test {
namespace {

World made_world() {
  World world;
  world.add(make_body("torus", build(torus(16, 10, 0.5, 0.2))));
  world.add(make_body("book", build(moved(book(5), {0.3, 0.1, 0}, 0.6))));
  world.set_surroundings({.gravity = {0, -9.81, 0}, .ground = -0.5});
  return world;
}

// A stroke across the middle with settings of its own.
std::vector<Command> random_stroke_commands(Random& random) {
  CutSettings s;
  s.laser.radius = random.uniform(0.01, 0.05);
  s.laser.range = {0, 5};
  s.resolution.scheme = random.below(2) == 0 ? Scheme::kOneToFour : Scheme::kLongestEdge;
  s.resolution.rim = random.below(3) == 0 ? Rim::kSmooth : Rim::kFaces;
  s.resolution.target_edge = s.laser.radius * random.uniform(0.5, 2);
  if (random.below(2) == 0) s.bite = 1 + random.below(200);
  const auto pose = [&] {
    const Vec3 d = glm::normalize(Vec3(random.uniform(-0.2, 0.2), -1, random.uniform(-0.2, 0.2)));
    return Pose{Vec3(random.uniform(-0.9, 0.9), 0, random.uniform(-0.9, 0.9)) - 2.0 * d, d};
  };
  std::vector<Command> commands{BeginStroke{s, pose()}};
  for (size_t n = random.below(3) + 1; n > 0; --n) commands.emplace_back(MoveStroke{pose()});
  commands.emplace_back(EndStroke{});
  return commands;
}

CutSettings random_settings(Random& random) {
  return std::get<BeginStroke>(random_stroke_commands(random).front()).settings;
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

void finish(Document& document) { ASSERT_TRUE(run_all(document).ok()); }

// The command with steps of whole moves.
Command with_one_bite(Command command) {
  if (auto* begin = std::get_if<BeginStroke>(&command))
    begin->settings.bite = std::numeric_limits<size_t>::max();
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
  void pass(const Advance& time) {
    const bool joins = time.joins && !time.bodies;
    const auto is_edit = [](const Command& first) {
      return std::visit(
          Overloaded{[](const HappensAtOnce auto&) { return true; }, [](const auto&) { return false; }},
          first);
    };
    const bool own = at == 0 || (!joins && is_edit(steps[at - 1].commands.front()));
    if (own) return add({time});
    steps.resize(at);
    steps.back().commands.emplace_back(time);
  }
  World world() const {
    Document fresh(made_world());
    for (size_t i = 0; i < at; ++i) {
      if (i + 1 < at && steps[i + 1].again) continue;
      for (const Command& c : steps[i].commands)
        EXPECT_TRUE(fresh.apply(with_id(with_one_bite(c), fresh.world())).ok());
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
Advance random_time(Random& random) {
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
    auto stroke = with_time(random_stroke_commands(random), random);
    for (const Command& c : stroke) {
      ASSERT_TRUE(document.apply(c).ok());
      if (random.below(2) == 0) {
        ASSERT_TRUE(document.step(random.below(8)).ok());
      }
    }
    const auto here = document.execution().stop_here();
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
  } else if (what == 9 && document.can_recut()) {
    const CutSettings settings = random_settings(random);
    ASSERT_TRUE(document.apply(Recut{settings}).ok());
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
    const Advance time{1 + random.below(12), true};
    document.apply(Play{});
    document.apply(time);
    model.add({Play{}, time});
  } else if (what >= 13) {
    const Advance time = random_time(random);
    document.apply(time);
    model.pass(time);
  }
}

void run_at_random(uint64_t seed, size_t window) {
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  Document document(made_world(), [](const Progress*) { return Result<World>(made_world()); });
  document.set_window(window);
  Model model;
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

TEST(History, random_commands_undos_and_redos_end_where_a_fresh_replay_ends) {
  for (uint64_t seed = 1; seed <= runs(12); ++seed) {
    run_at_random(seed, size_t{1} << 30);
    if (HasFailure()) return;
  }
}

TEST(History, a_smaller_window_discards_the_oldest_images_and_no_more_than_it_must) {
  Document document(made_world());
  Random random(3);
  for (int i = 0; i < 6; ++i) {
    for (const Command& command : random_stroke_commands(random)) document.apply(command);
    finish(document);
  }
  const History& history = document.history();
  const size_t steps = history.position();
  ASSERT_TRUE(history.holds_images(0, steps));
  const size_t all = history.bytes(), window = all * 6 / 10;
  document.set_window(window);
  EXPECT_LE(history.bytes(), window);
  EXPECT_FALSE(history.holds_images(0, 1));
  size_t oldest = 0;
  while (oldest < steps && !history.holds_images(oldest, steps)) ++oldest;
  EXPECT_LT(oldest, steps) << "none is left";
  document.set_window(history.bytes());
  EXPECT_TRUE(history.holds_images(oldest, steps)) << "what is held fits";
}

TEST(History, keeps_within_its_window_right_after_a_command_that_happens_at_once) {
  Document document(world_of(grid(20, 1)));
  constexpr size_t kWindow = 1000;
  document.set_window(kWindow);
  const PieceId piece{document.world().ids().front(), 0};
  ASSERT_TRUE(document.apply(SubdividePiece{piece, Subdivision::kMidpoint}).ok());
  EXPECT_LE(document.history().bytes(), kWindow);
  EXPECT_FALSE(document.history().holds_images(0, 1));
}

TEST(History, states_beyond_the_window_come_back_by_replay) {
  for (uint64_t seed = 101; seed <= 100 + runs(6); ++seed) {
    run_at_random(seed, 200'000);
    if (HasFailure()) return;
  }
}

TEST(History, a_journal_with_undos_and_recuts_replays_to_the_same_world) {
  for (uint64_t seed = 201; seed <= 200 + runs(4); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    Document document(made_world());
    Model model;
    for (int i = 0; i < 20; ++i) act(document, model, random);
    finish(document);
    Document again(made_world());
    for (const Command& c : document.journal()) ASSERT_TRUE(again.apply(c).ok());
    finish(again);
    expect_same_world(document.world(), again.world());
  }
}

TEST(History, a_stroke_that_is_stopped_is_taken_back) {
  for (const size_t bite : {size_t{1}, size_t{30}, CutSettings{}.bite}) {
    SCOPED_TRACE("bite " + std::to_string(bite));
    Random random(3);
    Document document(made_world());
    auto first = random_stroke_commands(random);
    auto second = random_stroke_commands(random);
    std::get<BeginStroke>(second.front()).settings.bite = bite;
    for (const Command& c : first) ASSERT_TRUE(document.apply(c).ok());
    finish(document);
    const World before = document.world();
    for (const Command& c : second) ASSERT_TRUE(document.apply(c).ok());
    ASSERT_TRUE(document.step(1).ok());
    int asked = 0;
    const Progress stop{[&](double) { return ++asked < 20; }};
    while (document.waiting() > 0) {
      if (!document.step(1, &stop)) break;
    }
    EXPECT_GE(asked, 20);
    expect_same_world(document.world(), before);
    EXPECT_EQ(document.history().position(), 1u);
    EXPECT_EQ(document.history().strokes(), 1u);
    // Nothing of it is left half-way for the next one.
    Document fresh(made_world());
    for (const auto* stroke : {&first, &second}) {
      for (const Command& c : *stroke) ASSERT_TRUE(fresh.apply(c).ok());
      finish(fresh);
    }
    for (const Command& c : second) ASSERT_TRUE(document.apply(c).ok());
    finish(document);
    expect_same_world(document.world(), fresh.world());
  }
}

// A twin is begun from there at any time.
TEST(History, asking_what_was_before_a_stroke_leaves_the_stroke_alone) {
  for (uint64_t seed = 301; seed <= 303; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    Document asked(made_world()), left_alone(made_world());
    for (int stroke = 0; stroke < 2; ++stroke) {
      const World before = asked.world();
      auto commands = random_stroke_commands(random);
      CutSettings& settings = std::get<BeginStroke>(commands.front()).settings;
      settings.bite = 1 + random.below(100);
      settings.search_a_move = 1 + random.below(100);
      for (const Command& c : commands) {
        ASSERT_TRUE(asked.apply(c).ok());
        ASSERT_TRUE(left_alone.apply(c).ok());
      }
      while (asked.waiting() > 0) {
        ASSERT_TRUE(asked.step(1).ok());
        if (random.below(4) != 0) continue;
        const auto then = asked.before_last_stroke();
        ASSERT_TRUE(then.has_value());
        EXPECT_EQ(state_hash(*then), state_hash(before));
      }
      finish(left_alone);
      expect_same_world(asked.world(), left_alone.world());
    }
    ASSERT_TRUE(asked.apply(Undo{}).ok());
    ASSERT_TRUE(left_alone.apply(Undo{}).ok());
    expect_same_world(asked.world(), left_alone.world());
    if (HasFailure()) return;
  }
}

TEST(History, does_not_tell_what_was_before_a_stroke_after_which_something_else_happened) {
  Random random(5);
  Document document(made_world());
  EXPECT_FALSE(document.before_last_stroke().has_value());
  for (const Command& c : random_stroke_commands(random)) ASSERT_TRUE(document.apply(c).ok());
  finish(document);
  EXPECT_TRUE(document.before_last_stroke().has_value());
  ASSERT_TRUE(document.apply(RenamePiece{{document.world().ids().front(), 0}, "ring"}).ok());
  EXPECT_FALSE(document.before_last_stroke().has_value());
  ASSERT_TRUE(document.apply(Undo{}).ok());
  EXPECT_TRUE(document.before_last_stroke().has_value());
}

// Pieces that came off while bodies moved take ids, which commands name: also where the stroke is cut again
// before it is walked, and where the history is replayed from its origin.
TEST(History, ids_of_bodies_do_not_depend_on_how_far_a_stroke_was_walked_when_it_was_cut_again) {
  CutSettings settings;
  settings.laser.radius = 0.02;
  settings.resolution.target_edge = 0.05;
  CutSettings wider = settings;
  wider.laser.radius = 0.03;
  const auto origin = [](const Progress*) { return Result<World>(made_world()); };
  const auto draw = [&](Document& document, bool walks) {
    const auto apply = [&](const Command& command) {
      ASSERT_TRUE(document.apply(command).ok());
      if (walks) finish(document);
    };
    apply(BeginStroke{settings, {{0.05, 2, -0.9}, {0, -1, 0}}});
    apply(MoveStroke{{{0.05, 2, 0.9}, {0, -1, 0}}});
    apply(EndStroke{});
    apply(Advance{3, true});
    apply(Recut{wider});
    finish(document);
  };
  Document walked(made_world(), origin), waiting(made_world(), origin);
  draw(walked, true);
  draw(waiting, false);
  ASSERT_GT(walked.world().ids().size(), made_world().ids().size());
  expect_same_world(walked.world(), waiting.world());
  const std::vector<BodyId> ids = walked.world().ids();
  walked.set_window(0);  // lets all images go
  ASSERT_TRUE(walked.travel(1).ok());
  ASSERT_TRUE(walked.travel(2).ok());
  EXPECT_EQ(walked.world().ids(), ids);
}

// At every step of the first, in the middle of its moves too; it cuts the plate in two.
TEST(History, a_stroke_cut_again_before_it_is_walked_leaves_the_one_before_it_alone) {
  CutSettings settings;
  settings.laser.radius = 0.1;
  settings.resolution.target_edge = 0.1;
  settings.bite = 1;
  CutSettings finer = settings;
  finer.resolution.target_edge = 0.05;
  const auto draw = [](Document& document, const CutSettings& s, double x) {
    document.apply(BeginStroke{s, {{x, 1, -0.7}, {0, -1, 0}}});
    document.apply(MoveStroke{{{x, 1, 0.7}, {0, -1, 0}}});
    document.apply(EndStroke{});
  };
  Document fresh(world_of(plate(1)));
  draw(fresh, settings, -0.2);
  draw(fresh, finer, 0.2);
  finish(fresh);
  ASSERT_EQ(fresh.world().live_pieces(), 3u);
  for (size_t steps = 0;; ++steps) {
    SCOPED_TRACE("after " + std::to_string(steps) + " steps");
    Document document(world_of(plate(1)));
    draw(document, settings, -0.2);
    draw(document, settings, 0.2);
    for (size_t i = 0; i < steps; ++i) ASSERT_TRUE(document.step(1).ok());
    if (!document.history().step(1).waiting()) break;
    ASSERT_TRUE(document.apply(Recut{finer}).ok());
    finish(document);
    expect_same_world(document.world(), fresh.world());
    if (HasFailure()) return;
  }
}

TEST(History, nothing_to_undo_or_redo_is_no_error_and_is_not_written) {
  Document document(made_world());
  EXPECT_TRUE(document.apply(Undo{}).ok());
  EXPECT_TRUE(document.apply(Redo{}).ok());
  EXPECT_TRUE(document.apply(Recut{}).ok());
  EXPECT_TRUE(document.journal().empty());
}

TEST(History, a_piece_that_is_not_there_is_named_and_changes_nothing) {
  Document document(made_world());
  const auto moved = document.apply(MovePiece{{{7, 0}, 1}, {}});
  ASSERT_FALSE(moved.ok());
  EXPECT_EQ(moved.error().message, "there is no piece 1 of body 7");
  EXPECT_EQ(document.history().size(), 0u);
  EXPECT_TRUE(document.journal().empty());
}

}  // namespace
}  // namespace kerf::test
