#include <cmath>
#include <cstdio>
#include <string>

#include "core/base/random.h"
#include "core/mesh/build_mesh.h"
#include "core/world/body_mass.h"
#include "tests/bench/sections.h"
#include "tests/bench/slot_walk.h"
#include "tests/bench/timing.h"

namespace kerf::bench {

namespace {

constexpr double kPi = 3.141592653589793;
constexpr double kRadius = 0.012, kTargetEdge = 0.012;  // m
constexpr double kBeam = 8;                             // m, its length
constexpr double kShortest = 0.1, kLongest = 0.4;       // m, of a slot
constexpr double kLaterBar = 1.5;                       // the last cuts, relative to the first ones

// Random slots through the tube: some end in it, others cut it through.
std::vector<SlotBar> random_slots(const TrefoilKnot& knot, size_t count) {
  Random random(68);
  std::vector<SlotBar> slots;
  for (size_t i = 0; i < count; ++i) {
    const Vec3 beam = random_direction(random);
    const Vec3 along = glm::normalize(glm::cross(beam, random_direction(random)));
    const Vec3 middle = knot.middle(random.uniform(0, 2 * kPi)) + knot.radius * random_direction(random);
    slots.push_back({middle, along, beam, random.uniform(kShortest, kLongest), kRadius});
  }
  return slots;
}

std::vector<BeamMove> path_of(const SlotBar& slot) {
  const int moves = static_cast<int>(std::ceil(slot.length / kRadius));
  const auto pose = [&](int i) {
    return Pose{slot.middle + slot.length * (double(i) / moves - 0.5) * slot.along - 0.5 * kBeam * slot.beam,
                slot.beam};
  };
  std::vector<BeamMove> path;
  for (int i = 0; i < moves; ++i) path.push_back({pose(i), pose(i + 1)});
  return path;
}

CutSettings settings() {
  CutSettings settings;
  settings.laser.radius = kRadius;
  settings.laser.range = {0, kBeam};
  settings.resolution.target_edge = kTargetEdge;
  settings.resolution.rim = Rim::kSmooth;
  return settings;
}

double sum(std::span<const double> values) {
  double all = 0;
  for (const double v : values) all += v;
  return all;
}

}  // namespace

void bench_league(const Subject&, const Effort& effort, const Report& report) {
  const TrefoilKnot knot;
  World world;
  const BodyId id = world.add(make_body("knot", std::move(*build_mesh(knot.soup(effort.league_faces)))));
  make_solid(world.body(id), true);
  const TriangleArrays at_first = arrays_of(world.body(id).mesh);
  const std::vector<SlotBar> slots = random_slots(knot, effort.league_cuts);
  std::vector<double> cuts, per_face, rebuilds;
  size_t left_open = 0;
  for (const SlotBar& slot : slots) {
    const Walked walked = walk(world, settings(), path_of(slot));
    cuts.push_back(walked.seconds);
    per_face.push_back(walked.per_face());
    left_open += walked.left_open;
    if (has_embree())
      rebuilds.push_back(
          make_embree(arrays_of(world.body(id).mesh), EmbreeQuality::kMedium)->build_seconds());
  }
  std::printf("  ms of each cut:");
  for (const double s : cuts) std::printf(" %.0f", kMilli * s);
  std::printf("\n  %u faces at the end, %zu parts left open\n", world.body(id).mesh.live_faces(), left_open);
  const std::string name = "knot";
  const size_t tenth = std::max<size_t>(1, cuts.size() / 10);
  const auto row = [&](const std::string& what, const char* unit, double ours, double peer,
                       std::optional<double> bar) {
    report({what, name, unit, ours, peer, bar});
  };
  const auto first = [&](const std::vector<double>& v) {
    return sum(std::span(v).first(tenth)) / double(tenth);
  };
  const auto last = [&](const std::vector<double>& v) {
    return sum(std::span(v).last(tenth)) / double(tenth);
  };
  row("cut, mean of the last tenth / of the first", "ms", kMilli * last(cuts), kMilli * first(cuts),
      std::nullopt);
  row("cut, per new or removed face, last tenth / first", "us", kMicro * last(per_face),
      kMicro * first(per_face), kLaterBar);
  row("longest cut / mean", "ms", kMilli * *std::max_element(cuts.begin(), cuts.end()),
      kMilli * sum(cuts) / static_cast<double>(cuts.size()), std::nullopt);
  if (has_embree())
    row("all cuts / Embree medium rebuilt after each", "s", sum(cuts), sum(rebuilds), std::nullopt);
  if (const auto peer = manifold_seconds(at_first, slots))
    row("all cuts / Manifold difference of each", "s", sum(cuts), *peer, std::nullopt);
}

}  // namespace kerf::bench
