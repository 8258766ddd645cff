#include "core/api/api_internal.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>
#include <memory>
#include <utility>

#include "core/base/version.h"
#include "core/mesh/files/soup_file.h"
#include "core/mesh/measures.h"
#include "core/mesh/mesh.h"
#include "core/mesh/mesh_file.h"
#include "core/mesh/weld.h"

namespace kerf {

namespace {

// Keeps the values of these triangles, ascending.
template <typename T>
void keep_triangles(LookChannel<T>& channel, const std::vector<size_t>& kept) {
  for (size_t t = 0; channel.any() && t < kept.size(); ++t) channel.corners[t] = channel.corners[kept[t]];
  if (channel.any()) channel.corners.resize(kept.size());
}

// Calls use(channel, size) for an attribute. Returns false if there is none of this number.
template <typename Use>
bool use_attribute(const CornerLooks& looks, size_t attribute, const Use& use) {
  if (attribute < looks.uv_sets.size()) {
    use(looks.uv_sets[attribute], 2);
    return true;
  }
  attribute -= looks.uv_sets.size();
  if (looks.normals.any() && attribute-- == 0) {
    use(looks.normals, 3);
    return true;
  }
  if (looks.tangents.any() && attribute-- == 0) {
    use(looks.tangents, 4);
    return true;
  }
  if (attribute >= looks.attributes.size()) return false;
  use(looks.attributes[attribute].channel, int{looks.attributes[attribute].parts});
  return true;
}

// Returns the parts as ranges of the kept triangles, ascending; empty ones are dropped.
std::vector<MeshPart> parts_of_kept(std::vector<MeshPart> parts, const std::vector<size_t>& kept) {
  const auto kept_before = [&](uint32_t triangle) {
    return static_cast<uint32_t>(std::lower_bound(kept.begin(), kept.end(), triangle) - kept.begin());
  };
  for (MeshPart& part : parts) {
    part.first = kept_before(part.first);
    part.last = kept_before(part.last);
  }
  std::erase_if(parts, [](const MeshPart& part) { return part.first == part.last; });
  return parts;
}

Status convert_soup(Soup soup, const std::string& name, kerf_mesh& mesh) {
  WeldedTriangles welded(soup.positions);
  std::vector<size_t> kept;
  Repairs dropped;
  dropped.invalid_faces_dropped = soup.invalid_faces_dropped;
  dropped.incomplete_faces_dropped = soup.incomplete_faces_dropped;
  for (size_t t = 0; t < soup.triangles.size(); ++t) {
    const std::array<uint32_t, 3>& corners = soup.triangles[t];
    const bool finite =
        std::all_of(corners.begin(), corners.end(), [&](uint32_t v) { return is_finite(soup.positions[v]); });
    if (!finite || !welded.add(corners)) {
      ++(finite ? dropped.degenerate_faces_dropped : dropped.non_finite_faces_dropped);
      continue;
    }
    kept.push_back(t);
    if (!soup.material_names.empty())
      mesh.materials.push_back(soup.materials.empty() ? uint16_t{0} : soup.materials[t]);
  }
  if (welded.triangles.empty()) return bad_input(name + ": the file has no usable face.");
  mesh.parts = parts_of_kept(std::move(soup.parts), kept);
  for (size_t p = 0; p < welded.sources.size() && !soup.colours.empty(); ++p)
    mesh.colours.push_back(soup.colours[welded.sources[p]]);
  mesh.warnings = dropped_notes(dropped);
  mesh.warnings.insert(mesh.warnings.end(), soup.warnings.begin(), soup.warnings.end());
  mesh.positions = std::move(welded.positions);
  mesh.triangles = std::move(welded.triangles);
  mesh.material_names = std::move(soup.material_names);
  CornerLooks& looks = soup.looks;
  for (auto& set : looks.uv_sets) keep_triangles(set, kept);
  keep_triangles(looks.normals, kept);
  keep_triangles(looks.tangents, kept);
  for (auto& attribute : looks.attributes) keep_triangles(attribute.channel, kept);
  set_looks(mesh, std::move(looks), std::move(soup.surfaces));
  return Done{};
}

// Converts the content of a Kerf mesh, unchanged.
Status convert_exactly(Soup soup, kerf_mesh& mesh) {
  if (!std::ranges::all_of(soup.positions, is_finite))
    return bad_input("bytes: a position of the mesh is not finite");
  mesh.positions = std::move(soup.positions);
  mesh.triangles.assign(soup.triangles.begin(), soup.triangles.end());
  mesh.colours = std::move(soup.colours);
  mesh.materials = std::move(soup.materials);
  mesh.material_names = std::move(soup.material_names);
  mesh.parts = std::move(soup.parts);
  set_looks(mesh, std::move(soup.looks), std::move(soup.surfaces));
  measure(mesh);
  return Done{};
}

int64_t euler_number(const kerf_mesh& mesh) {
  std::vector<std::pair<uint32_t, uint32_t>> edges;
  std::vector<bool> is_used(mesh.positions.size());
  edges.reserve(3 * mesh.triangles.size());
  for (const std::array<uint32_t, 3>& t : mesh.triangles) {
    for (size_t i = 0; i < 3; ++i) {
      edges.push_back(std::minmax({t[i], t[(i + 1) % 3]}));
      is_used[t[i]] = true;
    }
  }
  std::sort(edges.begin(), edges.end());
  const auto distinct = std::unique(edges.begin(), edges.end()) - edges.begin();
  return std::count(is_used.begin(), is_used.end(), true) - distinct +
         static_cast<int64_t>(mesh.triangles.size());
}

}  // namespace

Result<std::unique_ptr<kerf_mesh>> mesh_of_soup(Soup soup, const std::string& name) {
  auto mesh = std::make_unique<kerf_mesh>();
  if (const auto converted = convert_soup(std::move(soup), name, *mesh); !converted) return converted.error();
  measure(*mesh);
  return mesh;
}

void measure(kerf_mesh& mesh) {
  const SurfaceMeasures measures = measure_surface(mesh.positions, mesh.triangles);
  mesh.info.area = measures.area;
  for (int k = 0; k < 3; ++k) mesh.info.centroid[k] = measures.centroid[k];
  mesh.info.orientation[0] = 1;
}

void set_looks(kerf_mesh& mesh, CornerLooks looks, std::shared_ptr<const SurfaceLibrary> surfaces) {
  mesh.looks = std::move(looks);
  mesh.surfaces = std::move(surfaces);
  for (size_t set = 0; set < mesh.looks.uv_sets.size(); ++set)
    mesh.attribute_names.push_back("TEXCOORD_" + std::to_string(set));
  if (mesh.looks.normals.any()) mesh.attribute_names.emplace_back("NORMAL");
  if (mesh.looks.tangents.any()) mesh.attribute_names.emplace_back("TANGENT");
  for (const LookAttribute& attribute : mesh.looks.attributes)
    mesh.attribute_names.push_back("_" + attribute.name);
  mesh.attribute_names = distinct_names(std::move(mesh.attribute_names));
}

MeshView view_of(const kerf_mesh& mesh) {
  MeshView view{mesh.positions, mesh.triangles, mesh.materials, mesh.material_names, {},
                mesh.name,      mesh.colours};
  if (mesh.looks.any()) view.looks = &mesh.looks;
  view.surfaces = mesh.surfaces.get();
  return view;
}

Soup soup_of(const kerf_mesh& mesh) {
  Soup soup;
  soup.positions = mesh.positions;
  soup.triangles.assign(mesh.triangles.begin(), mesh.triangles.end());
  soup.colours = mesh.colours;
  soup.materials = mesh.materials;
  soup.material_names = mesh.material_names;
  soup.parts = mesh.parts;
  soup.looks = mesh.looks;
  soup.surfaces = mesh.surfaces;
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
    auto mesh = kerf::mesh_of_soup(std::move(*soup), path);
    if (!mesh) return mesh.error();
    *out = mesh->release();
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
    return kerf::write_mesh(kerf::view_of(*mesh), file, *format);
  });
}

