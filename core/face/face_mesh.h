#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/vec3.h"
#include "core/kerf_c.h"
#include "core/mesh/files/soup.h"

// A mesh as outsiders see it: flat arrays.
struct kerf_mesh {
  std::vector<kerf::Vec3> positions;
  std::vector<std::array<uint32_t, 3>> triangles;
  std::vector<kerf::VertexColour> colours;  // one per position, or empty
  std::vector<uint16_t> materials;          // one per triangle, or empty
  std::vector<std::string> material_names;
  std::vector<double> temperatures;  // K, one per triangle of a piece; empty for any other mesh
  std::string name;
  kerf_mesh_info info{};         // but for its name
  std::optional<double> volume;  // of a piece that is closed, m^3
};

namespace kerf {

// Fills what follows from the arrays: area, centroid, and the identity as the placement.
void measure(kerf_mesh& mesh);

// The mesh as the content of a file.
Soup soup_of(const kerf_mesh& mesh);

}  // namespace kerf
