// Meshes from and to memory.
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <string_view>
#include <utility>

#include "core/api/api_internal.h"
#include "core/mesh/mesh_file.h"

namespace kerf {

namespace {

constexpr size_t kMaxElements = size_t{1} << 31;

// A buffer of elements of three numbers, at any stride and alignment.
template <typename Byte>
class Triples {
 public:
  Triples(Byte* bytes, size_t stride, size_t number_size)
      : bytes_(bytes), stride_(stride == 0 ? 3 * number_size : stride) {}

  template <typename T>
  std::array<T, 3> get(size_t element) const {
    std::array<T, 3> numbers;
    std::memcpy(numbers.data(), bytes_ + element * stride_, sizeof numbers);
    return numbers;
  }
  template <typename T>
  void set(size_t element, const std::array<T, 3>& numbers) const {
    std::memcpy(bytes_ + element * stride_, numbers.data(), sizeof numbers);
  }

 private:
  Byte* bytes_;
  size_t stride_;
};

// A checked layout, and its buffers.
struct Format {
  kerf_layout layout;

  size_t position_size() const { return layout.is_float ? sizeof(float) : sizeof(double); }
  size_t index_size() const { return layout.is_16_bit ? sizeof(uint16_t) : sizeof(uint32_t); }
  template <typename Byte>
  Triples<Byte> vertices(Byte* bytes) const {
    return {bytes, layout.vertex_stride, position_size()};
  }
  template <typename Byte>
  Triples<Byte> faces(Byte* bytes) const {
    return {bytes, layout.face_stride, index_size()};
  }
};

Result<Format> format_of(const kerf_layout* given) {
  const auto layout = read_struct(given, KERF_LAYOUT_INIT, "layout");
  if (!layout) return layout.error();
  const Format format{*layout};
  const auto holds = [](size_t stride, size_t number) { return stride == 0 || stride >= 3 * number; };
  if (!holds(layout->vertex_stride, format.position_size()))
    return bad_input("layout: vertex_stride must be 0 or at least the size of a position");
  if (!holds(layout->face_stride, format.index_size()))
    return bad_input("layout: face_stride must be 0 or at least the size of three indices");
  return format;
}

Status read_vertices(const Format& format, const std::byte* bytes, std::vector<Vec3>& positions) {
  const auto from = format.vertices(bytes);
  for (size_t v = 0; v < positions.size(); ++v) {
    Vec3& p = positions[v];
    if (format.layout.is_float) {
      const auto [x, y, z] = from.get<float>(v);
      p = {x, y, z};
    } else {
      const auto [x, y, z] = from.get<double>(v);
      p = {x, y, z};
    }
    if (!is_finite(p)) return bad_input("vertices[" + std::to_string(v) + "] is not finite");
  }
  return Done{};
}

Status read_faces(const Format& format, const std::byte* bytes, kerf_mesh& mesh) {
  const auto from = format.faces(bytes);
  for (size_t f = 0; f < mesh.triangles.size(); ++f) {
    if (format.layout.is_16_bit) {
      const auto [a, b, c] = from.get<uint16_t>(f);
      mesh.triangles[f] = {a, b, c};
    } else {
      mesh.triangles[f] = from.get<uint32_t>(f);
    }
    for (const uint32_t v : mesh.triangles[f]) {
      if (v >= mesh.positions.size()) {
        return bad_input("faces[" + std::to_string(f) + "] references vertex " + std::to_string(v) +
                         ", but the number of vertices is " + std::to_string(mesh.positions.size()));
      }
    }
  }
  return Done{};
}

Result<std::unique_ptr<kerf_mesh>> create_mesh(const void* vertices, size_t vertex_count, const void* faces,
                                               size_t face_count, const kerf_layout* layout) {
  const auto format = format_of(layout);
  if (!format) return format.error();
  if (vertices == nullptr || vertex_count == 0) return bad_input("vertices: must not be empty");
  if (faces == nullptr || face_count == 0) return bad_input("faces: must not be empty");
  if (vertex_count > kMaxElements || face_count > kMaxElements)
    return bad_input("vertices and faces: must be at most 2147483648 each");
  auto mesh = std::make_unique<kerf_mesh>();
  mesh->positions.resize(vertex_count);
  mesh->triangles.resize(face_count);
  Status read = read_vertices(*format, static_cast<const std::byte*>(vertices), mesh->positions);
  if (read) read = read_faces(*format, static_cast<const std::byte*>(faces), *mesh);
  if (!read) return read.error();
  measure(*mesh);
  return mesh;
}

Status copy_mesh(const kerf_mesh& mesh, const kerf_layout* layout, void* vertices, void* faces) {
  const auto format = format_of(layout);
  if (!format) return format.error();
  if (faces != nullptr && format->layout.is_16_bit &&
      mesh.positions.size() > size_t{std::numeric_limits<uint16_t>::max()} + 1)
    return bad_input("layout: 16 bits are too few for the indices of " +
                     std::to_string(mesh.positions.size()) + " vertices; use 32");
  const auto vertices_to = format->vertices(static_cast<std::byte*>(vertices));
  for (size_t v = 0; vertices != nullptr && v < mesh.positions.size(); ++v) {
    const Vec3& p = mesh.positions[v];
    if (format->layout.is_float) {
      vertices_to.set<float>(v, {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
    } else {
      vertices_to.set<double>(v, {p.x, p.y, p.z});
    }
  }
  const auto faces_to = format->faces(static_cast<std::byte*>(faces));
  for (size_t f = 0; faces != nullptr && f < mesh.triangles.size(); ++f) {
    const auto& [a, b, c] = mesh.triangles[f];
    if (format->layout.is_16_bit) {
      faces_to.set<uint16_t>(f,
                             {static_cast<uint16_t>(a), static_cast<uint16_t>(b), static_cast<uint16_t>(c)});
    } else {
      faces_to.set<uint32_t>(f, {a, b, c});
    }
  }
  return Done{};
}

Result<MeshFormat> format_named(const char* name) {
  if (const auto format = mesh_format(name)) return *format;
  return bad_input("format: \"" + std::string(name) + "\" is unknown; use " + list_mesh_endings(""));
}

Result<std::unique_ptr<kerf_mesh>> decode(std::string_view bytes, const char* format,
                                          const Progress& progress) {
  if (format != nullptr) {
    if (const auto known = format_named(format); !known) return known.error();
  }
  auto soup = decode_mesh(bytes, "bytes", format == nullptr ? "" : format, &progress);
  if (!soup) return soup.error();
  return mesh_of_soup(std::move(*soup), "bytes");
}

Status hand_over(Result<std::unique_ptr<kerf_mesh>> mesh, kerf_mesh** out) {
  if (!mesh) return mesh.error();
  *out = mesh->release();
  return Done{};
}

}  // namespace
}  // namespace kerf

kerf_result kerf_mesh_create_from(const void* vertices, size_t vertex_count, const void* faces,
                                  size_t face_count, const kerf_layout* layout, kerf_mesh** out) {
  if (out == nullptr) return kerf::set_error(KERF_INVALID_ARGUMENT, "out: must not be null");
  return kerf::Call(nullptr).run([&](const kerf::Progress&) {
    return kerf::hand_over(kerf::create_mesh(vertices, vertex_count, faces, face_count, layout), out);
  });
}

kerf_result kerf_mesh_create(const double* vertices, size_t vertex_count, const uint32_t* faces,
                             size_t face_count, kerf_mesh** out) {
  return kerf_mesh_create_from(vertices, vertex_count, faces, face_count, nullptr, out);
}

kerf_result kerf_mesh_copy_to(const kerf_mesh* mesh, const kerf_layout* layout, void* vertices, void* faces) {
  if (mesh == nullptr) return kerf::set_error(KERF_INVALID_ARGUMENT, "mesh: must not be null");
  return kerf::Call(nullptr).run(
      [&](const kerf::Progress&) { return kerf::copy_mesh(*mesh, layout, vertices, faces); });
}

kerf_result kerf_mesh_decode(const void* bytes, size_t byte_count, const char* format,
                             const kerf_call_options* options, kerf_mesh** out) {
  if (bytes == nullptr || out == nullptr)
    return kerf::set_error(KERF_INVALID_ARGUMENT, "bytes and out: must not be null");
  return kerf::Call(options).run([&](const kerf::Progress& progress) {
    return kerf::hand_over(kerf::decode({static_cast<const char*>(bytes), byte_count}, format, progress),
                           out);
  });
}

kerf_result kerf_mesh_encode(const kerf_mesh* mesh, const char* format, char** bytes, size_t* byte_count) {
  if (mesh == nullptr || format == nullptr || bytes == nullptr || byte_count == nullptr)
    return kerf::set_error(KERF_INVALID_ARGUMENT, "mesh, format, bytes and byte_count: must not be null");
  return kerf::Call(nullptr).run([&](const kerf::Progress&) -> kerf::Status {
    const auto known = kerf::format_named(format);
    if (!known) return known.error();
    const auto encoded = kerf::encode_mesh(kerf::view_of(*mesh), *known);
    if (!encoded) return encoded.error();
    *bytes = kerf::copy_of(*encoded);
    *byte_count = encoded->size();
    return kerf::Done{};
  });
}

size_t kerf_mesh_warning_count(const kerf_mesh* mesh) { return mesh == nullptr ? 0 : mesh->warnings.size(); }

const char* kerf_mesh_warning(const kerf_mesh* mesh, size_t warning) {
  return warning < kerf_mesh_warning_count(mesh) ? mesh->warnings[warning].c_str() : nullptr;
}
