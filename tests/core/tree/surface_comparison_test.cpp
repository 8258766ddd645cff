#include "core/tree/surface_comparison.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/deterministic_math.h"
#include "core/mesh/measures.h"
#include "core/tree/point_fit.h"
#include "tests/support/made_meshes.h"
#include "tests/support/strokes.h"

namespace kerf::test {
namespace {

struct Compared {
  explicit Compared(const Soup& soup) : mesh(build(soup).mesh), tree(mesh) {}
  Surface surface() const { return {mesh, tree}; }
  bool closed() const { return enclosed_volume(mesh, Vec3(0)).closed; }

  Mesh mesh;
  AabbTree tree;
};

SurfaceComparison compare(const Soup& a, const Soup& b, Alignment alignment = Alignment::kNone) {
  const Compared one(a), other(b);
  const RigidMotion motion = *align_surfaces(one.surface(), other.surface(), alignment, nullptr);
  return *compare_surfaces(one.surface(), other.surface(), other.closed(), motion, nullptr);
}

Soup turned(Soup soup, const RigidMotion& motion) {
  for (Vec3& p : soup.positions) p = motion.apply(p);
  return soup;
}

RigidMotion random_motion(Random& random, double max_angle, double max_shift) {
  return {axis_angle(random_direction(random), random.uniform(0, max_angle)),
          random.uniform(0, max_shift) * random_direction(random)};
}

// Without symmetry: a long brick with a smaller one at its end and a sphere on its side.
Soup lopsided() {
  return both(both(brick({3, 1, 0.6}), moved(brick({1, 1, 1}), {3.2, 0.5, 0.1}, 0.7)),
              moved(sphere(12, 20, 1), {0.6, 1.6, 0.4}, 0.5));
}

TEST(SurfaceComparison, is_zero_for_equal_surfaces) {
  for (const NamedSoup& named : mesh_classes()) {
    SCOPED_TRACE(named.name);
    const SurfaceComparison same = compare(named.soup, named.soup);
    const Bounds bounds = Compared(named.soup).tree.bounds();
    EXPECT_LE(same.max, 1e-15 * (bounds.diagonal() + glm::length(bounds.centre())));
  }
}

// A square moved along its normal, and within its plane, where only the part beyond the border has a
// distance, which grows linearly.
TEST(SurfaceComparison, matches_the_closed_form_for_a_moved_square) {
  const double side = 2, by = 0.3;
  const SurfaceComparison raised = compare(moved(grid(7, side), {0, by, 0}, 1), plate(side));
  for (const double d : {raised.max, raised.mean, raised.rms, raised.p95}) EXPECT_NEAR(d, by, 1e-12);
  EXPECT_FALSE(raised.signed_by);
  const SurfaceComparison slid = compare(moved(grid(7, side), {by, 0, 0}, 1), plate(side));
  EXPECT_NEAR(slid.max, by, 1e-14);
  EXPECT_NEAR(slid.mean, by * by / (2 * side), 1e-3 * by);
  EXPECT_NEAR(slid.rms, std::sqrt(by * by * by / (3 * side)), 1e-3 * by);
  EXPECT_NEAR(slid.p95, by - 0.05 * side, 1e-3 * by);
}

// The corners of a sphere of triangles, scaled, are nearest to the corners of the sphere, and no point is
// nearer than the planes of the faces are apart.
TEST(SurfaceComparison, has_the_sign_of_the_side_of_a_sphere) {
  const Soup ball = sphere(40, 80, 1);
  const Compared mesh(ball);
  double inner = 1;  // the smallest distance of a face from the middle
  for (uint32_t f = 0; f < mesh.mesh.face_slots(); ++f)
    inner = std::min(inner, std::sqrt(squared_distance(Vec3(0), mesh.mesh.triangle(FaceId(f)))));
  for (const double scale : {1.25, 0.8}) {
    SCOPED_TRACE(scale);
    const SurfaceComparison found = compare(moved(ball, Vec3(0), scale), ball);
    const double apart = std::abs(scale - 1);
    ASSERT_TRUE(found.signed_by);
    EXPECT_GE(found.mean, apart * inner - 1e-12);
    EXPECT_LE(found.max, apart * 1.005);
    if (scale > 1) {
      EXPECT_NEAR(found.max, apart, 1e-12);
      EXPECT_NEAR(found.signed_by->mean, found.mean, 1e-12);
      EXPECT_GT(found.signed_by->min, 0);
      EXPECT_EQ(found.signed_by->max, found.max) << "that of a corner, not of a sample";
    } else {
      EXPECT_NEAR(found.signed_by->mean, -found.mean, 1e-12);
      EXPECT_LT(found.signed_by->max, 0);
      EXPECT_EQ(found.signed_by->min, -found.max);
    }
    const auto& bins = found.signed_by->histogram;
    EXPECT_EQ(std::accumulate(bins.begin(), bins.end(), size_t{0}), SurfaceComparison::kSamples);
    const double width = (found.signed_by->max - found.signed_by->min) / SurfaceComparison::kBins;
    double sum = 0;
    for (size_t i = 0; i < bins.size(); ++i)
      sum += static_cast<double>(bins[i]) * (found.signed_by->min + (static_cast<double>(i) + 0.5) * width);
    EXPECT_NEAR(sum / SurfaceComparison::kSamples, found.signed_by->mean, 0.5 * width + 1e-12);
  }
}

TEST(SurfaceComparison, counts_the_cavity_of_a_solid_as_outside) {
  const Soup hollow = both(sphere(16, 32, 1), inside_out(sphere(16, 32, 0.5)));
  const SurfaceComparison in_wall = compare(sphere(16, 32, 0.75), hollow);
  const SurfaceComparison in_cavity = compare(sphere(16, 32, 0.25), hollow);
  ASSERT_TRUE(in_wall.signed_by && in_cavity.signed_by);
  EXPECT_LT(in_wall.signed_by->max, 0);
  EXPECT_GT(in_cavity.signed_by->min, 0);
}

TEST(SurfaceComparison, has_the_same_digits_for_surfaces_of_any_size) {
  const auto found_at = [](double size) {
    const Soup inner = moved(sphere(8, 16, 1), Vec3(0), size),
               outer = moved(sphere(8, 16, 1.25), Vec3(0), size);
    return compare(outer, inner, Alignment::kCentre);
  };
  const SurfaceComparison plain = found_at(1);
  ASSERT_TRUE(plain.signed_by);
  for (const int exponent : {-400, 400}) {
    SCOPED_TRACE(exponent);
    const double size = std::ldexp(1.0, exponent);
    const SurfaceComparison found = found_at(size);
    ASSERT_TRUE(found.signed_by);
    EXPECT_NEAR(found.max / size, plain.max, 1e-12);
    EXPECT_NEAR(found.mean / size, plain.mean, 1e-12);
    EXPECT_NEAR(found.signed_by->mean / size, plain.signed_by->mean, 1e-12);
  }
}

TEST(SurfaceComparison, spreads_samples_evenly_over_the_area) {
  const Mesh mesh = build(grid(9, 1)).mesh;
  constexpr size_t kSamples = 10'000, kCells = 5;
  std::array<size_t, kCells * kCells> counts{};
  for (const Vec3& p : sample_surface(mesh, kSamples)) {
    const auto cell = [](double x) {
      return std::min<size_t>(static_cast<size_t>((x + 0.5) * kCells), kCells - 1);
    };
    ++counts[cell(p.x) * kCells + cell(p.z)];
  }
  for (const size_t count : counts) EXPECT_NEAR(static_cast<double>(count), 400, 20);
}

TEST(SurfaceAlignment, moves_centroids_together) {
  const SurfaceComparison found = compare(moved(lopsided(), {5, -3, 2}, 1), lopsided(), Alignment::kCentre);
  EXPECT_LT(found.max, 1e-13);
}

TEST(SurfaceAlignment, recovers_a_rigid_motion) {
  for (const uint64_t seed : {1, 2, 3, 4, 5, 6}) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const RigidMotion motion = random_motion(random, kPi, 20);
    const SurfaceComparison found = compare(lopsided(), turned(lopsided(), motion), Alignment::kIcp);
    EXPECT_LT(found.max, 1e-9);
  }
}

// The largest distance of a corner from that of the other soup after their alignment.
double apart_after_alignment(const Soup& a, const Soup& b) {
  const Compared one(a), other(b);
  const RigidMotion found = *align_surfaces(one.surface(), other.surface(), Alignment::kIcp, nullptr);
  double farthest = 0;
  for (size_t i = 0; i < a.positions.size(); ++i)
    farthest = std::max(farthest, glm::distance(found.apply(a.positions[i]), b.positions[i]));
  return farthest;
}

// With its faces in another order, a surface has other samples, so that the motion must be refined.
TEST(SurfaceAlignment, recovers_a_rigid_motion_from_other_samples_of_the_same_surface) {
  for (const uint64_t seed : {1, 2, 3}) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    Soup part = lopsided();
    std::ranges::reverse(part.triangles);
    EXPECT_LT(apart_after_alignment(part, turned(lopsided(), random_motion(random, kPi, 20))), 1e-9);
  }
}

