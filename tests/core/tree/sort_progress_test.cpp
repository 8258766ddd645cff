#include "core/tree/build_tree.h"

#include <gtest/gtest.h>

#include <vector>

namespace kerf {
namespace {

// Halves a range until nothing is left of it, as a sort does.
void sort(SortProgress& progress, size_t faces) {
  if (faces <= 3) return progress.record_done(faces);
  progress.record_split(faces, faces / 2, faces - faces / 2);
  sort(progress, faces / 2);
  sort(progress, faces - faces / 2);
}

TEST(SortProgress, rises_to_completion_in_at_most_a_hundred_reports) {
  std::vector<double> reports;
  const Progress progress{[&](double done) {
    if (!reports.empty()) EXPECT_GE(done, reports.back());
    reports.push_back(done);
    return true;
  }};
  SortProgress sorting(&progress, 100'000);
  sort(sorting, 100'000);
  EXPECT_LE(reports.size(), 102u);
  EXPECT_GT(reports.size(), 50u);
  EXPECT_GT(reports.back(), 0.98);
  EXPECT_LE(reports.back(), 1);
  EXPECT_FALSE(sorting.stopped());
}

TEST(SortProgress, ends_after_a_single_cancellation) {
  size_t reports = 0;
  const Progress progress{[&](double) { return ++reports < 3; }};
  SortProgress sorting(&progress, 10'000);
  sort(sorting, 10'000);
  EXPECT_TRUE(sorting.stopped());
  EXPECT_EQ(reports, 3u);
}

}  // namespace
}  // namespace kerf
