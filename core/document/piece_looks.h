#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/mesh/files/surfaces.h"
#include "core/world/world.h"

namespace kerf {

// The surface is sharp at an edge where it turns by more than 35 degrees: the cosine of that angle.
inline constexpr double kCreaseCosine = 0.8191520442889918;

// Which normals looks_of() returns.
enum class LookNormals : uint8_t {
  kLoaded,  // normals from the file, for faces that have them; in the axes of the body
  kSmooth,  // in world axes; if any face has normals from the file, the others get smooth ones with creases
  kAll,     // like kSmooth, but also if no face has normals from the file
};

// Returns the UVs and unit normals of faces of a body, evaluated from its looks; empty if the body has none.
// With LookNormals::kSmooth and kAll also returns the unit tangents and custom attributes of loaded faces.
// Triangles and corners have the order of extract_faces(). Walls of a body with UVs get UVs in metres,
// neither distorted nor mirrored, and continuous in a plane. Precondition: the faces are live. O(n log n).
CornerLooks looks_of(const Body& body, std::span<const FaceId> faces, LookNormals normals);

// The origin of a face: the loaded face that contains it, by its number in the file, and the barycentric
// coordinates of its corners there, in the order of the file. Coordinates are negative if a vertex that moved
// onto a smooth rim lies outside that face. A wall has the number -1 and zeros.
struct FaceSource {
  int64_t face = -1;
  std::array<Vec3, 3> barycentrics{Vec3(0), Vec3(0), Vec3(0)};
};

// Returns the origins of faces. Precondition: the faces are live, and the looks of the body, if any, keep
// corners (see Soup::keeps_corners). Linear time.
std::vector<FaceSource> sources_of(const Body& body, std::span<const FaceId> faces);

// Returns the name of the part that contains the largest area of these faces, in a tie that of the smallest
// part; empty if no part contains any. `parts` are ranges of loaded faces. O(faces log faces + parts) if
// parts do not overlap.
std::string part_name_of(const Body& body, std::span<const MeshPart> parts, std::span<const FaceId> faces);

}  // namespace kerf
