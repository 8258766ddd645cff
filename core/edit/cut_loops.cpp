#include "core/edit/cut_loops.h"

#include <cassert>

namespace kerf {

void CutLoops::remove(FaceId f) {
  assert(mesh_.is_live(f));
  const Edges edges = edges_of(f);
  state_.over_rings |= edges.others;
  state_.cannot_know |= edges.others && state_.neighbours.size() > 1;
  const auto c = mesh_.corners(f);
  for (const VertexId v : c) meet(v);
  const int joined = int{unite(c[0], c[1])} + int{unite(c[1], c[2])} + int{unite(c[2], c[0])};
  const int more = edges.shared - 1 - joined;
  state_.loops += more;
  if (more > 0) state_.any_closed = true;
}

CutLoops::Edges CutLoops::edges_of(FaceId f) const {
  Edges edges;
  std::array<bool, 3> found{};
  const auto c = mesh_.corners(f);
  for (const FaceId n : state_.neighbours) {
    const auto d = mesh_.corners(n);
    bool beside = false;
    for (size_t i = 0; i < 3 && !beside; ++i) {
      for (size_t k = 0; k < 3 && !found[i] && !beside; ++k)
        beside = found[i] = c[i] == d[(k + 1) % 3] && c[(i + 1) % 3] == d[k];
    }
    edges.shared += beside;
    edges.others |= !beside;
  }
  return edges;
}

void CutLoops::meet(VertexId v) {
  if (state_.joined.get(v.index) == 0) meet_along_rim(v);
}

// Traverses the boundary edges connected with v and unites their vertices.
void CutLoops::meet_along_rim(VertexId v) {
  state_.joined.at(v.index) = v.index + 1;
  state_.rim.assign(1, v);
  while (!state_.rim.empty()) {
    const VertexId at = state_.rim.back();
    state_.rim.pop_back();
    mesh_.star(at, state_.star);
    for (const VertexId next : state_.star.rim) {
      if (state_.joined.get(next.index) == 0) {
        state_.joined.at(next.index) = next.index + 1;
        state_.rim.push_back(next);
      }
      unite(at, next);
    }
  }
}

uint32_t CutLoops::find(VertexId v) {
  uint32_t x = v.index;
  for (;;) {
    assert(state_.joined.get(x) != 0);
    const uint32_t parent = state_.joined.get(x) - 1;
    if (parent == x) return x;
    const uint32_t above = state_.joined.get(parent);
    if (above != parent + 1) state_.joined.at(x) = above;
    x = parent;
  }
}

bool CutLoops::unite(VertexId a, VertexId b) {
  uint32_t x = find(a), y = find(b);
  if (x == y) return false;
  if (y < x) std::swap(x, y);
  state_.joined.at(y) = x + 1;
  return true;
}

}  // namespace kerf
