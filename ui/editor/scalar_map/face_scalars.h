#pragma once

#include <string>

#include "core/mesh/files/file_frame.h"
#include "ui/render/bodies/prepared_body.h"
#include "ui/render/view/scalar_field.h"

namespace kerf {

// What a scalar map shows of each face.
enum class FaceQuantity {
  kLevel,        // how often the area of its loaded face was halved
  kLongestEdge,  // m
  kLeastAngle,   // degrees; 0 for a face without area
  kTemperature,  // K
  kRimDistance,  // m, of its nearest corner from the nearest rim that a cut made; none far from all rims
};
inline constexpr size_t kFaceQuantities = 5;

// The name for people: "level", "distance to the rim".
const char* name_of(FaceQuantity quantity);
// A value as a label, lengths in the numbers of the file: "3", "2.75 mm", "31.5°", "410 K".
std::string quantity_text(FaceQuantity quantity, double value, FileUnit unit);

// The values of all faces of a body. `loaded` tells which sides of faces were open when the body was loaded;
// without it all sides that no other face shares are rims. O(faces); for kRimDistance O(n log n) in the faces
// near rims.
FaceScalars face_scalars(const Body& body, FaceQuantity quantity, const LoadedShading* loaded);

}  // namespace kerf
