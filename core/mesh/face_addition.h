#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "core/mesh/mesh.h"

namespace kerf {

using HalfEdgeId = Id<struct HalfEdgeTag>;

// New faces that come into a mesh in parts (see Mesh::add_faces, which adds them at once). Between the parts
// the mesh is one that can be asked for everything, but the star of a vertex lacks faces that do not hang
// together with the others yet: nothing else may edit the mesh until the addition is over.
class FaceAddition {
 public:
  // Corners are indices of `vertices`, each of which is there once. For the rest see Mesh::add_faces.
  FaceAddition(std::vector<VertexId> vertices, std::vector<std::array<uint32_t, 3>> corners);

  size_t faces() const { return corners_.size(); }
  // The number of faces that were added.
  size_t added() const { return added_; }

  // Adds the next faces, as many as there are data, and returns their slots. Precondition: there are so many.
  std::vector<FaceId> add(Mesh& mesh, std::span<const FaceData> data);

  // Lets each of the next `most` vertices give way to several where the faces around it do not hang together
  // over edges. Appends the faces whose corners are others by that. Returns whether the addition is over.
  // Precondition: all faces were added.
  bool part_fans(Mesh& mesh, size_t most, std::vector<FaceId>& changed);

 private:
  static constexpr uint32_t kNone = 0xffffffffu;

  // The half-edges that start at a vertex: a chain of entries.
  struct Chain {
    uint32_t first = kNone, last = kNone;
  };
  struct Entry {
    HalfEdgeId half_edge;
    uint32_t next;
  };

  template <typename Visit>
  void for_each_at(uint32_t v, Visit visit) const {
    for (uint32_t e = chains_[v].first; e != kNone; e = entries_[e].next) visit(entries_[e].half_edge);
  }
  void append(uint32_t v, HalfEdgeId h);
  void note_half_edges(const Mesh::Kernel& kernel, uint32_t v);
  HalfEdgeId side(Mesh::Kernel& kernel, uint32_t from, uint32_t to);
  void link_boundaries(Mesh::Kernel& kernel, uint32_t v) const;
  bool is_one_fan(const Mesh::Kernel& kernel, uint32_t v) const;
  void part_fans_at(Mesh::Kernel& kernel, uint32_t v, std::vector<FaceId>& changed) const;

  std::vector<VertexId> vertices_;
  std::vector<std::array<uint32_t, 3>> corners_;
  std::vector<bool> is_noted_;  // by vertex: its half-edges are listed
  std::vector<Chain> chains_;   // by vertex
  std::vector<Entry> entries_;
  size_t added_ = 0, parted_ = 0;  // faces, vertices
};

}  // namespace kerf
