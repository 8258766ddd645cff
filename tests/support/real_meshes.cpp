#include "tests/support/real_meshes.h"

#include <algorithm>
#include <cstdlib>

#include "core/mesh/mesh_file.h"
#include "tests/support/runs.h"

namespace kerf::test {

namespace {

// A facet of a text STL with all digits, the longest of any format. Longer files need not be read to be left
// out.
constexpr size_t kMaxBytesAFace = 400;

}  // namespace

std::vector<std::filesystem::path> real_meshes(size_t max_faces) {
  std::vector<std::filesystem::path> files;
  const char* folder = std::getenv("KERF_TEST_MESHES");
  if (!folder || !std::filesystem::is_directory(std::filesystem::path(folder) / "real")) return files;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(std::filesystem::path(folder) / "real")) {
    if (!entry.is_regular_file()) continue;
    const std::string ending = entry.path().extension().string();
    if (ending == ".json" || ending == ".md" || entry.file_size() > max_faces * kMaxBytesAFace) continue;
    const auto soup = read_mesh(entry.path());
    if (soup && soup->triangles.size() <= max_faces && build_mesh(*soup).ok()) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  const size_t step = runs(4) == 4 ? 1 : 3;
  for (size_t i = 0; i * step < files.size(); ++i) std::swap(files[i], files[i * step]);
  files.resize((files.size() + step - 1) / step);
  return files;
}

World world_of_file(const std::filesystem::path& file) {
  World world;
  world.add(make_body(file.stem().string(), std::move(*build_mesh(*read_mesh(file)))));
  return world;
}

}  // namespace kerf::test
