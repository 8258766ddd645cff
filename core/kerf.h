#ifndef KERF_KERF_H
#define KERF_KERF_H

// Kerf as a C++ library: kerf_c.h with RAII types and exceptions. See there for units, frames, costs and
// threads. Client code compiles this header itself, so it does not depend on Kerf's compiler options.

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

// Base of all errors: a call failed for the reason that what() states. The call has changed nothing.
class Failure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};
// A wrong argument or file.
class BadInput : public Failure {
 public:
  using Failure::Failure;
};
// A call that the caller's progress callback cancelled.
class Cancelled : public Failure {
 public:
  using Failure::Failure;
};
// A call that cannot run while another one uses the world.
class Busy : public Failure {
 public:
  using Failure::Failure;
};

// Throws the exception of a failed result; no-op for KERF_OK.
inline void check(kerf_result result) {
  if (result == KERF_OK) return;
  if (result == KERF_BUSY) throw Busy(kerf_message());
  if (result == KERF_BAD_INPUT) throw BadInput(kerf_message());
  if (result == KERF_CANCELLED) throw Cancelled(kerf_message());
  throw Failure(kerf_message());
}

// Options of a call: a callback that receives the completed share of the work, 0 to 1, and returns true to
// continue; and the maximum number of threads, 0 for one per processor. The call rethrows exceptions of
// `progress`.
struct Control {
  std::function<bool(double share)> progress;
  unsigned threads = 0;
};

// Calls a function of kerf_c.h with a Control.
class Run {
 public:
  explicit Run(const Control& control) : control_(control) {}

  template <typename F>
  void call(F function) {
    kerf_control c{nullptr, this, control_.threads};
    if (control_.progress) c.progress = &Run::ask;
    const kerf_result result = function(&c);
    if (thrown_) std::rethrow_exception(thrown_);
    check(result);
  }

 private:
  static int ask(double share, void* user) {
    Run& run = *static_cast<Run*>(user);
    try {
      return run.control_.progress(share) ? 0 : 1;
    } catch (...) {
      run.thrown_ = std::current_exception();
      return 1;
    }
  }

  const Control& control_;
  std::exception_ptr thrown_;
};

// A triangle mesh, or a piece of one; immutable. Copies share the data.
class Mesh {
 public:
  // Reads a mesh file.
  // path: an OBJ, PLY, STL, OFF or glTF file.
  // Throws BadInput if the file cannot be opened or parsed. O(file size).
  static Mesh read(const std::string& path, const Control& control = {}) {
    kerf_mesh* mesh = nullptr;
    Run(control).call([&](const kerf_control* c) { return kerf_mesh_read(path.c_str(), c, &mesh); });
    return Mesh(mesh);
  }
  // Creates a mesh from arrays, which are copied.
  // vertices: three numbers per position (m), finite.
  // faces: three vertex indices per face.
  // Throws BadInput if an array violates the above. O(n).
  Mesh(std::span<const double> vertices, std::span<const uint32_t> faces) {
    if (vertices.size() % 3 != 0) throw BadInput("vertices: must be three numbers each");
    if (faces.size() % 3 != 0) throw BadInput("faces: must be three indices each");
    kerf_mesh* mesh = nullptr;
    check(kerf_mesh_make(vertices.data(), vertices.size() / 3, faces.data(), faces.size() / 3, &mesh));
    mesh_.reset(mesh, kerf_mesh_free);
  }
  // Takes ownership of a mesh of kerf_c.h.
  explicit Mesh(kerf_mesh* mesh) : mesh_(mesh, kerf_mesh_free) {}

  // Writes the mesh to a file, whole or not at all; the extension of the path decides the format. O(n).
  void write(const std::string& path) const { check(kerf_mesh_write(get(), path.c_str())); }

  // Return three numbers per vertex (m), and three indices per face. Valid as long as any copy of the mesh.
  std::span<const double> vertices() const {
    return {kerf_mesh_vertices(get()), 3 * kerf_mesh_vertex_count(get())};
  }
  std::span<const uint32_t> faces() const {
    return {kerf_mesh_faces(get()), 3 * kerf_mesh_face_count(get())};
  }

