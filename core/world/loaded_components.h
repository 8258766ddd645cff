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

// The connected components of a mesh as loaded. What is left of a component belongs to the piece that is its
// home: 0, or the piece that joints hold it to. Whatever was cut off a component is connected itself and is
// counted by its piece (Piece::cut_off), so that the counts of the connected part of a face are always known
// without a search.
struct LoadedComponents {
  static constexpr uint32_t kNone = 0xffffffffu;

  std::vector<uint32_t> of_base;  // by base face; all lists are empty if the mesh is connected
  Records<FaceCounts> left;       // by component: its faces that have the label of its home
  Records<uint32_t> home;         // by component: a label
  // By component: the one that a wall joined it to, plus one, or 0; up to the last that was joined.
  Records<uint32_t> joined;

  // The component of a base face, together with those that walls have joined to it. Precondition: the mesh
  // was not connected.
  uint32_t of(FaceId base) const {
    uint32_t component = of_base[base.index];
    while (component < joined.size() && joined[component] != 0) component = joined[component] - 1;
    return component;
  }

  // The component of faces with this base face and this label, or kNone if they were cut off it. A connected
  // mesh has none.
  uint32_t at_home(FaceId base, uint32_t label) const {
    if (of_base.empty()) return kNone;
    const uint32_t component = of(base);
    return home[component] == label ? component : kNone;
  }

  size_t bytes() const {
    return of_base.capacity() * sizeof(uint32_t) + left.bytes() + home.bytes() + joined.bytes();
  }

  // Makes two components one, that with the lower number. Precondition: both are roots, i.e. values of of(),
  // differ, and have the same home.
  void join(uint32_t a, uint32_t b);

  // The changes of a command (see ChangeOf).
  class Change;
  template <typename Self>
  static auto parts(Self& self) {
    return std::tie(self.left, self.home, self.joined);
  }
};

class LoadedComponents::Change : public ChangeOfParts<LoadedComponents> {};

// Counts the components of a mesh as loaded, whose number is known. Fails with cancelled() when stopped;
// `progress` may be null. O(n), or constant time if the mesh is connected.
Result<LoadedComponents> count_components(const Mesh& mesh, size_t components, const Progress* progress);

}  // namespace kerf
