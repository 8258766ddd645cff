#include "core/base/root.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "core/base/random.h"

namespace kerf::test {
namespace {

struct Found {
  double at;
  int evaluations;
};

// Checks that the bound `rest` of the function holds on the way.
Found find(const std::function<double(double)>& f, double precision) {
  int evaluations = 0;
  double previous = 0, previous_rest = 1;
  const double at = upper_end_of_root(f(0), f(1), precision, [&](double x, double rest) {
    EXPECT_LE(std::abs(x - previous), previous_rest);
    previous = x;
    previous_rest = rest;
    ++evaluations;
    return f(x);
  });
  return {at, evaluations};
}

constexpr double kPrecision = 0x1p-52;
constexpr int kBisections = 52;

TEST(Root, lies_just_below_the_returned_end_after_few_evaluations) {
  Random random(7);
  for (int i = 0; i < 10000; ++i) {
    const double root = random.unit(), bend = random.uniform(-0.9, 0.9), steep = random.uniform(0.01, 100);
    // Increases from 0 to 1, since |bend| < 1.
    const auto f = [&](double x) { return steep * ((x - root) * (1 + bend * (x + root - 1))); };
    const Found found = find(f, kPrecision);
    EXPECT_NEAR(found.at, root, 4 * kPrecision) << "root " << root << ", bend " << bend;
    EXPECT_LE(found.evaluations, 12) << "root " << root << ", bend " << bend;
  }
}

TEST(Root, takes_at_most_four_evaluations_more_than_bisection) {
  Random random(8);
  for (int i = 0; i < 10000; ++i) {
    const double root = random.unit(), low = -std::exp(random.uniform(-40, 40)),
                 high = std::exp(random.uniform(-40, 40));
    const Found found = find([&](double x) { return x < root ? low : high; }, kPrecision);
    EXPECT_LE(found.evaluations, kBisections + 4) << "root " << root << ", from " << low << " to " << high;
    EXPECT_GE(found.at, root);
    EXPECT_LE(found.at - root, kPrecision);
  }
}

TEST(Root, is_at_the_ends_if_the_sign_does_not_change) {
  EXPECT_EQ(find([](double) { return -1.0; }, kPrecision).at, 1);
  EXPECT_LE(find([](double) { return 1.0; }, kPrecision).at, kPrecision);
}

TEST(Root, is_as_coarse_as_the_precision) {
  const Found found = find([](double x) { return x * x - 0.5; }, 1e-3);
  EXPECT_NEAR(found.at, std::sqrt(0.5), 1e-3);
  EXPECT_LE(found.evaluations, 6);
}

}  // namespace
}  // namespace kerf::test
