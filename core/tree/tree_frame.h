#pragma once

#include <array>

#include "core/base/vec3.h"
#include "core/mesh/mesh.h"

namespace kerf {

// The coordinates of a tree's boxes: (x - origin) times a power of two, so that a mesh of any size anywhere
// lies about within [-1, 1] and floats suffice to cull.
struct TreeFrame {
  Vec3 origin{0};
  double scale = 1;  // a power of two

  // Around the live faces of a mesh; the identity for a mesh without any.
  static TreeFrame around(const Mesh& mesh);

  Vec3 to_tree(const Vec3& p) const { return (p - origin) * scale; }
  Vec3 to_mesh(const Vec3& p) const { return origin + p / scale; }
};

// How far a float of a tree may lie from the double that it was rounded from, relative to itself and, near
// zero, absolutely. Both are several times the rounding, so that sums of a few such errors fit as well.
inline constexpr float kFloatSlack = 0x1p-22f;
inline constexpr float kFloatLeast = 0x1p-126f;

// The float moved outward past the double that it was rounded from.
inline float round_down(float x) { return x - ((x < 0 ? -x : x) * kFloatSlack + kFloatLeast); }
inline float round_up(float x) { return x + ((x < 0 ? -x : x) * kFloatSlack + kFloatLeast); }

}  // namespace kerf
