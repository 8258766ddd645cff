#include "core/world/state_hash.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include "core/base/hash.h"
#include "core/base/parallel.h"
#include "core/mesh/triangle_batch.h"

namespace kerf {

namespace {

constexpr uint64_t kClockSeed = 0x9d5c'b07a'63e1'42f8u, kMotionSeed = 0x3c81'6f2e'b9d4'0a57u,
                   kHeatSeed = 0x51f3'8ad9'2e67'c40bu, kSolidSeed = 0xb27d'40c9'581e'f36au;

uint64_t hash_of(uint64_t seed, const Vec3& p) {
  for (int k = 0; k < 3; ++k) seed = hash_combine(seed, number_bits(p[k]));
  return seed;
}

uint64_t face_hash(const Body& body, uint64_t seed, FaceId f, const Triangle& t) {
  int least = 0;
  for (int i = 1; i < 3; ++i) {
    if (precedes(t[i], t[least])) least = i;
  }
  uint64_t h = hash_combine(seed, body.mesh.data(f).halvings);
  for (int i = 0; i < 3; ++i) h = hash_of(h, t[(least + i) % 3]);
  const double energy = body.heat.energy_of(body.mesh, f);
  return energy == 0 ? h : hash_combine(hash_combine(h, kHeatSeed), number_bits(energy));
}

uint64_t sum_of_face_hashes(const Body& body, uint64_t seed) {
  constexpr size_t kSlots = 1 << 14;  // a range
  std::vector<uint64_t> sums(range_count(body.mesh.face_slots(), kSlots));
  for_each_range(body.mesh.face_slots(), kSlots, [&](size_t first, size_t end) {
    uint64_t sum = 0;
    for_each_triangle(body.mesh, first, end,
                      [&](FaceId f, const Triangle& t) { sum += face_hash(body, seed, f, t); });
    sums[first / kSlots] = sum;
  });
  return std::accumulate(sums.begin(), sums.end(), uint64_t{0});
}

// The hash of the motion of a body that moves or has moved.
uint64_t motion_hash(uint64_t seed, const Motion& motion) {
  const uint64_t h = hash_of(hash_of(hash_combine(seed, kMotionSeed), motion.velocity), motion.spin);
  return hash_combine(hash_combine(h, motion.quiet), motion.asleep ? 1 : 0);
}

}  // namespace

uint64_t state_hash(const World& world) {
  std::vector<BodyId> ids = world.ids();
  std::sort(ids.begin(), ids.end(),
            [&](BodyId a, BodyId b) { return world.body(a).number < world.body(b).number; });
  uint64_t sum = 0, place_of_body = 0;
  for (const BodyId id : ids) {
    const Body& body = world.body(id);
    const uint64_t seed = mix64(++place_of_body);
    sum += sum_of_face_hashes(body, seed);
    const auto& q = body.placement.orientation;
    uint64_t place = hash_of(seed, body.placement.position);
    for (const double x : {q.w, q.x, q.y, q.z}) place = hash_combine(place, number_bits(x));
    sum += place;
    if (body.motion != Motion{}) sum += motion_hash(seed, body.motion);
    if (body.solid) sum += hash_combine(seed, kSolidSeed);
  }
  if (world.clock() != 0) sum += hash_combine(kClockSeed, world.clock());
  return sum;
}

}  // namespace kerf
