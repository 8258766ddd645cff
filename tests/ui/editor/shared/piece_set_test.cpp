#include <gtest/gtest.h>

#include <set>

#include "core/document/document.h"
#include "core/document/scene.h"
#include "tests/support/checkout.h"
#include "tests/support/jointed.h"
#include "tests/support/made_meshes.h"
#include "ui/editor/pieces/pieces_list.h"
#include "ui/editor/shared/piece_set.h"
#include "ui/render/view/view_options.h"

namespace kerf {
namespace {

PieceId key(uint32_t label) { return {BodyId{0, 0}, label}; }

TEST(PieceSet, a_click_selects_one_and_shift_adds) {
  PieceMap looks;
  select_piece(looks, key(1), false);
  select_piece(looks, key(2), false);
  EXPECT_EQ(selected_count(looks), 1u);
  select_piece(looks, key(3), true);
  EXPECT_EQ(selected_count(looks), 2u);
  select_piece(looks, key(3), true);
  EXPECT_EQ(selected_count(looks), 1u);
  select_piece(looks, key(2), false);
  EXPECT_TRUE(looks.empty());
}

TEST(PieceSet, a_hidden_piece_is_not_selected) {
  PieceMap looks;
  looks[key(1)].hidden = true;
  select_piece(looks, key(2), false);
  for (const bool add : {false, true}) {
    select_piece(looks, key(1), add);
    EXPECT_FALSE(looks[key(1)].selected);
    EXPECT_EQ(first_selected(looks), key(2));
  }
}

// A sphere whose last stroke went through its middle.
class CutSphere : public testing::Test {
 protected:
  CutSphere() {
    World world;
    world.add(make_body("sphere", test::build(test::sphere(24, 32, 1))));
    document = Document(std::move(world));
    CutSettings settings;
    settings.laser.radius = 0.1;
    settings.laser.range = {0, 10};
    settings.resolution = {.rule = Resolution::Rule::kDepth, .depth = 1};
    document.apply(BeginStroke{settings, {{-1.5, 0, 5}, {0, 0, -1}}});
    document.apply(MoveBeam{{{1.5, 0, 5}, {0, 0, -1}}});
    document.apply(EndStroke{});
    while (document.waiting() > 0) EXPECT_TRUE(document.step(64).ok());
  }
  Document document;
  PieceMap looks;
};

TEST_F(CutSphere, display_settings_follow_a_piece_hidden_and_shown_again) {
  const PieceId half = list_pieces(document.world())[1].id;
  select_piece(looks, half, false);
  const Outcome hid = document.apply(HidePiece{half, true});
  ASSERT_TRUE(hid.ok());
  follow_world(document.world(), hid.delta, looks);
  EXPECT_EQ(selected_count(looks), 0u);
  ASSERT_EQ(hidden_pieces(looks).size(), 1u);
  EXPECT_EQ(document.world().body(hidden_pieces(looks).front().body).own_name(), "sphere 1");
  EXPECT_EQ(list_pieces(document.world()).size(), 2u);
  const Outcome shown = document.apply(Undo{});
  ASSERT_TRUE(shown.ok());
  follow_world(document.world(), shown.delta, looks);
  EXPECT_TRUE(looks.empty());
}

TEST_F(CutSphere, a_piece_stays_selected_when_detached_and_reattached) {
  for (const PieceRow& row : list_pieces(document.world())) {
    select_piece(looks, row.id, false);
    const Outcome moved = document.apply(MovePiece{row.id, {{1, 2, 3}, {1, 0, 0, 0}}});
    ASSERT_TRUE(moved.ok());
    follow_world(document.world(), moved.delta, looks);
    const BodyId own = document.world().ids().back();
    EXPECT_EQ(first_selected(looks), (PieceId{own, row.id.label}));
    const Outcome back = document.apply(Undo{});
    ASSERT_TRUE(back.ok());
    follow_world(document.world(), back.delta, looks);
    EXPECT_EQ(first_selected(looks), row.id);
  }
}

TEST_F(CutSphere, explodes_its_halves) {
  const World& world = document.world();
  const std::vector<PieceRow> rows = list_pieces(world);
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].name, "sphere");
  ViewOptions look;
  spread_pieces(world, 0.5, look);
  const Vec3 a = look.pieces[rows[0].id].offset, b = look.pieces[rows[1].id].offset;
  EXPECT_GT(std::abs(a.y - b.y), 0.3);
  EXPECT_LT(a.y * b.y, 0);
  EXPECT_NEAR(a.x, 0, 0.05);
  spread_pieces(world, 0, look);
  EXPECT_TRUE(look.pieces.empty() && look.groups.empty());
}

