#pragma once

#include "core/heat/substance.h"
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
  // The highest temperature that f ever had as far as it was recorded (see note_hottest), K.
  double hottest_of(const Mesh& mesh, FaceId f) const;
  // Records that f is at this temperature (K).
  void note_hottest(Mesh& mesh, FaceId f, double temperature) const;

  // The sum over all faces (J). O(hot faces).
  double stored(const Mesh& mesh) const;
};

}  // namespace kerf
