#pragma once

#include <span>

#include "core/cut/step_state.h"

namespace kerf {

// Leaves the heat of a cut by the geometric model in the faces beside what a move of the beam removed: where
// the body is d metres away from the volume that the beam swept, it is as hot as the transition of its
// material (melting) at d = 0 and less, linearly in d, down to the ambient at d = settings.heat_width. A face
// gets the mean of the enthalpy over its area, from samples finer than the width; no face is split for it. A
// face that is hotter keeps its heat, so that moves which overlap do not add up. The energy is booked as
// emitted and absorbed.
//
// Only faces that hang together with `beside` within that distance are heated: the live faces that the beam
// touched or that adjoin removed ones. Precondition: step.beam is that of the move, and heat_width > 0.
// O(faces within the width).
void deposit_heat(World& world, BodyStep& step, const CutSettings& settings, std::span<const FaceId> beside);

// Makes walls as hot as the transition of their material, since they lie where the beam was. Booked likewise.
void heat_walls(World& world, const BodyStep& step, std::span<const FaceId> walls);

}  // namespace kerf
