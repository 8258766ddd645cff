#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/base/containers.h"
#include "core/base/geometry.h"
#include "core/world/world.h"

namespace kerf {

// What a face at a vertex knows of its heat: its mean temperatures, now and the highest ones that were, which
// are those at its centroid.
struct FaceSample {
  Vec3 centroid;
  double size;                           // its longest edge (m)
  std::array<double, 2> temperatures{};  // K
};

// A temperature at a vertex (K) and its gradient there (K/m).
struct LocalHeat {
  double at = 0;
  Vec3 gradient{0};
};

// Fits temperatures that are linear in space to the faces around a vertex. The mean of a few faces of
// different sizes would be the temperature of another place than the vertex. Least squares, weighted by one
// over the fourth power of the size of the face, since the mean of a large face says little of what lies near
// one of its corners. Where the centroids leave a direction open, the gradient has no part in it.
// Preconditions: there are samples, and none has the size 0.
std::array<LocalHeat, 2> fit_heat(const Vec3& vertex, std::span<const FaceSample> samples);

// A temperature at a corner of a face in the format of the GPU: in units of kHeatUnit, 0 where it is the
// ambient, and its gradient as half floats, in units of kHeatGradientUnit over the unit of the float frame.
struct CornerTemperature {
  uint16_t at = 0;
  std::array<uint16_t, 3> gradient{};
  friend bool operator==(const CornerTemperature&, const CornerTemperature&) = default;
};

// What a corner of a face shows of heat.
struct HeatMark {
  CornerTemperature now;
  CornerTemperature hottest;  // that it ever was
  friend bool operator==(const HeatMark&, const HeatMark&) = default;
};
static_assert(sizeof(HeatMark) == 16);

inline constexpr double kHeatUnit = 1.0 / 16;     // K
inline constexpr double kHeatGradientUnit = 256;  // K

// The temperatures of the corners of faces with their gradients, fitted to the faces around each corner on
// its sheet (see fit_heat), so that heat that is known a face shows no facets, and a large face that touches
// what is hot is drawn hot near there alone: the temperature of a point is the mean, by barycentric
// coordinates, of those to which its three corners extrapolate; it lies between the ambient and the same mean
// of the temperatures of the corners. It is the same from both sides of an edge. Only corners of faces that
// are or were hot are looked at; a body that was never hot costs nothing.
class CornerHeat {
 public:
  // Whether any corner is or was hot.
  bool any() const { return !marks_.empty() || !wall_marks_.empty(); }
  // The temperature of the hottest face at the last update (K).
  double warmest() const { return warmest_; }

  // Follows the heat of the body, whose float frame has this scale (> 0), at each update the same. `changed`
  // are corners of faces that came, went or have new corners; those that the mesh does not have are passed
  // over. Appends the faces whose corners have new marks to `affected`. Fits are made at corners of faces
  // that changed or have another temperature, several at a time; a compare for each face that is or was hot.
  void update(const Body& body, double scale, std::span<const VertexId> changed,
              std::vector<FaceId>& affected);

  // Precondition: f is live.
  std::array<HeatMark, 3> of(const Mesh& mesh, FaceId f) const;

 private:
  // Of a face at the last update.
  struct Known {
    double energy = 0;  // J
    double now = kAmbient, hottest = kAmbient;
  };
  // New marks of vertices, and the faces at them.
  struct NewMarks {
    std::vector<std::pair<VertexId, HeatMark>> of_surface, of_walls;
    std::vector<FaceId> affected;
  };
  class Fitter;

  void forget_temperatures(const Body& body, std::span<const VertexId> changed);
  void find_reheated(const Body& body);
  void find_tinted(const Body& body);
  void list_corners(const Mesh& mesh, FaceId f);
  bool list_corner(VertexId v);
  static void set_marks(std::vector<HeatMark>& marks, std::span<const std::pair<VertexId, HeatMark>> found);

  // By vertex: of the surface, and of walls, which meet it at an angle and are larger: what is fitted to one
  // does not tell of the other.
  std::vector<HeatMark> marks_, wall_marks_;
  WallFaces walls_;
  Sheet sheet_;
  PagedArray<Known> known_;         // by face
  std::vector<FaceId> hot_;         // the faces that had energy
  std::vector<FaceId> tinted_;      // the faces that were hot enough to keep their highest temperature
  std::vector<VertexId> to_fit_;    // of an update
  std::vector<uint8_t> is_listed_;  // by vertex: whether it is in to_fit_
  double warmest_ = kAmbient;
};

}  // namespace kerf
