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

// The parts of a mesh that never hung together, and what each of them still has among the faces of piece 0.
// Every other piece came off one of them and is one component; so what a face hangs together with is counted
// here or by its piece, and never has to be searched for.
struct LoadedComponents {
  std::vector<uint32_t> of_base;  // by base face; both are empty where the mesh is one component
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

// For a mesh as loaded, which has so many components, or that it was stopped. `progress` may be null.
// O(faces), and constant time where it is one.
Result<LoadedComponents> count_components(const Mesh& mesh, size_t components, const Progress* progress);

}  // namespace kerf
