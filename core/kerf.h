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
// A call on a world that another call or a stroke in steps uses.
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
    kerf_call_options c = KERF_CALL_OPTIONS_INIT;
    c.user = this;
    c.threads = options_.threads;
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
  // path: an OBJ, PLY, STL, OFF, glTF, 3MF or Kerf (.kmesh) file; the content decides the format.
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
  // Creates a mesh from the result of bytes(). Throws InvalidArgument for other or damaged bytes. O(n).
  static Mesh from_bytes(std::string_view bytes) {
    kerf_mesh* mesh = nullptr;
    check(kerf_mesh_from_bytes(bytes.data(), bytes.size(), &mesh));
    return Mesh(mesh);
  }
  // Creates a mesh from buffers of any layout, which are copied; see kerf_mesh_create_from. Throws
  // InvalidArgument like the constructor. O(n).
  static Mesh from_buffers(const void* vertices, size_t vertex_count, const void* faces, size_t face_count,
                           const kerf_layout& layout = KERF_LAYOUT_INIT) {
    kerf_mesh* mesh = nullptr;
    check(kerf_mesh_create_from(vertices, vertex_count, faces, face_count, &layout, &mesh));
    return Mesh(mesh);
  }
  // Reads the bytes of a mesh file; see kerf_mesh_decode. format: a hint, such as "stl"; empty: none.
  // Throws InvalidArgument if they cannot be parsed, or have no usable face. O(bytes).
  static Mesh decode(std::span<const char> bytes, const std::string& format = {},
                     const CallOptions& options = {}) {
    kerf_mesh* mesh = nullptr;
    const char* hint = format.empty() ? nullptr : format.c_str();
    Run(options).call([&](const kerf_call_options* c) {
      return kerf_mesh_decode(bytes.data(), bytes.size(), hint, c, &mesh);
    });
    return Mesh(mesh);
  }
  // Takes ownership of a kerf_c.h handle.
  explicit Mesh(kerf_mesh* mesh) : mesh_(mesh, kerf_mesh_destroy) {}

  // Writes the mesh to a file atomically: a failed call leaves no partial file.
  // path: its extension decides the format: .obj, .ply, .stl, .off, .glb, .gltf or .3mf.
  // Throws InvalidArgument for another extension, Error if the file cannot be written. O(n).
  void write(const std::string& path) const { check(kerf_mesh_write(get(), path.c_str())); }

  // Returns the mesh with its attributes, materials and images; see kerf_mesh_to_bytes. O(n).
  std::string bytes() const {
    char* bytes = nullptr;
    size_t size = 0;
    check(kerf_mesh_to_bytes(get(), &bytes, &size));
    const std::unique_ptr<char, void (*)(char*)> owner(bytes, kerf_text_free);
    return {bytes, size};
  }
  // Returns the bytes that write() writes. format: an extension without the dot, such as "ply". Throws
  // InvalidArgument for another format, Error if it cannot store the mesh. O(n).
  std::string encode(const std::string& format) const {
    char* bytes = nullptr;
    size_t count = 0;
    check(kerf_mesh_encode(get(), format.c_str(), &bytes, &count));
    const std::unique_ptr<char, void (*)(char*)> owner(bytes, kerf_text_free);
    return {bytes, count};
  }
  // Writes positions and faces to buffers, null to skip one; see kerf_mesh_copy_to. Throws InvalidArgument
  // for a layout that cannot hold them. O(n).
  void copy_to(const kerf_layout& layout, void* vertices, void* faces) const {
    check(kerf_mesh_copy_to(get(), &layout, vertices, faces));
  }
  // Returns the warnings of reading the mesh, such as dropped faces, one sentence each.
  std::vector<std::string> warnings() const {
    std::vector<std::string> warnings;
    for (size_t i = 0; i < kerf_mesh_warning_count(get()); ++i)
      warnings.emplace_back(kerf_mesh_warning(get(), i));
    return warnings;
  }

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

  // A named range of faces; see kerf_mesh_part_count.
  struct Part {
    std::string name;
    size_t first = 0, count = 0;
  };
  // Returns the parts that the file of the mesh names; ranges may overlap.
  std::vector<Part> parts() const {
    std::vector<Part> all(kerf_mesh_part_count(get()));
    for (size_t i = 0; i < all.size(); ++i) {
      const char* name = nullptr;
      check(kerf_mesh_get_part(get(), i, &name, &all[i].first, &all[i].count));
      all[i].name = name;
    }
    return all;
  }

  // Return the properties of the mesh; see kerf_mesh_info. O(1).
  kerf_mesh_info info() const {
    kerf_mesh_info info = KERF_MESH_INFO_INIT;
    check(kerf_mesh_get_info(get(), &info));
    return info;
  }
  std::string name() const { return info().name; }
  double area() const { return info().area; }
  // Returns vertices - edges + faces; see kerf_mesh_euler_number. O(n log n).
  int64_t euler_number() const {
    int64_t number = 0;
    check(kerf_mesh_euler_number(get(), &number));
    return number;
  }

  // Returns the kerf_c.h handle; this object keeps ownership.
  const kerf_mesh* get() const { return mesh_.get(); }

 private:
  std::shared_ptr<kerf_mesh> mesh_;
};

