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

// The heat of a face at a vertex: its current and maximum mean temperatures, which hold at its centroid.
struct FaceSample {
  Vec3 centroid;
  double size;                           // its longest edge [m]
  std::array<double, 2> temperatures{};  // K
};

// A temperature at a vertex [K] and its gradient there [K/m].
struct LocalHeat {
  double at = 0;
  Vec3 gradient{0};
};

// Fits linear temperature fields to the faces around a vertex. The mean of a few faces of different sizes
// would be the temperature of another place than the vertex. Least squares, weighted by the inverse fourth
// power of the face size, since the mean of a large face says little about the vicinity of one of its
// corners. The gradient is zero in directions not determined by the centroids. Preconditions: there are
// samples, and none has the size 0.
std::array<LocalHeat, 2> fit_heat(const Vec3& vertex, std::span<const FaceSample> samples);

// A temperature at a face corner in the format of the GPU: in units of kHeatUnit, 0 at the ambient, and its
// gradient as half floats, in units of kHeatGradientUnit over the unit of the float frame.
struct CornerTemperature {
  uint16_t at = 0;
  std::array<uint16_t, 3> gradient{};
  friend bool operator==(const CornerTemperature&, const CornerTemperature&) = default;
};

// The heat shown at a face corner.
struct HeatMark {
  CornerTemperature now;
  CornerTemperature hottest;  // maximum so far
  friend bool operator==(const HeatMark&, const HeatMark&) = default;
};
static_assert(sizeof(HeatMark) == 16);

inline constexpr double kHeatUnit = 1.0 / 16;     // K
inline constexpr double kHeatGradientUnit = 256;  // K

// The temperatures of face corners with their gradients, fitted to the faces around each corner on its
// sheet (see fit_heat). Heat known per face then shows no facets, and a large face next to a hot place is
// hot only near it: the temperature of a point is the barycentric mean of the extrapolations from its three
// corners, clamped between the ambient and the same mean of the corner temperatures. It is continuous
// across edges. Visits only corners of faces that are or were hot; a body that was never hot costs nothing.
class CornerHeat {
 public:
  // Returns true if any corner is or was hot.
  bool any() const { return !marks_.empty() || !wall_marks_.empty(); }
  // The temperature of the hottest face at the last update [K].
  double warmest() const { return warmest_; }

  // Follows the heat of the body, whose float frame has this scale (> 0), the same at each update.
  // `changed` are corners of faces that were added, removed or got new corners; vertices missing in the
  // mesh are skipped. Appends the faces with new marks at their corners to `affected`. Fits the corners of
  // faces that changed or have another temperature, in parallel; compares each face that is or was hot.
  void update(const Body& body, double scale, std::span<const VertexId> changed,
              std::vector<FaceId>& affected);

  // Precondition: f is live.
  std::array<HeatMark, 3> of(const Mesh& mesh, FaceId f) const;

 private:
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

  // By vertex: of the surface, and of walls, which are larger and meet it at an angle, so neither fit
  // applies to the other.
  std::vector<HeatMark> marks_, wall_marks_;
  WallFaces walls_;
  Sheet sheet_;
  PagedArray<Known> known_;         // by face
  std::vector<FaceId> hot_;         // faces that had energy
  std::vector<FaceId> tinted_;      // faces hot enough to keep their maximum temperature
  std::vector<VertexId> to_fit_;    // of an update
  std::vector<uint8_t> is_listed_;  // by vertex: it is in to_fit_
  double warmest_ = kAmbient;
};

}  // namespace kerf
