#pragma once

#include <tuple>

#include "core/base/change_of_parts.h"
#include "core/base/ids.h"
#include "core/base/records.h"
#include "core/mesh/files/vertex_colour.h"

namespace kerf {

// The colours of the vertices of a mesh, which the mesh takes along: the vertex that splits an edge gets the
// colour between those of its ends, a vertex that moves keeps its own, and copies, extracts and Mesh::Change
// include them. They are no part of the state of a world (see state_hash). A mesh in which no colour was set
// pays nothing; in any other, vertices whose colour was not set are white and opaque.
class VertexColours {
 public:
  // Whether no colour was ever set.
  bool blank() const { return cells_.empty(); }
  VertexColour get(VertexId v) const { return v.index < cells_.size() ? cells_[v.index] : VertexColour(); }
  void set(VertexId v, const VertexColour& colour);

  // The colours before a command; see ChangeOf.
  class Change;

 private:
  friend class ChangeOfParts<VertexColours>;
  template <typename Self>
  static auto parts(Self& self) {
    return std::tie(self.cells_);
  }

  Records<VertexColour> cells_;  // up to the last vertex whose colour was set
};

class VertexColours::Change : public ChangeOfParts<VertexColours> {};

}  // namespace kerf
