#include <algorithm>

#include "core/base/random.h"
#include "tests/bench/kernel_edits.h"
#include "tests/bench/sections.h"
#include "tests/bench/timing.h"

namespace kerf::bench {

namespace {

// Edges and faces at random places.
KernelEdits random_edits(const Mesh& mesh, size_t count) {
  Random random(22);
  KernelEdits edits;
  std::vector<bool> taken(mesh.face_slots()), gone(mesh.face_slots());
  std::vector<Mesh::Side> sides;
  const auto random_face = [&] { return FaceId(static_cast<uint32_t>(random.below(mesh.face_slots()))); };
  for (size_t tries = 0; tries < 4 * count && edits.splits.size() < count; ++tries) {
    const FaceId f = random_face();
    const auto c = mesh.corners(f);
    const size_t i = random.below(3);
    sides.clear();
    mesh.append_edge_sides(f, c[i], c[(i + 1) % 3], sides);
    if (taken[f.index] || sides.size() != 1 || taken[sides[0].face.index]) continue;
    taken[f.index] = taken[sides[0].face.index] = true;
    edits.splits.push_back({f, c[i], c[(i + 1) % 3]});
  }
  for (size_t tries = 0; tries < count; ++tries) {
    const FaceId f = random_face();
    if (gone[f.index]) continue;
    gone[f.index] = true;
    edits.removals.push_back(f);
  }
  return edits;
}

KernelStatistics time_kerf(const Mesh& whole, const KernelEdits& edits) {
  KernelStatistics statistics;
  std::vector<Mesh::FaceSplit> made;
  const auto split = [&](Mesh& mesh, const KernelEdits::Edge& edge) {
    made.clear();
    mesh.split_edge(edge.face, edge.from, edge.to, made);
  };
  Mesh mesh = whole;
  statistics.bytes = static_cast<double>(mesh.bytes());
  statistics.split_seconds = seconds_of([&] {
    for (const auto& edge : edits.splits) split(mesh, edge);
  });
  mesh = whole;
  for (const auto& edge : edits.splits)
    statistics.longest_seconds = std::max(statistics.longest_seconds, seconds_of([&] { split(mesh, edge); }));
  mesh = whole;
  statistics.remove_seconds = seconds_of([&] {
    for (const FaceId f : edits.removals) mesh.remove_face(f);
  });
  return statistics;
}

bool has_rings(const Mesh& mesh) {
  std::vector<Mesh::Side> sides;
  for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
    const auto c = mesh.corners(FaceId(f));
    for (size_t i = 0; i < 3; ++i) {
      sides.clear();
      mesh.append_edge_sides(FaceId(f), c[i], c[(i + 1) % 3], sides);
      if (sides.size() > 1) return true;
    }
  }
  return false;
}

}  // namespace

void bench_kernel(const Subject& s, const Effort& effort, const Report& report) {
  if (has_rings(s.mesh)) return;
  const KernelEdits edits = random_edits(s.mesh, 10 * static_cast<size_t>(effort.edit_steps));
  std::vector<KernelStatistics> ours, peers;
  for (int i = 0; i < effort.build_times; ++i) {
    ours.push_back(time_kerf(s.mesh, edits));
    peers.push_back(time_openmesh(s.mesh, edits));
  }
  const auto row = [&](const char* name, const char* unit, double KernelStatistics::*figure, double factor) {
    const auto middle = [&](const std::vector<KernelStatistics>& all) {
      std::vector<double> values;
      for (const KernelStatistics& one : all) values.push_back(factor * one.*figure);
      return median(values);
    };
    report({name, s.name, unit, middle(ours), middle(peers), std::nullopt});
  };
  const auto faces = static_cast<double>(s.mesh.live_faces());
  row("split an edge / OpenMesh", "ns", &KernelStatistics::split_seconds,
      kNano / static_cast<double>(edits.splits.size()));
  row("longest split of an edge / OpenMesh", "us", &KernelStatistics::longest_seconds, kMicro);
  row("remove a face / OpenMesh", "ns", &KernelStatistics::remove_seconds,
      kNano / static_cast<double>(edits.removals.size()));
  row("half-edges, memory / OpenMesh", "B/face", &KernelStatistics::bytes, 1 / faces);
}

}  // namespace kerf::bench
