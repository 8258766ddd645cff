#include "tests/bench/peer.h"

namespace kerf::bench {

bool has_cgal() { return false; }
std::unique_ptr<Peer> make_cgal(const TriangleArrays&) { return nullptr; }

}  // namespace kerf::bench
