#include "tests/bench/peer.h"

namespace kerf::bench {

bool has_manifold() { return false; }
std::optional<ManifoldSlot> manifold_slot(const TriangleArrays&, const SlotBox&) { return std::nullopt; }
std::optional<double> manifold_seconds(const TriangleArrays&, std::span<const SlotBar>) {
  return std::nullopt;
}

}  // namespace kerf::bench