  // Returns the temperature of each face (K) of a piece; empty for any other mesh.
  std::span<const double> temperatures() const {
    const double* first = kerf_mesh_temperatures(get());
    return {first, first == nullptr ? 0 : kerf_mesh_face_count(get())};
  }

  // Returns name, area, mass and inertia; see kerf_mesh_info. O(1).
  kerf_mesh_info info() const {
    kerf_mesh_info info;
    kerf_mesh_describe(get(), &info);
    return info;
  }
  std::string name() const { return info().name; }
  double area() const { return info().area; }

  const kerf_mesh* get() const { return mesh_.get(); }

 private:
  std::shared_ptr<kerf_mesh> mesh_;
};

using Key = kerf_key;

// A stroke of the laser; see kerf_stroke for the meaning of 0.
struct Stroke {
  std::vector<Key> keys;
  double radius = 0;
  std::array<double, 2> range{0, 0};
  double power = 0;
};

// Settings of a cut; see kerf_cut_settings.
struct CutSettings {
  kerf_rim rim = KERF_RIM_FACES;
  kerf_scheme scheme = KERF_SCHEME_LONGEST_EDGE;
  kerf_model model = KERF_MODEL_GEOMETRIC;
  std::optional<double> target_edge{}, tolerance{};  // m
  std::optional<int> levels{};
  std::string material{};  // empty: unchanged
};

using CutResult = kerf_cut_result;

// Crossings of rays: those of ray i are entries first[i] to first[i + 1] - 1 of the other arrays.
struct Hits {
  std::vector<size_t> first;
  std::vector<double> distances;
  std::vector<uint32_t> bodies, faces;
};

// The bodies that a laser cuts.
class World {
 public:
  World() {
    kerf_world* world = nullptr;
    check(kerf_world_make(&world));
    world_.reset(world);
  }
  // Opens a file as a world.
  // path: a scene, a journal, whose commands are replayed, or a mesh.
  // Throws BadInput if the file is wrong.
  explicit World(const std::string& path, const Control& control = {}) {
    kerf_world* world = nullptr;
    Run(control).call([&](const kerf_control* c) { return kerf_world_open(path.c_str(), c, &world); });
    world_.reset(world);
  }

  // Adds a copy of a mesh as a new body, a sheet of mild steel 1 mm thick. O(n log n).
  void add(const Mesh& mesh, const std::string& name = "mesh", const Control& control = {}) {
    Run(control).call(
        [&](const kerf_control* c) { return kerf_world_add(get(), mesh.get(), name.c_str(), c); });
  }

  // Cuts all bodies with the strokes, in order, all or nothing. Throws BadInput for a wrong stroke or
  // setting, Cancelled, Busy. About 1 us per created or removed face.
  CutResult cut(std::span<const Stroke> strokes, const CutSettings& settings = {},
                const Control& control = {}) {
    std::vector<kerf_stroke> plain;
    for (const Stroke& s : strokes)
      plain.push_back({s.keys.data(), s.keys.size(), s.radius, {s.range[0], s.range[1]}, s.power});
    kerf_cut_settings how{};
    how.rim = settings.rim;
    how.scheme = settings.scheme;
    how.model = settings.model;
    // An explicit 0 is an error, whereas 0 in kerf_cut_settings means unset.
    if (settings.target_edge) how.target_edge = *settings.target_edge == 0 ? -1 : *settings.target_edge;
    if (settings.tolerance) how.tolerance = *settings.tolerance == 0 ? -1 : *settings.tolerance;
    if (settings.levels)
      how.levels_plus_one = *settings.levels < 0 ? -1 : std::min(*settings.levels, 1000) + 1;
    if (!settings.material.empty()) how.material = settings.material.c_str();
    CutResult result{};
    Run(control).call([&](const kerf_control* c) {
      return kerf_world_cut(get(), plain.data(), plain.size(), &how, c, &result);
    });
    return result;
  }
  CutResult cut(const Stroke& stroke, const CutSettings& settings = {}, const Control& control = {}) {
    return cut(std::span(&stroke, 1), settings, control);
  }

