#include <cmath>
#include <vector>

#include "core/heat/conduction_solver.h"
#include "core/heat/face_heat.h"
#include "tests/bench/sections.h"
#include "tests/bench/timing.h"

namespace kerf::bench {

namespace {

constexpr double kEdge = 0.5e-3;     // m, of the mean face
constexpr double kThickness = 1e-3;  // m
constexpr double kTick = 1.0 / 120;  // s
constexpr size_t kHotFaces = 5000;
constexpr double kLimit = 4;  // ms, of one tick

// Scales the mesh about the origin so that its faces have edges of kEdge in the mean.
void scale_to_edge(Mesh& mesh) {
  double area = 0;
  for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
    if (mesh.is_live(FaceId(f))) area += triangle_area(mesh.triangle(FaceId(f)));
  }
  const double wanted = mesh.live_faces() * std::sqrt(3.0) / 4 * kEdge * kEdge;
  const double scale = std::sqrt(wanted / area);
  for (uint32_t v = 0; v < mesh.vertex_slots(); ++v)
    mesh.move_vertex(VertexId(v), scale * mesh.position(VertexId(v)));
}

// Faces around the first one, nearest by steps over edges first.
std::vector<FaceId> patch(const Mesh& mesh, size_t count) {
  std::vector<uint8_t> seen(mesh.face_slots(), 0);
  std::vector<FaceId> found, next;
  for (uint32_t f = 0; found.empty(); ++f) {
    if (mesh.is_live(FaceId(f))) found.push_back(FaceId(f));
  }
  seen[found[0].index] = 1;
  for (size_t i = 0; i < found.size() && found.size() < count; ++i) {
    next.clear();
    mesh.append_neighbours(found[i], next);
    for (const FaceId f : next) {
      if (seen[f.index] == 0) found.push_back(f);
      seen[f.index] = 1;
    }
  }
  return found;
}

}  // namespace

void bench_heat(const Subject& subject, const Effort& effort, const Report& report) {
  Mesh mesh = subject.mesh;
  scale_to_edge(mesh);
  const FaceHeat heat = FaceHeat::attach(mesh);
  const Substance steel;
  const std::vector<FaceId> hot = patch(mesh, kHotFaces);
  for (size_t i = 0; i < hot.size(); ++i) {
    const double share = 1 - static_cast<double>(i) / static_cast<double>(hot.size());
    const double mass = triangle_area(mesh.triangle(hot[i])) * kThickness * steel.density;
    heat.set_energy(mesh, hot[i],
                    mass * enthalpy_at(steel, kAmbient + 1 + share * (steel.transition - kAmbient - 1)));
  }
  std::vector<double> ticks;
  HeatMemory memory;
  for (int i = 0; i < effort.heat_ticks; ++i)
    ticks.push_back(kMilli * seconds_of([&] { conduct(mesh, heat, steel, kThickness, {}, kTick, memory); }));
  report({"a tick of 5,000 hot faces / limit", subject.name, "ms", median(ticks), kLimit, 1});
}

}  // namespace kerf::bench
