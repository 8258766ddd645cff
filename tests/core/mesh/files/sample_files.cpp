#include "tests/core/mesh/files/sample_files.h"

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include "core/mesh/files/encode.h"
#include "core/mesh/files/readers.h"

namespace kerf::test {
namespace {

constexpr const char* kObj =
    "# a square\nmtllib none.mtl\nv 0 0 0 1 0 0\nv 1 0 0\r\nv 1.0e0 +1 0\nv -0 1 0\nvt 0 0\nvn 0 0 1\n"
    "usemtl red\nf 1/1/1 2/1/1 \\\n 3/1/1\nusemtl blue paint\nf -4//1 -2//1 -1//1 # done\nl 1 2\n";
constexpr const char* kOff =
    "COFF # with colours\n\n4 2 5\n0 0 0 1 0 0 1\n1 0 0 1 0 0 1#red\n1 1 0 1 0 0 1\n0 1 0 1 0 0 1\n"
    "3 0 1 2 0.5 0.5 0.5\n3 0 2 3\n";
constexpr const char* kPly =
    "ply\nformat ascii 1.0\ncomment a square\nelement face 1\nproperty int flags\n"
    "property list uint uint vertex_index\nproperty list uchar float texcoord\nelement vertex 4\n"
    "property float z\nproperty float x\nproperty uchar red\nproperty double y\nelement tristrips 1\n"
    "property list int int vertex_indices\nend_header\n7 3 0 1 2 2 0.5 0.25\n0 0 255 0\n0 1 255 0\n0 1 0 1\n"
    "0 0 0 1\n4 -1 0 2 3\n";
constexpr const char* kStl =
    "solid outer loop\n facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n   vertex 1 0 0\n   vertex 1 1 0\n"
    "  endloop\n endfacet\n FACET NORMAL nan 0 1\n  OUTER LOOP\n   VERTEX 0 0 0\n   VERTEX 1 1 0\n"
    "   VERTEX 0 1 0\n  ENDLOOP\n ENDFACET\nendsolid outer loop\n";

std::string big_endian_ply() {
  std::string bytes =
      "ply\r\nformat binary_big_endian 1.0\r\nelement vertex 4\r\nproperty short x\r\nproperty short y\r\n"
      "property char z\r\nelement face 2\r\nproperty list ushort uchar vertex_indices\r\nend_header\r\n";
  for (const char* corner : {"\0\0\0\0\0", "\0\1\0\0\0", "\0\1\0\1\0", "\0\0\0\1\0"}) bytes.append(corner, 5);
  bytes.append("\0\3\0\1\2", 5).append("\0\3\0\2\3", 5);
  return bytes;
}

}  // namespace

Reader reader_of(MeshFormat format) {
  constexpr Reader kGltf = [](std::string_view bytes, const std::string& name, const Progress* progress) {
    return read_gltf(bytes, name, progress);
  };
  constexpr Reader kPlyReader = [](std::string_view bytes, const std::string& name,
                                   const Progress* progress) { return read_ply(bytes, name, progress); };
  constexpr std::array<Reader, 7> kReaders{read_obj, kPlyReader, read_stl, read_off, kGltf, kGltf, read_3mf};
  return kReaders[static_cast<size_t>(format)];
}

std::vector<Sample> sample_files() {
  const std::vector<Vec3> positions{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const std::vector<std::array<uint32_t, 3>> triangles{{0, 1, 2}, {0, 2, 3}};
  const MeshView square{positions, triangles, {}, {}};
  return {{"square.obj", MeshFormat::kObj, kObj},
          {"square.off", MeshFormat::kOff, kOff},
          {"square_text.ply", MeshFormat::kPly, kPly},
          {"square_little.ply", MeshFormat::kPly, encoded(square, MeshFormat::kPly)},
          {"square_big.ply", MeshFormat::kPly, big_endian_ply()},
          {"square_text.stl", MeshFormat::kStl, kStl},
          {"square_binary.stl", MeshFormat::kStl, encoded(square, MeshFormat::kStl)},
          {"square.glb", MeshFormat::kGlb, encoded(square, MeshFormat::kGlb)},
          {"square.gltf", MeshFormat::kGltf, encoded(square, MeshFormat::kGltf)},
          {"square.3mf", MeshFormat::k3mf, encoded(square, MeshFormat::k3mf)}};
}

double area(const Soup& soup) {
  double sum = 0;
  for (const auto& [a, b, c] : soup.triangles) {
    const Vec3 origin = soup.positions[a];
    const double twice = glm::length(glm::cross(soup.positions[b] - origin, soup.positions[c] - origin));
    if (std::isfinite(twice)) sum += twice / 2;
  }
  return sum;
}

bool is_one_line_about(const Error& error, const std::string& file_name) {
  return error.message.size() > file_name.size() + 2 && error.message.starts_with(file_name) &&
         error.message.find('\n') == std::string::npos && error.message.ends_with('.');
}

}  // namespace kerf::test
