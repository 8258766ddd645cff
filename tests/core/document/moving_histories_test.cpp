#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <sstream>

#include "core/document/document.h"
#include "core/document/journal.h"
#include "core/document/replay.h"
#include "core/document/stroke_path.h"
#include "core/world/world.h"
#include "tests/support/checkout.h"
#include "tests/support/made_meshes.h"
#include "tests/support/random_edits.h"
#include "tests/support/real_meshes.h"
#include "tests/support/runs.h"
#include "tests/support/same_world.h"
#include "tests/support/strokes.h"
#include "tests/support/temporary_folder.h"

// Histories as a user makes them: strokes of many poses, through meshes of which the search for separated
// pieces takes longer than a move, while the queue is executed at its own pace and runs empty now and then.

namespace kerf::test {
namespace {

// The seeds of the histories; KERF_HISTORIES sets others, as "FIRST LAST". Most take a second or two.
std::pair<uint64_t, uint64_t> seeds_of_histories() {
  std::pair<uint64_t, uint64_t> seeds{1, runs(8)};
  if (const char* other = std::getenv("KERF_HISTORIES"))
    std::istringstream(other) >> seeds.first >> seeds.second;
  return seeds;
}

constexpr size_t kMaxFaces = 12'000;
constexpr double kLargest = 1e6;  // m

// Real ones of a size at which forces are finite, and our own.
std::vector<std::filesystem::path> mesh_files() {
  std::vector<std::filesystem::path> files = real_meshes(kMaxFaces);
  std::erase_if(files, [](const auto& file) { return world_of_file(file).bounds().diagonal() > kLargest; });
  for (const char* own : {"knot.obj", "car.obj", "plate.obj", "sphere.obj", "bracket.obj"})
    files.push_back(checkout() / "assets/meshes" / own);
  return files;
}

// On the ground, measured in metres or in a third of its own size.
World world_on_ground(const std::filesystem::path& file, bool of_own_size) {
  World world = world_of_file(file);
  const World::Bounds bounds = world.bounds();
  Environment around;
  around.ground = bounds.min.y - 0.02 * bounds.diagonal();
  if (of_own_size) around.metre = bounds.diagonal() / 3;
  around.gravity *= around.metre;
  world.set_environment(around);
  return world;
}

// One user at a document, whose frames come as they come.
class User {
 public:
  User(World world, uint64_t seed)
      : start_(std::move(world)), random_(seed), document_(World(start_)), bounds_(start_.bounds()) {}

  void work(size_t actions) {
    for (size_t strokes = 1 + random_.below(2); strokes > 0; --strokes) draw();
    for (; actions > 0 && !testing::Test::HasFailure(); --actions) act();
    rest();
  }

  const World& start() const { return start_; }
  Document& document() { return document_; }
  const std::vector<StateMark>& marks() const { return marks_; }

 private:
  void act() {
    switch (random_.below(8)) {
      case 0:
      case 1:
        return draw();
      case 2:
        return play();
      case 3:
        return apply(Undo{});
      case 4:
        return apply(Redo{});
      case 5:
        if (can_recut(document_)) apply(Recut{settings()});
        return;
      case 6:
        return edit_piece();
      default:
        return rest();
    }
  }

  void apply(const Command& command) {
    ASSERT_TRUE(document_.apply(command).ok());
    frame();
  }

  // What a frame has time for.
  void frame() {
    switch (random_.below(3)) {
      case 0:
        return;
      case 1:
        ASSERT_TRUE(document_.step(1 + random_.below(16)).ok());
        return;
      default:
        ASSERT_TRUE(run_all(document_).ok());
        if (random_.below(4) == 0) mark_state(document_, marks_);
    }
  }

  void rest() {
    ASSERT_TRUE(run_all(document_).ok());
    mark_state(document_, marks_, true);
  }

  CutSettings settings() {
    CutSettings s;
    s.laser.radius = bounds_.diagonal() * random_.uniform(0.005, 0.01);
    s.laser.range = {0, 10 * bounds_.diagonal()};
    s.resolution.target_edge = s.laser.radius * random_.uniform(0.5, 2);
    s.resolution.rim = random_.below(3) == 0 ? Rim::kFaces : Rim::kSmooth;
    s.resolution.scheme = random_.below(4) == 0 ? Scheme::kOneToFour : Scheme::kLongestEdge;
    if (random_.below(2) == 0) s.heat_width = default_heat_width(s.laser.radius);
    return s;
  }

