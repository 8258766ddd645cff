// An engine that cuts live: each frame moves the beam, cuts for at most 2 ms and copies only the changed
// faces to its vertex buffer. Prints the percentiles of the duration of a frame's work.
//   live_cut [SQUARES]
#include <kerf/kerf.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace {

// A sheet of n by n squares in the plane y = 0, one metre wide.
kerf::Mesh sheet(uint32_t n) {
  std::vector<double> vertices;
  std::vector<uint32_t> faces;
  for (uint32_t i = 0; i <= n; ++i) {
    for (uint32_t k = 0; k <= n; ++k) vertices.insert(vertices.end(), {double(i) / n, 0, double(k) / n});
  }
  for (uint32_t a = 0; a < n * (n + 1); ++a) {
    const uint32_t b = a + n + 1;
    if (a % (n + 1) < n) faces.insert(faces.end(), {a, a + 1, b, b, a + 1, b + 1});
  }
  return {vertices, faces};
}

// Nine floats per face slot; a removed face has no area.
struct VertexBuffer {
  std::vector<float> corners;
  size_t changed = 0;  // faces since the start

  void update(kerf::World& world, kerf::BodyId body) {
    const kerf::Changes changes = world.take_changes();
    for (size_t i = 0; i < changes.body_count; ++i) {
      const kerf_body_changes& b = changes.bodies[i];
      for (const uint32_t f : std::span(b.removed, b.removed_count)) write(f, nullptr);
      fetch(world, body, {b.added, b.added_count});
      changed += b.removed_count + b.added_count + b.moved_count;
    }
  }
  void fetch(const kerf::World& world, kerf::BodyId body, std::span<const uint32_t> faces) {
    const std::vector<double> from = world.corners(body, faces);
    for (size_t i = 0; i < faces.size(); ++i) write(faces[i], &from[9 * i]);
  }
  void write(size_t face, const double* from) {
    if (corners.size() < 9 * (face + 1)) corners.resize(9 * (face + 1));
    for (size_t k = 0; k < 9; ++k) corners[9 * face + k] = from == nullptr ? 0 : float(from[k]);
  }
};

void report(const char* what, std::vector<double> seconds) {
  std::sort(seconds.begin(), seconds.end());
  const auto at = [&](double share) { return 1e3 * seconds[size_t(share * double(seconds.size() - 1))]; };
  std::printf("%s: p50 %.3f ms, p99 %.3f ms, longest %.3f ms\n", what, at(0.5), at(0.99), at(1));
}

}  // namespace

int main(int argc, char** argv) try {
  constexpr double kBudget = 2e-3;
  kerf::World world;
  const kerf::BodyId body = world.add(sheet(argc > 1 ? uint32_t(std::atoi(argv[1])) : 200));
  VertexBuffer buffer;
  world.take_changes();
  buffer.fetch(world, body, world.faces(body));
  kerf::Stroke stroke;
  stroke.radius = 0.01;
  stroke.range = {0, 2};
  const auto pose = [](int frame) -> kerf::Keyframe {
    const double turn = 0.02 * frame;
    return {frame / 60.0, {0.5 + 0.4 * std::cos(turn), 1, 0.5 + 0.4 * std::sin(turn)}, {0, -1, 0}};
  };
  stroke.keys = {pose(0)};
  world.begin_stroke(stroke, {.rim = KERF_RIM_SMOOTH});
  std::vector<double> cutting, copying;
  double copied = 0;
  bool finished = false;
  for (int frame = 1; !finished; ++frame) {
    if (frame < 330) world.add_pose(pose(frame));
    if (frame == 330) world.end_stroke();
    const kerf::StrokeProgress step = world.step_stroke(std::numeric_limits<size_t>::max(), kBudget);
    finished = step.is_finished;
    cutting.push_back(step.seconds);
    const auto begin = std::chrono::steady_clock::now();
    buffer.update(world, body);
    copying.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    copied += copying.back();
  }
  std::printf("%zu frames, %zu faces changed, %zu pieces\n", cutting.size(), buffer.changed,
              world.pieces().size());
  report("step", cutting);
  report("changes", copying);
  std::printf("%.0f ns per changed face\n", 1e9 * copied / double(buffer.changed));
  return 0;
} catch (const std::exception& fault) {
  std::fprintf(stderr, "live_cut: %s\n", fault.what());
  return 1;
}
