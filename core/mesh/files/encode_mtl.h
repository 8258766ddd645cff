#pragma once

#include <span>
#include <string>

#include "core/base/vec3.h"

namespace kerf {

// A material of an OBJ file as its library (MTL) describes it.
struct MaterialLook {
  std::string name;  // as in usemtl; empty: the unnamed material, which OBJ calls "default"
  Vec3 colour{0};    // sRGB, 0 .. 1
  double gloss = 0;  // 0 matt .. 1 polished
};

// Encodes a library of materials: the colour as Kd, and the gloss as Ks and as the exponent Ns, 0 .. 1000.
// Numbers are the shortest that are read back exactly. Linear time.
std::string encode_mtl(std::span<const MaterialLook> materials);

}  // namespace kerf
