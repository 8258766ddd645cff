#include "core/graph/component_graph.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "tests/support/made_meshes.h"
#include "tests/support/runs.h"
#include "tests/support/strokes.h"

namespace kerf::test {
namespace {

struct Cut {
  World world;
  CutFaces removed;
  size_t closings() const {
    size_t count = 0;
    for (const auto& [id, faces] : removed) {
      for (const CutFace& f : faces) count += f.closed_loop;
    }
    return count;
  }
};

Cut cut_along(const Soup& soup, const CutSettings& settings, const std::vector<BeamMove>& moves) {
  Cut cut{world_of(soup), {}};
  auto done = cut_whole(cut.world, settings, moves);
  EXPECT_TRUE(done.ok());
  for (const BodyDelta& b : done->delta.bodies) {
    if (!b.removed.empty()) cut.removed[b.body] = b.removed;
  }
  return cut;
}

// Whether a way leads along an edge of a removed face, or along a part of one.
bool is_on_an_edge(const std::vector<CutFace>& faces, const Vec3& a, const Vec3& b) {
  const double length = glm::length(b - a);
  for (const CutFace& f : faces) {
    for (size_t i = 0; i < 3; ++i) {
      const Vec3 u = f.corners[i], v = f.corners[(i + 1) % 3];
      const double edge = glm::length(v - u), slack = 1e-9 * edge;
      const auto lies_on = [&](const Vec3& p) {
        return glm::length(p - u) + glm::length(v - p) <= edge + slack;
      };
      if (length <= edge + slack && lies_on(a) && lies_on(b)) return true;
    }
  }
  return false;
}

// Around the axis, as often as the line runs around it.
double turns_about_y(const std::vector<Vec3>& points) {
  double turned = 0;
  for (size_t i = 0; i < points.size(); ++i) {
    const Vec3 a = points[i], b = points[(i + 1) % points.size()];
    turned += std::remainder(std::atan2(b.z, b.x) - std::atan2(a.z, a.x), 2 * 3.14159265358979);
  }
  return turned / (2 * 3.14159265358979);
}

CutSettings fine(double radius) {
  CutSettings settings;
  settings.laser.radius = radius;
  settings.resolution.target_edge = radius;
  return settings;
}

TEST(LoopPaths, surround_a_ball_cut_in_two) {
  const Vec3 forward(0, 0, -1);
  const Cut cut =
      cut_along(sphere(12, 16, 1), fine(0.06), {{{{-1.4, 0.1, 3}, forward}, {{1.4, 0.1, 3}, forward}}});
  const std::vector<LoopPath> paths = loop_paths(cut.world, cut.removed);
  ASSERT_EQ(paths.size(), cut.closings());
  size_t around = 0;
  for (const LoopPath& path : paths) {
    EXPECT_TRUE(path.runs_around);
    around += std::abs(std::abs(turns_about_y(path.points)) - 1) < 1e-6;
  }
  EXPECT_GE(around, 1u);
}

TEST(LoopPaths, run_from_border_to_border_across_a_sheet) {
  const Vec3 down(0, -1, 0);
  const Cut cut = cut_along(grid(10, 2), fine(0.05), {{{{0.13, 3, -1.3}, down}, {{0.13, 3, 1.3}, down}}});
  bool across = false;
  for (const LoopPath& path : loop_paths(cut.world, cut.removed)) {
    if (path.runs_around) continue;
    across |= std::abs(path.points.front().z - path.points.back().z) > 1.99;
    for (const Vec3& end : {path.points.front(), path.points.back()})
      EXPECT_NEAR(std::abs(end.z), 1, 1e-9) << "a border of the sheet";
  }
  EXPECT_TRUE(across);
}

TEST(LoopPaths, of_random_cuts_follow_edges_removed_earlier) {
  size_t found = 0, closings = 0;
  for (uint64_t seed = 1; seed <= runs(20); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    Cut cut{world_of(sphere(12, 16, 1)), {}};
    const RandomStroke stroke = random_stroke(cut.world, random, 0.05, true);
    auto done = cut_whole(cut.world, stroke.settings, stroke.moves);
    ASSERT_TRUE(done.ok());
    for (const BodyDelta& b : done->delta.bodies) cut.removed[b.body] = b.removed;
    const std::vector<LoopPath> paths = loop_paths(cut.world, cut.removed);
    closings += cut.closings();
    found += paths.size();
    if (cut.removed.empty()) continue;
    const std::vector<CutFace>& faces = cut.removed.begin()->second;
    for (const LoopPath& path : paths) {
      ASSERT_LE(path.removal, faces.size());
      EXPECT_TRUE(faces[path.removal - 1].closed_loop);
      const std::vector<CutFace> so_far(faces.begin(), faces.begin() + static_cast<ptrdiff_t>(path.removal));
      for (size_t i = 0; i < path.points.size(); ++i) {
        ASSERT_TRUE(is_on_an_edge(so_far, path.points[i], path.points[(i + 1) % path.points.size()]))
            << "removal " << path.removal << ", point " << i;
      }
    }
  }
  EXPECT_GT(closings, 4 * runs(20));
  EXPECT_EQ(found, closings);
}

TEST(LoopPaths, count_no_removals_of_bodies_that_no_longer_exist) {
  World world;
  const BodyId deleted = world.add(make_body("deleted", build(sphere(12, 16, 1))));
  const BodyId ball = world.add(make_body("ball", build(sphere(12, 16, 1))));
  const Vec3 forward(0, 0, -1);
  const auto done = cut_whole(world, fine(0.06),
                              std::vector<BeamMove>{{{{-1.4, 0.1, 3}, forward}, {{1.4, 0.1, 3}, forward}}});
  ASSERT_TRUE(done.ok());
  CutFaces removed;
  for (const BodyDelta& b : done->delta.bodies) removed[b.body] = b.removed;
  ASSERT_FALSE(removed[deleted].empty());
  world.remove(deleted);
  const std::vector<LoopPath> paths = loop_paths(world, removed),
                              of_ball = loop_paths(world, {{ball, removed[ball]}});
  ASSERT_EQ(paths.size(), of_ball.size());
  EXPECT_FALSE(paths.empty());
  for (size_t i = 0; i < paths.size(); ++i) EXPECT_EQ(paths[i].removal, of_ball[i].removal);
}

TEST(LoopPaths, are_omitted_when_the_visit_limit_is_reached) {
  const Vec3 forward(0, 0, -1);
  const Cut cut =
      cut_along(sphere(12, 16, 1), fine(0.06), {{{{-1.4, 0.1, 3}, forward}, {{1.4, 0.1, 3}, forward}}});
  EXPECT_LT(loop_paths(cut.world, cut.removed, 10).size(), cut.closings());
}

}  // namespace
}  // namespace kerf::test