// Twelve plates around an axis, each longer than the one before.
Soup paddles() {
  constexpr int kPaddles = 12;
  Soup soup;
  for (int i = 0; i < kPaddles; ++i) {
    const RigidMotion turn{axis_angle({0, 0, 1}, 2 * kPi * i / kPaddles), Vec3(0)};
    soup = both(soup, turned(moved(brick({1, 0.05, 1 + 0.1 * i}), {1, 0, 0}, 1), turn));
  }
  return soup;
}

// Wherever a plate lies on another one, the distances have a local minimum: the start must be near.
TEST(SurfaceAlignment, starts_from_the_principal_axes_of_both_surfaces) {
  for (const uint64_t seed : {1, 2, 3, 4, 5, 6}) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const Soup part = turned(paddles(), random_motion(random, kPi, 5)),
               whole = turned(paddles(), random_motion(random, kPi, 5));
    EXPECT_LT(apart_after_alignment(part, whole), 1e-9);
  }
}

// Principal axes say nothing about a cube; small motions are recovered from where it stands.
TEST(SurfaceAlignment, recovers_a_small_motion_of_a_symmetric_part) {
  for (const uint64_t seed : {1, 2, 3}) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const Soup cube = brick({1, 1, 1});
    const SurfaceComparison found =
        compare(cube, turned(cube, random_motion(random, 0.2, 0.1)), Alignment::kIcp);
    EXPECT_LT(found.max, 1e-9);
  }
}

