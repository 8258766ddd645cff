#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/number_format.h"

namespace kerf {

// Temperature of the environment and of unheated material (K).
inline constexpr double kAmbient = 293;

// The constants of a material, one row each. Columns:
//   member of Substance, key in scenes, journals and assets/materials.json, default (mild steel), value of a
//   missing key, minimum, maximum, unit
// A missing key of a newer constant reproduces Kerf's behaviour before it existed: added_later(X).
#define KERF_SUBSTANCE(ROW)                                                                         \
  ROW(density, "material-density", 7850, always_written(7850), 1e-3, 1e6, "kg/m^3")                 \
  ROW(heat_solid, "heat-solid", 620, always_written(620), 1e-3, 1e6, "J/(kg K)")                    \
  ROW(heat_liquid, "heat-liquid", 820, always_written(820), 1e-3, 1e6, "J/(kg K)")                  \
  ROW(conductivity, "conductivity", 45, always_written(45), 0, 1e6, "W/(m K)")                      \
  ROW(transition, "transition", 1800, always_written(1800), kAmbient + 1, 1e5, "K")                 \
  ROW(latent, "latent", 270e3, always_written(270e3), 0, 1e9, "J/kg")                               \
  ROW(emissivity, "emissivity", 0.8, always_written(0.8), 0, 1, "")                                 \
  ROW(absorptivity_fibre, "absorptivity-fibre", 0.33, always_written(0.33), 0, 1, "") /* 1.07 um */ \
  ROW(absorptivity_co2, "absorptivity-co2", 0.1, always_written(0.1), 0, 1, "")       /* 10.6 um */ \
  ROW(burnt_share, "burnt-share", 0.4, added_later(0), 0, 1, "")                                    \
  ROW(wavelength, "wavelength", 1.07e-6, always_written(1.07e-6), 1e-9, 1, "m")

// The constants that determine the heat needed to remove a material: means over the temperature range, by
// default of mild steel. Preconditions of all functions: density, heat_solid and heat_liquid are positive,
// transition > kAmbient, and no constant is negative.
//
// A metal melts at `transition` and is removed once it has absorbed the heat of fusion (`latent`), because
// the melt is blown out. Plastics and wood instead decompose at `transition` and are removed once they have
// absorbed the rest of the heat of ablation (`latent`); sources state the heat of ablation as a total from
// the ambient temperature. The specific heats are those below and above the transition. `burnt_share` is the
// share of the kerf that burns with oxygen (see burning_heat). `wavelength` is that of the two absorptivities
// with which the material is usually cut.
struct Substance {
#define KERF_MEMBER(member, key, initial, ...) double member = initial;
  KERF_SUBSTANCE(KERF_MEMBER)
#undef KERF_MEMBER
  friend bool operator==(const Substance&, const Substance&) = default;
};

#define KERF_FIELD(member, key, initial, missing, least, most, unit) \
  {#member, key, &Substance::member, {least, most, unit}, missing},
inline constexpr NumberField<Substance> kSubstanceFields[] = {KERF_SUBSTANCE(KERF_FIELD)};
#undef KERF_FIELD
constexpr const NumberField<Substance>& substance_field(double Substance::*member) {
  const NumberField<Substance>* field = kSubstanceFields;
  while (field->member != member) ++field;
  return *field;
}

// Returns the substance of a saved object without any of the keys.
constexpr Substance substance_without_keys() {
  Substance s;
  for (const NumberField<Substance>& field : kSubstanceFields) s.*field.member = field.missing.value;
  return s;
}

// Returns true if `s` equals the material in all constants but those missing in older files.
constexpr bool is_of(const Substance& s, const Substance& material) {
  for (const NumberField<Substance>& field : kSubstanceFields) {
    const bool older = !field.missing.always_written && s.*field.member == field.missing.value;
    if (!older && s.*field.member != material.*field.member) return false;
  }
  return true;
}

// Returns the absorptivity at a wavelength (m): the one given for the nearer laser. A wavelength of 0 means
// the usual one of the material.
constexpr double absorptivity(const Substance& s, double wavelength) {
  constexpr double kBetween = 3.37e-6;  // the geometric mean
  return (wavelength > 0 ? wavelength : s.wavelength) < kBetween ? s.absorptivity_fibre : s.absorptivity_co2;
}

// Return the specific enthalpy (J/kg) relative to the ambient at the beginning and at the end of the
// transition; the beam removes a face at its end.
constexpr double enthalpy_before_transition(const Substance& s) {
  return s.heat_solid * (s.transition - kAmbient);
}
constexpr double enthalpy_of_removal(const Substance& s) { return enthalpy_before_transition(s) + s.latent; }

// Returns the temperature (K) at a specific enthalpy (J/kg) relative to the ambient: piecewise linear,
// constant during the transition; extrapolated with heat_solid below zero.
constexpr double temperature_at(const Substance& s, double enthalpy) {
  const double before = enthalpy_before_transition(s), after = before + s.latent;
  if (enthalpy <= before) return kAmbient + enthalpy / s.heat_solid;
  return enthalpy <= after ? s.transition : s.transition + (enthalpy - after) / s.heat_liquid;
}

// Returns the temperature (K) of a mass (kg) with an energy (J) above ambient; the ambient without mass.
constexpr double temperature_of(const Substance& s, double joules, double mass) {
  return mass > 0 ? temperature_at(s, joules / mass) : kAmbient;
}

// The inverse of temperature_at; at the transition, the enthalpy at its beginning.
constexpr double enthalpy_at(const Substance& s, double temperature) {
  if (temperature <= s.transition) return s.heat_solid * (temperature - kAmbient);
  return enthalpy_of_removal(s) + s.heat_liquid * (temperature - s.transition);
}

// Laser cutting with oxygen: a share of the kerf burns (Substance::burnt_share), and its heat helps to melt
// the rest (A. Ivarson et al., Journal of Materials Processing Technology 40, 1994). If more than about a
// quarter of the iron burnt, this heat alone would melt the kerf at any speed. The rate is therefore limited
// as well: oxygen reaches the iron through melt and oxide, and a front burns at kBurningFront at most. Both
// numbers are empirical.

// Heat of combustion of iron to FeO (J/kg): 267 kJ/mol.
inline constexpr double kHeatOfBurning = 4.78e6;
// Burning front speed (m/s), 2 m/min: up to it the front outruns a beam and leaves striations (Y. Arata et
// al., Transactions of JWRI 8, 1979).
inline constexpr double kBurningFront = 1.0 / 30;
// Ignition temperature of iron (K).
inline constexpr double kKindling = 1143;

// Returns the heat (J/kg) that burning adds to each kilogram of the kerf at a beam speed (m/s).
constexpr double burning_heat(const Substance& s, double speed) {
  return s.burnt_share * kHeatOfBurning * (speed > kBurningFront ? kBurningFront / speed : 1);
}

// A constant of a material and its source.
struct MaterialNumber {
  std::string key;   // as in assets/materials.json
  double value = 0;  // in SI units
  Interval range;    // of published values
  std::string source;
};

// A material that can be cut, by its name in the command line and scenes.
struct Material {
  std::string name;        // "mild-steel"
  std::string title;       // "Mild steel"
  std::string removed_by;  // "melting" or "ablation"
  Substance substance;
  std::vector<MaterialNumber> numbers;  // all constants, in the order of the file
};

inline const Material* find_material(std::span<const Material> materials, const std::string& name) {
  for (const Material& material : materials) {
    if (material.name == name) return &material;
  }
  return nullptr;
}

}  // namespace kerf
