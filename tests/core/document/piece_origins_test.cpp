#include "core/document/cut_effects.h"

#include <gtest/gtest.h>

#include <map>

#include "tests/support/made_meshes.h"
#include "tests/support/runs.h"
#include "tests/support/strokes.h"

namespace kerf::test {
namespace {

// The labels of the live faces by slot.
std::map<uint32_t, uint32_t> labels_of(const Mesh& mesh) {
  std::map<uint32_t, uint32_t> labels;
  for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
    if (mesh.is_live(FaceId(f))) labels[f] = mesh.data(FaceId(f)).piece;
  }
  return labels;
}

void draw_one_stroke(Document& document, Random& random) {
  const RandomStroke stroke = random_stroke(document.world(), random, 0.03, true);
  document.apply(BeginStroke{stroke.settings, stroke.moves.front().from});
  document.apply(MoveBeam{stroke.moves.back().to});
  document.apply(EndStroke{});
  ASSERT_TRUE(run_all(document).ok());
}

// The piece that a piece was part of before the stroke in which it came off, perhaps in several parts one
// after the other; nothing if one of these has no faces any more.
std::optional<uint32_t> piece_before(const std::map<uint32_t, PieceNode>& origins, uint32_t label) {
  const size_t step = origins.at(label).step;
  for (;;) {
    const uint32_t from = origins.at(label).came_off->label;
    const auto parent = origins.find(from);
    if (parent == origins.end()) return std::nullopt;
    if (!parent->second.came_off || parent->second.step != step) return from;
    label = from;
  }
}

// A face that lived before a stroke and has another label after it tells what the piece came off.
TEST(PieceOrigins, match_the_labels_before_and_after_each_stroke) {
  size_t compared = 0;
  for (uint64_t seed = 1; seed <= runs(24); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Document document(world_of(seed % 2 == 0 ? grid(12, 2) : sphere(12, 16, 1)));
    Random random(seed);
    std::map<uint32_t, std::pair<uint32_t, size_t>> expected;
    for (size_t step = 0; step < 4; ++step) {
      const auto before = labels_of(document.world().body(document.world().ids()[0]).mesh);
      draw_one_stroke(document, random);
      for (const auto& [slot, label] : labels_of(document.world().body(document.world().ids()[0]).mesh)) {
        const auto was = before.find(slot);
        if (was != before.end() && was->second != label) expected[label] = {was->second, step};
      }
    }
    std::map<uint32_t, PieceNode> origins;
    for (const PieceNode& origin : piece_origins(document)) origins[origin.piece.label] = origin;
    for (const auto& [label, origin] : origins) {
      if (label == 0) EXPECT_FALSE(origin.came_off);
      const auto found = expected.find(label);
      if (found == expected.end()) continue;
      ASSERT_TRUE(origin.came_off) << "piece " << label;
      EXPECT_EQ(origin.step, found->second.second) << "piece " << label;
      if (const auto before = piece_before(origins, label)) EXPECT_EQ(*before, found->second.first) << label;
      ++compared;
    }
  }
  EXPECT_GT(6 * compared, 20 * runs(24));  // over 20 in the usual six runs
}

TEST(PieceOrigins, follow_undo) {
  Document document(world_of(grid(12, 2)));
  Random random(3);
  EXPECT_EQ(piece_origins(document).size(), 1u);
  draw_one_stroke(document, random);
  const size_t pieces = document.world().live_pieces();
  EXPECT_EQ(piece_origins(document).size(), pieces);
  document.apply(Undo{});
  EXPECT_EQ(piece_origins(document).size(), 1u);
  document.apply(Redo{});
  EXPECT_EQ(piece_origins(document).size(), pieces);
}

}  // namespace
}  // namespace kerf::test
