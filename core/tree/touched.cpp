#include "core/base/shuffle.h"
#include "core/tree/aabb_tree.h"
#include "core/tree/beam_slab.h"
#include "core/tree/walk_scratch.h"

namespace kerf {

QueryCounts AabbTree::touched(const Mesh& mesh, const SweptCylinder& beam, std::vector<FaceId>& out,
                              std::vector<FaceId>* near) const {
  QueryCounts counts;
  if (store_.root == kNoIndex) return counts;
  const SlabQuery query = beam_slab(store_, beam);
  WalkScratch scratch;
  counts.boxes = walks_->slab(store_.view(), query, scratch);
  counts.faces = scratch.found().size();
  const auto face = [](uintptr_t word) { return FaceId(block_of(word)->face[lane_of(word)]); };
  if (near) {
    for (const uintptr_t word : scratch.met()) near->push_back(face(word));
  }
  const size_t first = out.size();
  for (const uintptr_t word : scratch.found()) {
    if (beam.touches(mesh.triangle(face(word)))) out.push_back(face(word));
  }
  Shuffle::chosen().reorder(out, first);
  return counts;
}

}  // namespace kerf
