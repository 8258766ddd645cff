#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "core/mesh/measures.h"
#include "core/mesh/mesh_file.h"
#include "core/world/body_creation.h"
#include "tests/support/mesh_numbers.h"
#include "tests/support/runs.h"
#include "tests/support/solids.h"
#include "tests/support/strokes.h"

namespace kerf::test {
namespace {

// A box between two corners. Where several share a coordinate, it is the same to the bit.
Soup box_between(const Vec3& low, const Vec3& high) {
  Soup box = brick({1, 1, 1});
  for (Vec3& p : box.positions) {
    for (int k = 0; k < 3; ++k) p[k] = p[k] == 0 ? low[k] : high[k];
  }
  return box;
}

// The same box with the other diagonals on its faces.
Soup mirrored_box_between(const Vec3& low, const Vec3& high) {
  return inside_out(box_between({high.x, low.y, low.z}, {low.x, high.y, high.z}));
}

// Turns a soup and a stroke together.
struct TurnOfSolids {
  glm::dmat3 by{1.0};

  Soup operator()(Soup soup) const {
    for (Vec3& p : soup.positions) p = by * p;
    return soup;
  }
  SolidStroke operator()(SolidStroke stroke) const {
    for (Pose& p : stroke.poses) p = {by * p.origin, by * p.direction};
    return stroke;
  }
};

TurnOfSolids random_turn(Random& random) {
  const Vec3 x = random_direction(random), y = glm::normalize(glm::cross(x, random_direction(random)));
  return {glm::dmat3(x, y, glm::cross(x, y))};
}

// Along x at this z, from above, through all that lies between y = -5 and y = 5.
SolidStroke slot_through(double z, double radius, double from = -9, double to = 9) {
  return straight_stroke({from, 5, z}, {to, 5, z}, {0, -1, 0}, radius, {0, 10});
}

constexpr double kSlotRadius = 0.02;

// Random sizes and a slot at a random height through two boxes; expects that they are closed, and that the
// slot took what it covers of a section of this area at its height.
class TouchingSolids : public testing::TestWithParam<uint64_t> {
 protected:
  TouchingSolids() : random_(GetParam()) { RecordProperty("seed", static_cast<int>(GetParam())); }

  double size() { return random_.uniform(0.4, 1.3); }
  void expect_cut(const Soup& soup, double z, double section) {
    for (const TurnOfSolids& turn : {TurnOfSolids{}, random_turn(random_)}) {
      SolidCut cut(world_of(turn(soup)));
      const double before = enclosed_volume(cut.body().mesh, cut.body().middle()).volume;
      ASSERT_TRUE(cut.draw(turn(slot_through(z, kSlotRadius)), random_)) << cut.reasons().front();
      const double after = enclosed_volume(cut.body().mesh, cut.body().middle()).volume;
      EXPECT_NEAR(before - after, 2 * kSlotRadius * section, 1e-6 * before);
      EXPECT_EQ(find_fault(cut.body().mesh, true), "");
      ASSERT_TRUE(cut.draw(turn(slot_through(z + 4 * kSlotRadius, kSlotRadius, 0.1, 0.3)), random_))
          << "a second stroke, which ends inside: " << cut.reasons().front();
    }
  }

  Random random_;
};

TEST_P(TouchingSolids, are_closed_if_they_share_a_face) {
  const double a = size(), b = size(), y = size(), z = size(), at = z * random_.uniform(0.2, 0.7);
  const Soup first = box_between({0, 0, 0}, {a, y, z});
  expect_cut(both(first, box_between({a, 0, 0}, {a + b, y, z})), at, (a + b) * y);
  expect_cut(both(first, mirrored_box_between({a, 0, 0}, {a + b, y, z})), at, (a + b) * y);
  // Loading turns both outward.
  expect_cut(inside_out(both(first, box_between({a, 0, 0}, {a + b, y, z}))), at, (a + b) * y);
}

TEST_P(TouchingSolids, are_closed_if_they_share_a_part_of_a_face) {
  const double a = size(), b = size(), y = size(), z = size(), at = z * random_.uniform(0.3, 0.6);
  const Soup first = box_between({0, 0, 0}, {a, y, z});
  expect_cut(both(first, box_between({a, 0.25 * y, 0.2 * z}, {a + b, 0.75 * y, 0.9 * z})), at,
             a * y + 0.5 * b * y);
  expect_cut(both(first, box_between({a, 0, 0}, {a + b, 0.5 * y, z})), at, a * y + 0.5 * b * y);
}

TEST_P(TouchingSolids, are_closed_if_they_share_an_edge) {
  const double a = size(), b = size(), y = size(), z = size(), at = z * random_.uniform(0.2, 0.7);
  const Soup first = box_between({0, 0, 0}, {a, y, z});
  expect_cut(both(first, box_between({a, y, 0}, {a + b, 2 * y, z})), at, (a + b) * y);
}

TEST_P(TouchingSolids, are_closed_if_they_share_a_vertex_in_the_kerf) {
  const double a = size(), b = size(), y = size(), z = size();
  const Soup first = box_between({0, 0, 0}, {a, y, z});
  expect_cut(both(first, box_between({a, y, z}, {a + b, 2 * y, 2 * z})), z - 0.5 * kSlotRadius,
             0.75 * a * y + 0.25 * b * y);
}

TEST_P(TouchingSolids, are_closed_if_blocks_of_a_chequerboard_share_edges) {
  const double s = size();
  Soup board;
  double section = 0;
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) {
      if ((i + k) % 2 != 0) continue;
      const Soup block = box_between({i * s, k * s, 0}, {(i + 1) * s, (k + 1) * s, s});
      board = board.positions.empty() ? block : both(board, block);
      section += s * s;
    }
  }
  expect_cut(board, 0.4 * s, section);
}

