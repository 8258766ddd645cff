#pragma once

#include <cassert>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/shadow/light.h"
#include "core/shadow/shadow_caster.h"

namespace kerf {

// How the shadow volume of a body is constructed.
enum class ShadowMethod {
  // The method of the paper: the polygons that face the light are the cap, and the edges that belong to
  // exactly one of them are the silhouette.
  kPaperOneVolume,
  // In addition the same for the polygons that face away from the light, the paper's method for hollow
  // meshes.
  kPaperTwoVolumes,
  // Every polygon, oriented towards the light, spans a closed volume of its own; along each edge their sides
  // are added with their signs. (G. Aldridge, E. Woods: Robust, geometry-independent shadow volumes, 2004,
  // after P. Bergeron: A general version of Crow's shadow volumes, 1986.)
  kRobust,
};

// A light relative to one body, in the coordinates of the body's float frame.
struct LightOnBody {
  LightPoint light;
  // The light relative to each piece, by label, because pieces may be drawn displaced; nothing for a piece
  // that is hidden and casts no shadow. For labels beyond the last one `light` holds.
  std::vector<std::optional<LightPoint>> pieces;
  friend bool operator==(const LightOnBody&, const LightOnBody&) = default;
};

// An edge of the silhouette and the number of sides of the volume that lie on it.
struct SilhouetteEdge {
  uint32_t edge = 0;  // slot of the caster
  // Never 0. If positive, the volume lies to the left of low -> high as seen from the light, if negative to
  // the right. Its magnitude is 1 at the rim of a sheet, 2 at the contour of a closed surface, and any number
  // where more than two triangles meet.
  int multiplicity = 0;
  friend bool operator==(const SilhouetteEdge&, const SilhouetteEdge&) = default;
};

// The shadow volume of one body for one light: a sign for every face and a silhouette, which together with
// the caster's positions suffice to draw it. For kRobust it is closed: at every vertex the multiplicities of
// the edges that start there add up to those of the edges that end there. It does not depend on the
// viewpoint.
class ShadowVolume {
 public:
  explicit ShadowVolume(ShadowMethod method = ShadowMethod::kRobust) : method_(method) {}

  ShadowMethod method() const { return method_; }
  const LightOnBody& light() const { return light_; }

  // Computes the volume for a light. O(faces + edges).
  void rebuild(const ShadowCaster& caster, LightOnBody light);
  // Follows a change that the caster's update() returned, for the same light. Precondition: rebuild() was
  // called with this caster. O(size of the change times the number of faces on its edges).
  void follow(const ShadowCaster& caster, const ShadowCaster::Change& change);

  // 1 if the triangle faces the light, -1 if it faces away, 0 if it casts no shadow or the light lies in its
  // plane. Precondition: face < signs().size().
  int8_t sign(uint32_t face) const {
    assert(face < signs_.size());
    return signs_[face];
  }
  std::span<const int8_t> signs() const { return signs_; }

  // The edges of the silhouette in unspecified order.
  std::span<const SilhouetteEdge> silhouette() const { return silhouette_; }

  // The entries that were recomputed since the last call of take_touched(): the faces whose signs and the
  // indices into silhouette() whose entries may have changed, perhaps repeated or beyond its end; or
  // everything.
  struct Touched {
    bool all = true;
    std::vector<uint32_t> faces, places;
  };
  Touched take_touched();

  // The numbers of faces and edges processed since the volume was constructed.
  struct Effort {
    uint64_t faces = 0, edges = 0;
  };
  const Effort& effort() const { return effort_; }

  // Memory allocated, in bytes.
  size_t bytes() const;

 private:
  static constexpr uint32_t kNone = 0xffffffffu;

  int8_t facing(const ShadowCaster& caster, uint32_t face) const;
  int multiplicity(const ShadowCaster& caster, uint32_t edge) const;
  void put(uint32_t edge, int multiplicity);

  ShadowMethod method_;
  LightOnBody light_;
  std::vector<int8_t> signs_;
  std::vector<SilhouetteEdge> silhouette_;
  std::vector<uint32_t> place_;  // by edge: its index in silhouette_, or kNone
  Touched touched_;
  Effort effort_;
};

// The side of the triangle's plane on which the light lies: the sign of (b - a) x (c - a) . (light - a).
int light_side(const std::array<glm::vec3, 3>& triangle, const LightPoint& light);

}  // namespace kerf
