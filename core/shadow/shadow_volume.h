#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/shadow/light.h"
#include "core/shadow/shadow_caster.h"

namespace kerf {

// How the volume that a body keeps from the light is made.
enum class ShadowMethod {
  // The paper's: the polygons that face the light, and of their edges those that only one of them has.
  kPaperOneVolume,
  // That and the same of the averted polygons, the paper's answer for hollow meshes.
  kPaperTwoVolumes,
  // Every polygon, turned to face the light, spans a closed volume of its own; along each edge their sides
  // are
  // added up with their directions. (G. Aldridge, E. Woods: Robust, geometry-independent shadow volumes,
  // 2004,
  // after P. Bergeron: A general version of Crow's shadow volumes, 1986.)
  kRobust,
};

// A light as one body sees it, in the coordinates of the body's float frame.
struct LightOnBody {
  LightPoint light;
  // Pieces that see it otherwise than the body, by label, because they are drawn elsewhere; nothing for
  // pieces that are not drawn and cast no shadow. Labels beyond the last are as the body.
  std::vector<std::optional<LightPoint>> pieces;
  friend bool operator==(const LightOnBody&, const LightOnBody&) = default;
};

// An edge of the silhouette: so many sides of the volume lie on it.
struct SilhouetteEdge {
  uint32_t edge = 0;  // slot of the caster
  // Never 0. Above: the volume lies left of low -> high seen from the light, below: right. 1 at the rim of a
  // sheet, 2 where a closed surface turns away, any number where more than two triangles meet.
  int multiplicity = 0;
  friend bool operator==(const SilhouetteEdge&, const SilhouetteEdge&) = default;
};

// The shadow volume of one body under one light, as a sign for every face and a silhouette, which together
// with the caster's positions are all that there is to draw. Closed for kRobust: at every vertex the
// multiplicities of the edges that leave it, minus those that arrive, sum to zero.
//
// Nothing depends on where the eye is.
class ShadowVolume {
 public:
  explicit ShadowVolume(ShadowMethod method = ShadowMethod::kRobust) : method_(method) {}

  ShadowMethod method() const { return method_; }
  const LightOnBody& light() const { return light_; }

  // Everything anew. O(faces + edges).
  void rebuild(const ShadowCaster& caster, LightOnBody light);
  // What the caster's update() changed, under the same light. O(changes), times the faces on their edges.
  void follow(const ShadowCaster& caster, const ShadowCaster::Change& change);

  // 1: the triangle faces the light, -1: it is averted, 0: it casts nothing or the light is in its plane.
  int8_t sign(uint32_t face) const { return signs_[face]; }
  std::span<const int8_t> signs() const { return signs_; }

  // In no order.
  std::span<const SilhouetteEdge> silhouette() const { return silhouette_; }

  // Since the last call: the faces whose sign and the places of silhouette() that were computed anew, some
  // more than once and some beyond its end; or that everything was.
  struct Touched {
    bool all = true;
    std::vector<uint32_t> faces, places;
  };
  Touched take_touched();

  // How much was looked at since the volume was made.
  struct Work {
    uint64_t faces = 0, edges = 0;
  };
  const Work& work() const { return work_; }

  // Memory that it holds.
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
  std::vector<uint32_t> place_;  // in silhouette_, by edge
  Touched touched_;
  Work work_;
};

// Which side of its plane the light is on: the sign of (b - a) x (c - a) . (light - a).
int light_side(const std::array<glm::vec3, 3>& triangle, const LightPoint& light);

}  // namespace kerf
