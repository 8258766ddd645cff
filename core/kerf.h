#ifndef KERF_KERF_H
#define KERF_KERF_H

// Kerf as a C++ library: kerf_c.h with RAII types and exceptions. See there for units, frames and threads:
// const functions of a World read it, the others need exclusive access. A failed call throws an Error and
// changes nothing. Client code compiles this header itself, so it does not depend on Kerf's compiler options.

#include <algorithm>
#include <array>
#include <cstdint>
#include <exception>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "kerf_c.h"

namespace kerf {
inline namespace api {

// Base of all errors; what() says what failed, where, and what to do.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};
// An invalid argument or file.
class InvalidArgument : public Error {
 public:
  using Error::Error;
};
// A call that its progress callback cancelled.
class Cancelled : public Error {
 public:
  using Error::Error;
};
// A call on a world that another call uses.
class Busy : public Error {
 public:
  using Error::Error;
};

// Throws the exception that corresponds to a failed result, with the message of kerf_last_error(). No-op for
// KERF_OK.
inline void check(kerf_result result) {
  if (result == KERF_OK) return;
  if (result == KERF_BUSY) throw Busy(kerf_last_error());
  if (result == KERF_INVALID_ARGUMENT) throw InvalidArgument(kerf_last_error());
  if (result == KERF_CANCELLED) throw Cancelled(kerf_last_error());
  throw Error(kerf_last_error());
}

// Options of a call.
struct CallOptions {
  // Receives the completed part of the work, 0 to 1; returns false to cancel. May throw; the call rethrows.
  std::function<bool(double fraction)> progress;
  unsigned threads = 0;  // maximum number of threads, 0 to 1024; 0: one per processor
};

// Internal: calls a function of kerf_c.h with CallOptions.
class Run {
 public:
  explicit Run(const CallOptions& options) : options_(options) {}

  template <typename F>
  void call(F function) {
    kerf_call_options c{nullptr, this, options_.threads};
    if (options_.progress) c.progress = &Run::on_progress;
    const kerf_result result = function(&c);
    if (thrown_) std::rethrow_exception(thrown_);
    check(result);
  }

 private:
  static int on_progress(double fraction, void* user) {
    Run& run = *static_cast<Run*>(user);
    try {
      return run.options_.progress(fraction) ? 0 : 1;
    } catch (...) {
      run.thrown_ = std::current_exception();
      return 1;
    }
  }

  const CallOptions& options_;
  std::exception_ptr thrown_;
};

// A triangle mesh, or a piece of one; immutable. Copies share the data.
class Mesh {
 public:
  // Reads a mesh file.
  // path: an OBJ, PLY, STL, OFF, glTF or 3MF file; the content decides the format.
  // Throws InvalidArgument if the file cannot be opened or parsed, or has no usable face. O(file size).
  static Mesh read(const std::string& path, const CallOptions& options = {}) {
    kerf_mesh* mesh = nullptr;
    Run(options).call([&](const kerf_call_options* c) { return kerf_mesh_read(path.c_str(), c, &mesh); });
    return Mesh(mesh);
  }
  // Creates a mesh from arrays, which are copied.
  // vertices: three numbers per position (m), finite.
  // faces: three vertex indices per face.
  // Throws InvalidArgument if an array violates the above. O(n).
  Mesh(std::span<const double> vertices, std::span<const uint32_t> faces) {
    if (vertices.size() % 3 != 0) throw InvalidArgument("vertices: must be three numbers each");
    if (faces.size() % 3 != 0) throw InvalidArgument("faces: must be three indices each");
    kerf_mesh* mesh = nullptr;
    check(kerf_mesh_create(vertices.data(), vertices.size() / 3, faces.data(), faces.size() / 3, &mesh));
    mesh_.reset(mesh, kerf_mesh_destroy);
  }
  // Takes ownership of a kerf_c.h handle.
  explicit Mesh(kerf_mesh* mesh) : mesh_(mesh, kerf_mesh_destroy) {}

  // Writes the mesh to a file atomically: a failed call leaves no partial file.
  // path: its extension decides the format: .obj, .ply, .stl, .off, .glb, .gltf or .3mf.
  // Throws InvalidArgument for another extension, Error if the file cannot be written. O(n).
  void write(const std::string& path) const { check(kerf_mesh_write(get(), path.c_str())); }

  // Return three numbers per vertex (m) and three vertex indices per face. Valid while any copy of the mesh
  // exists. O(1).
  std::span<const double> vertices() const {
    return {kerf_mesh_vertices(get()), 3 * kerf_mesh_vertex_count(get())};
  }
  std::span<const uint32_t> faces() const {
    return {kerf_mesh_faces(get()), 3 * kerf_mesh_face_count(get())};
  }

  // Returns the temperature of each face (K) of a piece; empty for any other mesh. O(1).
  std::span<const double> face_temperatures() const {
    const double* first = kerf_mesh_face_temperatures(get());
    return {first, first == nullptr ? 0 : kerf_mesh_face_count(get())};
  }

  // Values at the corners of the faces; see kerf_mesh_attribute_count.
  struct Attribute {
    std::string name;
    size_t size = 0;            // numbers per corner
    std::vector<float> values;  // 3 * size numbers per face; NaN if it has none
  };
  // Returns copies of all attributes. O(n).
  std::vector<Attribute> attributes() const {
    std::vector<Attribute> all(kerf_mesh_attribute_count(get()));
    for (size_t i = 0; i < all.size(); ++i) {
      all[i].name = kerf_mesh_attribute_name(get(), i);
      all[i].size = kerf_mesh_attribute_size(get(), i);
      all[i].values.resize(all[i].size * faces().size());
      check(kerf_mesh_get_attribute(get(), i, all[i].values.data()));
    }
    return all;
  }
  // Returns the index of the material of each face; empty if the mesh has no materials. O(1).
  std::span<const uint16_t> face_materials() const {
    const uint16_t* first = kerf_mesh_face_materials(get());
    return {first, first == nullptr ? 0 : kerf_mesh_face_count(get())};
  }
  // Returns the names of materials by index, some empty.
  std::vector<std::string> material_names() const {
    std::vector<std::string> names;
    for (size_t i = 0; i < kerf_mesh_material_count(get()); ++i)
      names.emplace_back(kerf_mesh_material_name(get(), i));
    return names;
  }

  // Return the properties of the mesh; see kerf_mesh_info. O(1).
  kerf_mesh_info info() const {
    kerf_mesh_info info;
    kerf_mesh_get_info(get(), &info);
    return info;
  }
  std::string name() const { return info().name; }
  double area() const { return info().area; }

  // Returns the kerf_c.h handle; this object keeps ownership.
  const kerf_mesh* get() const { return mesh_.get(); }

 private:
  std::shared_ptr<kerf_mesh> mesh_;
};

using Keyframe = kerf_keyframe;

// A stroke of the laser; see kerf_stroke.
struct Stroke {
  std::vector<Keyframe> keys;         // at least one
  double radius = 0;                  // m; 0: 1/400 of the diagonal of the world
  std::array<double, 2> range{0, 0};  // (min, max) along the beam [m]; both 0: from 0 to ten diagonals
  double power = 0;                   // W, for the thermal model; 0: 2000
};

// Settings of a cut; see kerf_cut_settings.
struct CutSettings {
  kerf_rim rim = KERF_RIM_FACES;
  kerf_scheme scheme = KERF_SCHEME_LONGEST_EDGE;
  kerf_model model = KERF_MODEL_GEOMETRIC;
  std::optional<double> target_edge{};  // longest edge under the beam [m], > 0
  std::optional<double> tolerance{};    // overshoot beyond the beam [m], > 0; excludes target_edge
  std::optional<int> max_level{};       // 0 to 24; excludes both
  std::string material{};               // empty: unchanged
};

using CutResult = kerf_cut_result;

// Crossings of rays.
struct Hits {
  // all_hits(): the crossings of ray i are entries offsets[i] to offsets[i + 1] - 1. nearest_hits(): empty.
  std::vector<size_t> offsets;
  std::vector<double> distances;        // m, infinity on a miss
  std::vector<uint32_t> bodies, faces;  // indices; bodies in the order of adding
};

// The bodies that a laser cuts.
class World {
 public:
  // Creates an empty world. O(1).
  World() {
    kerf_world* world = nullptr;
    check(kerf_world_create(&world));
    world_.reset(world);
  }
  // Creates a world from a file. path: a scene (.json), a journal (.kerf), whose commands are replayed, or a
  // mesh. Throws InvalidArgument for an invalid file. Cost: loading the meshes and replaying the cuts.
  explicit World(const std::string& path, const CallOptions& options = {}) {
    kerf_world* world = nullptr;
    Run(options).call([&](const kerf_call_options* c) { return kerf_world_open(path.c_str(), c, &world); });
    world_.reset(world);
  }

  // Adds a copy of a mesh as a new body, a sheet of mild steel 1 mm thick.
  // name: UTF-8.
  // Throws InvalidArgument if the name is not UTF-8. O(n log n), about 0.5 us per face.
  void add(const Mesh& mesh, const std::string& name = "mesh", const CallOptions& options = {}) {
    Run(options).call(
        [&](const kerf_call_options* c) { return kerf_world_add(get(), mesh.get(), name.c_str(), c); });
  }

  // Cuts all bodies with strokes, in order, all or nothing.
  // Throws InvalidArgument for an invalid stroke or setting, or if the world has no mesh; Error if a body
  // would exceed the maximum number of faces; Cancelled; Busy. About 1 us per created or removed face.
  CutResult cut(std::span<const Stroke> strokes, const CutSettings& settings = {},
                const CallOptions& options = {}) {
    std::vector<kerf_stroke> c_strokes;
    for (const Stroke& s : strokes)
      c_strokes.push_back({s.keys.data(), s.keys.size(), s.radius, {s.range[0], s.range[1]}, s.power});
    kerf_cut_settings c_settings{};
    c_settings.rim = settings.rim;
    c_settings.scheme = settings.scheme;
    c_settings.model = settings.model;
    // An explicit 0 is an error, whereas 0 in kerf_cut_settings means unset.
    if (settings.target_edge)
      c_settings.target_edge = *settings.target_edge == 0 ? -1 : *settings.target_edge;
    if (settings.tolerance) c_settings.tolerance = *settings.tolerance == 0 ? -1 : *settings.tolerance;
    if (settings.max_level)
      c_settings.max_level = *settings.max_level < 0    ? -2
                             : *settings.max_level == 0 ? -1
                                                        : *settings.max_level;
    if (!settings.material.empty()) c_settings.material = settings.material.c_str();
    CutResult result{};
    Run(options).call([&](const kerf_call_options* c) {
      return kerf_world_cut(get(), c_strokes.data(), c_strokes.size(), &c_settings, c, &result);
    });
    return result;
  }
  CutResult cut(const Stroke& stroke, const CutSettings& settings = {}, const CallOptions& options = {}) {
    return cut(std::span(&stroke, 1), settings, options);
  }

  // Returns the pieces of all bodies, largest area first. O(n log n).
  std::vector<Mesh> pieces(const CallOptions& options = {}) const {
    kerf_mesh** list = nullptr;
    size_t count = 0;
    Run(options).call([&](const kerf_call_options* c) { return kerf_world_pieces(get(), c, &list, &count); });
    const auto free_list = [count](kerf_mesh** l) { kerf_pieces_free(l, count); };
    const std::unique_ptr<kerf_mesh*, decltype(free_list)> owner(list, free_list);
    std::vector<Mesh> pieces;
    pieces.reserve(count);
    for (size_t i = 0; i < count; ++i) pieces.emplace_back(std::exchange(list[i], nullptr));
    return pieces;
  }

  // Finds the first surface that each ray crosses.
  // origins, directions: three numbers per ray; finite, directions of any non-zero length.
  // range: minimum and maximum distance (m).
  // Returns one entry per ray. Throws InvalidArgument if an argument violates the above. About 0.3 us per
  // ray.
  Hits nearest_hits(std::span<const double> origins, std::span<const double> directions,
                    std::array<double, 2> range = {0, std::numeric_limits<double>::max()},
                    const CallOptions& options = {}) const {
    const size_t n = ray_count(origins, directions);
    Hits hits{{}, std::vector<double>(n), std::vector<uint32_t>(n), std::vector<uint32_t>(n)};
    Run(options).call([&](const kerf_call_options* c) {
      return kerf_world_nearest_hits(get(), origins.data(), directions.data(), n, range.data(), c,
                                     hits.distances.data(), hits.bodies.data(), hits.faces.data());
    });
    return hits;
  }
  // Finds all surfaces that each ray crosses, nearest first. Arguments, errors and cost per crossing are
  // those of nearest_hits().
  Hits all_hits(std::span<const double> origins, std::span<const double> directions,
                std::array<double, 2> range = {0, std::numeric_limits<double>::max()},
                const CallOptions& options = {}) const {
    const size_t n = ray_count(origins, directions);
    kerf_hits found{};
    Run(options).call([&](const kerf_call_options* c) {
      return kerf_world_all_hits(get(), origins.data(), directions.data(), n, range.data(), c, &found);
    });
    const std::unique_ptr<kerf_hits, void (*)(kerf_hits*)> owner(&found, kerf_hits_free);
    return {{found.offsets, found.offsets + n + 1},
            {found.distances, found.distances + found.count},
            {found.bodies, found.bodies + found.count},
            {found.faces, found.faces + found.count}};
  }

  // Writes the bodies as OBJ files and a scene.json for the editor.
  // folder: created if missing.
  // Throws InvalidArgument if the world has no face, Error if a file cannot be written. O(n log n).
  void save_scene(const std::string& folder) const { check(kerf_world_save_scene(get(), folder.c_str())); }

  // Writes the journal of the cuts, which `kerf replay` verifies, and the added meshes next to it.
  // path: a .kerf file.
  // Throws InvalidArgument if the world has no mesh, or a body was added or the material changed after a cut;
  // Error if a file cannot be written. O(n log n).
  void save_journal(const std::string& path) const { check(kerf_world_save_journal(get(), path.c_str())); }

  // Returns a report of all cuts as JSON, with the keys of report.json of `kerf cut`. O(n log n).
  std::string report(const CallOptions& options = {}) const {
    char* text = nullptr;
    Run(options).call([&](const kerf_call_options* c) { return kerf_world_report(get(), c, &text); });
    const std::unique_ptr<char, void (*)(char*)> owner(text, kerf_text_free);
    return text;
  }

  // Returns 16 hexadecimal digits, equal to those of `kerf cut` for the same meshes and strokes. O(n).
  std::string hash() const {
    char text[17];
    check(kerf_world_hash(get(), text));
    return text;
  }

  // Returns the component graph of the faces as JSON, as written by `kerf inspect --graph`. O(n).
  std::string graph() const {
    char* text = nullptr;
    check(kerf_world_graph(get(), &text));
    const std::unique_ptr<char, void (*)(char*)> owner(text, kerf_text_free);
    return text;
  }

  // Returns the kerf_c.h handle; this object keeps ownership.
  kerf_world* get() const { return world_.get(); }

 private:
  struct Destroy {
    void operator()(kerf_world* world) const { kerf_world_destroy(world); }
  };

  static size_t ray_count(std::span<const double> origins, std::span<const double> directions) {
    if (origins.size() % 3 != 0 || origins.size() != directions.size())
      throw InvalidArgument("origins and directions: must have the same length, three numbers per ray");
    return origins.size() / 3;
  }

  std::unique_ptr<kerf_world, Destroy> world_;
};

}  // namespace api
}  // namespace kerf

#endif
