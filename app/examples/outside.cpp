// A C++ client: reads a mesh, cuts it in two along its longest side and prints the masses of the pieces.
//   outside MESH [SCENE]     SCENE: a folder for the result
#include <kerf/kerf.h>

#include <algorithm>
#include <cstdio>

int main(int argc, char** argv) try {
  if (argc < 2) throw kerf::InvalidArgument("usage: outside MESH [SCENE]");
  const kerf::Mesh mesh = kerf::Mesh::read(argv[1]);
  double low[3], high[3];
  std::copy_n(mesh.vertices().data(), 3, low);
  std::copy_n(mesh.vertices().data(), 3, high);
  for (size_t i = 0; i < mesh.vertices().size(); ++i) {
    low[i % 3] = std::min(low[i % 3], mesh.vertices()[i]);
    high[i % 3] = std::max(high[i % 3], mesh.vertices()[i]);
  }
  const double x = 0.5 * (low[0] + high[0]), above = 2 * high[1] - low[1], depth = high[2] - low[2];
  kerf::Stroke stroke;
  stroke.keys = {{0, {x, above, low[2] - depth}, {0, -1, 0}}, {1, {x, above, high[2] + depth}, {0, -1, 0}}};
  kerf::World world;
  world.add(mesh, "part");
  const kerf::CutResult cut = world.cut(stroke, {.rim = KERF_RIM_SMOOTH});
  std::printf("%zu faces were removed, state %s\n", cut.removed_faces, world.hash().c_str());
  for (const kerf::Mesh& piece : world.pieces())
    std::printf("%s: %.6g m2, %.6g kg\n", piece.name().c_str(), piece.area(), piece.info().mass);
  if (argc > 2) world.save_scene(argv[2]);
  return 0;
} catch (const std::exception& fault) {
  std::fprintf(stderr, "outside: %s\n", fault.what());
  return 1;
}
