#include "core/physics/contact/collider.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/random.h"

namespace kerf {
namespace {

using Segments = std::vector<std::array<Vec3, 2>>;

Segments random_segments(size_t count, Random& random) {
  const auto point = [&] { return Vec3(random.uniform(0, 10), random.unit(), random.unit()); };
  Segments segments;
  for (size_t i = 0; i < count; ++i) {
    const Vec3 from = point();
    segments.push_back({from, from + 0.1 * point()});
  }
  return segments;
}

bool overlap(const Cluster& cluster, const Box& box) {
  return Box{cluster.centre, cluster.centre}.wider(cluster.radius).overlaps(box);
}

// The items that are visited near a box, and how many clusters were tested.
struct Visit {
  std::vector<uint32_t> items;
  size_t tested = 0;
};

Visit visit(const Clusters& clusters, const Box& box) {
  Visit visit;
  const auto near = [&](const Cluster& cluster) {
    ++visit.tested;
    return overlap(cluster, box);
  };
  clusters.for_each(near, [&](uint32_t i) { visit.items.push_back(i); });
  return visit;
}

const Box kEverywhere{Vec3(-1e9), Vec3(1e9)};

TEST(Clusters, contain_each_item_once_in_list_order) {
  Random random(1);
  for (const size_t count : {1u, 8u, 9u, 100u, 777u}) {
    Clustering clustering = make_clusters(random_segments(count, random));
    const Visit all = visit(clustering.clusters, kEverywhere);
    ASSERT_EQ(all.items.size(), count);
    std::ranges::sort(clustering.order);
    for (uint32_t i = 0; i < count; ++i) {
      ASSERT_EQ(all.items[i], i);
      ASSERT_EQ(clustering.order[i], i);
    }
  }
}

TEST(Clusters, find_every_item_near_a_box) {
  Random random(2);
  const Segments segments = random_segments(500, random);
  const Clustering clustering = make_clusters(segments);
  for (int turn = 0; turn < 100; ++turn) {
    const Vec3 corner(random.uniform(0, 10), random.unit(), random.unit());
    const Box box{corner, corner + random.uniform(0, 1)};
    const Visit near = visit(clustering.clusters, box);
    for (uint32_t i = 0; i < segments.size(); ++i) {
      const auto& [from, to] = segments[clustering.order[i]];
      if (Box{glm::min(from, to), glm::max(from, to)}.overlaps(box))
        ASSERT_TRUE(std::ranges::binary_search(near.items, i)) << "item " << i << " in turn " << turn;
    }
  }
}

TEST(Clusters, prune_a_long_row_with_few_tests) {
  Segments segments;
  for (int i = 0; i < 4096; ++i) segments.push_back({Vec3(37 * i % 4096, 0, 0), Vec3(37 * i % 4096, 0, 0)});
  const Visit at_the_end = visit(make_clusters(segments).clusters, {Vec3(4095), Vec3(4096)});
  EXPECT_TRUE(at_the_end.items.empty());
  const Visit near = visit(make_clusters(segments).clusters, {Vec3(0, -1, -1), Vec3(3, 1, 1)});
  EXPECT_EQ(near.items.size(), 8u);
  EXPECT_LT(near.tested, 40u) << "of 512 clusters of items";
}

TEST(Clusters, any_of_stops_at_the_first_match) {
  Random random(3);
  const Clustering clustering = make_clusters(random_segments(100, random));
  const auto near = [](const Cluster&) { return true; };
  uint32_t visited = 0;
  EXPECT_TRUE(clustering.clusters.any_of(near, [&](uint32_t i) {
    ++visited;
    return i == 20;
  }));
  EXPECT_EQ(visited, 21u);
  EXPECT_FALSE(clustering.clusters.any_of(near, [](uint32_t) { return false; }));
}

TEST(Clusters, are_empty_without_items) {
  EXPECT_TRUE(visit(make_clusters({}).clusters, kEverywhere).items.empty());
}

}  // namespace
}  // namespace kerf