TEST_P(TouchingSolids, are_closed_including_their_cavities) {
  const double a = size(), b = size(), y = size(), z = size();
  const auto hollow = [&](double low, double high) {
    const double wall = 0.2 * (high - low);
    return both(box_between({low, 0, 0}, {high, y, z}),
                inside_out(box_between({low + wall, 0.2 * y, 0.2 * z}, {high - wall, 0.7 * y, 0.8 * z})));
  };
  expect_cut(both(hollow(0, a), hollow(a, a + b)), 0.4 * z, (a + b) * y * (1 - 0.6 * 0.5));
}

TEST_P(TouchingSolids, are_closed_if_stacked_face_to_face) {
  const double x = size(), y = size(), z = size();
  const Soup box = box_between({0, 0, 0}, {x, y, z});
  expect_cut(both(box, box), 0.4 * z, 2 * x * y);
}

TEST_P(TouchingSolids, are_closed_by_a_stroke_that_ends_inside) {
  const double a = size(), y = size(), z = size();
  const Soup soup = both(box_between({0, 0, 0}, {a, y, z}), box_between({a, 0, 0}, {2 * a, y, z}));
  SolidCut cut(world_of(soup));
  const SolidStroke stroke =
      straight_stroke({-1, y + 1, 0.5 * z}, {3, y + 1, 0.5 * z}, {0, -1, 0}, kSlotRadius, {0, 1 + 0.3 * y});
  ASSERT_TRUE(cut.draw(stroke, random_)) << cut.reasons().front();
  const double after = enclosed_volume(cut.body().mesh, cut.body().middle()).volume;
  EXPECT_NEAR(2 * a * y * z - after, 2 * kSlotRadius * 0.3 * y * 2 * a, 1e-6);
}

INSTANTIATE_TEST_SUITE_P(Seeds, TouchingSolids, testing::Values(1, 2, 3));

// A solid body of which only some parts are closed, and what one slot did.
struct PartlyClosed {
  World world;
  StepResult result;

  PartlyClosed(const Soup& soup, const SolidStroke& stroke) : world(world_of(soup)) {
    only_body(world).solid = true;
    Document document(std::move(world));
    document.apply(BeginStroke{stroke.settings, stroke.poses[0]});
    document.apply(MoveBeam{stroke.poses[1]});
    document.apply(EndStroke{});
    Result<StepResult> cut = run_all(document);
    EXPECT_TRUE(cut.ok());
    if (cut) result = std::move(*cut);
    world = document.world();
  }
  std::vector<std::string> notes() const {
    std::vector<std::string> notes;
    for (const LeftOpen& open : result.delta.left_open) notes.push_back(open.why);
    return notes;
  }
  size_t open_sides() {
    std::vector<Mesh::Side> open;
    only_body(world).mesh.append_open_sides(open);
    return open.size();
  }
};

const Soup& unit_box() {
  static const Soup box = box_between({0, 0, 0}, {1, 1, 1});
  return box;
}

Soup sheet_at(double x) { return moved(grid(1, 0.4), {x, 0.5, 0.4}, 1); }

TEST(PartlyClosedSolid, reports_an_inner_sheet_as_open_and_closes_the_box) {
  PartlyClosed cut(both(unit_box(), sheet_at(0.5)), slot_through(0.6, kSlotRadius));
  ASSERT_FALSE(cut.notes().empty());
  EXPECT_NE(cut.notes()[0].find("open before the stroke"), std::string::npos) << cut.notes()[0];
  EXPECT_GT(cut.result.delta.solid.wall_faces, 0u);
}

TEST(PartlyClosedSolid, closes_a_box_that_shares_an_edge_with_an_open_box) {
  Soup broken = box_between({1, 1, 0}, {2, 2, 1});
  broken.triangles.resize(broken.triangles.size() - 2);
  broken.triangles_in_file = broken.faces_in_file = broken.triangles.size();
  PartlyClosed cut(both(unit_box(), broken), slot_through(0.4, kSlotRadius));
  EXPECT_EQ(cut.notes().size(), 1u);
  // The walls of the closed box.
  EXPECT_NEAR(cut.result.delta.solid.wall_area, 2.0, 1e-6);
}

