#pragma once

#include <cstdint>

namespace kerf {

// Where the energy that beams have emitted has gone (J): emitted = absorbed + escaped. What was absorbed is
// stored in faces (FaceHeat::stored), went with faces that were removed (Body::ejected), or was lost to the
// surroundings.
struct EnergyLedger {
  double emitted = 0;
  double absorbed = 0;  // by faces
  double escaped = 0;   // reflected, or gone past all faces
  double lost = 0;      // by convection and radiation
  // The seconds for which beams of the thermal model were on, which tell where pulses are.
  double beam_on = 0;
  uint64_t poses = 0;  // from which they sent rays; see turned_bundle
  // The seconds for which heat has already flowed that the clock has not passed yet (see let_heat_flow).
  double ahead = 0;

  friend bool operator==(const EnergyLedger&, const EnergyLedger&) = default;
};

}  // namespace kerf
