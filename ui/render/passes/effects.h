#pragma once

#include <vector>

#include "ui/render/passes/beam_pass.h"

namespace kerf {

// A glowing droplet of metal, drawn as a streak.
struct Spark {
  Vec3 at, tail;     // m, world: where it is, and where its streak begins
  double width = 0;  // m, half of it
  double heat = 1;   // from 0, where it is invisible, over red and orange to 1, nearly white
};

// A puff of smoke, drawn as a soft disc that faces the eye.
struct Puff {
  Vec3 at;             // m, world
  double radius = 0;   // m
  double opacity = 0;  // 0 to 1
};

// A burnt place of a surface that beams do not cut.
struct Scorch {
  Vec3 at, normal;    // m and unit, world
  double radius = 0;  // m
  double heat = 0;    // from 1, where it was just burnt and glows, to 0
};

// What is drawn of lasers and of what they throw off.
struct Effects {
  std::vector<BeamPicture> beams;  // besides the one whose spot lights its environment
  std::vector<Spark> sparks;
  std::vector<Puff> puffs;
  std::vector<Scorch> scorches;
};

}  // namespace kerf