using Keyframe = kerf_keyframe;
using BodyId = kerf_body;

// A stroke of the laser; see kerf_stroke.
struct Stroke {
  std::vector<Keyframe> keys;         // at least one
  double radius = 0;                  // m; 0: 1/400 of the diagonal of the world
  std::array<double, 2> range{0, 0};  // (min, max) along the beam [m]; both 0: from 0 to ten diagonals
  double power = 2000;                // W, for the thermal model, as are the following members
  double wavelength = 0;              // m; 0: that of the usual laser for the material
  std::optional<double> focus{};      // m along the beam to its waist; nullopt: the radius is constant
  double pulse_rate = 0;              // Hz; 0: a continuous beam
  double duty = 1;                    // share of each pulse period with the beam on
  kerf_assist assist = KERF_ASSIST_NONE;
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
  std::vector<BodyId> bodies{};         // the only ones to cut; empty: all visible ones
};

// Internal: convert to structs of kerf_c.h, which refer to the arguments. Throw InvalidArgument for several
// resolutions.
inline kerf_stroke to_c(const Stroke& stroke) {
  kerf_stroke c = KERF_STROKE_INIT;
  c.keys = stroke.keys.data();
  c.key_count = stroke.keys.size();
  c.radius = stroke.radius;
  c.range[0] = stroke.range[0];
  c.range[1] = stroke.range[1];
  c.power = stroke.power;
  c.wavelength = stroke.wavelength;
  if (stroke.focus) c.focus = *stroke.focus;
  c.pulse_rate = stroke.pulse_rate;
  c.duty = stroke.duty;
  c.assist = stroke.assist;
  return c;
}
inline kerf_cut_settings to_c(const CutSettings& settings) {
  if (settings.target_edge.has_value() + settings.tolerance.has_value() + settings.max_level.has_value() > 1)
    throw InvalidArgument("target_edge, tolerance and max_level: set only one of them");
  kerf_cut_settings c = KERF_CUT_SETTINGS_INIT;
  c.rim = settings.rim;
  c.scheme = settings.scheme;
  c.model = settings.model;
  if (settings.target_edge) c.resolution = KERF_RESOLUTION_EDGE, c.target_edge = *settings.target_edge;
  if (settings.tolerance) c.resolution = KERF_RESOLUTION_TOLERANCE, c.tolerance = *settings.tolerance;
  if (settings.max_level) c.resolution = KERF_RESOLUTION_LEVEL, c.max_level = *settings.max_level;
  if (!settings.material.empty()) c.material = settings.material.c_str();
  if (!settings.bodies.empty()) c.bodies = settings.bodies.data();
  c.body_count = settings.bodies.size();
  return c;
}

using CutResult = kerf_cut_result;
using StrokeProgress = kerf_stroke_progress;
using Changes = kerf_changes;