TEST_F(CutSphere, the_bounds_of_the_selection_are_those_of_its_drawn_places) {
  const World& world = document.world();
  const PieceId half = list_pieces(world)[1].id;
  ViewOptions look;
  select_piece(look.pieces, half, false);
  const Bounds in_place = selected_bounds(world, look);
  spread_pieces(world, 0.5, look);
  const Vec3 offset = look.pieces[half].offset;
  ASSERT_NE(offset, Vec3(0));
  const Bounds apart = selected_bounds(world, look);
  const double size = in_place.diagonal();
  EXPECT_LT(glm::length(apart.min - (in_place.min + offset)), 1e-12 * size);
  EXPECT_LT(glm::length(apart.max - (in_place.max + offset)), 1e-12 * size);
}

TEST_F(CutSphere, the_measures_of_pieces_of_one_body_add_up) {
  const World& world = document.world();
  std::vector<PieceId> halves;
  double area = 0;
  for (const PieceRow& row : list_pieces(world)) {
    halves.push_back(row.id);
    const PieceMeasures half = measure_pieces(world, {row.id});
    EXPECT_NEAR(half.area, row.area, 1e-9 * row.area);
    EXPECT_FALSE(half.volume);
    area += half.area;
  }
  const PieceMeasures both = measure_pieces(world, halves);
  EXPECT_EQ(both.pieces, 2u);
  EXPECT_NEAR(both.area, area, 1e-12 * area);
  EXPECT_FALSE(both.volume);
}

TEST(PieceSet, articulated_parts_are_listed_after_pieces_by_mesh_name) {
  auto scene = read_scene(test::checkout() / "assets/scenes/car.json");
  ASSERT_TRUE(scene.ok()) << scene.error().message;
  Document document(std::move(scene->world));
  ASSERT_NO_FATAL_FAILURE(test::cut_car(document));
  const std::vector<PieceRow> rows = list_pieces(document.world());
  ASSERT_EQ(rows.size(), 7u);
  EXPECT_EQ(rows[0].name, "car");
  EXPECT_FALSE(rows[1].part) << "the roof";
  std::set<std::string> parts;
  for (size_t i = 2; i < rows.size(); ++i) {
    EXPECT_TRUE(rows[i].part);
    EXPECT_EQ(rows[i].number, 0u);
    parts.insert(rows[i].name);
    EXPECT_EQ(name_of_piece(document.world(), {}, rows[i].id), rows[i].name);
  }
  EXPECT_EQ(parts, std::set<std::string>({"wheel_front_left", "wheel_front_right", "wheel_rear_left",
                                          "wheel_rear_right", "steering_wheel"}));
}

TEST(PieceSet, is_sorted_by_number_faces_or_area) {
  const auto row = [](uint32_t number, size_t faces, double area, bool part) {
    return PieceRow{{{0, 0}, number + (part ? 100 : 0)}, part ? 0 : number, "", faces, area, false, part};
  };
  std::vector<PieceRow> rows{row(2, 5, 1, false), row(1, 9, 3, false), row(4, 7, 2, true),
                             row(0, 1, 4, false)};
  const auto labels = [&] {
    std::vector<uint32_t> all;
    for (const PieceRow& r : rows) all.push_back(r.id.label);
    return all;
  };
  sort_pieces(rows, PieceColumn::kNumber, false);
  EXPECT_EQ(labels(), (std::vector<uint32_t>{0, 1, 2, 104}));
  sort_pieces(rows, PieceColumn::kFaces, true);
  EXPECT_EQ(labels(), (std::vector<uint32_t>{1, 104, 2, 0}));
  sort_pieces(rows, PieceColumn::kArea, false);
  EXPECT_EQ(labels(), (std::vector<uint32_t>{2, 104, 1, 0}));
  sort_pieces(rows, PieceColumn::kArea, true);
  EXPECT_EQ(labels(), (std::vector<uint32_t>{0, 1, 104, 2}));
}

TEST(PieceSet, specks_are_grouped_but_a_single_one_stays_in_the_list) {
  const auto row = [](uint32_t label, size_t faces) {
    return PieceRow{{{0, 0}, label}, label, "piece " + std::to_string(label), faces, 1};
  };
  const SortedPieces sorted =
      separate_specks({row(0, 4), row(1, 9), row(2, 8), row(3, 1)}, {{{0, 0}, 2}, {{0, 0}, 3}, {{1, 0}, 1}});
  ASSERT_EQ(sorted.rest.size(), 2u);
  EXPECT_EQ(sorted.rest[1].id.label, 1u);
  ASSERT_EQ(sorted.specks.size(), 2u);
  EXPECT_EQ(sorted.specks[1].id.label, 3u);
  EXPECT_TRUE(separate_specks({row(0, 90), row(1, 1)}, {{{0, 0}, 1}}).specks.empty());
}

}  // namespace
}  // namespace kerf
