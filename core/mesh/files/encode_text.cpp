#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <optional>

#include "core/mesh/files/encode.h"
#include "core/mesh/files/encode_mtl.h"

namespace kerf {
namespace {

template <typename Number>
void append_number(Number number, std::string& text) {
  std::array<char, 32> digits;  // the shortest form of any double takes 24
  const auto written = std::to_chars(digits.data(), digits.data() + digits.size(), number);
  text.append(digits.data(), written.ptr);
}

// Appends three numbers separated by blanks, and a line feed.
template <typename Three>
void append_three(const Three& numbers, std::string& text) {
  append_number(numbers[0], text);
  text += ' ';
  append_number(numbers[1], text);
  text += ' ';
  append_number(numbers[2], text);
  text += '\n';
}

// An estimate of the size of the text, so that memory is allocated once.
size_t likely_size(const MeshView& mesh) {
  return 64 * mesh.positions.size() + 28 * mesh.triangles.size() + 128;
}

// OBJ cannot return to the unnamed material, so that it is given a name.
void append_material(const char* keyword, const std::string& name, std::string& text) {
  text += keyword;
  text += name.empty() ? "default" : name;
  text += '\n';
}

}  // namespace

std::string encode_obj(const MeshView& mesh) {
  assert(mesh.materials.empty() || mesh.materials.size() == mesh.triangles.size());
  std::string text;
  text.reserve(likely_size(mesh));
  if (!mesh.library.empty()) (text += "mtllib ").append(mesh.library) += '\n';
  for (const Vec3& p : mesh.positions) {
    text += "v ";
    append_three(p, text);
  }
  std::optional<uint16_t> material;
  for (size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (!mesh.materials.empty() && material != mesh.materials[i]) {
      material = mesh.materials[i];
      assert(*material < mesh.material_names.size());
      append_material("usemtl ", mesh.material_names[*material], text);
    }
    const auto& [a, b, c] = mesh.triangles[i];
    assert(std::max({a, b, c}) < mesh.positions.size());
    text += "f ";
    append_three(std::array<uint64_t, 3>{uint64_t{a} + 1, uint64_t{b} + 1, uint64_t{c} + 1}, text);
  }
  return text;
}

std::string encode_mtl(std::span<const MaterialLook> materials) {
  std::string text;
  for (const MaterialLook& m : materials) {
    append_material("newmtl ", m.name, text);
    text += "Kd ";
    append_three(m.colour, text);
    const double shine = 0.5 * m.gloss;
    text += "Ks ";
    append_three(Vec3(shine), text);
    text += "Ns ";
    append_number(1000 * m.gloss * m.gloss, text);
    text += "\nd 1\nillum 2\n";
  }
  return text;
}

std::string encode_off(const MeshView& mesh) {
  std::string text;
  text.reserve(likely_size(mesh));
  text += "OFF\n";
  append_three(std::array<size_t, 3>{mesh.positions.size(), mesh.triangles.size(), 0}, text);
  for (const Vec3& p : mesh.positions) append_three(p, text);
  for (const auto& triangle : mesh.triangles) {
    text += "3 ";
    append_three(triangle, text);
  }
  return text;
}

}  // namespace kerf
