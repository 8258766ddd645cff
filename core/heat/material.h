#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/number_format.h"

namespace kerf {

// The temperature of everything that was never heated, and of the environment (K).
inline constexpr double kAmbient = 293;

// The constants of a material, one row each. A row is all that a constant needs: its member of Substance, its
// key and limits in scenes, journals and assets/materials.json, and its row in the Material panel. Columns:
//   member, key in scenes and journals, default (mild steel), what a missing key stands for, least, most,
//   unit, and for the panel: label (null: not shown), size of the unit that is shown, format, meaning
// A missing key of a constant that is new stands for what Kerf did before it existed: added_later(X).
#define KERF_SUBSTANCE(ROW)                                                                                  \
  ROW(density, "material-density", 7850, always_written(7850), 1e-3, 1e6, "kg/m^3", "Density", 1,            \
      "%.5g kg/m\xc2\xb3", "Of the material.")                                                               \
  ROW(heat_solid, "heat-solid", 620, always_written(620), 1e-3, 1e6, "J/(kg K)", "Heat, solid", 1,           \
      "%.4g J/(kg K)", "What it takes to heat it by a kelvin.")                                              \
  ROW(heat_liquid, "heat-liquid", 820, always_written(820), 1e-3, 1e6, "J/(kg K)", "Heat, liquid", 1,        \
      "%.4g J/(kg K)", "The same once it is molten.")                                                        \
  ROW(conductivity, "conductivity", 45, always_written(45), 0, 1e6, "W/(m K)", "Conductivity", 1,            \
      "%.4g W/(m K)", "How well it conducts heat.")                                                          \
  ROW(transition, "transition", 1800, always_written(1800), kAmbient + 1, 1e5, "K", "Melts at", 1, "%.4g K", \
      "Where it melts, or decomposes. With the latent heat on top it is gone.")                              \
  ROW(latent, "latent", 270e3, always_written(270e3), 0, 1e9, "J/kg", "Latent heat", 1000, "%.4g kJ/kg",     \
      "What melting takes, or decomposing.")                                                                 \
  ROW(emissivity, "emissivity", 0.8, always_written(0.8), 0, 1, "", "Emissivity", 1, "%.3g",                 \
      "0 to 1: how well it radiates, from both sides.")                                                      \
  ROW(absorptivity_fibre, "absorptivity-fibre", 0.33, always_written(0.33), 0, 1, "", "Absorbs, fibre", 1,   \
      "%.3g", "0 to 1: the share of a beam of 1.07 \xc2\xb5m that stays in it.")                             \
  ROW(absorptivity_co2, "absorptivity-co2", 0.1, always_written(0.1), 0, 1, "", "Absorbs, CO2", 1, "%.3g",   \
      "0 to 1: the share of a beam of 10.6 \xc2\xb5m that stays in it.")                                     \
  ROW(burnt_share, "burnt-share", 0.4, added_later(0), 0, 1, "", "Burns", 1, "%.3g",                         \
      "0 to 1: the share of the kerf that burns where the laser blows oxygen.")                              \
  ROW(wavelength, "wavelength", 1.07e-6, always_written(1.07e-6), 1e-9, 1, "m", nullptr, 1, "",              \
      "Of the beam with which the material is usually cut.")

// The constants that tell how much heat a material takes until it is removed. They are means over the range
// of temperatures. By default mild steel. Precondition of its use: density, heat_solid, heat_liquid are
// positive, transition > kAmbient, and nothing is negative.
//
// A metal melts at `transition`, and what is molten is blown out: it is gone when it has taken the heat of
// fusion. What decomposes instead of melting (plastics, wood) does so at `transition`, where it takes the
// rest of its heat of ablation (`latent`), which is measured as a whole from the ambient on. The specific
// heats are those below and above the transition. `burnt_share` says how much of the kerf burns where the
// laser blows oxygen (see core/heat/material.h). `wavelength` is the one of the two of the absorptivities
// with which the material is usually cut.
struct Substance {
#define KERF_MEMBER(member, key, initial, ...) double member = initial;
  KERF_SUBSTANCE(KERF_MEMBER)
#undef KERF_MEMBER
  friend bool operator==(const Substance&, const Substance&) = default;
};

// The rows of the table, in its order.
#define KERF_FIELD(member, key, initial, missing, least, most, unit, ...) \
  {#member, key, &Substance::member, {least, most, unit}, missing, __VA_ARGS__},
inline constexpr NumberField<Substance> kSubstanceFields[] = {KERF_SUBSTANCE(KERF_FIELD)};
#undef KERF_FIELD
constexpr const NumberField<Substance>& substance_field(double Substance::*member) {
  const NumberField<Substance>* field = kSubstanceFields;
  while (field->member != member) ++field;
  return *field;
}

// The substance that an object of constants stands for that has none of its keys.
constexpr Substance substance_without_keys() {
  Substance s;
  for (const NumberField<Substance>& field : kSubstanceFields) s.*field.member = field.missing.value;
  return s;
}

// Whether this is a material: the same in all constants, but for those that a file of before did not have.
constexpr bool is_of(const Substance& s, const Substance& material) {
  for (const NumberField<Substance>& field : kSubstanceFields) {
    const bool older = !field.missing.always_written && s.*field.member == field.missing.value;
    if (!older && s.*field.member != material.*field.member) return false;
  }
  return true;
}

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

// The temperature (K) of a mass (kg) with an energy (J) relative to the ambient; the ambient without mass.
constexpr double temperature_of(const Substance& s, double joules, double mass) {
  return mass > 0 ? temperature_at(s, joules / mass) : kAmbient;
}

// The reverse of temperature_at: the enthalpy at a temperature; of the transition its beginning.
constexpr double enthalpy_at(const Substance& s, double temperature) {
  if (temperature <= s.transition) return s.heat_solid * (temperature - kAmbient);
  return enthalpy_of_removal(s) + s.heat_liquid * (temperature - s.transition);
}

// Laser cutting with oxygen: a share of the kerf burns (Substance::burnt_share), and its heat helps to melt
// the rest (A. Ivarson et al., Journal of Materials Processing Technology 40, 1994). With more than about a
// quarter of iron burnt that heat alone would melt the kerf at any speed; so the rate is bounded, too: oxygen
// reaches the iron through what is molten and burnt already, and a front does not burn faster than
// kBurningFront. Both numbers are empirical.

// J/kg, of iron that burns to FeO: 267 kJ/mol.
inline constexpr double kHeatOfBurning = 4.78e6;
// m/s: 2 m/min, up to which the front runs ahead of a beam and leaves striations (Y. Arata et al.,
// Transactions of JWRI 8, 1979).
inline constexpr double kBurningFront = 1.0 / 30;
// K, at which iron catches fire.
inline constexpr double kKindling = 1143;

// The heat (J/kg) that burning adds to each kilogram of the kerf of a beam that goes on at a speed (m/s).
constexpr double burning_heat(const Substance& s, double speed) {
  return s.burnt_share * kHeatOfBurning * (speed > kBurningFront ? kBurningFront / speed : 1);
}

// One constant of a material and where it is from.
struct MaterialNumber {
  std::string key;   // as in assets/materials.json
  double value = 0;  // in SI units
  Interval range;    // of the values that were published
  std::string source;
};

// A material that can be cut, by the name that the command line and scenes use.
struct Material {
  std::string name;        // "mild-steel"
  std::string title;       // "Mild steel"
  std::string removed_by;  // "melting" or "ablation"
  Substance substance;
  std::vector<MaterialNumber> numbers;  // all of them, in the order of the file
};

// The material of that name; null where there is none.
inline const Material* find_material(std::span<const Material> materials, const std::string& name) {
  for (const Material& material : materials) {
    if (material.name == name) return &material;
  }
  return nullptr;
}

}  // namespace kerf
