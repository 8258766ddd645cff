#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <glm/glm.hpp>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/parallel.h"
#include "core/base/result.h"
#include "core/mesh/mesh.h"
#include "core/shadow/shadow_volume.h"
#include "core/world/world.h"

namespace kerf {

// A histogram of surface area by its deviation from the facets; see BaseFaces::deviation().
class CurvedArea {
 public:
  // Adds a face corner of this area whose smooth normal deviates by an angle of this sine.
  void note(double sine, double area) {
    if (sine < kFlat) return;
    by_sine_[std::min(static_cast<size_t>(sine * kSteps), kSteps - 1)] += area;
  }
  void add(const CurvedArea& other) {
    for (size_t i = 0; i < kSteps; ++i) by_sine_[i] += other.by_sine_[i];
  }
  // Returns the sine that nine tenths of the area do not exceed; 0 without area.
  float deviation() const {
    constexpr double kLargeShare = 0.9;
    double all = 0, below = 0;
    for (const double area : by_sine_) all += area;
    float sine = 0;
    for (size_t i = 0; i < kSteps && below < kLargeShare * all; ++i) {
      below += by_sine_[i];
      sine = static_cast<float>(i + 1) / kSteps;
    }
    return sine;
  }

 private:
  static constexpr size_t kSteps = 100;
  static constexpr double kFlat = 0.01;  // smaller deviations count as flat
  std::array<double, kSteps> by_sine_{};
};

// The faces of a body as loaded, with smooth normals. A part of a split face interpolates the corner
// normals of its base face, so that cutting never changes the shading of a surface.
//
// The normal at a corner is the angle-weighted mean of the normals of those faces around its position whose
// planes differ by less than 35 degrees from that of the corner's face. Positions are compared bitwise.
// Construction takes expected linear time; memory is about 21 bytes per face if the surface is smooth and
// 61 if all edges are sharp.
class BaseFaces {
 public:
  BaseFaces() = default;
  // Precondition: the mesh is as loaded. Faces that were already split or removed are shaded flat.
  BaseFaces(const Mesh& mesh, const FloatFrame& frame);
  // Builds the base faces of such a mesh; fails with cancelled() if stopped. `progress` may be null.
  static Result<BaseFaces> build(const Mesh& mesh, const FloatFrame& frame, const Progress* progress);

  // Returns the bases of a body copied out of this one: its face i is face `faces[i]` of this one, or
  // unknown if that is invalid. O(k log k) for k faces.
  BaseFaces pick(std::span<const FaceId> faces) const;

  // Returns the same faces with one normal per position, the angle-weighted mean over all faces there,
  // whatever their dihedral angles. O(n log n).
  BaseFaces smoothed() const;

  // Returns the unit normals at three points in the plane of `base`, given in the body's float frame. An
  // unknown face gives the flat normal of the points.
  std::array<glm::vec3, 3> normals_at(FaceId base, const std::array<glm::vec3, 3>& points) const;

  // The number of face slots as loaded, and the corners of a face in the float frame; nullopt for an empty
  // slot.
  uint32_t count() const { return static_cast<uint32_t>(faces_.size()); }
  std::optional<std::array<glm::vec3, 3>> corners(FaceId base) const;

  // Returns true if the segment between two points in the plane of `base`, given in the float frame, lies
  // on a side of it that no other face shared as loaded.
  bool was_open(FaceId base, const glm::vec3& from, const glm::vec3& to) const;
  // Returns true if a mesh has the faces as loaded: none was split or removed.
  bool are_whole(const Mesh& mesh) const {
    return mesh.face_slots() == count() && mesh.live_faces() == live_;
  }

  // The sine of the angle between faces and the smooth normals at their corners that nine tenths of the
  // curved area do not exceed; 0 if nothing is curved.
  float deviation() const { return deviation_; }

  size_t bytes() const;

 private:
  static constexpr uint32_t kNone = 0xffffffffu;

  // The normal shared by the corners around one position whose faces join smoothly.
  struct Corner {
    glm::vec3 at;
    uint32_t normal;  // packed
  };
  class Builder;
  class Smoother;

  bool knows(FaceId base) const { return base.index < faces_.size() && faces_[base.index][0] != kNone; }

  uint32_t live_ = kNone;  // of the mesh as loaded; for a part of one, a value that no mesh has
  float deviation_ = 0;
  std::vector<uint8_t> open_;  // by face slot as loaded: bit i is set if the side after corner i was open
  std::vector<Corner> corners_;
  std::vector<std::array<uint32_t, 3>>
      faces_;  // by face slot as loaded: indices into corners_; kNone without a face
};

// Converts a unit vector to OpenGL's INT_2_10_10_10_REV and back.
uint32_t pack_normal(const glm::vec3& n);
glm::vec3 unpack_normal(uint32_t packed);

// The shading of a body as loaded. Immutable, and shared by all pieces copied out of the body.
struct LoadedShading {
  FloatFrame frame;
  std::shared_ptr<const BaseFaces> bases;
};
using LoadedShadings = std::map<BodyId, LoadedShading>;  // by Body::loaded_as

// Data for drawing a body that take long to compute. They involve no OpenGL, so another thread can prepare
// them.
struct PreparedBody {
  FloatFrame frame;  // frame in which its faces are drawn
  std::shared_ptr<const BaseFaces> bases;
  std::unique_ptr<ShadowCaster> caster;  // null if not prepared yet
};
using PreparedBodies = std::map<BodyId, PreparedBody>;

// Prepares the frame and the bases of a body: those of `loaded` if it has them, so that a piece is shaded
// like its body, otherwise new ones from its faces, which should be as loaded. Expected linear time.
PreparedBody prepare_shading(const Body& body, const LoadedShadings& loaded = {});
// Prepares the shading of every body of a world as loaded, or fails with cancelled() if stopped. `progress`
// may be null, here and below.
Result<PreparedBodies> prepare_shading(const World& world, const Progress* progress);
// Adds the shadow casters of prepared bodies, in their current state, or fails with cancelled() if stopped.
// Expected linear time.
Status prepare_shadows(const World& world, PreparedBodies& prepared, const Progress* progress);
// Prepares shading and shadows concurrently, for a world as loaded and uncut.
Result<PreparedBodies> prepare_drawing(const World& world, const Progress* progress);

// Memory used for drawing a world, in bytes.
struct PictureMemory {
  size_t shading = 0;   // smooth normals of the faces as loaded
  size_t shadows = 0;   // casters and shadow volumes
  size_t graphics = 0;  // graphics buffers and the lists of their contents

  PictureMemory& operator+=(const PictureMemory& more) {
    shading += more.shading;
    shadows += more.shadows;
    graphics += more.graphics;
    return *this;
  }
};

}  // namespace kerf
