#pragma once

#include <optional>

#include "core/cut/cut_step.h"
#include "core/world/world.h"
#include "ui/render/passes/beam_pass.h"

namespace kerf {

// The length in metres at which a ray first meets a body that a beam can cut (see cuttable); nothing if it
// misses all.
std::optional<double> first_hit(const World& world, const Pose& ray);

// The length in metres at which a beam first meets such a body. Rays are cast along its axis, around its
// radius and around the rim of what it burns, which lies `overshoot` metres farther out. Nothing if no ray
// hits within `reach` metres.
std::optional<double> find_strike(const World& world, const Pose& beam, double radius, double overshoot,
                                  double reach);

// A beam as it is drawn over at most a length (m), with the place where it first meets a body.
BeamPicture picture_of_beam(const World& world, const CutSettings& settings, const Pose& beam, double length);

}  // namespace kerf
