#include "core/mesh/vertex_colours.h"

#include <cassert>

namespace kerf {

void VertexColours::set(VertexId v, const VertexColour& colour) {
  assert(v.valid());
  while (cells_.size() <= v.index) cells_.push_back(VertexColour());
  cells_.edit(v.index) = colour;
}

}  // namespace kerf
