#include <cassert>

#include "core/base/assert.h"
#include "core/tree/aabb_tree.h"
#include "core/tree/beam_slab.h"
#include "core/tree/walk_scratch.h"

namespace kerf {

namespace {

void mark(TreeStore& tree, std::span<const uintptr_t> marks) {
  assert(marks.size() % 2 == 0);
  for (size_t i = 0; i < marks.size(); i += 2) {
    const auto bits = static_cast<unsigned>(marks[i + 1]);
    if (marks_block(marks[i]))
      tree.mark(*reinterpret_cast<const FaceBlock*>(marks[i] - 1), bits);
    else
      tree.mark(*reinterpret_cast<const WideNode*>(marks[i]), bits);
  }
}

}  // namespace

QueryCounts AabbTree::touched(const Mesh& mesh, const SweptCylinder& beam, std::vector<FaceId>& out) {
  QueryCounts counts;
  if (store_.root == kNoIndex) return counts;
  const SlabQuery query = beam_slab(store_, beam);
  WalkScratch scratch;
  counts.boxes = walks_->slab(store_.view(), query, scratch);
  counts.faces = scratch.found().size();
  mark(store_, scratch.met());
  store_.root_hit = store_.root_hit || store_.nodes[store_.root].hit != 0;
  for (const uintptr_t word : scratch.found()) {
    const FaceId f(block_of(word)->face[lane_of(word)]);
    if (beam.touches(mesh.triangle(f))) out.push_back(f);
  }
  return counts;
}

}  // namespace kerf
