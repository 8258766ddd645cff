#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <vector>

#include "core/base/parallel.h"
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

// Appends lines that are written on several threads: line(i, text) appends the one of item i, about `likely`
// bytes long.
template <typename Line>
void append_lines(size_t items, size_t likely, std::string& text, Line line) {
  constexpr size_t kLines = 1 << 14;  // a range
  std::vector<std::string> parts(range_count(items, kLines));
  for_each_range(items, kLines, [&](size_t i, size_t end) {
    std::string& part = parts[i / kLines];
    part.reserve((end - i) * likely);
    for (; i < end; ++i) line(i, part);
  });
  size_t size = text.size();
  for (const std::string& part : parts) size += part.size();
  text.reserve(size);
  for (std::string& part : parts) {
    text += part;
    part = std::string();
  }
}
constexpr size_t kPositionLine = 64, kTriangleLine = 28;

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
  if (!mesh.library.empty()) (text += "mtllib ").append(mesh.library) += '\n';
  append_lines(mesh.positions.size(), kPositionLine, text, [&](size_t i, std::string& part) {
    part += "v ";
    append_three(mesh.positions[i], part);
  });
  append_lines(mesh.triangles.size(), kTriangleLine, text, [&](size_t i, std::string& part) {
    if (!mesh.materials.empty() && (i == 0 || mesh.materials[i] != mesh.materials[i - 1])) {
      assert(mesh.materials[i] < mesh.material_names.size());
      append_material("usemtl ", mesh.material_names[mesh.materials[i]], part);
    }
    const auto& [a, b, c] = mesh.triangles[i];
    assert(std::max({a, b, c}) < mesh.positions.size());
    part += "f ";
    append_three(std::array<uint64_t, 3>{uint64_t{a} + 1, uint64_t{b} + 1, uint64_t{c} + 1}, part);
  });
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
  std::string text = "OFF\n";
  append_three(std::array<size_t, 3>{mesh.positions.size(), mesh.triangles.size(), 0}, text);
  append_lines(mesh.positions.size(), kPositionLine, text,
               [&](size_t i, std::string& part) { append_three(mesh.positions[i], part); });
  append_lines(mesh.triangles.size(), kTriangleLine, text, [&](size_t i, std::string& part) {
    part += "3 ";
    append_three(mesh.triangles[i], part);
  });
  return text;
}

}  // namespace kerf
