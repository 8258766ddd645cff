#include "tests/support/random_edits.h"

namespace kerf::test {

std::optional<PieceId> random_piece(const World& world, Random& random) {
  std::vector<PieceId> all;
  for (const BodyId id : world.ids()) {
    for (uint32_t p = 0; p < world.body(id).pieces.size(); ++p) {
      if (world.body(id).pieces[p].faces > 0) all.push_back({id, p});
    }
  }
  if (all.empty()) return std::nullopt;
  return all[random.below(all.size())];
}

namespace {

std::vector<Command> stroke_across(Random& random) {
  const double x = random.uniform(-0.45, 0.45);
  CutSettings settings;
  settings.laser.radius = 0.03;
  settings.resolution.target_edge = 0.1;
  return {BeginStroke{settings, {{x, 3, -0.7}, {0, -1, 0}}}, MoveBeam{{{x, 3, 0.7}, {0, -1, 0}}},
          EndStroke{}};
}

}  // namespace

std::vector<Command> random_edit(const World& world, const std::filesystem::path& mesh, Random& random) {
  const size_t what = random.below(11);
  if (what < 2) return stroke_across(random);
  if (what == 2) return {AddMesh{mesh, "more"}};
  if (what == 3) return {Redo{}};
  if (what < 6) return {Undo{}};
  const std::optional<PieceId> piece = random_piece(world, random);
  if (!piece) return {};
  if (what == 6) return {MovePiece{*piece, {{0, random.uniform(-1, 1), 0}, {1, 0, 0, 0}}}};
  if (what == 7) return {HidePiece{*piece, random.below(2) > 0}};
  if (what == 9) return {DuplicatePiece{*piece, {{random.uniform(-1, 1), 0, 0}, {1, 0, 0, 0}}}};
  if (what == 8) return {RenamePiece{*piece, "part " + std::to_string(random.below(100))}};
  return {DeletePiece{*piece}};
}

}  // namespace kerf::test
