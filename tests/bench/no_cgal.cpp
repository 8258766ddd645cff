#include "tests/bench/peer.h"

namespace kerf::bench {

bool has_cgal() { return false; }
std::unique_ptr<Peer> make_cgal(const TriangleArrays&) { return nullptr; }
std::optional<double> cgal_slot_seconds(const TriangleArrays&, const SlotBox&) { return std::nullopt; }

}  // namespace kerf::bench