// Properties of a new body; see kerf_body_desc.
struct BodyDesc {
  std::string name = "mesh";                      // UTF-8
  std::array<double, 3> position{0, 0, 0};        // m
  std::array<double, 4> orientation{1, 0, 0, 0};  // unit quaternion w x y z
  std::string material{};                         // a name from `kerf materials`; empty: mild steel
  double thickness = 0.001;                       // m
  double density = 0;                             // kg/m^3; 0: that of the material
  bool is_solid = false, is_hidden = false, is_fixed = false;
};

// Internal: converts to a struct that refers to the argument.
inline kerf_body_desc to_c(const BodyDesc& desc) {
  kerf_body_desc c = KERF_BODY_DESC_INIT;
  c.name = desc.name.c_str();
  std::copy(desc.position.begin(), desc.position.end(), c.position);
  std::copy(desc.orientation.begin(), desc.orientation.end(), c.orientation);
  if (!desc.material.empty()) c.material = desc.material.c_str();
  c.thickness = desc.thickness;
  c.density = desc.density;
  c.is_solid = desc.is_solid;
  c.is_hidden = desc.is_hidden;
  c.is_fixed = desc.is_fixed;
  return c;
}

// Points of surfaces; see kerf_hits. Vectors have three numbers per hit.
struct Hits {
  std::vector<size_t> offsets;  // all_hits(): ray i has entries offsets[i] to offsets[i + 1] - 1; else empty
  std::vector<double> distances;  // m, infinity on a miss
  std::vector<BodyId> bodies;     // KERF_NO_BODY on a miss
  std::vector<uint32_t> faces, pieces;
  std::vector<double> barycentrics, positions, normals;
  std::vector<uint16_t> materials;
  std::vector<uint8_t> is_cut;
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
  // mesh. Throws InvalidArgument for an invalid file; Error; Cancelled. Cost: loading and replaying it.
  explicit World(const std::string& path, const CallOptions& options = {}) {
    kerf_world* world = nullptr;
    Run(options).call([&](const kerf_call_options* c) { return kerf_world_open(path.c_str(), c, &world); });
    world_.reset(world);
  }

  // Adds a copy of a mesh as a new body and returns its id; see kerf_world_add. Throws InvalidArgument for an
  // invalid description. O(n log n), about 0.5 us per face.
  BodyId add(const Mesh& mesh, const BodyDesc& desc, const CallOptions& options = {}) {
    const kerf_body_desc c_desc = to_c(desc);
    BodyId body = KERF_NO_BODY;
    Run(options).call(
        [&](const kerf_call_options* c) { return kerf_world_add(get(), mesh.get(), &c_desc, c, &body); });
    return body;
  }
  // Likewise, as a sheet of mild steel 1 mm thick. name: UTF-8.
  BodyId add(const Mesh& mesh, const std::string& name = "mesh", const CallOptions& options = {}) {
    BodyDesc desc;
    desc.name = name;
    return add(mesh, desc, options);
  }

