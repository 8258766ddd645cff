#include "core/api/api_internal.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>

#include "core/base/version.h"
#include "core/mesh/mesh.h"
#include "core/mesh/mesh_file.h"
#include "core/mesh/weld.h"

namespace kerf {

namespace {

constexpr size_t kMaxElements = size_t{1} << 31;

bool is_finite(const Vec3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

// Converts the usable triangles of a file, over its welded positions.
Status convert_soup(Soup soup, const std::string& name, kerf_mesh& mesh) {
  WeldedTriangles welded(soup.positions);
  for (size_t t = 0; t < soup.triangles.size(); ++t) {
    const std::array<uint32_t, 3>& corners = soup.triangles[t];
    const bool usable =
        std::all_of(corners.begin(), corners.end(), [&](uint32_t v) { return is_finite(soup.positions[v]); });
    if (usable && welded.add(corners) && !soup.materials.empty()) mesh.materials.push_back(soup.materials[t]);
  }
  if (welded.triangles.empty()) return bad_input(name + ": the file has no usable face.");
  for (size_t p = 0; p < welded.sources.size() && !soup.colours.empty(); ++p)
    mesh.colours.push_back(soup.colours[welded.sources[p]]);
  mesh.positions = std::move(welded.positions);
  mesh.triangles = std::move(welded.triangles);
  mesh.material_names = std::move(soup.material_names);
  return Done{};
}

Status create_mesh(const double* vertices, size_t vertex_count, const uint32_t* faces, size_t face_count,
                   kerf_mesh& mesh) {
  if (vertices == nullptr || vertex_count == 0) return bad_input("vertices: must not be empty");
  if (faces == nullptr || face_count == 0) return bad_input("faces: must not be empty");
  if (vertex_count > kMaxElements || face_count > kMaxElements)
    return bad_input("vertices and faces: must be at most 2147483648 each");
  mesh.positions.resize(vertex_count);
  for (size_t v = 0; v < vertex_count; ++v) {
    for (int k = 0; k < 3; ++k) {
      const double x = vertices[3 * v + static_cast<size_t>(k)];
      if (!std::isfinite(x)) return bad_input("vertices[" + std::to_string(v) + "] is not finite");
      mesh.positions[v][k] = x;
    }
  }
  mesh.triangles.resize(face_count);
  for (size_t f = 0; f < face_count; ++f) {
    for (size_t i = 0; i < 3; ++i) {
      const uint32_t v = faces[3 * f + i];
      if (v >= vertex_count) {
        return bad_input("faces[" + std::to_string(f) + "] references vertex " + std::to_string(v) +
                         ", but the number of vertices is " + std::to_string(vertex_count));
      }
      mesh.triangles[f][i] = v;
    }
  }
  return Done{};
}

}  // namespace

void measure(kerf_mesh& mesh) {
  Vec3 sum(0);
  double area = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Triangle t = {mesh.positions[a], mesh.positions[b], mesh.positions[c]};
    const double own = triangle_area(t);
    area += own;
    sum += own / 3 * (t[0] + t[1] + t[2]);
  }
  mesh.info.area = area;
  for (int k = 0; k < 3; ++k) mesh.info.centroid[k] = area > 0 ? sum[k] / area : mesh.positions.front()[k];
  mesh.info.orientation[0] = 1;
}

Soup soup_of(const kerf_mesh& mesh) {
  Soup soup;
  soup.positions = mesh.positions;
  soup.triangles.assign(mesh.triangles.begin(), mesh.triangles.end());
  soup.colours = mesh.colours;
  soup.materials = mesh.materials;
  soup.material_names = mesh.material_names;
  soup.faces_in_file = soup.triangles_in_file = mesh.triangles.size();
  return soup;
}

}  // namespace kerf

const char* kerf_version(void) { return kerf::kVersion; }

const char* kerf_last_error(void) { return kerf::last_message(); }

kerf_result kerf_mesh_read(const char* path, const kerf_call_options* options, kerf_mesh** out) {
  if (path == nullptr || out == nullptr)
    return kerf::set_error(KERF_INVALID_ARGUMENT, "path and out: must not be null");
  return kerf::Call(options).run([&](const kerf::Progress& progress) -> kerf::Status {
    auto soup = kerf::read_mesh(path, &progress);
    if (!soup) return soup.error();
    auto mesh = std::make_unique<kerf_mesh>();
    if (const auto taken = kerf::convert_soup(std::move(*soup), path, *mesh); !taken) return taken;
    kerf::measure(*mesh);
    *out = mesh.release();
    return kerf::Done{};
  });
}

kerf_result kerf_mesh_create(const double* vertices, size_t vertex_count, const uint32_t* faces,
                             size_t face_count, kerf_mesh** out) {
  if (out == nullptr) return kerf::set_error(KERF_INVALID_ARGUMENT, "out: must not be null");
  return kerf::Call(nullptr).run([&](const kerf::Progress&) -> kerf::Status {
    auto mesh = std::make_unique<kerf_mesh>();
    const kerf::Status made = kerf::create_mesh(vertices, vertex_count, faces, face_count, *mesh);
    if (!made) return made;
    kerf::measure(*mesh);
    *out = mesh.release();
    return kerf::Done{};
  });
}

void kerf_mesh_destroy(kerf_mesh* mesh) { delete mesh; }

kerf_result kerf_mesh_write(const kerf_mesh* mesh, const char* path) {
  if (mesh == nullptr || path == nullptr)
    return kerf::set_error(KERF_INVALID_ARGUMENT, "mesh and path: must not be null");
  return kerf::Call(nullptr).run([&](const kerf::Progress&) -> kerf::Status {
    const std::filesystem::path file = path;
    const auto format = kerf::mesh_format(file.extension().string());
    if (!format) return kerf::bad_input(std::string(path) + ": must end in " + kerf::list_mesh_endings());
    return kerf::write_mesh({mesh->positions,
                             mesh->triangles,
                             mesh->materials,
                             mesh->material_names,
                             {},
                             mesh->name,
                             mesh->colours},
                            file, *format);
  });
}

size_t kerf_mesh_vertex_count(const kerf_mesh* mesh) { return mesh == nullptr ? 0 : mesh->positions.size(); }
size_t kerf_mesh_face_count(const kerf_mesh* mesh) { return mesh == nullptr ? 0 : mesh->triangles.size(); }
const double* kerf_mesh_vertices(const kerf_mesh* mesh) {
  return mesh == nullptr ? nullptr : &mesh->positions.data()->x;
}
const uint32_t* kerf_mesh_faces(const kerf_mesh* mesh) {
  return mesh == nullptr ? nullptr : mesh->triangles.data()->data();
}

const double* kerf_mesh_face_temperatures(const kerf_mesh* mesh) {
  return mesh == nullptr || mesh->temperatures.empty() ? nullptr : mesh->temperatures.data();
}

void kerf_mesh_get_info(const kerf_mesh* mesh, kerf_mesh_info* info) {
  if (info == nullptr) return;
  *info = mesh == nullptr ? kerf_mesh_info{} : mesh->info;
  info->name = mesh == nullptr ? "" : mesh->name.c_str();
}
