#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "core/mesh/files/bytes.h"
#include "core/mesh/files/emit_ranges.h"
#include "core/mesh/files/encode.h"

namespace kerf {
namespace {

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

std::string colour_properties(size_t count) {
  std::string lines;
  for (size_t k = 0; k < count; ++k)
    lines += "property uchar " + std::string(std::array{"red", "green", "blue", "alpha"}[k]) + "\n";
  return lines;
}

}  // namespace

void encode_ply(const MeshView& mesh, const ByteSink& sink) {
  assert(mesh.positions.size() <= size_t{1} << 31);
  const size_t colour_bytes = mesh.colours.empty() ? 0 : mesh.any_translucent() ? 4 : 3;
  const std::string head =
      "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(mesh.positions.size()) +
      "\nproperty double x\nproperty double y\nproperty double z\n" + colour_properties(colour_bytes) +
      "element face " + std::to_string(mesh.triangles.size()) +
      "\nproperty list uchar int vertex_indices\nend_header\n";
  const auto append_vertices = [&](size_t i, size_t end, std::string& part) {
    part.resize((end - i) * (3 * sizeof(double) + colour_bytes));
    for (char* to = part.data(); i < end; ++i) {
      for (int k = 0; k < 3; ++k) to = store_little(mesh.positions[i][k], to);
      for (size_t k = 0; k < colour_bytes; ++k) to = store_little(eight_bits(mesh.colours[i].part[k]), to);
    }
  };
  const auto append_faces = [&](size_t i, size_t end, std::string& part) {
    part.resize((end - i) * (1 + 3 * sizeof(int32_t)));
    for (char* to = part.data(); i < end; ++i) {
      to = store_little(uint8_t{3}, to);
      for (const uint32_t v : mesh.triangles[i]) {
        assert(v < mesh.positions.size());
        to = store_little(v, to);
      }
    }
  };
  if (sink(head) && emit_ranges(mesh.positions.size(), sink, append_vertices))
    emit_ranges(mesh.triangles.size(), sink, append_faces);
}

void encode_stl(const MeshView& mesh, const ByteSink& sink) {
  constexpr size_t kHeaderBytes = 80, kTriangleBytes = 50;
  assert(mesh.triangles.size() < size_t{1} << 32);
  std::string head = "binary STL written by Kerf";
  head.resize(kHeaderBytes, ' ');
  append_little(static_cast<uint32_t>(mesh.triangles.size()), head);
  const auto append_triangles = [&](size_t i, size_t end, std::string& part) {
    part.reserve((end - i) * kTriangleBytes);
    for (; i < end; ++i) {
      const auto& [a, b, c] = mesh.triangles[i];
      assert(std::max({a, b, c}) < mesh.positions.size());
      const Vec3 &pa = mesh.positions[a], &pb = mesh.positions[b], &pc = mesh.positions[c];
      append_floats(unit_normal(pa, pb, pc), part);
      for (const Vec3* corner : {&pa, &pb, &pc}) append_floats(*corner, part);
      append_little(uint16_t{0}, part);
    }
  };
  if (sink(head)) emit_ranges(mesh.triangles.size(), sink, append_triangles);
}

}  // namespace kerf
