#pragma once

#include <atomic>
#include <functional>
#include <optional>

#include "core/document/files/cut_report.h"
#include "core/document/history/document.h"
#include "core/face/call.h"
#include "core/face/face_journal.h"
#include "core/kerf_c.h"

namespace kerf {

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
