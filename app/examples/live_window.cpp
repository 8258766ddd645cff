// A live cut in a window of its own: hold the left mouse button to cut the sheet. Each frame cuts for at most
// 2 ms and copies only the changed faces. Needs GLFW and OpenGL.
//   live_window [FRAMES [SCENE]]     FRAMES: the beam moves by itself, for so long; SCENE: a folder for the
//   result
#include <GLFW/glfw3.h>
#include <kerf/kerf.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>

// Three positions and three colours per face index; a removed face has no area.
struct Buffers {
  std::vector<float> positions, colours;

  void update(kerf::World& world) {
    const kerf::Changes changes = world.take_changes();
    for (const kerf_body_changes& body : std::span(changes.bodies, changes.body_count)) {
      for (const uint32_t face : std::span(body.removed, body.removed_count)) write(face, nullptr);
      const std::vector<double> corners = world.corners(body.body, {body.added, body.added_count});
      for (size_t i = 0; i < body.added_count; ++i) write(body.added[i], &corners[9 * i]);
      for (size_t i = 0; i < body.added_count; ++i) paint(body.added[i], body.added_pieces[i]);
      for (size_t i = 0; i < body.moved_count; ++i) paint(body.moved[i], body.moved_pieces[i]);
    }
  }
  void write(size_t face, const double* from) {
    if (positions.size() < 9 * (face + 1)) positions.resize(9 * (face + 1));
    for (size_t k = 0; k < 9; ++k) positions[9 * face + k] = from == nullptr ? 0 : float(from[k]);
    colours.resize(positions.size());
  }
  void paint(size_t face, uint32_t piece) {
    for (size_t k = 0; k < 9; ++k)
      colours[9 * face + k] = float(0.6 + 0.3 * std::cos(2.1 * double(piece) + double(k % 3)));
  }
  void draw() const {
    glClear(GL_COLOR_BUFFER_BIT);
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_COLOR_ARRAY);
    glVertexPointer(3, GL_FLOAT, 0, positions.data());
    glColorPointer(3, GL_FLOAT, 0, colours.data());
    glDrawArrays(GL_TRIANGLES, 0, GLsizei(positions.size() / 3));
  }
};

int main(int argc, char** argv) try {
  const int frames = argc > 1 ? std::atoi(argv[1]) : 0;
  const std::vector<double> square{-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0};
  kerf::World world;
  Buffers buffers;
  buffers.update(world);
  world.add(kerf::Mesh(square, std::vector<uint32_t>{0, 1, 2, 0, 2, 3}));
  GLFWwindow* window = glfwInit() ? glfwCreateWindow(800, 800, "Kerf", nullptr, nullptr) : nullptr;
  if (window == nullptr) throw std::runtime_error("cannot open a window");
  glfwMakeContextCurrent(window);
  bool cutting = false, ended = false;
  for (int frame = 0; !glfwWindowShouldClose(window) && (frames == 0 || frame < frames || cutting); ++frame) {
    glfwPollEvents();
    double x = 400 + 3 * frame * std::cos(0.1 * frame), y = 400 + 3 * frame * std::sin(0.1 * frame);
    bool on = frame < frames;
    if (frames == 0) glfwGetCursorPos(window, &x, &y);
    if (frames == 0) on = glfwGetMouseButton(window, GLFW_MOUSE_BUTTON_LEFT) == GLFW_PRESS;
    const kerf::Keyframe pose{frame / 60.0, {x / 400 - 1, 1 - y / 400, 1}, {0, 0, -1}};
    if (on && !cutting)
      world.begin_stroke({.keys = {pose}, .radius = 0.02, .range = {0, 2}}, {.rim = KERF_RIM_SMOOTH});
    if (on && cutting && !ended) world.add_pose(pose);
    if (!on && cutting && !ended) world.end_stroke();
    ended = cutting && (ended || !on);
    if (on || cutting) cutting = !world.step_stroke(SIZE_MAX, 2e-3).is_finished;
    buffers.update(world);
    buffers.draw();
    glfwSwapBuffers(window);
  }
  std::printf("%zu pieces\n", world.pieces().size());
  if (argc > 2) world.save_scene(argv[2]);
  glfwTerminate();
  return 0;
} catch (const std::exception& fault) {
  std::fprintf(stderr, "live_window: %s\n", fault.what());
  return 1;
}
