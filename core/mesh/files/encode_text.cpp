#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>

#include "core/mesh/files/emit_ranges.h"
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

// Appends parts of a colour to the line that has just ended.
void append_colour(const VertexColour& colour, size_t parts, std::string& text) {
  text.pop_back();
  for (size_t k = 0; k < parts; ++k) {
    text += ' ';
    append_number(static_cast<float>(fraction_of(colour.part[k])), text);
  }
  text += '\n';
}

// Hands the lines of items to the sink; line(i, text) appends that of item i, about `likely` bytes long.
template <typename Line>
bool emit_lines(size_t items, size_t likely, const ByteSink& sink, Line line) {
  return emit_ranges(items, sink, [&](size_t i, size_t end, std::string& part) {
    part.reserve((end - i) * likely);
    for (; i < end; ++i) line(i, part);
  });
}
constexpr size_t kPositionLine = 64, kTriangleLine = 28;

// OBJ cannot return to the unnamed material, so that it is given a name.
void append_material(const char* keyword, const std::string& name, std::string& text) {
  text += keyword;
  text += name.empty() ? "default" : name;
  text += '\n';
}

}  // namespace

void encode_obj(const MeshView& mesh, const ByteSink& sink) {
  assert(mesh.materials.empty() || mesh.materials.size() == mesh.triangles.size());
  const size_t colour_numbers = mesh.colours.empty() ? 0 : mesh.any_translucent() ? 4 : 3;
  const auto append_position = [&](size_t i, std::string& text) {
    text += "v ";
    append_three(mesh.positions[i], text);
    if (colour_numbers > 0) append_colour(mesh.colours[i], colour_numbers, text);
  };
  const auto append_triangle = [&](size_t i, std::string& text) {
    if (!mesh.materials.empty() && (i == 0 || mesh.materials[i] != mesh.materials[i - 1])) {
      assert(mesh.materials[i] < mesh.material_names.size());
      append_material("usemtl ", mesh.material_names[mesh.materials[i]], text);
    }
    const auto& [a, b, c] = mesh.triangles[i];
    assert(std::max({a, b, c}) < mesh.positions.size());
    text += "f ";
    append_three(std::array<uint64_t, 3>{uint64_t{a} + 1, uint64_t{b} + 1, uint64_t{c} + 1}, text);
  };
  if (!mesh.mtl.empty() && !sink("mtllib " + std::string(mesh.mtl) + '\n')) return;
  if (emit_lines(mesh.positions.size(), kPositionLine, sink, append_position))
    emit_lines(mesh.triangles.size(), kTriangleLine, sink, append_triangle);
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

void encode_off(const MeshView& mesh, const ByteSink& sink) {
  std::string head = mesh.colours.empty() ? "OFF\n" : "COFF\n";
  append_three(std::array<size_t, 3>{mesh.positions.size(), mesh.triangles.size(), 0}, head);
  const auto append_position = [&](size_t i, std::string& text) {
    append_three(mesh.positions[i], text);
    if (mesh.colours.empty()) return;
    text.pop_back();
    for (const uint16_t part : mesh.colours[i].part) {
      text += ' ';
      append_number(eight_bits(part), text);
    }
    text += '\n';
  };
  const auto append_triangle = [&](size_t i, std::string& text) {
    text += "3 ";
    append_three(mesh.triangles[i], text);
  };
  if (sink(head) && emit_lines(mesh.positions.size(), kPositionLine, sink, append_position))
    emit_lines(mesh.triangles.size(), kTriangleLine, sink, append_triangle);
}

}  // namespace kerf
