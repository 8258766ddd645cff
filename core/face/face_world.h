#pragma once

// Private to core/face.
#include <atomic>
#include <functional>
#include <optional>

#include "core/document/files/cut_report.h"
#include "core/document/history/document.h"
#include "core/face/call.h"
#include "core/face/face_journal.h"
#include "core/kerf_c.h"

// A world as outsiders see it: a document that keeps no history between cuts.
struct kerf_world {
  kerf::Document document;
  kerf::Beginning beginning;
  kerf::CutJob job;                           // what the library has cut, for the report
  nlohmann::ordered_json settings = nullptr;  // of the first cut
  std::atomic_flag busy = ATOMIC_FLAG_INIT;
};

namespace kerf {

// Runs work on a world unless another thread does so already, with the result of Call::run().
kerf_result run_on(kerf_world* world, const kerf_control* control,
                   const std::function<Status(Document&, const Progress&)>& work);

}  // namespace kerf