  // Returns the ids of all bodies, in the order of their creation. O(bodies).
  std::vector<BodyId> bodies() const {
    return list_of<BodyId>(
        [&](BodyId* out, size_t capacity, size_t* n) { return kerf_world_bodies(get(), out, capacity, n); });
  }
  // Returns the properties of a body; see kerf_body_info. Throws InvalidArgument if there is none.
  kerf_body_info info(BodyId body) const {
    kerf_body_info info = KERF_BODY_INFO_INIT;
    check(kerf_body_get_info(get(), body, &info));
    return info;
  }
  // Returns a copy of the name of a body, also for a world that other threads may change. Throws likewise.
  std::string name(BodyId body) const {
    char* text = nullptr;
    check(kerf_body_get_name(get(), body, &text));
    const std::unique_ptr<char, void (*)(char*)> owner(text, kerf_text_free);
    return text;
  }
  // Returns the indices of the faces of a body, ascending. Throws InvalidArgument if there is none. O(faces).
  std::vector<uint32_t> faces(BodyId body) const {
    return list_of<uint32_t>([&](uint32_t* out, size_t capacity, size_t* n) {
      return kerf_body_faces(get(), body, out, capacity, n);
    });
  }
  // Returns nine numbers per face: its corners in the frame of the body [m]. Throws InvalidArgument if there
  // is no such body or face. About 10 ns per face.
  std::vector<double> corners(BodyId body, std::span<const uint32_t> faces) const {
    std::vector<double> corners(9 * faces.size());
    check(kerf_body_get_faces(get(), body, faces.data(), faces.size(), corners.data(), nullptr, nullptr,
                              nullptr));
    return corners;
  }
  // Returns the label of the piece of each face. Errors and cost are those of corners().
  std::vector<uint32_t> piece_labels(BodyId body, std::span<const uint32_t> faces) const {
    std::vector<uint32_t> labels(faces.size());
    check(kerf_body_get_faces(get(), body, faces.data(), faces.size(), nullptr, labels.data(), nullptr,
                              nullptr));
    return labels;
  }
  // Returns a piece as a mesh; see kerf_piece_get_mesh. Throws InvalidArgument if there is none.
  Mesh piece(BodyId body, uint32_t piece) const {
    kerf_mesh* mesh = nullptr;
    check(kerf_piece_get_mesh(get(), body, piece, &mesh));
    return Mesh(mesh);
  }

  // Edits of a piece; see kerf_piece_move. Return the body of the piece after the edit. Throw InvalidArgument
  // if there is no such piece, or for an invalid value.
  BodyId move(BodyId body, uint32_t piece, const std::array<double, 3>& position,
              const std::array<double, 4>& orientation = {1, 0, 0, 0}) {
    return edit([&](BodyId* now) {
      return kerf_piece_move(get(), body, piece, position.data(), orientation.data(), now);
    });
  }
  BodyId set_sheet(BodyId body, uint32_t piece, const std::string& material, double thickness,
                   double density = 0) {
    return edit([&](BodyId* now) {
      const char* name = material.empty() ? nullptr : material.c_str();
      return kerf_piece_set_sheet(get(), body, piece, name, thickness, density, now);
    });
  }
  BodyId set_solid(BodyId body, uint32_t piece, bool is_solid) {
    return edit([&](BodyId* now) { return kerf_piece_set_solid(get(), body, piece, is_solid, now); });
  }
  BodyId set_hidden(BodyId body, uint32_t piece, bool is_hidden) {
    return edit([&](BodyId* now) { return kerf_piece_set_hidden(get(), body, piece, is_hidden, now); });
  }
  BodyId set_fixed(BodyId body, uint32_t piece, bool is_fixed) {
    return edit([&](BodyId* now) { return kerf_piece_set_fixed(get(), body, piece, is_fixed, now); });
  }
  void rename(BodyId body, uint32_t piece, const std::string& name) {
    check(kerf_piece_rename(get(), body, piece, name.c_str()));
  }
  void remove(BodyId body, uint32_t piece) { check(kerf_piece_remove(get(), body, piece)); }

  // Joins two parts of a body; see kerf_body_join. Throws InvalidArgument if they cannot be joined.
  void join(BodyId body, const kerf_joint& joint) { check(kerf_body_join(get(), body, &joint)); }

  // Sets the environment of simulations. gravity: m/s^2. ground: height [m]. Throws InvalidArgument for
  // numbers that are not finite.
  void set_environment(const std::array<double, 3>& gravity, std::optional<double> ground = {}) {
    check(kerf_world_set_environment(get(), gravity.data(), ground ? &*ground : nullptr));
  }
  // Simulates rigid bodies and cooling; see kerf_world_simulate. seconds: 0 to 3600.
  void simulate(double seconds) { check(kerf_world_simulate(get(), seconds, nullptr)); }

