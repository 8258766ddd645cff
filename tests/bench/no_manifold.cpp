#include "tests/bench/peer.h"

namespace kerf::bench {

bool has_manifold() { return false; }
std::optional<double> manifold_slot_seconds(const TriangleArrays&, const SlotBox&) { return std::nullopt; }

}  // namespace kerf::bench
