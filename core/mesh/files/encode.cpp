#include "core/mesh/files/encode.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <cmath>
#include <set>
#include <utility>

#include "core/base/parallel.h"
#include "core/mesh/files/bytes.h"
#include "core/mesh/files/split_vertices_internal.h"

namespace kerf {

bool MeshView::any_translucent() const {
  return std::any_of(colours.begin(), colours.end(), [](const VertexColour& c) {
    return c.part[VertexColour::kOpacity] != VertexColour::kFull;
  });
}

void encode(const MeshView& mesh, MeshFormat format, const ByteSink& sink) {
  switch (format) {
    case MeshFormat::kObj:
      return encode_obj(mesh, sink);
    case MeshFormat::kPly:
      return encode_ply(mesh, sink);
    case MeshFormat::kStl:
      return encode_stl(mesh, sink);
    case MeshFormat::kOff:
      return encode_off(mesh, sink);
    case MeshFormat::kGlb:
      return encode_glb({&mesh, 1}, sink);
    case MeshFormat::kGltf:
      return encode_gltf({&mesh, 1}, sink);
    case MeshFormat::k3mf:
      return encode_3mf({&mesh, 1}, sink);
  }
}

std::string encoded(const MeshView& mesh, MeshFormat format) {
  std::string bytes;
  encode(mesh, format, [&](std::string_view part) {
    bytes += part;
    return true;
  });
  return bytes;
}

std::vector<std::string> distinct_names(std::vector<std::string> names) {
  std::set<std::string> taken(names.begin(), names.end()), seen;
  for (std::string& name : names) {
    if (seen.insert(name).second) continue;
    size_t number = 2;
    while (!taken.insert(name + "_" + std::to_string(number)).second) ++number;
    name += "_" + std::to_string(number);
  }
  return names;
}

bool emit_ranges(size_t items, const ByteSink& sink,
                 const std::function<void(size_t first, size_t end, std::string& part)>& encode) {
  constexpr size_t kItems = 1 << 13;  // per range
  std::array<std::string, 8> parts;
  const size_t most = parts.size() * kItems;  // at a time
  for (size_t done = 0; done < items; done += most) {
    const size_t now = std::min(most, items - done);
    for_each_range(now, kItems, [&](size_t first, size_t end) {
      std::string& part = parts[first / kItems];
      part.clear();
      encode(done + first, done + end, part);
    });
    for (size_t r = 0; r < range_count(now, kItems); ++r) {
      if (!sink(parts[r])) return false;
    }
  }
  return true;
}

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

// Appends components of a colour to the last line.
void append_colour(const VertexColour& colour, size_t parts, std::string& text) {
  text.pop_back();
  for (size_t k = 0; k < parts; ++k) {
    text += ' ';
    append_number(static_cast<float>(fraction_of(colour.part[k])), text);
  }
  text += '\n';
}

// Writes one line per item to the sink; line(i, text) appends that of item i, of about `likely` bytes.
template <typename Line>
bool emit_lines(size_t items, size_t likely, const ByteSink& sink, Line line) {
  return emit_ranges(items, sink, [&](size_t i, size_t end, std::string& part) {
    part.reserve((end - i) * likely);
    for (; i < end; ++i) line(i, part);
  });
}
constexpr size_t kPositionLine = 64, kTriangleLine = 28;

// Appends the numbers of a line, each after a blank, and a line feed.
template <typename V>
void append_floats_line(const char* keyword, const V& numbers, std::string& text) {
  text += keyword;
  for (int k = 0; k < V::length(); ++k) {
    text += ' ';
    append_number(numbers[k], text);
  }
  text += '\n';
}

// Appends a corner of a face with the numbers of its UV and its normal, if any: 7, 7/7, 7//7 or 7/7/7.
void append_obj_corner(uint32_t vertex, uint32_t uv, uint32_t normal, std::string& text) {
  constexpr uint32_t kNone = LookChannel<Vec3>::kNone;
  append_number(uint64_t{vertex} + 1, text);
  if (uv == kNone && normal == kNone) return;
  text += '/';
  if (uv != kNone) append_number(uint64_t{uv} + 1, text);
  if (normal == kNone) return;
  text += '/';
  append_number(uint64_t{normal} + 1, text);
}

// OBJ cannot return to the unnamed material, so it gets a name.
void append_material(const char* keyword, const std::string& name, std::string& text) {
  text += keyword;
  text += name.empty() ? "default" : name;
  text += '\n';
}

}  // namespace

