#include "ui/editor/editor_report.h"

#include <nlohmann/json.hpp>

#include "core/base/atomic_file.h"

namespace kerf {

Status write_editor_report(const EditorState& state, const std::filesystem::path& file) {
  const FrameStatistics& frames = state.frames;
  const nlohmann::ordered_json report{
      {"frames", frames.frames()},
      {"frame_ms",
       {{"p50", frames.percentile(0.5)}, {"p99", frames.percentile(0.99)}, {"max", frames.longest()}}},
      {"strokes", state.document.strokes()},
      {"faces", state.document.world().live_faces()},
      {"faces_removed", state.removed_faces},
      {"pieces", state.document.world().live_pieces()},
      {"undo_depth", 0},
  };
  return write_file_atomically(file, report.dump(2) + "\n");
}

}  // namespace kerf
