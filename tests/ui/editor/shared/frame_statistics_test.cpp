#include <gtest/gtest.h>

#include "ui/editor/shared/statistics.h"

namespace kerf {
namespace {

TEST(FrameStatistics, returns_nearest_rank_percentiles) {
  FrameStatistics frames;
  EXPECT_EQ(frames.percentile(0.5), 0);
  for (int i = 100; i >= 1; --i) frames.add(i);
  EXPECT_EQ(frames.percentile(0.5), 50);
  EXPECT_EQ(frames.percentile(0.99), 99);
  EXPECT_EQ(frames.longest(), 100);
  EXPECT_EQ(frames.frames(), 100u);
}

}  // namespace
}  // namespace kerf
