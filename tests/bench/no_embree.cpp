#include "tests/bench/peer.h"

namespace kerf::bench {

bool has_embree() { return false; }
std::unique_ptr<Peer> make_embree(const TriangleArrays&, EmbreeQuality) { return nullptr; }

}  // namespace kerf::bench