TEST(PartlyClosedSolid, reports_a_box_with_an_attached_inner_wall_as_open) {
  Soup soup = both(unit_box(), box_between({0, 0, 0}, {1, 1, 1}));
  soup.triangles.resize(unit_box().triangles.size());
  // From one edge of the box to the opposite one.
  const auto at = [&](const Vec3& p) {
    for (uint32_t i = 0; i < soup.positions.size(); ++i) {
      if (soup.positions[i] == p) return i;
    }
    return 0u;
  };
  const uint32_t a = at({0, 0, 0}), b = at({0, 1, 0}), c = at({1, 1, 1}), d = at({1, 0, 1});
  soup.triangles.push_back({a, b, c});
  soup.triangles.push_back({a, c, d});
  soup.triangles_in_file = soup.faces_in_file = soup.triangles.size();
  PartlyClosed cut(soup, slot_through(0.4, kSlotRadius));
  EXPECT_FALSE(cut.notes().empty());
}

// A block 2 x 1 x 2 with a slit of no width in the plane x = 1, from z = 0 to the middle.
Soup slit_block() {
  Soup soup;
  for (const double y : {0, 1}) {
    for (int z = 0; z < 3; ++z) {
      for (int x = 0; x < 3; ++x) soup.positions.emplace_back(x, y, z);
    }
  }
  const auto add_wall = [&](uint32_t from, uint32_t to) {
    soup.triangles.push_back({to, from, from + 9});
    soup.triangles.push_back({to, from + 9, to + 9});
  };
  for (uint32_t z = 0; z < 2; ++z) {
    for (uint32_t x = 0; x < 2; ++x) {
      const uint32_t a = 3 * z + x, b = a + 1, c = b + 3, d = a + 3;
      soup.triangles.insert(soup.triangles.end(), {{a, b, c}, {a, c, d}});
      soup.triangles.insert(soup.triangles.end(), {{a + 9, c + 9, b + 9}, {a + 9, d + 9, c + 9}});
      if (z == 0) add_wall(a, b);
      if (z == 1) add_wall(c, d);
      if (x == 1 || z == 0) add_wall(b, c);
      if (x == 0 || z == 0) add_wall(d, a);
    }
  }
  soup.triangles_in_file = soup.faces_in_file = soup.triangles.size();
  return soup;
}

TEST(PartlyClosedSolid, reports_the_place_of_a_self_contact) {
  PartlyClosed cut(slit_block(), slot_through(0.4, kSlotRadius));
  ASSERT_EQ(cut.notes().size(), 1u);
  EXPECT_NE(cut.notes()[0].find("near (1, "), std::string::npos) << cut.notes()[0];
}

TEST(DoubledFaces, are_reported_on_load) {
  const std::vector<std::string> notes = load_notes(build(both(unit_box(), unit_box())).report);
  EXPECT_TRUE(std::ranges::any_of(notes, [](const std::string& note) {
    return note.starts_with("12 faces coincide with others and face the same way");
  }));
}

struct Reported {
  const char* mesh;
  SolidStroke stroke;
  double removed;  // m^3
  size_t pieces;
};

// The meshes of reports from users, where they are there.
TEST(ReportedTouchingSolids, are_closed) {
  const char* const folder = std::getenv("KERF_TEST_MESHES");
  if (folder == nullptr) GTEST_SKIP() << "KERF_TEST_MESHES names no folder";
  const auto along_x = straight_stroke({-1, 5, 0.4}, {3, 5, 0.4}, {0, -1, 0}, kSlotRadius, {0, 10});
  const auto across_z = straight_stroke({-1, 0.45, 5}, {4, 0.45, 5}, {0, 0, -1}, kSlotRadius, {0, 10});
  for (const Reported& r :
       {Reported{"c30_face.obj", along_x, 0.08, 2}, Reported{"c30_part.obj", along_x, 0.06, 3},
        Reported{"c30_edge.obj", along_x, 0.08, 2}, Reported{"c30_dup.obj", along_x, 0.08, 2},
        Reported{"c31_checker.obj", across_z, 0.2, 2}}) {
    SCOPED_TRACE(r.mesh);
    auto loaded = load_body("body", std::filesystem::path(folder) / "reports" / r.mesh, nullptr);
    ASSERT_TRUE(loaded.ok()) << loaded.error().message;
    World world;
    world.add(std::move(*loaded));
    SolidCut cut(std::move(world));
    const double before = enclosed_volume(cut.body().mesh, cut.body().middle()).volume;
    Random random(1);
    ASSERT_TRUE(cut.draw(r.stroke, random)) << cut.reasons().front();
    EXPECT_NEAR(before - enclosed_volume(cut.body().mesh, cut.body().middle()).volume, r.removed, 1e-6);
    size_t pieces = 0;
    for (uint32_t label = 0; label < cut.body().pieces.size(); ++label)
      pieces += cut.body().pieces[label].faces > 0;
    EXPECT_EQ(pieces, r.pieces);
  }
}

}  // namespace
}  // namespace kerf::test
