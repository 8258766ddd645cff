#include "ui/editor/scalar_map/face_scalars.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/angle.h"
#include "core/base/parallel.h"
#include "core/mesh/triangle_batch.h"
#include "ui/editor/shared/files/file_frames.h"
#include "ui/render/bodies/rim_distance.h"
#include "ui/window/number_text.h"

namespace kerf {

namespace {

constexpr size_t kGrain = 1 << 14;
constexpr float kRimReach = 0.5f;  // in the float frame, in which a body is about 2 wide

double least_angle(const Triangle& t) { return std::acos(largest_cosine(t)) * 180 / kPi; }

float local_value(const Body& body, FaceId f, const Triangle& t, FaceQuantity quantity) {
  switch (quantity) {
    case FaceQuantity::kLevel:
      return static_cast<float>(body.mesh.data(f).halvings);
    case FaceQuantity::kLongestEdge:
      return static_cast<float>(std::sqrt(longest_edge2(t)));
    case FaceQuantity::kLeastAngle:
      return static_cast<float>(least_angle(t));
    case FaceQuantity::kTemperature:
      return static_cast<float>(
          body.heat.temperature(body.mesh, f, body.sheet.substance, body.sheet.thickness));
    case FaceQuantity::kRimDistance:
      break;
  }
  return kNoScalar;
}

template <typename Value>
void fill(FaceScalars& values, const Mesh& mesh, const Value& value) {
  for_each_range(values.size(), kGrain, [&](size_t first, size_t end) {
    for_each_triangle(mesh, first, end, [&](FaceId f, const Triangle& t) { values[f.index] = value(f, t); });
  });
}

// The bases of a body that was copied out of the loaded one; without a loaded one none, so that no side was
// open.
BaseFaces bases_of(const Body& body, const LoadedShading* loaded) {
  if (loaded == nullptr) return {};
  return body.loaded_faces.empty() ? *loaded->bases : loaded->bases->pick(body.loaded_faces);
}

void fill_rim_distances(FaceScalars& values, const Body& body, const LoadedShading* loaded) {
  const FloatFrame frame =
      loaded != nullptr ? loaded->frame : FloatFrame::around(body.bounds().min, body.bounds().max);
  const BaseFaces bases = bases_of(body, loaded);
  if (bases.are_whole(body.mesh)) return;
  RimDistance rims(kRimReach, 0);
  std::vector<VertexId> all, affected;
  for (uint32_t v = 0; v < body.mesh.vertex_slots(); ++v) all.emplace_back(v);
  rims.update(body.mesh, bases, frame, all, affected);
  if (!rims.any()) return;
  fill(values, body.mesh, [&](FaceId f, const Triangle&) {
    float nearest = RimDistance::kFar;
    for (const VertexId v : body.mesh.corners(f)) nearest = std::min(nearest, rims.of(v));
    return nearest < RimDistance::kFar ? static_cast<float>(nearest / frame.scale) : kNoScalar;
  });
}

}  // namespace

const char* name_of(FaceQuantity quantity) {
  constexpr std::array<const char*, kFaceQuantities> kNames{"level", "longest edge", "least angle",
                                                            "temperature", "distance to the rim"};
  return kNames[static_cast<size_t>(quantity)];
}

std::string quantity_text(FaceQuantity quantity, double value, FileUnit unit) {
  switch (quantity) {
    case FaceQuantity::kLevel:
      return text_of("%.0f", value);
    case FaceQuantity::kLongestEdge:
    case FaceQuantity::kRimDistance:
      return value == 0 ? "0" : length_label(value, unit);
    case FaceQuantity::kLeastAngle:
      return text_of("%.1f\u00b0", value);
    case FaceQuantity::kTemperature:
      break;
  }
  return text_of("%.0f K", value);
}

FaceScalars face_scalars(const Body& body, FaceQuantity quantity, const LoadedShading* loaded) {
  FaceScalars values(body.mesh.face_slots(), kNoScalar);
  if (quantity == FaceQuantity::kRimDistance) {
    fill_rim_distances(values, body, loaded);
  } else {
    fill(values, body.mesh, [&](FaceId f, const Triangle& t) { return local_value(body, f, t, quantity); });
  }
  return values;
}

}  // namespace kerf
