#include "core/mesh/write_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <string>

#include "core/base/atomic_file.h"

namespace kerf {
namespace {

bool fits_float(const Vec3& p) {
  constexpr double kLargest = std::numeric_limits<float>::max();
  return std::abs(p.x) <= kLargest && std::abs(p.y) <= kLargest && std::abs(p.z) <= kLargest;
}

std::string obstacle_to_gltf(const MeshView& mesh) {
  // Half of the range, because positions are told from the middle.
  const auto fits = [](const Vec3& p) { return fits_float(2.0 * p); };
  if (!std::all_of(mesh.positions.begin(), mesh.positions.end(), fits))
    return "glTF cannot hold coordinates beyond 1.7e38";
  if (mesh.positions.size() + mesh.triangles.size() > (size_t{1} << 28))
    return "glTF cannot hold more than 268435456 vertices and triangles";
  return {};
}

// Why the format cannot hold the mesh; empty when it can.
std::string obstacle(const MeshView& mesh, MeshFormat format) {
  if (format == MeshFormat::kStl && !std::all_of(mesh.positions.begin(), mesh.positions.end(), fits_float)) {
    return "STL cannot hold coordinates beyond 3.4e38";
  }
  if (format == MeshFormat::kStl && mesh.triangles.size() > std::numeric_limits<uint32_t>::max()) {
    return "STL cannot hold more than 4294967295 triangles";
  }
  if (format == MeshFormat::kPly && mesh.positions.size() > size_t{std::numeric_limits<int32_t>::max()} + 1) {
    return "PLY cannot hold more than 2147483648 vertices";
  }
  if (format == MeshFormat::kGlb || format == MeshFormat::kGltf) return obstacle_to_gltf(mesh);
  return {};
}

}  // namespace

Status write_mesh(const MeshView& mesh, const std::filesystem::path& path, MeshFormat format) {
  const std::string reason = obstacle(mesh, format);
  if (!reason.empty())
    return failed("cannot write " + path.string() + ": " + reason + "; choose another format.");
  try {
    return write_file_atomically(path, [&](const ByteSink& sink) { encode(mesh, format, sink); });
  } catch (const std::bad_alloc&) {
    return failed("cannot write " + path.string() + ": there is not enough memory.");
  }
}

}  // namespace kerf
