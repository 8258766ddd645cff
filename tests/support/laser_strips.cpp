#include "tests/support/laser_strips.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "core/cut/cut_step.h"
#include "tests/support/sheets.h"

namespace kerf::test {

namespace {

constexpr double kLengthInKerfs = 30;

double width_of(const LaserStrip& strip, double speed) {
  const Substance& s = strip.substance;
  const double diffusion = s.conductivity / (s.density * s.heat_solid * speed);
  return std::max(20 * strip.kerf, 20 * diffusion);
}

}  // namespace

World cross(const LaserStrip& strip, double speed) {
  World world;
  const double length = kLengthInKerfs * strip.kerf, run_up = 2 * strip.kerf, height = 0.1;
  Body& body = world.body(add(world, rectangle(width_of(strip, speed), length, 1), Vec3(0)));
  body.sheet = {strip.thickness, strip.substance.density, strip.substance};

  CutSettings settings;
  settings.model = Model::kThermal;
  settings.laser.radius = 0.5 * strip.kerf;
  settings.laser.range = {0, 1};
  settings.laser.power = strip.power;
  settings.laser.assist = strip.assist;
  settings.resolution.target_edge = strip.target_edge * settings.laser.radius;
  const double end = 0.5 * length + run_up;
  const BeamMove way{{{0, height, -end}, {0, -1, 0}}, {{0, height, end}, {0, -1, 0}}, 2 * end / speed};
  for (const BeamMove& move : subdivide(way, settings.laser.radius, height)) {
    UnfinishedMove unfinished;
    if (!cut_step(world, settings, {&move, 1}, unfinished)) throw std::runtime_error("the strip was not cut");
  }
  while (!is_settled(world)) continue_separation(world, 1000);
  return world;
}

bool is_in_two(const World& world) {
  double area = 0, largest = 0, second = 0;
  for (const BodyId id : world.ids()) {
    const Records<Piece>& pieces = world.body(id).pieces;
    for (uint32_t p = 0; p < pieces.size(); ++p) {
      area += pieces[p].area;
      second = std::max(second, std::min(largest, pieces[p].area));
      largest = std::max(largest, pieces[p].area);
    }
  }
  return second > 0.25 * area;
}

double fastest_cut(const LaserStrip& strip, double slowest, double guess) {
  assert(0 < slowest && slowest <= guess);
  constexpr double kStep = 1.3, kExact = 1.02;
  const auto cuts = [&](double speed) { return is_in_two(cross(strip, speed)); };
  double low = guess;
  while (!cuts(low)) {
    if (low <= slowest) return 0;
    low = std::max(slowest, low / kStep);
  }
  double high = kStep * low;
  while (low >= guess && cuts(high)) low = std::exchange(high, kStep * high);
  while (high > kExact * low) {
    const double middle = std::sqrt(low * high);
    (cuts(middle) ? low : high) = middle;
  }
  return low;
}

}  // namespace kerf::test
