#include "ui/editor/inspect/scalar_map.h"

#include <gtest/gtest.h>

#include <numeric>

namespace kerf {
namespace {

using List = std::shared_ptr<const FaceScalars>;

List list_of(FaceScalars values) { return std::make_shared<const FaceScalars>(std::move(values)); }

TEST(Histogram, counts_every_value_once_and_skips_faces_without_one) {
  const std::vector<List> lists{list_of({1, 2, kNoScalar, 5}), list_of({3, kNoScalar})};
  const Histogram h = histogram_of(lists, 4, false);
  EXPECT_EQ(h.faces, 4u);
  EXPECT_EQ(std::accumulate(h.bins.begin(), h.bins.end(), size_t{0}), 4u);
  EXPECT_EQ(h.least, 1);
  EXPECT_EQ(h.most, 5);
  EXPECT_EQ(h.bins, (std::vector<size_t>{1, 1, 1, 1})) << "the largest value is in the last bin";
}

TEST(Histogram, integers_have_one_bin_each) {
  const std::vector<List> lists{list_of({0, 0, 1, 3, 3, 3})};
  const Histogram h = histogram_of(lists, 64, true);
  EXPECT_EQ(h.bins, (std::vector<size_t>{2, 1, 0, 3}));
  EXPECT_EQ(h.from, -0.5);
  EXPECT_EQ(h.to, 3.5);
}

TEST(Histogram, has_a_positive_width_for_equal_or_missing_values) {
  const std::vector<List> equal{list_of({7, 7})}, none{list_of({kNoScalar})};
  for (const auto& lists : {equal, none}) {
    const Histogram h = histogram_of(lists, 8, false);
    EXPECT_LT(h.from, h.to);
    EXPECT_EQ(h.bins.size(), 8u);
  }
  EXPECT_EQ(histogram_of(none, 8, false).faces, 0u);
}

TEST(Histogram, a_quantile_excludes_a_fraction_of_the_faces) {
  FaceScalars values;
  for (int i = 0; i < 1000; ++i) values.push_back(static_cast<float>(i) / 1000);
  values.push_back(100);
  const std::vector<List> lists{list_of(values)};
  const Histogram h = histogram_of(lists, 64, false);
  EXPECT_LT(h.quantile(0.99), 2);
  EXPECT_EQ(h.quantile(1), 100);
  EXPECT_EQ(h.quantile(0), 0);
}

TEST(ScalarRange, is_never_empty_for_a_float) {
  for (const double x : {0.0, 1.0, -3.0, 1e-9, 1e9}) {
    const ScalarRange range = range_between(x, x);
    EXPECT_LT(static_cast<float>(range.low), static_cast<float>(range.high)) << x;
  }
}

}  // namespace
}  // namespace kerf
