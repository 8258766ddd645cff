#include "core/physics/collider/cluster.h"

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

TEST(Clusters, hold_each_item_once_and_at_most_eight_within_their_balls) {
  Random random(1);
  for (const size_t count : {1u, 8u, 9u, 100u, 777u}) {
    const Segments segments = random_segments(count, random);
    const Clustering clustering = make_clusters(segments);
    std::vector<uint32_t> order = clustering.order;
    std::sort(order.begin(), order.end());
    for (uint32_t i = 0; i < count; ++i) ASSERT_EQ(order[i], i);
    uint32_t end = 0;
    for (const Cluster& cluster : clustering.clusters) {
      ASSERT_EQ(cluster.begin, end);
      end = cluster.end;
      ASSERT_TRUE(cluster.begin < cluster.end && cluster.end - cluster.begin <= 8);
      for (uint32_t i = cluster.begin; i < cluster.end; ++i) {
        for (const Vec3& p : segments[clustering.order[i]])
          ASSERT_LE(glm::distance(p, cluster.centre), cluster.radius + 1e-12);
      }
    }
    ASSERT_EQ(end, count);
  }
}

TEST(Clusters, of_a_long_row_lie_beside_each_other) {
  Segments segments;
  for (int i = 0; i < 64; ++i) segments.push_back({Vec3(37 * i % 64, 0, 0), Vec3(37 * i % 64, 0, 0)});
  for (const Cluster& cluster : make_clusters(segments).clusters) EXPECT_LE(cluster.radius, 3.5 + 1e-12);
}

TEST(Clusters, of_nothing_are_none) { EXPECT_TRUE(make_clusters({}).clusters.empty()); }

}  // namespace
}  // namespace kerf
