#include "core/graph/component_graph.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "core/document/document.h"
#include "core/edit/detach.h"
#include "core/edit/separation.h"
#include "tests/support/made_meshes.h"
#include "tests/support/runs.h"
#include "tests/support/strokes.h"

namespace kerf::test {
namespace {

// The components of each piece, by a search of the whole mesh.
std::map<PieceId, std::set<uint32_t>> components_of(const World& world) {
  std::map<PieceId, std::set<uint32_t>> all;
  for (const BodyId id : world.ids()) {
    const Mesh& mesh = world.body(id).mesh;
    std::vector<uint32_t> component;
    label_components(mesh, component);
    for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
      if (mesh.is_live(FaceId(f))) all[{id, mesh.data(FaceId(f)).piece}].insert(component[f]);
    }
  }
  return all;
}

TEST(PieceNode, counts_the_parts_of_each_piece_like_a_mesh_search) {
  size_t several = 0, off = 0;
  for (uint64_t seed = 1; seed <= runs(16); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Soup two = both(grid(10, 2), moved(grid(10, 2), {0.3, 0.5, 0.1}, 1));
    World world = cut_at_random(seed % 4 == 0 ? sphere(10, 12, 1) : two, seed);
    if (seed % 2 == 0 && world.live_pieces() > 1) {
      Delta delta;
      const std::vector<PieceNode> nodes = piece_nodes(world);
      detach(world, nodes.back().piece, 1, delta);
    }
    const auto expected = components_of(world);
    const std::vector<PieceNode> nodes = piece_nodes(world);
    ASSERT_EQ(nodes.size(), expected.size());
    auto it = expected.begin();
    for (const PieceNode& node : nodes) {
      EXPECT_EQ(node.piece, it->first);
      EXPECT_EQ(node.parts, it->second.size()) << "piece " << node.piece.label;
      several += node.parts > 1;
      off += node.piece.label != 0;
      ++it;
    }
  }
  EXPECT_GT(several, 0u);
  EXPECT_GT(off, 0u);
}

TEST(PieceNode, does_not_count_a_removed_part) {
  Document document(world_of(both(grid(10, 2), moved(plate(0.1), {3, 0, 0}, 1))));
  EXPECT_EQ(piece_nodes(document.world()).front().parts, 2u);
  CutSettings settings;
  settings.laser.radius = 0.5;
  document.apply(BeginStroke{settings, {{3, 1, 0}, {0, -1, 0}}});
  document.apply(EndStroke{});
  ASSERT_TRUE(run_all(document).ok());
  const std::vector<PieceNode> nodes = piece_nodes(document.world());
  ASSERT_EQ(nodes.size(), 1u);
  EXPECT_EQ(nodes[0].parts, 1u);
  EXPECT_EQ(nodes[0].held_by, Holder::kItself);
}

TEST(PieceNode, is_held_by_its_body_or_pin_until_it_comes_off) {
  World world = cut_at_random(grid(12, 2), 3);
  const BodyId id = world.ids()[0];
  ASSERT_GT(world.live_pieces(), 1u);
  const auto holders = [&] {
    std::vector<Holder> all;
    for (const PieceNode& node : piece_nodes(world)) all.push_back(node.held_by);
    return all;
  };
  std::vector<Holder> expected(world.live_pieces(), Holder::kNothing);
  expected[0] = Holder::kItself;
  EXPECT_EQ(holders(), expected);
  for (const PieceNode& node : piece_nodes(world)) EXPECT_EQ(node.beside, world.live_pieces() - 1);
  world.body(id).pinned = true;
  expected[0] = Holder::kPin;
  EXPECT_EQ(holders(), expected);
  Delta delta;
  const PieceId piece = piece_nodes(world).back().piece;
  const BodyId own = detach(world, piece, 1, delta);
  world.body(own).pinned = true;
  for (const PieceNode& node : piece_nodes(world)) {
    if (node.piece.body != own) continue;
    EXPECT_EQ(node.held_by, Holder::kPin) << "a pinned body of its own";
    EXPECT_EQ(node.beside, 0u);
  }
}

TEST(PieceNode, of_several_parts_is_held_by_its_body) {
  const World world = world_of(both(plate(1), moved(plate(1), {3, 0, 0}, 1)));
  const std::vector<PieceNode> nodes = piece_nodes(world);
  ASSERT_EQ(nodes.size(), 1u);
  EXPECT_EQ(nodes[0].parts, 2u);
  EXPECT_EQ(nodes[0].held_by, Holder::kBody);
}

}  // namespace
}  // namespace kerf::test
