#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/api/change_log.h"
#include "core/base/geometry.h"
#include "core/base/parallel.h"
#include "core/base/result.h"
#include "core/document/cut_report.h"
#include "core/document/document.h"
#include "core/document/scene.h"
#include "core/kerf_c.h"
#include "core/mesh/files/encode.h"
#include "core/mesh/files/soup.h"

namespace kerf {

// Structs of the interface begin with their size (see kerf_c.h).

// Returns an error if the size of a struct is invalid. `name`: of the argument.
template <typename T>
Status check_size(const T& given, const char* name) {
  static_assert(offsetof(T, size) == 0 && sizeof(T) % 8 == 0);
  if (given.size >= 8 && given.size <= sizeof(T) && given.size % 8 == 0) return Done{};
  return bad_input(std::string(name) + ": its size must be sizeof the struct, at most " +
                   std::to_string(sizeof(T)) + " in this version of the library");
}

// Returns the caller's struct, with the defaults for members that it lacks or if `given` is null.
template <typename T>
Result<T> read_struct(const T* given, T defaults, const char* name) {
  if (given == nullptr) return defaults;
  if (const Status valid = check_size(*given, name); !valid) return valid.error();
  std::memcpy(&defaults, given, given->size);
  return defaults;
}

// Writes the members that the caller's struct has. Precondition: its size is valid.
template <typename T>
void write_struct(T value, T& to) {
  value.size = to.size;
  std::memcpy(&to, &value, to.size);
}

// Runs a function of the library with Kerf's floating-point modes and at most as many threads as the caller
// allows. Converts exceptions to results and stores the message of an error for kerf_last_error().
class Call {
 public:
  // `options` may be null.
  explicit Call(const kerf_call_options* options) : options_(options) {}

  // Returns the result of the work: that of its status, or of the exception that it throws.
  kerf_result run(const std::function<Status(const Progress&)>& work);

 private:
  const kerf_call_options* options_;
  bool stopped_ = false;
};

// Stores the message of an error for this thread and returns its code.
kerf_result set_error(kerf_result result, const char* message) noexcept;

// Copies a text, with a terminating zero, for kerf_text_free.
char* copy_of(const std::string& text);

// Returns the last message stored in this thread.
const char* last_message();

}  // namespace kerf

// The mesh of the C interface: flat arrays.
struct kerf_mesh {
  std::vector<kerf::Vec3> positions;
  std::vector<std::array<uint32_t, 3>> triangles;
  std::vector<kerf::VertexColour> colours;  // one per position, or empty
  std::vector<uint16_t> materials;          // one per triangle, or empty
  std::vector<std::string> material_names;
  std::vector<kerf::MeshPart> parts;  // of the triangles
  kerf::CornerLooks looks;            // of the triangles
  std::vector<std::string> attribute_names;
  std::shared_ptr<const kerf::SurfaceLibrary> surfaces;  // describes the materials; null: none
  std::vector<std::string> warnings;                     // of reading
  std::vector<double> temperatures;  // K, one per triangle of a piece; empty for any other mesh
  std::string name;
  kerf_mesh_info info{};  // except for its name
};

namespace kerf {

// Computes the values that follow from the arrays, area and centroid, and sets the placement to the identity.
void measure(kerf_mesh& mesh);

// Sets the looks of a mesh and the names of its attributes.
void set_looks(kerf_mesh& mesh, CornerLooks looks, std::shared_ptr<const SurfaceLibrary> surfaces);

// Converts the usable triangles of a file, over its welded positions. `name`: begins messages.
Result<std::unique_ptr<kerf_mesh>> mesh_of_soup(Soup soup, const std::string& name);

// Returns the mesh as it is written; the view refers to it.
MeshView view_of(const kerf_mesh& mesh);

// Returns the mesh in the form of a file's content.
Soup soup_of(const kerf_mesh& mesh);

// A body that was added from memory.
struct AddedBody {
  std::shared_ptr<const kerf_mesh> mesh;
  std::string name;
  Placement placement;
  Sheet sheet;
  bool solid = false, hidden = false, pinned = false;
  uint32_t slot = 0;  // of the body in its world

  Result<Body> create(const Progress* progress) const;
};

// The bodies added to a world, by the index of their command in its journal.
using AddedBodies = std::map<size_t, AddedBody>;

// Writes the journal of a world: the commands that were not undone, and next to it a mesh file per body added
// from memory. Returns a bad-input error if the world has no body; fails if a file cannot be written.
Status save_journal_of(const kerf_world& world, const std::filesystem::path& file);

// The calls that use a world: one that changes it, or any number that read it.
class WorldUsers {
 public:
  // Returns true if the call may proceed; it must then call end_reading() or end_changing() when done.
  bool begin_reading();
  bool begin_changing();
  void end_reading() { users_.fetch_sub(1, std::memory_order_release); }
  void end_changing() { users_.store(0, std::memory_order_release); }

 private:
  static constexpr int kChanging = -1;

  std::atomic<int> users_{0};  // the number of readers, or kChanging
};

}  // namespace kerf

namespace kerf {

// The energy and depth of the thermal cuts of a world at a moment.
class ThermalTotals {
 public:
  explicit ThermalTotals(const kerf_world& world);

