#include "ui/editor/shared/piece_set.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "core/document/document.h"
#include "tests/support/made_meshes.h"

namespace kerf {
namespace {

// A row of strips, beside a larger one that stays: cut off one by one, from the left or from the right.
class CutStrips : public testing::Test {
 protected:
  CutStrips() { restart(); }

  static CutSettings settings(double edge) {
    CutSettings s;
    s.laser.radius = 0.01;
    s.laser.range = {0, 5};
    s.resolution.target_edge = edge;
    return s;
  }

  void cut(const std::vector<double>& at) {
    document.apply(BeginStroke{settings(0.005), {{at.front(), 1, -0.7}, {0, -1, 0}}});
    double z = 0.7;
    for (const double x : at) {
      document.apply(MoveBeam{{{x, 1, -z}, {0, -1, 0}}});
      document.apply(MoveBeam{{{x, 1, z}, {0, -1, 0}}});
      z = -z;
    }
    document.apply(EndStroke{});
    walk(false);
  }

  void walk(bool replaced) {
    follow(replaced);
    while (document.waiting() > 0) ASSERT_TRUE(document.step(64).ok());
    follow(false);
  }

  void follow(bool replaced) {
    const bool recut =
        document.history().position() > 0 && document.history().last().kind() == HistoryStep::Kind::kRecut;
    numbers.follow(document.world(), replaced,
                   recut || document.history().size() > document.history().position(), looks);
  }

  void apply(const Command& command) {
    const Outcome outcome = document.apply(command);
    ASSERT_TRUE(outcome.ok());
    follow_world(document.world(), outcome.delta, looks);
    walk(true);
  }

  // Opens the uncut plate again.
  void restart() {
    World world;
    world.add(make_body("plate", test::build(test::grid(16, 1))));
    document = Document(std::move(world));
  }

  // As cut({-0.4, -0.2, 0.4}), but from the right; the faces are not removed yet.
  void cut_from_the_right() {
    document.apply(BeginStroke{settings(0.005), {{0.4, 1, -0.7}, {0, -1, 0}}});
    document.apply(MoveBeam{{{0.4, 1, 0.7}, {0, -1, 0}}});
    document.apply(MoveBeam{{{-0.2, 1, 0.7}, {0, -1, 0}}});
    document.apply(MoveBeam{{{-0.2, 1, -0.7}, {0, -1, 0}}});
    document.apply(MoveBeam{{{-0.4, 1, -0.7}, {0, -1, 0}}});
    document.apply(MoveBeam{{{-0.4, 1, 0.7}, {0, -1, 0}}});
    document.apply(EndStroke{});
  }

  // The middle of a piece along x, in hundredths.
  long place_of(const PieceId& id) const {
    const Body& body = document.world().body(id.body);
    const Piece& piece = body.pieces[id.label];
    return std::lround(100 * (body.middle() + piece.moments.first / piece.area).x);
  }

  // By number: the place of each piece.
  std::map<uint32_t, long> places() const {
    std::map<uint32_t, long> places;
    for (const PieceRow& row : list_pieces(document.world(), looks)) {
      if (row.id.label == 0) continue;
      EXPECT_TRUE(places.emplace(row.number, place_of(row.id)).second) << "two pieces of one number";
    }
    return places;
  }

  Document document;
  PieceNumbers numbers;
  PieceMap looks;
};

TEST_F(CutStrips, a_new_piece_has_the_number_of_its_label) {
  cut({-0.4, -0.2});
  const auto rows = list_pieces(document.world(), looks);
  ASSERT_EQ(rows.size(), 3u);
  for (const PieceRow& row : rows) EXPECT_EQ(row.number, row.id.label);
  EXPECT_TRUE(looks.empty());
}

TEST_F(CutStrips, numbers_keep_their_positions_through_recuts_undo_and_redo) {
  cut({-0.4, -0.2, 0.4});
  const auto before = places();
  ASSERT_EQ(before.size(), 3u);
  for (const double edge : {0.02, 0.003, 0.01}) {
    apply(Recut{settings(edge)});
    EXPECT_EQ(places(), before) << edge;
  }
  for (int i = 0; i < 4; ++i) {
    apply(Undo{});
    if (i < 3) {
      EXPECT_EQ(places(), before) << "undone " << i + 1;
    }
  }
  EXPECT_TRUE(places().empty());
  for (int i = 0; i < 4; ++i) {
    apply(Redo{});
    EXPECT_EQ(places(), before) << "redone " << i + 1;
  }
}

// Parts that come off in another order have other labels, as after a recut.
TEST_F(CutStrips, numbers_keep_their_positions_when_labels_are_swapped) {
  cut({-0.4, -0.2, 0.4});
  const auto before = places();
  restart();
  numbers.follow(document.world(), true, true, looks);
  cut_from_the_right();
  while (document.waiting() > 0) {
    ASSERT_TRUE(document.step(1).ok());
    numbers.follow(document.world(), false, true, looks);
  }
  EXPECT_EQ(places(), before);
  EXPECT_FALSE(looks.empty()) << "the labels are the same: nothing was shown";
}

TEST_F(CutStrips, the_selection_stays_on_its_piece_when_labels_are_swapped) {
  cut({-0.4, -0.2, 0.4});
  PieceId right;
  for (const PieceRow& row : list_pieces(document.world(), looks)) {
    if (row.id.label != 0 && place_of(row.id) > 40) right = row.id;
  }
  ASSERT_NE(right.label, 0u);
  const long before = place_of(right);
  select_piece(looks, right, false);
  restart();
  cut_from_the_right();
  while (document.waiting() > 0) ASSERT_TRUE(document.step(64).ok());
  follow_world(document.world(), Delta{}, looks);
  numbers.follow(document.world(), true, true, looks);
  ASSERT_EQ(selected_count(looks), 1u);
  EXPECT_EQ(place_of(*first_selected(looks)), before);
  EXPECT_NE(*first_selected(looks), right) << "the labels are the same: nothing was shown";
}

TEST_F(CutStrips, a_piece_keeps_its_number_and_name_when_it_is_hidden_and_shown) {
  cut({-0.4, -0.2, 0.4});
  const auto before = places();
  const auto rows = list_pieces(document.world(), looks);
  const PieceId some = rows[2].id;
  apply(HidePiece{some, true});
  EXPECT_EQ(places(), before);
  const BodyId own = document.world().ids().back();
  apply(HidePiece{{own, some.label}, false});
  EXPECT_EQ(places(), before);
  for (const PieceRow& row : list_pieces(document.world(), looks)) {
    const auto old =
        std::find_if(rows.begin(), rows.end(), [&](const PieceRow& r) { return r.name == row.name; });
    ASSERT_NE(old, rows.end()) << row.name;
    EXPECT_EQ(old->number, row.number);
    EXPECT_EQ(old->area, row.area);
  }
}

}  // namespace
}  // namespace kerf
