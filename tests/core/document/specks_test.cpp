#include "core/document/cut_effects.h"

#include <gtest/gtest.h>

#include "core/document/single_step.h"
#include "tests/support/made_meshes.h"
#include "tests/support/strokes.h"

namespace kerf {
namespace {

constexpr double kRadius = 0.1;

// Two strips in z = 0, beside each other and 1 m long in y; from each a stroke along x at y = 0.5 cuts the
// rest beyond it, which ends at y = 1 and at `short_end`.
Soup two_strips(double short_end) {
  Soup soup;
  for (const auto& [x, end, rows] : {std::tuple{0.0, 1.0, 40u}, std::tuple{1.0, short_end, 20u}}) {
    const auto first = static_cast<uint32_t>(soup.positions.size());
    for (uint32_t i = 0; i <= rows; ++i) {
      const double y = i == rows ? end : i * std::min(end, 0.6) / rows;
      soup.positions.push_back({x, y, 0});
      soup.positions.push_back({x + 0.05, y, 0});
    }
    for (uint32_t i = 0; i < rows; ++i) {
      const uint32_t a = first + 2 * i;
      soup.triangles.push_back({a, a + 1, a + 3});
      soup.triangles.push_back({a, a + 3, a + 2});
    }
  }
  return soup;
}

// With the stroke to be cut.
Document strips() {
  Document document(test::world_of(two_strips(0.63)));
  CutSettings settings;
  settings.laser.radius = kRadius;
  settings.laser.range = {0, 10};
  settings.resolution.rule = Resolution::Rule::kTargetEdge;
  settings.resolution.target_edge = 0.005;
  document.apply(BeginStroke{settings, {{-1, 0.5, 1}, {0, 0, -1}}});
  document.apply(MoveBeam{{{2, 0.5, 1}, {0, 0, -1}}});
  document.apply(EndStroke{});
  return document;
}

Document cut_strips() {
  Document document = strips();
  while (document.waiting() > 0) EXPECT_TRUE(document.step(64).ok());
  return document;
}

TEST(Specks, are_smaller_than_a_fraction_of_the_beam_cross_section) {
  EXPECT_TRUE(is_speck(0.0039, kRadius));
  EXPECT_FALSE(is_speck(0.0040, kRadius));
}

TEST(Specks, are_found_among_cut_off_pieces_and_disappear_on_undo) {
  Document document = cut_strips();
  const Body& body = document.world().body(document.world().ids()[0]);
  size_t pieces = 0;
  for (uint32_t i = 0; i < body.pieces.size(); ++i) pieces += body.pieces[i].faces > 0;
  ASSERT_GE(pieces, 3u);
  const std::set<PieceId> found = specks(document);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_TRUE(is_speck(body.pieces[found.begin()->label].area, kRadius));
  EXPECT_EQ(document.history().step(0).totals().specks, found);
  document.apply(Undo{});
  EXPECT_TRUE(specks(document).empty());
  document.apply(Redo{});
  EXPECT_EQ(specks(document), found);
}

TEST(Specks, stay_specks_when_they_become_bodies) {
  Document document = cut_strips();
  const PieceId speck = *specks(document).begin();
  document.apply(HidePiece{speck, true});
  const std::set<PieceId> after = specks(document);
  ASSERT_EQ(after.size(), 1u);
  EXPECT_NE(after.begin()->body, speck.body);
}

TEST(Specks, are_reported_by_the_stage_that_cuts_them_off) {
  Document document = strips();
  SingleStep single(document);
  size_t reported = 0;
  while (document.waiting() > 0) {
    const Result<StageRecord> stage = single.next();
    ASSERT_TRUE(stage.ok());
    reported += stage->specks;
  }
  EXPECT_EQ(reported, 1u);
  EXPECT_EQ(specks(document).size(), 1u);
}

}  // namespace
}  // namespace kerf
