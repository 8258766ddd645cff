#include <vector>

#include "core/shadow/shadow_volume.h"
#include "core/tree/aabb_tree.h"
#include "tests/bench/sections.h"
#include "tests/bench/timing.h"

namespace kerf::bench {

namespace {

constexpr double kRebuildBar = 1.5;           // of a plain pass
constexpr double kBiteBar = 1.0 / 100;        // of a volume made from nothing
constexpr uint32_t kBiteManyFaces = 1000000;  // from which that is asked
constexpr uint32_t kBite = 50;                // faces

// The signs of all faces, and for every edge their sum with its directions; nothing else is kept.
void plain_pass(const ShadowCaster& caster, const LightPoint& light, std::vector<int8_t>& signs,
                std::vector<int>& sums) {
  for (uint32_t f = 0; f < caster.face_slots(); ++f) {
    signs[f] = caster.casts(f) ? static_cast<int8_t>(light_side(caster.corners(f), light)) : int8_t{0};
  }
  for (uint32_t e = 0; e < caster.edge_slots(); ++e) {
    sums[e] = 0;
    caster.for_each_face_on(e, [&](uint32_t face, int along) { sums[e] += signs[face] * along; });
  }
}

}  // namespace

void bench_shadows(const Subject& subject, const Effort& effort, const Report& report) {
  Mesh mesh = subject.mesh;
  const Bounds box = AabbTree(mesh).bounds();
  ShadowCaster caster(mesh, FloatFrame::around(box.min, box.max));
  const LightPoint light{{1.3, 3, 2.1}, 1};
  const bool many = mesh.live_faces() >= kBiteManyFaces;

  ShadowVolume volume;
  std::vector<int8_t> signs(caster.face_slots());
  std::vector<int> sums(caster.edge_slots());
  const Pair whole = in_turn(
      effort.build_times,
      [&] {
        volume.rebuild(caster, {light, {}});
      },
      [&] { plain_pass(caster, light, signs, sums); });
  report({"shadow volume / plain pass", subject.name, "ms", kMilli * whole.ours, kMilli * whole.peer,
          many ? std::optional(kRebuildBar) : std::nullopt});

  std::vector<double> times;
  for (int i = 0; i < effort.build_times; ++i) {
    std::vector<uint32_t> slots;
    const uint32_t first =
        mesh.face_slots() / static_cast<uint32_t>(effort.build_times + 1) * static_cast<uint32_t>(i);
    for (uint32_t f = first; f < mesh.face_slots() && slots.size() < kBite; ++f) {
      if (mesh.is_live(FaceId(f))) slots.push_back(f);
    }
    for (const uint32_t f : slots) mesh.remove_face(FaceId(f));
    times.push_back(seconds_of([&] { volume.follow(caster, caster.update(mesh, slots)); }));
  }
  report({"step of 50 faces / shadow volume", subject.name, "ms", kMilli * median(times), kMilli * whole.ours,
          many ? std::optional(kBiteBar) : std::nullopt});
}

}  // namespace kerf::bench
