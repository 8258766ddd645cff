#include <unistd.h>

#include <fstream>
#include <string>

#include "core/mesh/mesh_file.h"
#include "core/world/body_creation.h"
#include "tests/bench/sections.h"
#include "tests/bench/slot_walk.h"
#include "tests/bench/timing.h"
#include "tests/support/temporary_folder.h"

namespace kerf::bench {

namespace {

constexpr double kFlatBar = 1.5;  // per face, relative to the mesh of a tenth of the faces
constexpr double kSlotBar = 10;   // the slot, whose separation visits the part that comes off
constexpr double kStepBar = 2;    // a step, relative to the same mesh
constexpr size_t kBytesOfManyFaces = 16ull << 30, kMaxOnSmallMachine = 10'000'000;

size_t bytes_of_machine() {
  return static_cast<size_t>(sysconf(_SC_PHYS_PAGES)) * static_cast<size_t>(sysconf(_SC_PAGESIZE));
}

// Peak memory of the process in bytes since forget_peak().
double peak_bytes() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with("VmHWM:")) return 1024 * std::stod(line.substr(6));
  }
  return 0;
}
void forget_peak() { std::ofstream("/proc/self/clear_refs") << 5; }

struct Scaled {
  double faces = 0;
  double load = 0, tree = 0;  // elapsed seconds
  double bytes = 0;           // at most
  Walked slot;
};

Scaled run_scaled(size_t faces, int moves) {
  const test::TemporaryFolder folder;
  {
    const Soup soup = knobbly_torus(faces);
    if (!write_mesh({soup.positions, soup.triangles, {}, {}}, folder / "torus.ply", MeshFormat::kPly))
      std::abort();
  }
  forget_peak();
  Scaled scaled;
  World world;
  {
    std::optional<BuiltMesh> built;
    scaled.load = seconds_of([&] { built = *load_mesh(folder / "torus.ply", nullptr); }, passed_seconds);
    std::optional<Body> body;
    scaled.tree = seconds_of([&] { body = make_body("torus", std::move(*built)); }, passed_seconds);
    scaled.faces = body->mesh.live_faces();
    const Slot slot(body->bounds());
    world.add(std::move(*body));
    scaled.slot = walk(world, slot.settings(), slot.path(moves));
  }
  scaled.bytes = peak_bytes();
  return scaled;
}

}  // namespace

void bench_scale(const Subject&, const Effort& effort, const Report& report) {
  const size_t faces = bytes_of_machine() >= kBytesOfManyFaces
                           ? effort.scale_faces
                           : std::min(effort.scale_faces, kMaxOnSmallMachine);
  const Scaled tenth = run_scaled(faces / 10, effort.slot_steps),
               whole = run_scaled(faces, effort.slot_steps);
  const std::string name = std::to_string(faces) + " faces";
  const auto row = [&](const char* what, const char* unit, double factor, auto value, double bar) {
    report({std::string(what) + " / with a tenth of the faces", name, unit, factor * value(whole),
            factor * value(tenth), bar});
  };
  row(
      "load PLY, a face", "ns", kNano, [](const Scaled& s) { return s.load / s.faces; }, kFlatBar);
  row(
      "tree, a face", "ns", kNano, [](const Scaled& s) { return s.tree / s.faces; }, kFlatBar);
  row(
      "peak memory, a face", "B", 1, [](const Scaled& s) { return s.bytes / s.faces; }, kFlatBar);
  row(
      "step, median", "us", kMicro, [](const Scaled& s) { return s.slot.quantile(0.5); }, kStepBar);
  row(
      "step, 99th percentile", "us", kMicro, [](const Scaled& s) { return s.slot.quantile(0.99); }, kStepBar);
  row(
      "slot", "ms", kMilli, [](const Scaled& s) { return s.slot.seconds; }, kSlotBar);
}

}  // namespace kerf::bench
