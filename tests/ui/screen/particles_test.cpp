#include "ui/render/passes/beam_effects.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace kerf {
namespace {

const Vec3 kUp(0, 1, 0);

Effects effects_of(const Particles& particles) {
  Effects effects;
  particles.append_to(effects);
  return effects;
}

// A beam that points at the ground, 1 m above it, and has removed some mass (kg).
Particles emitted(double mass, double size = 1) {
  Particles particles;
  particles.add({{0, 1, 0}, {0, -1, 0}, size, mass}, kUp);
  return particles;
}

TEST(Particles, are_as_many_for_one_large_removal_as_for_many_small_ones) {
  Particles short_ones;
  for (int i = 0; i < 1000; ++i) short_ones.add({{0, 1, 0}, {0, -1, 0}, 1, 0.001}, kUp);
  const Effects once = effects_of(emitted(1)), often = effects_of(short_ones);
  EXPECT_NEAR(static_cast<double>(once.sparks.size()), static_cast<double>(often.sparks.size()), 1);
  EXPECT_NEAR(static_cast<double>(once.puffs.size()), static_cast<double>(often.puffs.size()), 1);
  EXPECT_GT(once.sparks.size(), once.puffs.size());
}

TEST(Particles, are_proportional_to_mass_relative_to_size) {
  const auto sparks = [](double mass, double size) {
    return static_cast<double>(effects_of(emitted(mass, size)).sparks.size());
  };
  EXPECT_NEAR(sparks(1, 1), 2 * sparks(0.5, 1), 2);
  EXPECT_NEAR(sparks(1, 1), sparks(0.25, 0.5), 1);
  EXPECT_EQ(sparks(0, 1), 0);
}

TEST(Particles, are_bounded_in_number) {
  const Effects effects = effects_of(emitted(1000));
  EXPECT_LE(effects.sparks.size(), 1200u);
  EXPECT_LE(effects.puffs.size(), 160u);
}

TEST(Particles, sparks_stay_above_the_ground_and_cool_while_smoke_fades) {
  Particles particles = emitted(1);
  for (int frame = 0; frame < 30; ++frame) {
    particles.advance(1 / 60.0, kUp, 0.5);
    for (const Spark& s : effects_of(particles).sparks) EXPECT_GE(glm::dot(s.at, kUp), 0.5 - 1e-12);
  }
  const Effects later = effects_of(particles);
  ASSERT_FALSE(later.sparks.empty());
  EXPECT_TRUE(std::all_of(later.sparks.begin(), later.sparks.end(),
                          [](const Spark& s) { return s.heat > 0 && s.heat < 0.5; }));
}

TEST(Particles, disappear_two_seconds_after_the_last_removal) {
  Particles particles = emitted(1);
  EXPECT_FALSE(particles.empty());
  for (int frame = 0; frame < 120; ++frame) particles.advance(1 / 60.0, kUp, 0);
  EXPECT_TRUE(particles.empty());
}

TEST(Particles, stay_near_a_small_object) {
  const auto farthest = [](double size) {
    Particles particles = emitted(0.5 * size * size, size);
    for (int frame = 0; frame < 12; ++frame) particles.advance(1 / 60.0, kUp, -10);
    double most = 0;
    for (const Spark& s : effects_of(particles).sparks)
      most = std::max(most, glm::length(s.at - Vec3(0, 1, 0)));
    return most;
  };
  EXPECT_NEAR(farthest(0.01), 0.01 * farthest(1), 1e-9);
}

}  // namespace
}  // namespace kerf