  // Undo or redo a step of the history; see kerf_world_undo. Return false if there is none. Throw Error if it
  // is no longer stored.
  bool undo() {
    int done = 0;
    check(kerf_world_undo(get(), &done));
    return done != 0;
  }
  bool redo() {
    int done = 0;
    check(kerf_world_redo(get(), &done));
    return done != 0;
  }
  void set_undo_memory(size_t bytes) { check(kerf_world_set_undo_memory(get(), bytes)); }

  // Returns all changes since the last call; see kerf_changes. Its arrays are valid until the next
  // take_changes(), or until the world is destroyed.
  Changes take_changes() {
    Changes changes = KERF_CHANGES_INIT;
    check(kerf_world_take_changes(get(), &changes));
    return changes;
  }

  // Cuts all visible bodies, or those of the settings, with strokes, in order, all or nothing; see
  // kerf_world_cut. Throws InvalidArgument for an invalid stroke or setting, without a mesh, or for a solid
  // if the rim is not smooth or the model is thermal; Error if a body would exceed the maximum number of
  // faces; Cancelled; Busy. About 1 us per created or removed face.
  CutResult cut(std::span<const Stroke> strokes, const CutSettings& settings = {},
                const CallOptions& options = {}) {
    std::vector<kerf_stroke> c_strokes;
    for (const Stroke& stroke : strokes) c_strokes.push_back(to_c(stroke));
    const kerf_cut_settings c_settings = to_c(settings);
    CutResult result = KERF_CUT_RESULT_INIT;
    Run(options).call([&](const kerf_call_options* c) {
      return kerf_world_cut(get(), c_strokes.data(), c_strokes.size(), &c_settings, c, &result);
    });
    return result;
  }
  CutResult cut(const Stroke& stroke, const CutSettings& settings = {}, const CallOptions& options = {}) {
    return cut(std::span(&stroke, 1), settings, options);
  }

  // Cuts all visible bodies along the plane normal . x = distance by a knife of no width; see
  // kerf_world_cut_plane. Throws InvalidArgument if the normal is zero or a number is not finite; Error;
  // Cancelled; Busy.
  void cut_plane(const std::array<double, 3>& normal, double distance, const CallOptions& options = {}) {
    Run(options).call(
        [&](const kerf_call_options* c) { return kerf_world_cut_plane(get(), normal.data(), distance, c); });
  }

  // A stroke in steps; see kerf_stroke_begin. Throw InvalidArgument for an invalid argument or without a
  // stroke, Busy while another call or stroke uses the world.
  void begin_stroke(const Stroke& stroke, const CutSettings& settings = {}) {
    const kerf_stroke c_stroke = to_c(stroke);
    const kerf_cut_settings c_settings = to_c(settings);
    check(kerf_stroke_begin(get(), &c_stroke, &c_settings));
  }
  void add_pose(const Keyframe& key) { check(kerf_stroke_add_pose(get(), &key)); }
  void end_stroke() { check(kerf_stroke_end(get())); }
  // Executes a part of the stroke, at least one unit of work. max_faces, max_seconds: targets. Throws Error,
  // and cancels the stroke, if a body would exceed the maximum number of faces.
  StrokeProgress step_stroke(size_t max_faces, double max_seconds) {
    StrokeProgress progress = KERF_STROKE_PROGRESS_INIT;
    check(kerf_stroke_step(get(), max_faces, max_seconds, &progress));
    return progress;
  }
  void cancel_stroke() { check(kerf_stroke_cancel(get())); }

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
  // Returns one entry per ray. Throws InvalidArgument if an argument violates the above. O(bodies) per ray.
  Hits nearest_hits(std::span<const double> origins, std::span<const double> directions,
                    std::array<double, 2> range = {0, std::numeric_limits<double>::max()},
                    const CallOptions& options = {}) const {
    const size_t n = ray_count(origins, directions);
    return query(options, [&](const kerf_call_options* c, kerf_hits* out) {
      return kerf_world_nearest_hits(get(), origins.data(), directions.data(), n, range.data(), c, out);
    });
  }
  // Finds all surfaces that each ray crosses, nearest first. Arguments, errors and cost per crossing are
  // those of nearest_hits().
  Hits all_hits(std::span<const double> origins, std::span<const double> directions,
                std::array<double, 2> range = {0, std::numeric_limits<double>::max()},
                const CallOptions& options = {}) const {
    const size_t n = ray_count(origins, directions);
    return query(options, [&](const kerf_call_options* c, kerf_hits* out) {
      return kerf_world_all_hits(get(), origins.data(), directions.data(), n, range.data(), c, out);
    });
  }
  // Finds the point of all surfaces nearest to each point. points: three numbers each; max_distance: m.
  // Returns one entry per point. Throws InvalidArgument if a point is not finite, or if max_distance is
  // negative or NaN. About 2 us per point and body.
  Hits closest_points(std::span<const double> points,
                      double max_distance = std::numeric_limits<double>::infinity(),
                      const CallOptions& options = {}) const {
    if (points.size() % 3 != 0) throw InvalidArgument("points: must be three numbers each");
    const size_t n = points.size() / 3;
    return query(options, [&](const kerf_call_options* c, kerf_hits* out) {
      return kerf_world_closest_points(get(), points.data(), n, max_distance, c, out);
    });
  }

