#include <algorithm>

#include "core/cut/cut_step.h"
#include "core/document/extract.h"
#include "core/edit/separation.h"
#include "core/mesh/build_mesh.h"
#include "core/world/body_mass.h"
#include "tests/bench/sections.h"
#include "tests/bench/slot_walk.h"
#include "tests/bench/timing.h"

namespace kerf::bench {

namespace {

constexpr double kFaceBar = 2;        // us a face born or gone
constexpr double kLongestBar = 8;     // of the median
constexpr double kWallsBar = 50;      // ms that walls may take in addition to the rim
constexpr double kJobBar = 1.0 / 20;  // of CGAL
constexpr double kManifoldBar = 1.0 / 12;
constexpr double kSeparationBar = 500;            // ns per removed face
constexpr uint32_t kHole = 20000, kOneStep = 50;  // faces

Body body_of(const Subject& s) {
  BuiltMesh built{.mesh = s.mesh, .report = {}, .material_names = {}, .parts = {}, .looks = {}};
  std::vector<uint32_t> component;
  built.report.faces = s.mesh.live_faces();
  built.report.components = label_components(s.mesh, component);
  for (uint32_t f = 0; f < s.mesh.face_slots(); ++f)
    built.report.area += triangle_area(s.mesh.triangle(FaceId(f)));
  return make_body(s.name, std::move(built));
}

Soup soup_of(const TriangleArrays& arrays) {
  Soup soup;
  for (size_t i = 0; i < arrays.positions.size(); i += 3)
    soup.positions.push_back({arrays.positions[i], arrays.positions[i + 1], arrays.positions[i + 2]});
  for (size_t i = 0; i < arrays.corners.size(); i += 3)
    soup.triangles.push_back({arrays.corners[i], arrays.corners[i + 1], arrays.corners[i + 2]});
  return soup;
}

// Faces around the first, nearest first.
std::vector<FaceId> hole(const Mesh& mesh) {
  std::vector<FaceId> faces{FaceId(0)}, neighbours;
  std::vector<bool> seen(mesh.face_slots());
  seen[0] = true;
  const size_t most = std::min(kHole, mesh.live_faces() / 2);
  for (size_t i = 0; i < faces.size() && faces.size() < most; ++i) {
    neighbours.clear();
    mesh.append_nearest_neighbours(faces[i], neighbours);
    for (const FaceId n : neighbours) {
      if (!seen[n.index]) faces.push_back(n);
      seen[n.index] = true;
    }
  }
  return faces;
}

double seconds_of_hole(Body body, std::span<const FaceId> faces, bool told) {
  return seconds_of([&] {
    for (size_t i = 0; i < faces.size(); ++i) {
      if (told) record_removed_part(body, faces[i]);
      body.mesh.remove_face(faces[i]);
      if (told && i % kOneStep == 0) settle(body);
    }
  });
}

void bench_separation(const Subject& s, const Effort& effort, const Report& report) {
  const Body body = body_of(s);
  const std::vector<FaceId> faces = hole(body.mesh);
  std::vector<double> told, untold;
  for (int i = 0; i < effort.build_times; ++i) {
    told.push_back(seconds_of_hole(body, faces, true));
    untold.push_back(seconds_of_hole(body, faces, false));
  }
  report({"separation, per removed face / limit", s.name, "ns",
          1e9 * (median(told) - median(untold)) / static_cast<double>(faces.size()), kSeparationBar, 1.0});
}

// The whole job at a tolerance, and the copy of what came off.
void bench_job(const Subject& s, const Effort& effort, const Report& report) {
  World world;
  const BodyId id = world.add(body_of(s));
  const Slot slot(world.body(id).bounds());
  const Walked walked = walk(world, slot.quick_settings(), slot.path(effort.slot_steps));
  if (const auto peer = cgal_slot_seconds(s.arrays, slot.box()))
    report({"slot into pieces / CGAL difference + split", s.name, "ms", 1e3 * walked.seconds, 1e3 * *peer,
            kJobBar});
  const auto pieces = faces_by_piece(world.body(id), false);
  if (pieces.size() < 2) return;
  const auto& copied = *std::max_element(pieces.begin() + 1, pieces.end(),
                                         [](const auto& a, const auto& b) { return a.size() < b.size(); });
  const double seconds = seconds_of([&] { extract_faces(world.body(id), copied); });
  report({"copying the largest separated piece / slot", s.name, "ms", 1e3 * seconds, 1e3 * walked.seconds,
          std::nullopt});
}

// From triangles in memory to triangles of the pieces, on all threads.
void bench_pieces(const Subject& s, const Effort& effort, const Report& report) {
  if (!has_manifold()) return;
  std::vector<double> ours, our_slot, theirs, their_slot;
  for (int i = 0; i < effort.build_times; ++i) {
    World world;
    const auto start = passed_seconds();
    const BodyId id = world.add(make_body(s.name, std::move(*build_mesh(soup_of(s.arrays)))));
    const Slot slot(world.body(id).bounds());
    our_slot.push_back(walk(world, slot.quick_settings(), slot.path(effort.slot_steps)).seconds);
    for (const auto& faces : faces_by_piece(world.body(id), false)) extract_faces(world.body(id), faces);
    ours.push_back(passed_seconds() - start);
    const auto peer = manifold_slot(s.arrays, slot.box());
    if (!peer) return;
    theirs.push_back(peer->import_s + peer->cut_s);
    their_slot.push_back(peer->cut_s);
  }
  report({"slot, tree built / Manifold difference, decompose", s.name, "ms", 1e3 * median(our_slot),
          1e3 * median(their_slot), kManifoldBar});
  report({"triangles to pieces / Manifold import, difference, decompose", s.name, "ms", 1e3 * median(ours),
          1e3 * median(theirs), std::nullopt});
}

// Three runs have the same steps, and each step counts with its shortest time: a pause of a few milliseconds
// that the machine makes in one of thousands of steps would decide which is the longest.
Walked walk_three_times(const Subject& s, const Effort& effort, CutSettings (Slot::*settings)() const,
                        bool solid = false) {
  std::vector<Walked> runs;
  for (int run = 0; run < 3; ++run) {
    World world;
    const BodyId id = world.add(body_of(s));
    if (solid) make_solid(world.body(id), true);
    const Slot slot(world.body(id).bounds());
    runs.push_back(walk(world, (slot.*settings)(), slot.path(effort.slot_steps)));
  }
  Walked shortest = runs.front();
  for (const Walked& run : runs) {
    for (size_t i = 0; i < run.steps.size(); ++i)
      shortest.steps[i] = std::min(shortest.steps[i], run.steps[i]);
    shortest.seconds = std::min(shortest.seconds, run.seconds);
  }
  return shortest;
}

// Of a slot whose rim is smoothed in the end; the steps of that count as well.
void bench_rim(const Subject& s, const Effort& effort, const Report& report) {
  const Walked walked = walk_three_times(s, effort, &Slot::smooth_settings);
  if (walked.steps.empty()) return;
  report({"slot with a smooth rim, longest / median step", s.name, "us", 1e6 * walked.longest(),
          1e6 * walked.quantile(0.5), kLongestBar});
  report({"slot with a smooth rim, per new or removed face", s.name, "us", 1e6 * walked.per_face(), kFaceBar,
          std::nullopt});
  const Walked solid = walk_three_times(s, effort, &Slot::smooth_settings, true);
  if (solid.walls == 0) return;  // not closed before
  report({"slot through a solid, longest / median step", s.name, "us", 1e6 * solid.longest(),
          1e6 * solid.quantile(0.5), kLongestBar});
  report({"walls of the slot, in addition to the rim / limit", s.name, "ms", 1e3 * (solid.seconds - walked.seconds),
          kWallsBar, 1.0});
}

void bench_steps(const Subject& s, const Effort& effort, const Report& report) {
  const Walked walked = walk_three_times(s, effort, &Slot::settings);
  if (walked.steps.empty()) return;
  report({"slot, per new or removed face / limit", s.name, "us", 1e6 * walked.per_face(), kFaceBar, 1.0});
  report({"slot, longest / median step", s.name, "us", 1e6 * walked.longest(), 1e6 * walked.quantile(0.5),
          kLongestBar});
}

}  // namespace

void bench_cut(const Subject& s, const Effort& effort, const Report& report) {
  bench_steps(s, effort, report);
  bench_rim(s, effort, report);
  bench_job(s, effort, report);
  bench_pieces(s, effort, report);
  bench_separation(s, effort, report);
}

}  // namespace kerf::bench
