#pragma once

#include <span>

#include "core/cut/cut_step.h"
#include "core/world/heat_flow.h"

namespace kerf {

// One step of a cut by the thermal model, which cut_step calls: moves of the beam through all bodies that it
// may cut, one after the other, until settings.bite faces were processed.
//
// In each move, the faces that the beam reaches are split until they are fine enough (refine); those behind
// a wall that still stands are not. The move is divided into parts in which the beam goes on by a fraction of
// its radius and emits no more than melts what it covers. In each part a bundle of rays (ray_bundle) shares
// the energy that is emitted: a ray heats the first face that it meets and is reflected for the rest; where
// the face has taken its energy of removal, what the ray has left goes on to the next face behind. So the
// speed of a cut depends neither on the size of faces nor on the rate of moves. Faces that have their energy
// of removal are removed with it; after each part heat flows for the duration of the part (let_heat_flow),
// and after each move separated pieces get their labels.
//
// A ray that has the energy for a face wider than the kerf (two radii) waits while the face can be split: the
// parts that are gone are removed, the face is split, and the ray goes on. If the resolution forbids to split
// it, it is removed for as much energy as a strip of it as wide as the kerf needs (scales_removal).
//
// Fails like cut_step. A move without a duration emits nothing. The result does not depend on the division
// into steps.
Result<StepResult> thermal_step(World& world, const CutSettings& settings, std::span<const BeamMove> moves,
                                const Progress* progress = nullptr);

// Whether the resolution lets faces stay so large that their energy of removal is scaled.
bool scales_removal(const CutSettings& settings);

}  // namespace kerf
