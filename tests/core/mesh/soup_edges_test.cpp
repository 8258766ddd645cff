#include "core/mesh/soup_topology.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "core/base/random.h"
#include "tests/support/made_meshes.h"

namespace kerf::test {
namespace {

// The sides on each undirected edge, by a map.
std::vector<std::vector<uint32_t>> grouped(const std::vector<Soup::Triangle>& triangles) {
  std::map<std::pair<uint32_t, uint32_t>, std::vector<uint32_t>> of;
  for (uint32_t t = 0; t < triangles.size(); ++t) {
    for (uint32_t i = 0; i < 3; ++i)
      of[std::minmax(triangles[t][i], triangles[t][(i + 1) % 3])].push_back(3 * t + i);
  }
  std::vector<std::vector<uint32_t>> groups;
  for (auto& [edge, sides] : of) groups.push_back(std::move(sides));
  return groups;
}

TEST(SoupEdges, group_the_sides_of_every_class_of_mesh) {
  for (const auto& [name, soup] : mesh_classes()) {
    std::vector<Soup::Triangle> triangles = soup.triangles;
    std::erase_if(triangles,
                  [](const Soup::Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
    const SoupEdges edges = group_sides(triangles, soup.positions.size());
    std::vector<std::vector<uint32_t>> found;
    for (uint32_t e = 0; e < edges.count(); ++e)
      found.emplace_back(edges.sides_of(e).begin(), edges.sides_of(e).end());
    auto expected = grouped(triangles);
    std::sort(found.begin(), found.end());
    std::sort(expected.begin(), expected.end());
    EXPECT_EQ(found, expected) << name;
    EXPECT_EQ(edges.triangles(), triangles.size());
    const std::vector<uint32_t> of_side = edges_of_sides(edges);
    for (uint32_t e = 0; e < edges.count(); ++e) {
      for (const uint32_t side : edges.sides_of(e)) ASSERT_EQ(of_side[side], e) << name;
    }
  }
}

TEST(SoupEdges, of_a_book_group_all_its_sheets) {
  const Soup soup = book(7);
  const SoupEdges edges = group_sides(soup.triangles, soup.positions.size());
  size_t most = 0;
  for (uint32_t e = 0; e < edges.count(); ++e) most = std::max(most, edges.sides_of(e).size());
  EXPECT_EQ(most, 7u);
}

}  // namespace
}  // namespace kerf::test
