#pragma once

#include <array>

#include "core/heat/substance.h"

namespace kerf {

// A constant of a substance with its key in scenes and journals, and the interval in which it makes sense.
struct SubstanceNumber {
  const char* key;
  double& number;
  double least, most;
};

// All constants of a substance.
inline std::array<SubstanceNumber, 10> substance_numbers(Substance& s) {
  return {{{"material-density", s.density, 1e-3, 1e6},
           {"heat-solid", s.heat_solid, 1e-3, 1e6},
           {"heat-liquid", s.heat_liquid, 1e-3, 1e6},
           {"conductivity", s.conductivity, 0, 1e6},
           {"transition", s.transition, kAmbient + 1, 1e5},
           {"latent", s.latent, 0, 1e9},
           {"emissivity", s.emissivity, 0, 1},
           {"absorptivity-fibre", s.absorptivity_fibre, 0, 1},
           {"absorptivity-co2", s.absorptivity_co2, 0, 1},
           {"wavelength", s.wavelength, 1e-9, 1}}};
}

}  // namespace kerf