  // Sets `emitted`, `absorbed` and `depth` to the values of the cuts since then.
  template <typename T>
  void set(const kerf_world& world, T& to) const {
    const ThermalTotals now(world);
    to.emitted = now.emitted_ - emitted_;
    to.absorbed = now.absorbed_ - absorbed_;
    to.depth = now.met_s_ > met_s_ ? (now.depth_s_ - depth_s_) / (now.met_s_ - met_s_) : 0;
  }

 private:
  double emitted_, absorbed_, met_s_, depth_s_;
};

// A stroke that is cut in steps.
struct RunningStroke {
  StrokePath last;    // its last key
  double begin_time;  // of its first key [s]
  CutJob before;      // the job of the world before the stroke
  nlohmann::ordered_json settings_before;
  size_t position, window;  // of the history before the stroke
  ThermalTotals thermal;    // before the stroke
  bool ended = false;
};

}  // namespace kerf

// The world of the C interface.
struct kerf_world {
  static constexpr size_t kUndoMemory = size_t{256} << 20;

  kerf_world() {
    document.set_window(kUndoMemory);
    keep();
  }

  // Adds a new body to the bounds and to the report.
  void record_loaded(const kerf::Body& body, const kerf::Placement& placement);

  // What follows from the steps of the history besides the document.
  struct Kept {
    kerf::CutJob job;  // without durations, missed strokes and cuts of scrap
    nlohmann::ordered_json settings;
    std::optional<kerf::World::Bounds> bounds;
    double time_left;
  };
  // Keeps the values at the present position of the history, for undo and redo.
  void keep();
  void restore();

  kerf::Document document;
  kerf::SceneDescription scene;  // that was opened; empty for a new world
  kerf::AddedBodies added;
  double time_left = 0;                       // of a tick, not simulated yet [s]
  kerf::CutJob job;                           // cuts of the library, for the report
  std::vector<size_t> undone_missed;          // those of undone strokes
  std::vector<kerf::ScrapCut> undone_scrap;   // likewise
  nlohmann::ordered_json settings = nullptr;  // of the first cut
  std::vector<std::optional<Kept>> kept;      // by position of the history
  // Bounds of all meshes as they were added, independent of cuts; the defaults of strokes follow from them.
  std::optional<kerf::World::Bounds> bounds;
  std::optional<kerf::RunningStroke> stroke;
  kerf::ChangeLog changes;
  mutable kerf::WorldUsers users;
};

namespace kerf {

// Runs work that reads a world. Returns the result of Call::run(), or KERF_BUSY if another call changes it.
kerf_result read_world(const kerf_world* world, const kerf_call_options* options,
                       const std::function<Status(const Document&, const Progress&)>& work);

// Runs work that changes a world. Returns the result of Call::run(), or KERF_BUSY if another call or a stroke
// uses it.
kerf_result change_world(kerf_world* world, const kerf_call_options* options,
                         const std::function<Status(const Progress&)>& work);

// Likewise, but also while a stroke uses it.
kerf_result use_exclusively(kerf_world* world, const kerf_call_options* options,
                            const std::function<Status(const Progress&)>& work);

// Likewise for work on a stroke that is cut in steps; fails if there is none.
kerf_result change_stroke(kerf_world* world, const std::function<Status(RunningStroke&)>& work);

inline bool is_finite(const Vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

// Returns the first number of an array of vectors; null if it is empty.
inline const double* numbers_of(const std::vector<Vec3>& vectors) {
  static_assert(sizeof(Vec3) == 3 * sizeof(double));
  return vectors.empty() ? nullptr : &vectors.front().x;
}

// Convert the id of a body to and from the C interface.
inline kerf_body to_api(BodyId id) { return uint64_t{id.generation} << 32 | id.slot; }
inline BodyId from_api(kerf_body body) {
  return {static_cast<uint32_t>(body), static_cast<uint32_t>(body >> 32)};
}

// Returns a body, or an error if there is none.
Result<const Body*> body_of(const World& world, kerf_body body);

// Returns the unit normal of a triangle; zero if it has no area.
Vec3 unit_normal(const Triangle& t);

// Internal functions of cuts.

// Applies a command that executes immediately, and records its changes. Returns these.
Result<Delta> apply_edit(kerf_world& world, const Command& command, const Progress& progress);

// Returns a piece as a mesh in world coordinates. Precondition: it has these faces.
std::unique_ptr<kerf_mesh> mesh_of_piece(const Body& body, std::span<const FaceId> faces);

// Returns the pieces of all bodies, largest area first.
Result<std::vector<std::unique_ptr<kerf_mesh>>> pieces_of(const World& world, const Progress& progress);

// Returns a material of the table, or an error that lists their names.
Result<Substance> substance_named(const std::string& name);

// Appends a key to a path. `where`: begins the message of an error.
Status add_key(const kerf_keyframe& key, const std::string& where, StrokePath& path);

// A stroke of the caller as commands.
struct StrokeCommands {
  StrokePath path;
  std::vector<Command> commands;
};

// Converts strokes to commands, or returns an error for an invalid one.
Result<std::vector<StrokeCommands>> stroke_commands_of(const kerf_world& world, const kerf_stroke* strokes,
                                                       size_t count, const kerf_cut_settings& settings);

// Returns the defaults, or an error for invalid settings.
Result<kerf_cut_settings> read_settings(const kerf_cut_settings* given);

// Records the begin of a cut in the job of the world, and the first settings.
void begin_job(kerf_world& world, const Command& first);

}  // namespace kerf
