#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "core/base/vec3.h"

namespace kerf {

// A view of a triangle mesh that is to be written. The viewed arrays must outlive it.
struct MeshView {
  std::span<const Vec3> positions;                     // finite, metres
  std::span<const std::array<uint32_t, 3>> triangles;  // indices of positions, counter-clockwise
  std::span<const uint16_t> materials;                 // one per triangle, or empty
  std::span<const std::string> material_names;  // by material; covers every material that a triangle has
  std::string_view library{};  // name of the MTL file beside it, on one line; empty: none. Only for OBJ
};

}  // namespace kerf
