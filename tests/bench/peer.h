#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/mesh/mesh.h"
#include "core/tree/swept_cylinder.h"

namespace kerf::bench {

// The faces of a mesh as other libraries take them.
struct TriangleArrays {
  std::vector<float> positions;   // x y z a vertex
  std::vector<uint32_t> corners;  // three a triangle
};
TriangleArrays arrays_of(const Mesh& mesh);

// Another library's tree over the same triangles. Hits are counted, not sorted.
class Peer {
 public:
  virtual ~Peer() = default;
  virtual size_t all_hits(std::span<const Pose> rays, double reach) = 0;
  virtual size_t nearest_hits(std::span<const Pose> rays, double reach) = 0;
  virtual double build_seconds() const = 0;  // of processor time, without the copies of the arrays
  virtual double bytes() const { return 0; }
};

enum class EmbreeQuality { kLow, kMedium, kMediumRobust };

// Nothing where this program was built without the library.
std::unique_ptr<Peer> make_embree(const TriangleArrays& arrays, EmbreeQuality quality);
std::unique_ptr<Peer> make_cgal(const TriangleArrays& arrays);
// The plane slot that a beam of this radius cuts through the middle of a box, across one of its sides.
struct SlotBox {
  Vec3 low, high, middle;
  int across;
  double radius;
};
// How long a thin box takes to be taken from the mesh, and what is left to be split into its components.
// Nothing without the library, and where the mesh bounds no volume.
std::optional<double> cgal_slot_seconds(const TriangleArrays& arrays, const SlotBox& slot);

// How long Manifold takes, on all threads, to import the arrays, and to find the components of the difference
// with that box.
struct ManifoldSlot {
  double import_s, cut_s;
};
std::optional<ManifoldSlot> manifold_slot(const TriangleArrays& arrays, const SlotBox& slot);

// A slot of this length along a unit vector through its middle, cut by a beam along another; `radius` is half
// of its width.
struct SlotBar {
  Vec3 middle, along, beam;
  double length, radius;
};
// Returns the elapsed time in which Manifold subtracts a box for each slot, one after the other, on all
// threads and without the import.
std::optional<double> manifold_seconds(const TriangleArrays& arrays, std::span<const SlotBar> slots);

bool has_embree();
bool has_cgal();
bool has_manifold();

}  // namespace kerf::bench
