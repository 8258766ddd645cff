#pragma once

#include "core/heat/material.h"
#include "core/mesh/mesh.h"

namespace kerf {

// Heat of the faces of a mesh. Each face is a small sheet of one temperature.
//
// The energy of a face is relative to the ambient temperature: a face that was never heated has no energy and
// takes no memory. The parts of a split face share its energy by area, so that splitting conserves energy and
// temperatures.
struct FaceHeat {
  FaceColumn<double> energy;  // J
  FaceColumn<float> hottest;  // K, the highest temperature the face ever had; 0 if it was never hot

  // Attaches both columns. Precondition: no change of the mesh is open. O(1).
  static FaceHeat attach(Mesh& mesh);

  double energy_of(const Mesh& mesh, FaceId f) const { return mesh.columns().get(energy, f); }
  // Sets the energy of a face (J). Precondition: f is live.
  void set_energy(Mesh& mesh, FaceId f, double joules) const { mesh.columns().set(energy, f, joules); }

  // Returns the temperature (K) of a face of a sheet of this thickness (m); the ambient for a face without
  // area.
  double temperature(const Mesh& mesh, FaceId f, const Substance& substance, double thickness) const;
  // Returns the highest recorded temperature of f (see record_hottest), K.
  double hottest_of(const Mesh& mesh, FaceId f) const;
  void record_hottest(Mesh& mesh, FaceId f, double temperature) const;

  // Returns the sum over all faces (J). O(hot faces).
  double stored(const Mesh& mesh) const;
};

// Losses of a sheet to its environment, from both sides.
struct HeatLoss {
  double convection = 15;  // W/(m^2 K), from each side; still air
};

inline constexpr double kStefanBoltzmann = 5.670374419e-8;  // W/(m^2 K^4)

// Returns the loss of both sides of a sheet at a temperature (K) by convection and grey radiation, divided by
// the temperature difference to the ambient: W/(m^2 K).
constexpr double heat_lost_per_kelvin(const Substance& s, const HeatLoss& loss, double temperature) {
  const double squares = temperature * temperature + kAmbient * kAmbient;
  return 2 * (loss.convection + s.emissivity * kStefanBoltzmann * squares * (temperature + kAmbient));
}

// Returns the derivative of this loss (W/m^2) with respect to temperature, W/(m^2 K).
constexpr double heat_lost_slope(const Substance& s, const HeatLoss& loss, double temperature) {
  return 2 *
         (loss.convection + 4 * s.emissivity * kStefanBoltzmann * temperature * temperature * temperature);
}

struct HeatMemory;

// Conducts heat between the faces of a mesh, and from them to the environment, for a time (s, >= 0). Changes
// the energies of `heat`, and records the hottest temperatures above 500 K. Returns the energy lost (J): the
// energy of the faces before minus that after.
//
// Discretisation: one temperature per face, two-point flux over each shared edge (see HeatRegion). Backward
// Euler, solved by conjugate gradients for the faces more than 0.5 K above the ambient, those around them,
// and further faces as the heat reaches them. The energy error left by the solver's tolerance is distributed
// in proportion to the energies, so that conservation is exact. Losses are evaluated in the middle of the
// step (second order), and a time is divided into up to 64 steps to keep them accurate. The transition is
// implicit in the enthalpy: a face in it keeps its temperature and absorbs or releases the flux (semismooth
// Newton iteration). No face becomes colder than the ambient or hotter than the hottest face before; stable
// for every time step. A face at most 0.5 K above the ambient without a warmer neighbour is excluded and
// relaxes to the ambient at 0.5 K/s, so that a plate finally cools completely and its column becomes empty.
//
// Preconditions: thickness (m) > 0, the substance meets its preconditions, no loss is negative. The result is
// identical to the bit on every machine, whatever the contents of `memory`. O(hot faces), independent of the
// size of the mesh.
double conduct(Mesh& mesh, const FaceHeat& heat, const Substance& substance, double thickness,
               const HeatLoss& loss, double seconds, HeatMemory& memory);

}  // namespace kerf
