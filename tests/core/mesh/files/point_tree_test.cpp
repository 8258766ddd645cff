#include "core/mesh/files/triangulation.h"

#include <gtest/gtest.h>

#include <array>
#include <numeric>
#include <set>
#include <utility>

#include "core/base/random.h"

namespace kerf {
namespace {

using Verdict = PointTree::Verdict;

class RandomPoints : public testing::Test {
 protected:
  RandomPoints() {
    for (int i = 0; i < 500; ++i) points_.emplace_back(random_.unit(), random_.unit());
    selected_.resize(points_.size());
    std::iota(selected_.begin(), selected_.end(), 0u);
    tree_.build(points_, selected_);
  }
  static double side(const Vec2& a, const Vec2& b, const Vec2& p) {
    return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
  }
  std::array<Vec2, 3> random_triangle() {
    std::array<Vec2, 3> t;
    for (Vec2& corner : t) corner = {random_.unit(), random_.unit()};
    if (side(t[0], t[1], t[2]) < 0) std::swap(t[1], t[2]);
    return t;
  }
  std::set<uint32_t> within(const std::array<Vec2, 3>& t) const {
    std::set<uint32_t> found;
    for (const uint32_t i : selected_) {
      const Vec2& p = points_[i];
      if (side(t[0], t[1], p) >= 0 && side(t[1], t[2], p) >= 0 && side(t[2], t[0], p) >= 0) found.insert(i);
    }
    return found;
  }

  Random random_{8};
  std::vector<Vec2> points_;
  std::vector<uint32_t> selected_;
  PointTree tree_;
};

TEST_F(RandomPoints, inside_a_triangle_are_visited_exactly_once) {
  for (int i = 0; i < 100; ++i) {
    const auto triangle = random_triangle();
    std::multiset<uint32_t> visited;
    uint64_t work = 0;
    EXPECT_FALSE(tree_.visit(triangle, work, [&](uint32_t p) {
      visited.insert(p);
      return Verdict::kPass;
    }));
    for (const uint32_t p : within(triangle)) ASSERT_EQ(visited.count(p), 1u);
    EXPECT_GE(work, visited.size());
  }
}

TEST_F(RandomPoints, are_not_visited_after_removal) {
  const std::array<Vec2, 3> all{Vec2(-9, -9), Vec2(9, -9), Vec2(0, 9)};
  uint64_t work = 0;
  size_t first = 0, second = 0;
  tree_.visit(all, work, [&](uint32_t p) {
    ++first;
    return p % 3 == 0 ? Verdict::kForget : Verdict::kPass;
  });
  tree_.visit(all, work, [&](uint32_t p) {
    ++second;
    EXPECT_NE(p % 3, 0u);
    return Verdict::kPass;
  });
  EXPECT_EQ(first, 500u);
  EXPECT_EQ(second, 333u);
}

TEST_F(RandomPoints, visit_ends_on_request) {
  uint64_t work = 0;
  size_t visited = 0;
  EXPECT_TRUE(tree_.visit({Vec2(-9, -9), Vec2(9, -9), Vec2(0, 9)}, work,
                          [&](uint32_t) { return ++visited == 10 ? Verdict::kStop : Verdict::kPass; }));
  EXPECT_EQ(visited, 10u);
}

}  // namespace
}  // namespace kerf