void encode_obj(const MeshView& mesh, const ByteSink& sink) {
  assert(mesh.materials.empty() || mesh.materials.size() == mesh.triangles.size());
  const size_t colour_numbers = mesh.colours.empty() ? 0 : mesh.any_translucent() ? 4 : 3;
  const LookChannel<glm::vec2>* uvs =
      mesh.looks && !mesh.looks->uv_sets.empty() ? &mesh.looks->uv_sets[0] : nullptr;
  const LookChannel<glm::vec3>* normals =
      mesh.looks && mesh.looks->normals.any() ? &mesh.looks->normals : nullptr;
  constexpr uint32_t kNoValue = LookChannel<glm::vec2>::kNone;
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
    if (!mesh.looks) {
      append_three(std::array<uint64_t, 3>{uint64_t{a} + 1, uint64_t{b} + 1, uint64_t{c} + 1}, text);
      return;
    }
    for (size_t k = 0; k < 3; ++k) {
      append_obj_corner(mesh.triangles[i][k], uvs ? uvs->corners[i][k] : kNoValue,
                        normals ? normals->corners[i][k] : kNoValue, text);
      text += k < 2 ? ' ' : '\n';
    }
  };
  const auto append_uv = [&](size_t i, std::string& text) {
    const glm::vec2& uv = uvs->values[i];
    append_floats_line("vt", glm::vec2(uv.x, mesh.looks->v_points_down ? 1 - uv.y : uv.y), text);
  };
  const auto append_normal = [&](size_t i, std::string& text) {
    append_floats_line("vn", normals->values[i], text);
  };
  if (!mesh.mtl.empty() && !sink("mtllib " + std::string(mesh.mtl) + '\n')) return;
  if (!mesh.object.empty() && !sink("o " + std::string(mesh.object) + '\n')) return;
  if (emit_lines(mesh.positions.size(), kPositionLine, sink, append_position) &&
      (!uvs || emit_lines(uvs->values.size(), kTriangleLine, sink, append_uv)) &&
      (!normals || emit_lines(normals->values.size(), kPositionLine, sink, append_normal)))
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

namespace {

void append_floats(const Vec3& v, std::string& bytes) {
  for (int i = 0; i < 3; ++i) append_little(static_cast<float>(v[i]), bytes);
}

}  // namespace