kerf_result kerf_mesh_to_bytes(const kerf_mesh* mesh, char** out, size_t* size) {
  if (mesh == nullptr || out == nullptr || size == nullptr)
    return kerf::set_error(KERF_INVALID_ARGUMENT, "mesh, out and size: must not be null");
  return kerf::Call(nullptr).run([&](const kerf::Progress&) -> kerf::Status {
    const std::string bytes = kerf::encode_soup(kerf::soup_of(*mesh));
    auto copy = std::make_unique<char[]>(bytes.size());
    std::memcpy(copy.get(), bytes.data(), bytes.size());
    *size = bytes.size();
    *out = copy.release();
    return kerf::Done{};
  });
}

kerf_result kerf_mesh_from_bytes(const char* bytes, size_t size, kerf_mesh** out) {
  if (bytes == nullptr || out == nullptr)
    return kerf::set_error(KERF_INVALID_ARGUMENT, "bytes and out: must not be null");
  return kerf::Call(nullptr).run([&](const kerf::Progress&) -> kerf::Status {
    auto soup = kerf::read_soup({bytes, size}, "bytes");
    if (!soup) return soup.error();
    auto mesh = std::make_unique<kerf_mesh>();
    if (const auto converted = kerf::convert_exactly(std::move(*soup), *mesh); !converted) return converted;
    *out = mesh.release();
    return kerf::Done{};
  });
}

