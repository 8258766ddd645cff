#include "tests/fuzz/reader_check.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <vector>

#include "core/mesh/build_mesh.h"
#include "core/mesh/files/encode.h"
#include "core/mesh/files/readers.h"

namespace kerf::fuzz {
namespace {

constexpr size_t kSmall = 2000;  // triangles of a soup that is built and written too
const std::string kName = "input";

void require(bool holds, const std::string& what) {
  if (holds) return;
  std::fprintf(stderr, "kerf: broken: %s\n", what.c_str());
  std::abort();
}

void check_error(const Error& error) {
  require(error.code == ErrorCode::kBadInput, "an error that is not of the input: " + error.message);
  require(error.message.starts_with(kName) && error.message.ends_with('.'),
          "an error that is no sentence about the file: " + error.message);
  require(error.message.find_first_of("\r\n") == std::string::npos, "an error of several lines");
}

template <typename T>
void check_channel(const LookChannel<T>& channel, const Soup& soup) {
  require(channel.corners.empty() || channel.corners.size() == soup.triangles.size(),
          "UVs or normals that are not one a corner");
  for (const auto& corners : channel.corners) {
    for (const uint32_t v : corners)
      require(v == channel.kNone || v < channel.values.size(), "a UV or a normal that is not there");
  }
}

void check_soup(const Soup& soup) {
  require(!soup.triangles.empty(), "a soup without a face");
  require(soup.triangles_in_file == soup.triangles.size() + soup.invalid_faces_dropped,
          "faces unaccounted for");
  for (const auto& triangle : soup.triangles) {
    for (const uint32_t v : triangle) require(v < soup.positions.size(), "an index that is not there");
  }
  require(soup.materials.empty() || soup.materials.size() == soup.triangles.size(),
          "materials that are not one a face");
  require(soup.colours.empty() || soup.colours.size() == soup.positions.size(),
          "colours that are not one a position");
  for (const auto& set : soup.looks.uv_sets) check_channel(set, soup);
  check_channel(soup.looks.normals, soup);
  check_channel(soup.looks.tangents, soup);
  for (const LookAttribute& attribute : soup.looks.attributes) {
    require(attribute.parts >= 1 && attribute.parts <= 4, "an attribute without parts");
    check_channel(attribute.channel, soup);
  }
  for (const uint16_t m : soup.materials)
    require(m < soup.material_names.size(), "a material that is not there");
}

void check_report(const MeshReport& report, const Soup& soup) {
  const Repairs& r = report.repairs;
  require(report.triangles_in_file == soup.triangles_in_file, "another number of triangles in the file");
  require(report.triangles_in_file == report.faces + r.degenerate_faces_dropped + r.non_finite_faces_dropped +
                                          r.invalid_faces_dropped,
          "faces unaccounted for after building");
  require(r.reoriented_faces <= report.faces && r.zero_area_faces <= report.faces, "more repairs than faces");
  require(report.components >= 1 && report.components <= report.faces, "an impossible number of components");
}

using Corners = std::array<Vec3, 3>;

// Corner by corner in the order of the turn, which may start at any of them.
bool same_turn(const Corners& a, const Corners& b) {
  for (size_t i = 0; i < 3; ++i) {
    if (a[0] == b[i] && a[1] == b[(i + 1) % 3] && a[2] == b[(i + 2) % 3]) return true;
  }
  return false;
}

bool is_finite(const Vec3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

Corners corners_of(const Soup& soup, size_t t) {
  const auto& [a, b, c] = soup.triangles[t];
  return {soup.positions[a], soup.positions[b], soup.positions[c]};
}

bool is_kept(const Corners& c) {
  return std::all_of(c.begin(), c.end(), is_finite) && c[0] != c[1] && c[1] != c[2] && c[2] != c[0];
}

// The faces are the usable triangles of the soup in their order, turned where the report says so.
void check_faces(const BuiltMesh& built, const Soup& soup) {
  require(built.mesh.face_slots() == built.report.faces && built.mesh.live_faces() == built.report.faces,
          "another number of faces in the mesh");
  uint32_t f = 0;
  size_t turned = 0;
  for (size_t t = 0; t < soup.triangles.size(); ++t) {
    const Corners wanted = corners_of(soup, t);
    if (!is_kept(wanted)) continue;
    const Triangle face = built.mesh.triangle(FaceId(f));
    if (!same_turn(face, wanted)) {
      require(same_turn(face, {wanted[0], wanted[2], wanted[1]}), "a face with other corners");
      ++turned;
    }
    ++f;
  }
  require(f == built.report.faces, "a usable face that is not in the mesh");
  require(turned == built.report.repairs.reoriented_faces, "faces turned and not counted");
}

struct Written {
  std::vector<Vec3> positions;
  std::vector<std::array<uint32_t, 3>> triangles;
  std::vector<uint16_t> materials;
};

Written written_form(const BuiltMesh& built) {
  Written w;
  for (uint32_t v = 0; v < built.mesh.vertex_slots(); ++v)
    w.positions.push_back(built.mesh.position(VertexId(v)));
  for (uint32_t f = 0; f < built.mesh.face_slots(); ++f) {
    const auto corners = built.mesh.corners(FaceId(f));
    w.triangles.push_back({corners[0].index, corners[1].index, corners[2].index});
    if (!built.material_names.empty()) w.materials.push_back(built.mesh.data(FaceId(f)).material);
  }
  return w;
}

bool fits_float(const Vec3& p) {
  constexpr double kLargest = std::numeric_limits<float>::max();
  return std::abs(p.x) <= kLargest && std::abs(p.y) <= kLargest && std::abs(p.z) <= kLargest;
}

bool same_bits(const Vec3& a, const Vec3& b) {
  for (int i = 0; i < 3; ++i) {
    if (std::bit_cast<uint64_t>(a[i]) != std::bit_cast<uint64_t>(b[i])) return false;
  }
  return true;
}

void check_read_back(const Soup& back, const Written& w, const BuiltMesh& built) {
  require(back.triangles == w.triangles, "other faces when read back");
  require(back.positions.size() == w.positions.size(), "other vertices when read back");
  for (size_t i = 0; i < w.positions.size(); ++i) {
    require(same_bits(back.positions[i], w.positions[i]), "a position that does not read back as it was");
  }
  for (size_t t = 0; t < back.materials.size() && !w.materials.empty(); ++t) {
    std::string name = built.material_names[w.materials[t]];
    if (name.empty()) name = "default";
    require(back.material_names[back.materials[t]] == name, "another material when read back");
  }
}

void check_stl_read_back(const Soup& back, const Written& w) {
  require(back.triangles.size() == w.triangles.size(), "other faces when read back");
  for (size_t t = 0; t < w.triangles.size(); ++t) {
    for (size_t i = 0; i < 3; ++i) {
      const Vec3 rounded(glm::vec3(w.positions[w.triangles[t][i]]));
      require(same_bits(back.positions[3 * t + i], rounded),
              "a position that does not read back to float precision");
    }
  }
}

// Triangles come by material, and positions are floats relative to the middle.
void check_gltf_read_back(const Soup& back, const Written& w) {
  require(back.triangles.size() == w.triangles.size(), "other faces when read back");
  require(back.positions.size() == w.positions.size(), "other vertices when read back");
  Vec3 low = w.positions[0], high = low;
  for (const Vec3& p : w.positions) low = glm::min(low, p), high = glm::max(high, p);
  const Vec3 slack = 1e-6 * (high - low) + 1e-15 * glm::max(glm::abs(low), glm::abs(high)) + Vec3(1e-44);
  for (size_t i = 0; i < w.positions.size(); ++i) {
    const Vec3 off = glm::abs(back.positions[i] - w.positions[i]);
    require(off.x <= slack.x && off.y <= slack.y && off.z <= slack.z, "a position that does not read back");
  }
}

// Millimetres as floats with six decimal places.
void check_3mf_read_back(const Soup& back, const Written& w) {
  require(back.triangles == w.triangles, "other faces when read back");
  require(back.positions.size() == w.positions.size(), "other vertices when read back");
  for (size_t i = 0; i < w.positions.size(); ++i) {
    const Vec3 off = glm::abs(back.positions[i] - w.positions[i]),
               slack = Vec3(2e-9) + 3e-7 * glm::abs(w.positions[i]);
    require(off.x <= slack.x && off.y <= slack.y && off.z <= slack.z, "a position that does not read back");
  }
}

void check_round_trip(Reader read, MeshFormat format, const BuiltMesh& built) {
  const Written w = written_form(built);
  const bool stl = format == MeshFormat::kStl;
  const bool gltf = format == MeshFormat::kGlb;
  const double range = gltf ? 2 : 1;  // positions are told from the middle
  const auto fits = [&](const Vec3& p) { return fits_float(range * p); };
  if ((stl || gltf) && !std::all_of(w.positions.begin(), w.positions.end(), fits)) return;
  const bool is_3mf = format == MeshFormat::k3mf;
  const auto fits_3mf = [](const Vec3& p) {
    return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) <= kMaxThreeMf;
  };
  if (is_3mf && !std::all_of(w.positions.begin(), w.positions.end(), fits_3mf)) return;
  const std::string bytes = encoded({w.positions, w.triangles, w.materials, built.material_names}, format);
  const Result<Soup> back = read(bytes, kName, nullptr);
  require(back.ok(), "what was written is refused: " + (back ? "" : back.error().message));
  check_soup(*back);
  if (stl) return check_stl_read_back(*back, w);
  if (gltf) return check_gltf_read_back(*back, w);
  if (is_3mf) return check_3mf_read_back(*back, w);
  check_read_back(*back, w, built);
}

// UVs, normals and materials can be written and read again.
void check_looks(const Soup& soup) {
  if (!soup.looks.any() && !soup.surfaces) return;
  const auto fits = [](const Vec3& p) { return is_finite(p) && fits_float(2.0 * p); };
  if (!std::all_of(soup.positions.begin(), soup.positions.end(), fits)) return;
  const MeshView view{soup.positions, soup.triangles,     soup.materials, soup.material_names, {}, {}, {},
                      &soup.looks,    soup.surfaces.get()};
  const auto glb = read_gltf(encoded(view, MeshFormat::kGlb), kName);
  require(glb.ok(), "a glTF file with looks is refused: " + (glb ? "" : glb.error().message));
  check_soup(*glb);
  const auto obj = read_obj(encoded(view, MeshFormat::kObj), kName);
  require(obj.ok(), "an OBJ file with looks is refused: " + (obj ? "" : obj.error().message));
  check_soup(*obj);
  const auto ply = read_ply(encoded(view, MeshFormat::kPly), kName);
  require(ply.ok(), "a PLY file with looks is refused: " + (ply ? "" : ply.error().message));
  check_soup(*ply);
}

}  // namespace

void check_reader(Reader read, MeshFormat format, const uint8_t* data, size_t size) {
  const Result<Soup> soup = read({reinterpret_cast<const char*>(data), size}, kName, nullptr);
  if (!soup) return check_error(soup.error());
  check_soup(*soup);
  if (soup->triangles.size() > kSmall) return;
  const Result<BuiltMesh> built = build_mesh(*soup);
  if (!built) return;
  check_report(built->report, *soup);
  check_faces(*built, *soup);
  check_round_trip(read, format, *built);
  check_looks(*soup);
}

}  // namespace kerf::fuzz
