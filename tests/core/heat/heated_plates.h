#pragma once

#include <functional>
#include <vector>

#include "core/heat/conduction_solver.h"
#include "core/heat/face_heat.h"
#include "core/mesh/build_mesh.h"

namespace kerf::test {

// The steel of the reference numbers: constant properties, no losses, no transition in reach.
Substance reference_steel();
inline constexpr double kSheet = 1e-3;                  // m, its thickness
inline constexpr HeatLoss kNoLoss = {.convection = 0};  // with an emissivity of 0

// How the diagonals of a grid lie.
enum class Diagonals { kAlternating, kOneWay };
// A plate in y = 0 whose vertices have these coordinates.
Soup plate_of(const std::vector<double>& xs, const std::vector<double>& zs, Diagonals diagonals);
// Coordinates that are `step` apart from `from` to `to` and, `beyond` on both sides, ever farther.
std::vector<double> graded(double from, double to, double step, double beyond);
// A plate of nearly equilateral triangles with vertices moved by up to `jitter` of their distance, made
// Delaunay by turning edges. Between -half and half along x and z.
Mesh jittered_plate(double half, double step, double jitter, uint64_t seed);

// A mesh with heat.
struct HeatedMesh {
  Mesh mesh;
  FaceHeat heat;
  Substance substance = reference_steel();
  HeatMemory memory;

  explicit HeatedMesh(Mesh of) : mesh(std::move(of)), heat(FaceHeat::attach(mesh)) {}
  // Adds to each face what the density (J/m^2, of the position) has there: the integral over the face.
  void deposit(const std::function<double(const Vec3&)>& density, const Vec3& centre, double reach);
  double rise(FaceId f) const { return heat.temperature(mesh, f, substance, kSheet) - kAmbient; }
  // The mean over the faces around a point of their rise over the expected one at their centroids.
  double rise_over(const std::function<double(const Vec3&)>& expected, const Vec3& at, double within) const;
  double conduct(double seconds, const HeatLoss& loss = kNoLoss) {
    return kerf::conduct(mesh, heat, substance, kSheet, loss, seconds, memory);
  }
  void conduct_in_steps(double seconds, double step, const HeatLoss& loss = kNoLoss);
};

// The density (1/m^2) of a Gaussian beam of 1/e^2 radius w whose integral is 1, at the squared distance.
double gaussian(double distance2, double w);

template <typename Visit>
void for_each_face(const Mesh& mesh, Visit visit) {
  for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
    if (mesh.is_live(FaceId(f))) visit(FaceId(f));
  }
}

Vec3 centroid(const Mesh& mesh, FaceId f);

}  // namespace kerf::test
