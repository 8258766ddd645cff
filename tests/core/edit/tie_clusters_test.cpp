#include "core/edit/part_search.h"

#include <gtest/gtest.h>

#include "core/base/random.h"

namespace kerf {
namespace {

using Tie = std::pair<FaceId, FaceId>;

TEST(TieClusters, list_faces_in_order_of_appearance_and_join_tied_ones) {
  const std::vector<Tie> ties{
      {FaceId(7), FaceId(3)}, {FaceId(9), FaceId(4)}, {FaceId(3), FaceId(5)}, {FaceId(7), FaceId(3)}};
  PagedArray<uint32_t> scratch;
  TieClusters clusters(ties, scratch);
  ASSERT_EQ(clusters.faces().size(), 5u);
  EXPECT_EQ(clusters.faces()[0], FaceId(7));
  EXPECT_EQ(clusters.faces()[1], FaceId(3));
  EXPECT_EQ(clusters.faces()[4], FaceId(5));
  EXPECT_EQ(clusters.cluster(0), 0u);
  EXPECT_EQ(clusters.cluster(1), 0u);
  EXPECT_EQ(clusters.cluster(4), 0u);
  EXPECT_EQ(clusters.cluster(2), 2u);
  EXPECT_EQ(clusters.cluster(3), 2u);
}

TEST(TieClusters, restore_their_scratch_buffer) {
  Random random(3);
  PagedArray<uint32_t> scratch;
  std::vector<Tie> ties;
  for (int i = 0; i < 300; ++i)
    ties.emplace_back(static_cast<uint32_t>(random.below(400)), static_cast<uint32_t>(random.below(400)));
  const TieClusters once(ties, scratch);
  for (uint32_t f = 0; f < 400; ++f) ASSERT_EQ(scratch.get(f), 0u);
  EXPECT_EQ(TieClusters(ties, scratch).faces().size(), once.faces().size());
}

TEST(TieClusters, are_empty_without_ties) {
  PagedArray<uint32_t> scratch;
  EXPECT_TRUE(TieClusters({}, scratch).faces().empty());
}

}  // namespace
}  // namespace kerf