  // Returns the pieces of all bodies, largest area first. O(n log n).
  std::vector<Mesh> pieces(const Control& control = {}) const {
    kerf_mesh** list = nullptr;
    size_t count = 0;
    Run(control).call([&](const kerf_control* c) { return kerf_world_pieces(get(), c, &list, &count); });
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
  // Returns one entry per ray, with a distance of infinity on a miss. Throws BadInput. About 0.3 us per ray.
  Hits nearest_hits(std::span<const double> origins, std::span<const double> directions,
                    std::array<double, 2> range = {0, std::numeric_limits<double>::max()},
                    const Control& control = {}) const {
    const size_t n = rays(origins, directions);
    Hits hits{{}, std::vector<double>(n), std::vector<uint32_t>(n), std::vector<uint32_t>(n)};
    Run(control).call([&](const kerf_control* c) {
      return kerf_world_nearest_hits(get(), origins.data(), directions.data(), n, range.data(), c,
                                     hits.distances.data(), hits.bodies.data(), hits.faces.data());
    });
    return hits;
  }
  // Finds all surfaces that each ray crosses, nearest first; otherwise like nearest_hits().
  Hits all_hits(std::span<const double> origins, std::span<const double> directions,
                std::array<double, 2> range = {0, std::numeric_limits<double>::max()},
                const Control& control = {}) const {
    const size_t n = rays(origins, directions);
    kerf_hits found{};
    Run(control).call([&](const kerf_control* c) {
      return kerf_world_all_hits(get(), origins.data(), directions.data(), n, range.data(), c, &found);
    });
    const std::unique_ptr<kerf_hits, void (*)(kerf_hits*)> owner(&found, kerf_hits_free);
    return {{found.first, found.first + n + 1},
            {found.distances, found.distances + found.count},
            {found.bodies, found.bodies + found.count},
            {found.faces, found.faces + found.count}};
  }

  // Writes the bodies as OBJ files and a scene.json for the editor. Throws Failure if a file cannot be
  // written.
  void save_scene(const std::string& folder) const { check(kerf_world_save_scene(get(), folder.c_str())); }

  // Writes the journal of the cuts, which `kerf replay` verifies, and the added meshes next to it.
  void save_journal(const std::string& path) const { check(kerf_world_save_journal(get(), path.c_str())); }
  // Returns the report of all cuts so far as JSON, with the keys of report.json of `kerf cut`.
  std::string report(const Control& control = {}) const {
    char* text = nullptr;
    Run(control).call([&](const kerf_control* c) { return kerf_world_report(get(), c, &text); });
    const std::unique_ptr<char, void (*)(char*)> owner(text, kerf_text_free);
    return text;
  }

  // Returns 16 hexadecimal digits, equal to those of `kerf cut` for the same meshes and strokes. O(n).
  std::string hash() const {
    char text[17];
    check(kerf_world_hash(get(), text));
    return text;
  }
  // Returns the component graph of the faces as JSON.
  std::string graph() const {
    char* text = nullptr;
    check(kerf_world_graph(get(), &text));
    const std::unique_ptr<char, void (*)(char*)> owner(text, kerf_text_free);
    return text;
  }

  kerf_world* get() const { return world_.get(); }

 private:
  struct Free {
    void operator()(kerf_world* world) const { kerf_world_free(world); }
  };

  static size_t rays(std::span<const double> origins, std::span<const double> directions) {
    if (origins.size() % 3 != 0 || origins.size() != directions.size())
      throw BadInput("origins and directions: must have the same length, three numbers per ray");
    return origins.size() / 3;
  }

  std::unique_ptr<kerf_world, Free> world_;
};

}  // namespace api
}  // namespace kerf

#endif
