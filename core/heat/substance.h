#pragma once

namespace kerf {

// The temperature of everything that was never heated, and of the surroundings (K).
inline constexpr double kAmbient = 293;

// What it takes to heat a material and to remove it, with constants that are means over the range of
// temperatures. By default mild steel. Precondition of its use: density, heat_solid, heat_liquid are
// positive, transition > kAmbient, and nothing is negative.
//
// A metal melts at `transition`, and what is molten is blown out: it is gone when it has taken the heat of
// fusion. What decomposes instead of melting (plastics, wood) does so at `transition`, where it takes the
// rest of its heat of ablation, which is measured as a whole from the ambient on.
struct Substance {
  double density = 7850;     // kg/m^3
  double heat_solid = 620;   // J/(kg K), specific heat below the transition
  double heat_liquid = 820;  // J/(kg K), above it
  double conductivity = 45;  // W/(m K)
  double transition = 1800;  // K, melting or decomposition
  double latent = 270e3;     // J/kg, taken at the transition
  double emissivity = 0.8;   // 0 .. 1, of both sides
  // The share of the power of a beam that stays in a face, 0 .. 1, at 1.07 um (fibre lasers) and at 10.6 um
  // (CO2), and the one of these wavelengths (m) with which the material is usually cut.
  double absorptivity_fibre = 0.33;
  double absorptivity_co2 = 0.1;
  double wavelength = 1.07e-6;
  friend bool operator==(const Substance&, const Substance&) = default;
};

// The absorptivity at a wavelength (m), that of the nearer of the two; 0 stands for the usual wavelength.
constexpr double absorptivity(const Substance& s, double wavelength) {
  constexpr double kBetween = 3.37e-6;  // the geometric mean
  return (wavelength > 0 ? wavelength : s.wavelength) < kBetween ? s.absorptivity_fibre : s.absorptivity_co2;
}

// The specific enthalpy (J/kg) relative to the ambient at which the transition begins, and at which it is
// complete; a face under the beam is gone with the latter.
constexpr double enthalpy_before_transition(const Substance& s) {
  return s.heat_solid * (s.transition - kAmbient);
}
constexpr double enthalpy_of_removal(const Substance& s) { return enthalpy_before_transition(s) + s.latent; }

// The temperature (K) at a specific enthalpy (J/kg) relative to the ambient: piecewise linear, constant
// during the transition. Below zero it goes on with heat_solid.
constexpr double temperature_at(const Substance& s, double enthalpy) {
  const double before = enthalpy_before_transition(s), after = before + s.latent;
  if (enthalpy <= before) return kAmbient + enthalpy / s.heat_solid;
  return enthalpy <= after ? s.transition : s.transition + (enthalpy - after) / s.heat_liquid;
}

// The reverse: the enthalpy at a temperature; of the transition its beginning.
constexpr double enthalpy_at(const Substance& s, double temperature) {
  if (temperature <= s.transition) return s.heat_solid * (temperature - kAmbient);
  return enthalpy_of_removal(s) + s.heat_liquid * (temperature - s.transition);
}

}  // namespace kerf
