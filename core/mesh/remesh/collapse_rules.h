#pragma once

#include <cstdint>
#include <vector>

#include "core/mesh/remesh/flat_sheets.h"
#include "core/mesh/remesh/flat_surface.h"

namespace kerf {

// The faces and the vertices around a vertex.
struct Ring {
  std::vector<FlatSurface::Opposite> sides;
  std::vector<uint32_t> vertices;  // each once
};

// Decides which vertices may collapse onto which of their neighbours.
class CollapseRules {
 public:
  // Both must outlive the rules.
  CollapseRules(const FlatSheets& sheets, const FlatSurface& surface)
      : sheets_(sheets), surface_(surface), mark_(surface.vertices(), 0) {}

  // The least cosine, squared, of the angle by which a collapse may turn a face; 0 or more.
  void set_least_cosine2(double cosine2) { least_cosine2_ = cosine2; }

  // A vertex with more faces is a hub and does not collapse before its neighbours have: to look at its ring
  // after each of their collapses would take quadratic time. Collapses onto it look at no other hub either.
  static constexpr uint32_t kMostFaces = 256;

  bool is_hub(uint32_t v) const { return surface_.faces_at(v) > kMostFaces; }

  // Finds what is around a vertex, and remembers it for allows(). Precondition: it is in use.
  void look_at(uint32_t v, Ring& ring);

  // Whether the vertex of the last look_at, which has this ring, may collapse onto `to`: the surface stays a
  // manifold of the same topology (the link condition of T. Dey et al., 1999), no sheets are joined, and no
  // face turns too far or loses its area. Two hubs beside the vertex may forbid it, too. Preconditions: `to`
  // is in the ring, and the vertex is neither locked nor a hub.
  bool allows(uint32_t v, uint32_t to, const Ring& ring);

 private:
  bool keeps_topology(uint32_t v, uint32_t to, const Ring& ring);
  bool keeps_topology_of_hub(uint32_t to, const Ring& ring) const;
  bool joins_sheets(uint32_t to, const Ring& ring) const;
  bool turns_too_far(uint32_t v, uint32_t to, const Ring& ring) const;

  const FlatSheets& sheets_;
  const FlatSurface& surface_;
  double least_cosine2_ = 0;
  uint32_t stamp_ = 0;
  std::vector<uint32_t> mark_;                   // by vertex: the stamp of the ring in which it was last
  uint32_t left_ = kNoIndex, right_ = kNoIndex;  // the two vertices that have a face with both ends
};

}  // namespace kerf
