#pragma once

#include "core/heat/material.h"
#include "core/mesh/mesh.h"

namespace kerf {

// The heat of the faces of a mesh. Each face is a small sheet of one temperature.
//
// The energy of a face is relative to the ambient: a face that was never heated has none and takes no memory.
// The parts of a split face share it by area, so that splitting neither makes nor loses energy and leaves
// temperatures what they are.
struct FaceHeat {
  FaceColumn<double> energy;  // J
  FaceColumn<float> hottest;  // K, the highest temperature that the face ever had; 0 where it was never hot

  // Attaches both columns. Precondition: no change of the mesh is open. Constant time.
  static FaceHeat attach(Mesh& mesh);

  double energy_of(const Mesh& mesh, FaceId f) const { return mesh.columns().get(energy, f); }
  // Sets the energy of a face (J). Precondition: f is live.
  void set_energy(Mesh& mesh, FaceId f, double joules) const { mesh.columns().set(energy, f, joules); }

  // The temperature of a face (K) of a sheet of the given thickness (m). A face without area is at the
  // ambient.
  double temperature(const Mesh& mesh, FaceId f, const Substance& substance, double thickness) const;
  // The highest temperature that f ever had as far as it was recorded (see record_hottest), K.
  double hottest_of(const Mesh& mesh, FaceId f) const;
  // Records that f is at this temperature (K).
  void record_hottest(Mesh& mesh, FaceId f, double temperature) const;

  // The sum over all faces (J). O(hot faces).
  double stored(const Mesh& mesh) const;
};

// The losses of a sheet to its environment, from both sides.
struct HeatLoss {
  double convection = 15;  // W/(m^2 K), from each side; still air
};

inline constexpr double kStefanBoltzmann = 5.670374419e-8;  // W/(m^2 K^4)

// The loss of both sides of a sheet at a temperature (K) by convection and grey radiation, over the
// difference of the temperature from the ambient: W/(m^2 K).
constexpr double heat_lost_per_kelvin(const Substance& s, const HeatLoss& loss, double temperature) {
  const double squares = temperature * temperature + kAmbient * kAmbient;
  return 2 * (loss.convection + s.emissivity * kStefanBoltzmann * squares * (temperature + kAmbient));
}

// The derivative of this loss (W/m^2) by the temperature, W/(m^2 K).
constexpr double heat_lost_slope(const Substance& s, const HeatLoss& loss, double temperature) {
  return 2 *
         (loss.convection + 4 * s.emissivity * kStefanBoltzmann * temperature * temperature * temperature);
}

struct HeatMemory;

// Lets heat flow between the faces of a mesh, and from them to the environment, for a time (s, >= 0).
// Changes the energies of `heat`, and records the hottest temperatures where they are above 500 K. Returns
// the energy that was lost (J): what the faces had before less what they have after.
//
// Discretisation: one temperature a face, two-point flux over each shared edge (see HeatRegion). Backward
// Euler, solved by conjugate gradients for the faces that are more than 0.5 K above the ambient and those
// around them, and further faces as the heat gets there. What the tolerance of the solver leaves of the sum
// of the energies is shared out in proportion to them, so that conservation is exact. Losses are taken in the
// middle of the step (second order), and a time is divided into up to 64 steps so that they stay accurate.
// The transition is implicit in the enthalpy: a face that is in it keeps its temperature and takes or gives
// the flux (semismooth Newton iteration). No face gets colder than the ambient, or hotter than the hottest
// was; stable for every time step. A face that is at most 0.5 K above the ambient and has no neighbour that
// is more takes no part and goes to the ambient at 0.5 K/s, so that a plate ends cold and its column blank.
//
// Preconditions: thickness (m) > 0, the substance as it demands, no loss is negative. The result is the same
// to the bit on every machine, whatever `memory` was used for before. O(hot faces), whatever the size of the
// mesh.
double conduct(Mesh& mesh, const FaceHeat& heat, const Substance& substance, double thickness,
               const HeatLoss& loss, double seconds, HeatMemory& memory);

}  // namespace kerf
