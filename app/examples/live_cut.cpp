// An engine that cuts live: each frame moves the beam, cuts for at most 2 ms and copies only the changed
// faces to its vertex buffer. Prints the percentiles of the duration of a frame's work.
//   live_cut [SQUARES [SCENE]]     SQUARES: of the sheet, per side; SCENE: a folder for the result
#include <kerf/kerf.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>

// A sheet of n by n squares in the plane y = 0, one metre wide.
static kerf::Mesh sheet(uint32_t n) {
  std::vector<double> vertices;
  std::vector<uint32_t> faces;
  for (uint32_t i = 0; i <= n; ++i)
    for (uint32_t k = 0; k <= n; ++k) vertices.insert(vertices.end(), {double(i) / n, 0, double(k) / n});
  for (uint32_t a = 0; a < n * (n + 1); ++a) {
    const uint32_t b = a + n + 1;
    if (a % (n + 1) < n) faces.insert(faces.end(), {a, a + 1, b, b, a + 1, b + 1});
  }
  return {vertices, faces};
}

// Nine floats per face index; a removed face has no area. Returns the number of changed faces.
static size_t update(std::vector<float>& buffer, kerf::World& world) {
  const kerf::Changes changes = world.take_changes();
  const auto write = [&](size_t face, const double* from) {
    if (buffer.size() < 9 * (face + 1)) buffer.resize(9 * (face + 1));
    for (size_t k = 0; k < 9; ++k) buffer[9 * face + k] = from == nullptr ? 0 : float(from[k]);
  };
  size_t changed = 0;
  for (const kerf_body_changes& body : std::span(changes.bodies, changes.body_count)) {
    for (const uint32_t face : std::span(body.removed, body.removed_count)) write(face, nullptr);
    const std::vector<double> corners = world.corners(body.body, {body.added, body.added_count});
    for (size_t i = 0; i < body.added_count; ++i) write(body.added[i], &corners[9 * i]);
    changed += body.removed_count + body.added_count + body.moved_count;
  }
  return changed;
}

static void report(const char* what, std::vector<double> seconds) {
  std::sort(seconds.begin(), seconds.end());
  const auto at = [&](double share) { return 1e3 * seconds[size_t(share * double(seconds.size() - 1))]; };
  std::printf("%s: p50 %.3f ms, p99 %.3f ms, longest %.3f ms\n", what, at(0.5), at(0.99), at(1));
}

int main(int argc, char** argv) try {
  kerf::World world;
  std::vector<float> buffer;
  world.take_changes();
  world.add(sheet(argc > 1 ? uint32_t(std::atoi(argv[1])) : 200));
  update(buffer, world);
  const auto pose = [](int frame) -> kerf::Keyframe {
    const double turn = 0.02 * frame;
    return {frame / 60.0, {0.5 + 0.4 * std::cos(turn), 1, 0.5 + 0.4 * std::sin(turn)}, {0, -1, 0}};
  };
  world.begin_stroke({.keys = {pose(0)}, .radius = 0.01, .range = {0, 2}}, {.rim = KERF_RIM_SMOOTH});
  std::vector<double> cutting, copying;
  double copied = 0, changed = 0;
  kerf::StrokeProgress step{};
  for (int frame = 1; !step.is_finished; ++frame) {
    if (frame < 330) world.add_pose(pose(frame));
    if (frame == 330) world.end_stroke();
    step = world.step_stroke(SIZE_MAX, 2e-3);
    cutting.push_back(step.seconds);
    const auto begin = std::chrono::steady_clock::now();
    changed += double(update(buffer, world));
    copying.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    copied += copying.back();
  }
  std::printf("%zu frames, %.0f faces changed, %zu pieces\n", cutting.size(), changed, world.pieces().size());
  report("step", cutting);
  report("changes", copying);
  std::printf("%.0f ns per changed face\n", 1e9 * copied / changed);
  if (argc > 2) world.save_scene(argv[2]);
  return 0;
} catch (const std::exception& fault) {
  std::fprintf(stderr, "live_cut: %s\n", fault.what());
  return 1;
}