size_t kerf_mesh_vertex_count(const kerf_mesh* mesh) { return mesh == nullptr ? 0 : mesh->positions.size(); }
size_t kerf_mesh_face_count(const kerf_mesh* mesh) { return mesh == nullptr ? 0 : mesh->triangles.size(); }
const double* kerf_mesh_vertices(const kerf_mesh* mesh) {
  return mesh == nullptr ? nullptr : kerf::numbers_of(mesh->positions);
}
const uint32_t* kerf_mesh_faces(const kerf_mesh* mesh) {
  return mesh == nullptr || mesh->triangles.empty() ? nullptr : mesh->triangles.front().data();
}

const double* kerf_mesh_face_temperatures(const kerf_mesh* mesh) {
  return mesh == nullptr || mesh->temperatures.empty() ? nullptr : mesh->temperatures.data();
}

size_t kerf_mesh_attribute_count(const kerf_mesh* mesh) {
  return mesh == nullptr ? 0 : mesh->attribute_names.size();
}

const char* kerf_mesh_attribute_name(const kerf_mesh* mesh, size_t attribute) {
  return attribute < kerf_mesh_attribute_count(mesh) ? mesh->attribute_names[attribute].c_str() : nullptr;
}

size_t kerf_mesh_attribute_size(const kerf_mesh* mesh, size_t attribute) {
  size_t size = 0;
  if (mesh != nullptr) {
    kerf::use_attribute(mesh->looks, attribute,
                        [&](const auto&, int parts) { size = static_cast<size_t>(parts); });
  }
  return size;
}

kerf_result kerf_mesh_get_attribute(const kerf_mesh* mesh, size_t attribute, float* values) {
  if (mesh == nullptr || values == nullptr)
    return kerf::set_error(KERF_INVALID_ARGUMENT, "mesh and values: must not be null");
  const kerf::CornerLooks& looks = mesh->looks;
  const bool turn_v = attribute < looks.uv_sets.size() && !looks.v_points_down;
  const bool found = kerf::use_attribute(looks, attribute, [&](const auto& channel, int parts) {
    for (size_t t = 0; t < mesh->triangles.size(); ++t) {
      for (size_t i = 0; i < 3; ++i) {
        const uint32_t at = channel.any() ? channel.corners[t][i] : channel.kNone;
        for (int k = 0; k < parts; ++k) {
          const bool known = at < channel.values.size();
          const float own = known ? channel.values[at][k] : std::numeric_limits<float>::quiet_NaN();
          *values++ = turn_v && k == 1 ? 1 - own : own;
        }
      }
    }
  });
  return found ? KERF_OK
               : kerf::set_error(KERF_INVALID_ARGUMENT, "attribute: the mesh has no such attribute");
}

const uint16_t* kerf_mesh_face_materials(const kerf_mesh* mesh) {
  return kerf_mesh_material_count(mesh) == 0 || mesh->materials.empty() ? nullptr : mesh->materials.data();
}

size_t kerf_mesh_material_count(const kerf_mesh* mesh) {
  return mesh == nullptr ? 0 : mesh->material_names.size();
}

const char* kerf_mesh_material_name(const kerf_mesh* mesh, size_t material) {
  return material < kerf_mesh_material_count(mesh) ? mesh->material_names[material].c_str() : nullptr;
}

size_t kerf_mesh_part_count(const kerf_mesh* mesh) { return mesh == nullptr ? 0 : mesh->parts.size(); }

kerf_result kerf_mesh_get_part(const kerf_mesh* mesh, size_t part, const char** name, size_t* first,
                               size_t* count) {
  if (name == nullptr || first == nullptr || count == nullptr)
    return kerf::set_error(KERF_INVALID_ARGUMENT, "name, first and count: must not be null");
  if (part >= kerf_mesh_part_count(mesh))
    return kerf::set_error(KERF_INVALID_ARGUMENT, "part: the mesh has no such part");
  const kerf::MeshPart& own = mesh->parts[part];
  *name = own.name.c_str();
  *first = own.first;
  *count = own.last - own.first;
  return KERF_OK;
}

kerf_result kerf_mesh_get_info(const kerf_mesh* mesh, kerf_mesh_info* info) {
  if (info == nullptr) return kerf::set_error(KERF_INVALID_ARGUMENT, "info: must not be null");
  if (const kerf::Status valid = kerf::check_size(*info, "info"); !valid)
    return kerf::set_error(KERF_INVALID_ARGUMENT, valid.error().message.c_str());
  kerf_mesh_info own = mesh == nullptr ? kerf_mesh_info{} : mesh->info;
  own.name = mesh == nullptr ? "" : mesh->name.c_str();
  kerf::write_struct(own, *info);
  return KERF_OK;
}

kerf_result kerf_mesh_euler_number(const kerf_mesh* mesh, int64_t* out) {
  if (mesh == nullptr || out == nullptr)
    return kerf::set_error(KERF_INVALID_ARGUMENT, "mesh and out: must not be null");
  return kerf::Call(nullptr).run([&](const kerf::Progress&) -> kerf::Status {
    *out = kerf::euler_number(*mesh);
    return kerf::Done{};
  });
}