  // Finds the faces that a box meets; see kerf_world_faces_in_box. min, max: corners (m). Throws
  // InvalidArgument for numbers beyond 1e150, or min > max.
  Hits faces_in_box(const std::array<double, 3>& min, const std::array<double, 3>& max,
                    const CallOptions& options = {}) const {
    return query(options, [&](const kerf_call_options* c, kerf_hits* out) {
      return kerf_world_faces_in_box(get(), min.data(), max.data(), c, out);
    });
  }

  // Writes the visible bodies as meshes, and a scene.json for the editor; see kerf_world_save_scene.
  // folder: created if missing.
  // Throws InvalidArgument if no face is visible, Error if a file cannot be written. O(n log n).
  void save_scene(const std::string& folder) const { check(kerf_world_save_scene(get(), folder.c_str())); }

  // Writes the journal of all commands that are not undone, which `kerf replay` verifies, and the added
  // meshes next to it. path: a .kerf file. Throws InvalidArgument if the world has no mesh or was simulated
  // before it had one, or if path names a folder, device or pipe; Error if a file cannot be written.
  // O(n log n).
  void save_journal(const std::string& path) const { check(kerf_world_save_journal(get(), path.c_str())); }

  // Returns a report as JSON, with the keys of report.json of `kerf cut` (see kerf_world_report). O(n log n).
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

  template <typename T, typename F>
  static std::vector<T> list_of(F function) {
    std::vector<T> list;
    for (size_t count = 0;; list.resize(count)) {  // another thread may change the number between two calls
      check(function(list.data(), list.size(), &count));
      if (count == list.size()) return list;
    }
  }

  template <typename F>
  static BodyId edit(F function) {
    BodyId now = KERF_NO_BODY;
    check(function(&now));
    return now;
  }

  // Runs a query and copies its hits.
  template <typename F>
  static Hits query(const CallOptions& options, F function) {
    kerf_hits found = KERF_HITS_INIT;
    const std::unique_ptr<kerf_hits, void (*)(kerf_hits*)> owner(&found, kerf_hits_free);
    Run(options).call([&](const kerf_call_options* c) { return function(c, &found); });
    const size_t n = found.count;
    Hits hits{{},
              {found.distances, found.distances + n},
              {found.bodies, found.bodies + n},
              {found.faces, found.faces + n},
              {found.pieces, found.pieces + n},
              {found.barycentrics, found.barycentrics + 3 * n},
              {found.positions, found.positions + 3 * n},
              {found.normals, found.normals + 3 * n},
              {found.materials, found.materials + n},
              {found.is_cut, found.is_cut + n}};
    if (found.offsets != nullptr) hits.offsets.assign(found.offsets, found.offsets + found.offset_count);
    return hits;
  }

  std::unique_ptr<kerf_world, Destroy> world_;
};

}  // namespace api
}  // namespace kerf

#endif
