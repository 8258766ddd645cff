#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/document/document.h"
#include "core/document/scene.h"
#include "core/world/world.h"

namespace kerf::test {

// A part of a mesh, at its place.
struct NamedSheet {
  std::string name;
  Soup soup;
  Vec3 position{0};
  glm::dquat orientation{1, 0, 0, 0};
};

// One soup of several parts.
Soup assembled(std::span<const NamedSheet> sheets);

// A world of one body of these parts with these joints. The joints must fit.
World jointed_world(std::span<const NamedSheet> sheets, std::span<const JointDescription> joints);

// Makes every piece that moves on its own a body: what joints hold only movably, and what was cut off.
// Returns the bodies in the order of their ids.
std::vector<BodyId> part_bodies(World& world);

// Cuts the car of assets/scenes/car.json along x by one stroke, at a height of 1.25 m.
void cut_car(Document& document);

}  // namespace kerf::test
