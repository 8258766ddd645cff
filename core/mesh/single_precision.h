#pragma once

#include <optional>
#include <string>

#include "core/mesh/files/encode.h"

namespace kerf {

// The loss of a mesh in a format that holds positions in single precision.
struct PrecisionLoss {
  double largest_move = 0;   // of a vertex, m
  double shortest_edge = 0;  // of those longer than zero, before the rounding, m; 0 if there is none
  size_t merged = 0;         // vertices that fall together with another one that was elsewhere
  size_t vertices = 0;

  // Whether the loss can be seen: vertices fall together, or move by more than a tenth of the shortest edge.
  bool matters() const { return merged > 0 || largest_move > 0.1 * shortest_edge; }
  // The loss of two meshes in one.
  PrecisionLoss& operator+=(const PrecisionLoss& other);
};

// Measures the positions as encode() writes them: about the origin in STL, about the middle of the mesh in
// glTF. The other formats hold doubles and lose nothing. Precondition: the coordinates fit the format (see
// write_mesh). Expected linear time.
PrecisionLoss precision_loss(const MeshView& mesh, MeshFormat format);

// A sentence for the user about meshes that were written in this format: "STL holds single precision: …".
// Nothing if the loss does not matter. `advice` says what to do instead.
std::optional<std::string> precision_note(const PrecisionLoss& loss, MeshFormat format,
                                          const std::string& advice);

}  // namespace kerf
