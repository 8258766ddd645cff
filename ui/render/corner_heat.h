#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/world/world.h"

namespace kerf {

// What a corner of a face shows of heat, in the format of the GPU: temperatures in units of kHeatUnit.
struct HeatMark {
  uint16_t now = 0;      // 0: at the ambient
  uint16_t hottest = 0;  // that it ever was; 0: it was never hot
  friend bool operator==(const HeatMark&, const HeatMark&) = default;
};

inline constexpr double kHeatUnit = 1.0 / 16;  // K

// The temperatures of the corners of faces: the mean of the faces around each corner on its sheet, so that
// heat that is known a face shows no facets. Only corners of faces that are or were hot are looked at; a body
// that was never hot costs nothing.
class CornerHeat {
 public:
  // Whether any corner is or was hot.
  bool any() const { return !marks_.empty(); }
  // The temperature of the hottest face at the last update (K).
  double warmest() const { return warmest_; }

  // Follows the heat of the body. `changed` are corners of faces that came, went or have new corners; those
  // that the mesh does not have are passed over. Appends the faces whose corners have new marks to
  // `affected`. O(faces that are hot, plus a compare for each that ever was).
  void update(const Body& body, std::vector<VertexId> changed, std::vector<FaceId>& affected);

  // Precondition: f is live.
  std::array<HeatMark, 3> of(const Mesh& mesh, FaceId f) const;

 private:
  void add_corners(const Mesh& mesh, FaceId f, std::vector<VertexId>& corners) const;
  void find_hot(const Body& body, std::vector<VertexId>& corners);
  void find_tinted(const Body& body, std::vector<VertexId>& corners);
  HeatMark mean_around(const Body& body, const std::vector<FaceId>& faces) const;

  std::vector<HeatMark> marks_;  // by vertex
  std::vector<float> seen_;      // by face: the highest temperature as of the last update
  std::vector<FaceId> tinted_;   // the faces for which it is not 0
  std::vector<VertexId> hot_;    // the corners of the faces that had energy then
  double warmest_ = kAmbient;
};

}  // namespace kerf
