#include <cassert>
#include <cmath>

#include "core/base/parallel.h"
#include "core/mesh/files/bytes.h"
#include "core/mesh/files/encode.h"

namespace kerf {
namespace {

constexpr size_t kRows = 1 << 14;  // a range

void append_floats(const Vec3& v, std::string& bytes) {
  for (int i = 0; i < 3; ++i) append_little(static_cast<float>(v[i]), bytes);
}

// The unit normal, zero for a degenerate triangle. The edges are scaled so that their product neither
// overflows nor underflows.
Vec3 unit_normal(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 u = b - a, v = c - a;
  const double size =
      std::max({std::abs(u.x), std::abs(u.y), std::abs(u.z), std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  if (!(size > 0)) return Vec3(0);
  const Vec3 normal = glm::cross(u / size, v / size);
  const double length = glm::length(normal);
  return length > 0 ? normal / length : Vec3(0);
}

}  // namespace

std::string encode_ply(const MeshView& mesh) {
  assert(mesh.positions.size() <= size_t{1} << 31);
  constexpr size_t kVertexBytes = 3 * sizeof(double), kFaceBytes = 1 + 3 * sizeof(int32_t);
  std::string bytes =
      "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(mesh.positions.size()) +
      "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
      std::to_string(mesh.triangles.size()) + "\nproperty list uchar int vertex_indices\nend_header\n";
  const size_t vertices_at = bytes.size(), faces_at = vertices_at + kVertexBytes * mesh.positions.size();
  bytes.resize(faces_at + kFaceBytes * mesh.triangles.size());
  for_each_range(mesh.positions.size(), kRows, [&](size_t i, size_t end) {
    for (char* to = bytes.data() + vertices_at + kVertexBytes * i; i < end; ++i) {
      for (int k = 0; k < 3; ++k) to = store_little(mesh.positions[i][k], to);
    }
  });
  for_each_range(mesh.triangles.size(), kRows, [&](size_t i, size_t end) {
    for (char* to = bytes.data() + faces_at + kFaceBytes * i; i < end; ++i) {
      to = store_little(uint8_t{3}, to);
      for (const uint32_t v : mesh.triangles[i]) {
        assert(v < mesh.positions.size());
        to = store_little(v, to);
      }
    }
  });
  return bytes;
}

std::string encode_stl(const MeshView& mesh) {
  constexpr size_t kHeaderBytes = 80, kTriangleBytes = 50;
  assert(mesh.triangles.size() < size_t{1} << 32);
  std::string bytes = "binary STL written by Kerf";
  bytes.reserve(kHeaderBytes + sizeof(uint32_t) + kTriangleBytes * mesh.triangles.size());
  bytes.resize(kHeaderBytes, ' ');
  append_little(static_cast<uint32_t>(mesh.triangles.size()), bytes);
  for (const auto& [a, b, c] : mesh.triangles) {
    assert(std::max({a, b, c}) < mesh.positions.size());
    const Vec3 &pa = mesh.positions[a], &pb = mesh.positions[b], &pc = mesh.positions[c];
    append_floats(unit_normal(pa, pb, pc), bytes);
    for (const Vec3* corner : {&pa, &pb, &pc}) append_floats(*corner, bytes);
    append_little(uint16_t{0}, bytes);
  }
  return bytes;
}

}  // namespace kerf