// Scaling the edges avoids overflow and underflow.
Vec3 unit_normal(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 u = b - a, v = c - a;
  const double size =
      std::max({std::abs(u.x), std::abs(u.y), std::abs(u.z), std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  if (!(size > 0)) return Vec3(0);
  const Vec3 normal = glm::cross(u / size, v / size);
  const double length = glm::length(normal);
  return length > 0 ? normal / length : Vec3(0);
}

namespace {

std::string colour_properties(size_t count) {
  std::string lines;
  for (size_t k = 0; k < count; ++k)
    lines += "property uchar " + std::string(std::array{"red", "green", "blue", "alpha"}[k]) + "\n";
  return lines;
}

// Returns the name of a property of PLY for a part of an attribute.
std::string ply_name(const LookAttribute& attribute, size_t part) {
  constexpr std::array<std::string_view, 20> kTaken{"x",
                                                    "y",
                                                    "z",
                                                    "nx",
                                                    "ny",
                                                    "nz",
                                                    "s",
                                                    "t",
                                                    "u",
                                                    "v",
                                                    "texture_u",
                                                    "texture_v",
                                                    "red",
                                                    "green",
                                                    "blue",
                                                    "alpha",
                                                    "diffuse_red",
                                                    "diffuse_green",
                                                    "diffuse_blue",
                                                    "diffuse_alpha"};
  std::string name = attribute.name;
  for (char& c : name) {
    if (static_cast<unsigned char>(c) <= 0x20 || c == 0x7f) c = '_';
  }
  if (attribute.parts > 1) name += std::string("_") + "xyzw"[part];
  const bool taken = std::find(kTaken.begin(), kTaken.end(), name) != kTaken.end();
  return name.empty() || taken ? "_" + name : name;
}

std::string attribute_properties(const MeshView& mesh) {
  std::string lines;
  if (!mesh.looks) return lines;
  std::vector<std::string> names;
  for (const LookAttribute& attribute : mesh.looks->attributes) {
    for (size_t part = 0; part < attribute.parts; ++part) names.push_back(ply_name(attribute, part));
  }
  for (const std::string& name : distinct_names(std::move(names))) lines += "property float " + name + "\n";
  return lines;
}

}  // namespace

void encode_ply(const MeshView& mesh, const ByteSink& sink) {
  assert(mesh.positions.size() <= size_t{1} << 31);
  const size_t colour_bytes = mesh.colours.empty() ? 0 : mesh.any_translucent() ? 4 : 3;
  const SplitVertices vertices(mesh, false, false);
  const bool has_uvs = mesh.looks && !mesh.looks->uv_sets.empty(), has_normals = !vertices.normals.empty();
  size_t look_floats = (has_normals ? 3 : 0) + (has_uvs ? 2 : 0);
  for (size_t a = 0; a < vertices.attributes.size(); ++a) look_floats += mesh.looks->attributes[a].parts;
  const std::string head =
      "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(vertices.count(mesh)) +
      "\nproperty double x\nproperty double y\nproperty double z\n" +
      (has_normals ? "property float nx\nproperty float ny\nproperty float nz\n" : "") +
      (has_uvs ? "property float s\nproperty float t\n" : "") + attribute_properties(mesh) +
      colour_properties(colour_bytes) + "element face " + std::to_string(mesh.triangles.size()) +
      "\nproperty list uchar int vertex_indices\nend_header\n";
  const auto append_vertices = [&](size_t i, size_t end, std::string& part) {
    part.resize((end - i) * (3 * sizeof(double) + look_floats * sizeof(float) + colour_bytes));
    for (char* to = part.data(); i < end; ++i) {
      const uint32_t p = vertices.position(i);
      for (int k = 0; k < 3; ++k) to = store_little(mesh.positions[p][k], to);
      for (int k = 0; has_normals && k < 3; ++k) to = store_little(vertices.normals[i][k], to);
      for (int k = 0; has_uvs && k < 2; ++k) to = store_little(vertices.uv_sets[0][i][k], to);
      for (size_t a = 0; a < vertices.attributes.size(); ++a) {
        for (int k = 0; k < mesh.looks->attributes[a].parts; ++k)
          to = store_little(vertices.attributes[a][i][k], to);
      }
      for (size_t k = 0; k < colour_bytes; ++k) to = store_little(eight_bits(mesh.colours[p].part[k]), to);
    }
  };
  const auto append_faces = [&](size_t i, size_t end, std::string& part) {
    part.resize((end - i) * (1 + 3 * sizeof(int32_t)));
    for (char* to = part.data(); i < end; ++i) {
      to = store_little(uint8_t{3}, to);
      for (const uint32_t v : vertices.triangles(mesh)[i]) {
        assert(v < vertices.count(mesh));
        to = store_little(v, to);
      }
    }
  };
  if (sink(head) && emit_ranges(vertices.count(mesh), sink, append_vertices))
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