// A dent of one corner stays visible: the rest is aligned.
TEST(SurfaceAlignment, leaves_the_distance_of_a_difference) {
  Soup dented = sphere(40, 80, 1);
  for (Vec3& p : dented.positions) {
    if (p.y > 0.95) p *= 0.9;
  }
  Random random(11);
  const RigidMotion motion = random_motion(random, 0.3, 0.3);
  const SurfaceComparison found = compare(turned(dented, motion), sphere(40, 80, 1), Alignment::kIcp);
  EXPECT_NEAR(found.max, 0.1, 0.02);
  EXPECT_LT(found.rms, 0.02);
}

TEST(SurfaceAlignment, stops_when_cancelled) {
  const Compared one(lopsided()), other(sphere(10, 20, 1));
  const Progress stop{[](double) { return false; }};
  EXPECT_FALSE(align_surfaces(one.surface(), other.surface(), Alignment::kIcp, &stop));
  EXPECT_FALSE(compare_surfaces(one.surface(), other.surface(), true, {}, &stop));
}

TEST(PointFit, recovers_a_rigid_motion_of_points) {
  for (uint64_t seed = 1; seed <= 30; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const RigidMotion motion = random_motion(random, kPi, 20);
    std::vector<std::pair<Vec3, Vec3>> pairs;
    for (uint64_t i = 4 + random.below(5); i > 0; --i) {
      const Vec3 p(random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(-3, 3));
      pairs.emplace_back(p, motion.apply(p));
    }
    ASSERT_TRUE(determine_motion(pairs));
    const RigidMotion found = fit_points(pairs);
    for (const auto& [from, to] : pairs) EXPECT_LT(glm::distance(found.apply(from), to), 1e-9);
    pairs.resize(2);
    EXPECT_FALSE(determine_motion(pairs));
    pairs.emplace_back(0.5 * (pairs[0].first + pairs[1].first), 0.5 * (pairs[0].second + pairs[1].second));
    EXPECT_FALSE(determine_motion(pairs)) << "points on a line";
  }
}

}  // namespace
}  // namespace kerf::test
