#include <manifold/manifold.h>

#include "tests/bench/peer.h"
#include "tests/bench/timing.h"

namespace kerf::bench {

namespace {

using manifold::Manifold, manifold::vec3;

// As thick as the slot, and larger than the mesh to all sides.
Manifold box_of(const SlotBox& slot) {
  Vec3 low = slot.low - 0.1 * (slot.high - slot.low), high = slot.high + 0.1 * (slot.high - slot.low);
  low[slot.across] = slot.middle[slot.across] - slot.radius;
  high[slot.across] = slot.middle[slot.across] + slot.radius;
  const Vec3 size = high - low;
  return Manifold::Cube(vec3(size.x, size.y, size.z)).Translate(vec3(low.x, low.y, low.z));
}

manifold::MeshGL mesh_of(const TriangleArrays& arrays) {
  manifold::MeshGL mesh;
  mesh.numProp = 3;
  mesh.vertProperties = arrays.positions;
  mesh.triVerts = arrays.corners;
  return mesh;
}

Manifold box_of(const SlotBar& slot) {
  constexpr double kBeam = 100;  // m, through everything
  const Vec3 across = glm::cross(slot.beam, slot.along);
  const auto vec = [](const Vec3& v) { return vec3(v.x, v.y, v.z); };
  return Manifold::Cube(vec3(slot.length, 2 * slot.radius, kBeam), true)
      .Transform(manifold::mat3x4(vec(slot.along), vec(across), vec(slot.beam), vec(slot.middle)));
}

}  // namespace

bool has_manifold() { return true; }

std::optional<ManifoldSlot> manifold_slot(const TriangleArrays& arrays, const SlotBox& slot) {
  const manifold::MeshGL mesh = mesh_of(arrays);
  std::optional<Manifold> whole;
  const double import_s = seconds_of(
      [&] {
        whole.emplace(mesh);
        (void)whole->Status();  // which makes it
      },
      passed_seconds);
  size_t parts = 0;
  const double cut_s = seconds_of(
      [&] {
        for (const Manifold& part : (*whole - box_of(slot)).Decompose()) parts += part.NumTri() > 0;
      },
      passed_seconds);
  return parts > 0 ? std::optional(ManifoldSlot{import_s, cut_s}) : std::nullopt;
}

std::optional<double> manifold_seconds(const TriangleArrays& arrays, std::span<const SlotBar> slots) {
  Manifold part(mesh_of(arrays));
  if (part.Status() != Manifold::Error::NoError) return std::nullopt;
  return seconds_of(
      [&] {
        for (const SlotBar& slot : slots) {
          part -= box_of(slot);
          (void)part.Status();  // which computes it
        }
      },
      passed_seconds);
}

}  // namespace kerf::bench
