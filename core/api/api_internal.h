#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/parallel.h"
#include "core/base/result.h"
#include "core/document/cut_report.h"
#include "core/document/document.h"
#include "core/document/scene.h"
#include "core/kerf_c.h"
#include "core/mesh/files/soup.h"

namespace kerf {

// How a function of the library runs: with the floating-point modes that Kerf computes with and as many
// threads as the caller allows, and without letting an exception out. The message of what fails is kept for
// kerf_message().
class Call {
 public:
  // `control` may be null.
  explicit Call(const kerf_control* control);

  // Returns the result of the work: that of its status, or of what it throws.
  kerf_result run(const std::function<Status(const Progress&)>& work);

 private:
  kerf_control control_{};
  bool stopped_ = false;
};

// Keeps the message of an error for this thread, and returns its code.
kerf_result told(kerf_result result, const char* message) noexcept;

// The message that was kept last in this thread.
const char* last_message();

}  // namespace kerf

// A mesh as outsiders see it: flat arrays.
struct kerf_mesh {
  std::vector<kerf::Vec3> positions;
  std::vector<std::array<uint32_t, 3>> triangles;
  std::vector<kerf::VertexColour> colours;  // one per position, or empty
  std::vector<uint16_t> materials;          // one per triangle, or empty
  std::vector<std::string> material_names;
  std::vector<double> temperatures;  // K, one per triangle of a piece; empty for any other mesh
  std::string name;
  kerf_mesh_info info{};         // but for its name
  std::optional<double> volume;  // of a piece that is closed, m^3
};

namespace kerf {

// Fills what follows from the arrays: area, centroid, and the identity as the placement.
void measure(kerf_mesh& mesh);

// The mesh as the content of a file.
Soup soup_of(const kerf_mesh& mesh);

// What the journal of a world begins with: the bodies of the scene that was opened, and behind them those
// that were added, as they were then. A world that is changed in a way that its journal cannot tell, after it
// was cut, has none any more.
class Beginning {
 public:
  void open(SceneDescription scene) { scene_ = std::move(scene); }
  void add(const kerf_mesh& mesh, const std::string& name) { added_.push_back({mesh, name}); }
  // The bodies have another material from now on.
  void set_substance(const Substance& substance);
  // The world is not what the journal leads to any more.
  void lose() { lost_ = true; }

  // Writes the journal of the document, and beside it the meshes that were added. Bad input where there is no
  // journal; fails if a file cannot be written.
  Status save(const Document& document, const std::filesystem::path& file) const;

 private:
  struct Added {
    kerf_mesh mesh;
    std::string name;
  };

  SceneDescription scene_;
  std::vector<Added> added_;
  Sheet sheet_;  // of those that were added
  bool lost_ = false;
};

// The calls that use a world at the moment: one that changes it, or any number that read it.
class WorldUsers {
 public:
  // Whether the call may go on. Each that may calls end_reading() or end_changing() when it is done.
  bool begin_reading();
  bool begin_changing();
  void end_reading() { users_.fetch_sub(1, std::memory_order_release); }
  void end_changing() { users_.store(0, std::memory_order_release); }

 private:
  static constexpr int kChanging = -1;

  std::atomic<int> users_{0};  // the number of readers, or kChanging
};

}  // namespace kerf

// A world as outsiders see it: a document that keeps no history between cuts.
struct kerf_world {
  kerf::Document document;
  kerf::Beginning beginning;
  kerf::CutJob job;                           // what the library has cut, for the report
  nlohmann::ordered_json settings = nullptr;  // of the first cut
  // Of all meshes as they were added, which defaults of strokes follow from; cuts do not change them.
  std::optional<kerf::World::Bounds> bounds;
  mutable kerf::WorldUsers users;
};

namespace kerf {

// Runs work that reads a world. Returns the result of Call::run(), or KERF_BUSY if another call changes it.
kerf_result read_world(const kerf_world* world, const kerf_control* control,
                       const std::function<Status(const Document&, const Progress&)>& work);

// Runs work that changes a world. Returns the result of Call::run(), or KERF_BUSY if another call uses it.
kerf_result change_world(kerf_world* world, const kerf_control* control,
                         const std::function<Status(const Progress&)>& work);

}  // namespace kerf