  // Across the bounds along one axis, the beam along another, by hand; time may pass meanwhile.
  void draw() {
    const Vec3 size = bounds_.max - bounds_.min, middle = 0.5 * (bounds_.min + bounds_.max);
    const auto along = static_cast<int>(random_.below(3));
    const int beam = (along + 1 + static_cast<int>(random_.below(2))) % 3, aside = 3 - along - beam;
    const size_t poses = random_.below(3) == 0 ? 2 : 20 + random_.below(40);
    const size_t time = random_.below(3);  // none, heat alone, bodies too
    const double offset = random_.uniform(-0.3, 0.3) * size[aside];
    const double drift = random_.uniform(-0.3, 0.3) * size[aside];
    const auto pose = [&](size_t i) {
      const double share = static_cast<double>(i) / static_cast<double>(poses - 1);
      Pose p{middle, Vec3(0)};
      p.origin[beam] += bounds_.diagonal();
      p.origin[along] = bounds_.min[along] + (1.2 * share - 0.1) * size[along];
      p.origin[aside] += offset + share * drift + random_.uniform(-0.001, 0.001) * size[aside];
      p.direction[beam] = -1;
      return p;
    };
    apply(BeginStroke{settings(), pose(0)});
    for (size_t i = 1; i < poses; ++i) {
      apply(MoveBeam{pose(i), static_cast<double>(i) / 60});
      if (time > 0 && random_.below(8) == 0) apply(AdvanceTime{1 + random_.below(3), time == 2});
    }
    if (random_.below(8) != 0) apply(EndStroke{});
    if (random_.below(2) == 0) apply(AdvanceTime{1 + random_.below(20), random_.below(2) == 0});
  }

  void play() {
    apply(Play{});
    for (size_t i = 1 + random_.below(3); i > 0; --i) apply(AdvanceTime{1 + random_.below(15), true});
  }

  void edit_piece() {
    rest();
    const auto piece = random_piece(document_.world(), random_);
    if (!piece) return;
    const Placement& at = document_.world().body(piece->body).placement;
    switch (random_.below(5)) {
      case 0:
        return apply(DeletePiece{*piece});
      case 1:
        return apply(HidePiece{*piece, random_.below(2) == 0});
      case 2:
        return apply(PinPiece{*piece, random_.below(2) == 0});
      case 3:
        return apply(SetSolid{*piece, random_.below(3) > 0});
      default:
        return apply(MovePiece{
            *piece, {at.position + 0.1 * bounds_.diagonal() * random_direction(random_), at.orientation}});
    }
  }

  World start_;
  Random random_;
  Document document_;
  World::Bounds bounds_;
  std::vector<StateMark> marks_;
};

// The journal as a file holds it.
Journal journal_of(User& user) {
  const TemporaryFolder folder;
  const auto lines = journal_lines(user.document().journal(), user.marks(), folder.path());
  EXPECT_TRUE(lines.ok());
  write_text(folder / "work.kerf",
             std::string(R"({"kerf":"journal","format":1,"program":"0.2.0","bodies":[{"mesh":"a.obj"}]})") +
                 '\n' + *lines);
  auto journal = read_journal(folder / "work.kerf");
  EXPECT_TRUE(journal.ok());
  EXPECT_EQ(journal->damage, "");
  return std::move(*journal);
}

void expect_replays(const Journal& journal, User& user) {
  Document again(World(user.start()));
  Replay replay(journal, again);
  const Status run = replay.run({});
  ASSERT_TRUE(run.ok()) << run.error().message;
  EXPECT_FALSE(replay.difference().has_value());
  expect_same_world(user.document().world(), again.world());
}

// As after a crash: bodies are put where marks say that time has brought them.
void expect_recovers(const Journal& journal, User& user) {
  Document again(World(user.start()));
  Replay replay(journal, again, time_skips(journal, 10));
  const Status run = replay.run({});
  ASSERT_TRUE(run.ok()) << run.error().message;
  EXPECT_FALSE(replay.difference().has_value());
  EXPECT_EQ(state_hash(user.document().world()), state_hash(again.world()));
}

void expect_goes_back_and_forth(Document& document) {
  const uint64_t end = state_hash(document.world());
  const size_t position = document.history().position();
  ASSERT_TRUE(document.travel(0).ok());
  ASSERT_TRUE(document.travel(position).ok());
  ASSERT_TRUE(run_all(document).ok());
  EXPECT_EQ(state_hash(document.world()), end);
}

TEST(MovingHistories, replay_recovery_and_undo_are_bit_identical) {
  const std::vector<std::filesystem::path> files = mesh_files();
  const auto [first, last] = seeds_of_histories();
  for (uint64_t seed = first; seed <= last; ++seed) {
    const auto& file = files[(7 * seed) % files.size()];
    SCOPED_TRACE("seed " + std::to_string(seed) + ", " + file.filename().string());
    User user(world_on_ground(file, seed % 2 == 0), seed);
    user.work(5);
    if (testing::Test::HasFailure()) return;
    const Journal journal = journal_of(user);
    expect_replays(journal, user);
    expect_recovers(journal, user);
    expect_goes_back_and_forth(user.document());
    if (testing::Test::HasFailure()) return;
  }
}

}  // namespace
}  // namespace kerf::test
