#pragma once

#include <cstdint>
#include <vector>

#include "core/base/change_of_parts.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/mesh.h"

namespace kerf {

// Some live faces of a mesh, counted.
struct FaceCounts {
  size_t faces = 0;
  double area = 0;  // m^2
};

// The connected components of a mesh as loaded, with the counts of their faces that still belong to piece 0.
// Every other piece was separated from one of them and is connected itself, so that the counts of the
// component of a face are always known, here or by its piece, without a search.
struct LoadedComponents {
  std::vector<uint32_t> of_base;  // by base face; both are empty if the mesh is connected
  Records<FaceCounts> left;

  size_t bytes() const { return of_base.capacity() * sizeof(uint32_t) + left.bytes(); }

  // What a command changes (see ChangeOf).
  class Change;
  template <typename Self>
  static auto parts(Self& self) {
    return std::tie(self.left);
  }
};

class LoadedComponents::Change : public ChangeOfParts<LoadedComponents> {};

// Counts the components of a mesh as loaded, whose number is known. Fails with cancelled() when stopped;
// `progress` may be null. O(n), or constant time if the mesh is connected.
Result<LoadedComponents> count_components(const Mesh& mesh, size_t components, const Progress* progress);

}  // namespace kerf
