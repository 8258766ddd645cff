#include "ui/editor/editor_report.h"

#include <nlohmann/json.hpp>

#include "core/base/atomic_file.h"
#include "ui/editor/piece_set.h"

namespace kerf {

namespace {

nlohmann::ordered_json view_of(const EditorState& state) {
  const ViewOptions& look = state.look;
  return {{"wire", look.show.wire},
          {"boxes", look.show.aabb},
          {"boxes_hit", look.show.aabb_hit || look.tree.hit_only},
          {"boxes_deepest", look.tree.deepest},
          {"boxes_leaves_only", look.tree.leaves_only},
          {"pieces", look.show.pieces},
          {"normals", look.show.normals},
          {"face_numbers", look.show.face_numbers},
          {"two_sided", look.two_sided},
          {"cull_backs", look.cull_backs},
          {"ghost", look.ghost},
          {"eye", {state.view().eye.x, state.view().eye.y, state.view().eye.z}}};
}

nlohmann::ordered_json layout_of(const EditorState& state) {
  const Layout& l = state.layout;
  const auto area = [](const Area& a) { return nlohmann::ordered_json{a.at.x, a.at.y, a.size.x, a.size.y}; };
  return {{"viewport", area(l.viewport)},
          {"first", area(l.first)},
          {"second", area(l.second)},
          {"side", area(l.side)},
          {"status", area(l.status)}};
}

}  // namespace

Status write_editor_report(const EditorState& state, const std::filesystem::path& file) {
  const FrameStatistics& frames = state.frames;
  nlohmann::ordered_json names = nlohmann::ordered_json::array();
  for (const std::filesystem::path& name : state.files) names.push_back(name.filename().string());
  const nlohmann::ordered_json report{
      {"frames", frames.frames()},
      {"frame_ms",
       {{"p50", frames.percentile(0.5)}, {"p99", frames.percentile(0.99)}, {"max", frames.longest()}}},
      {"strokes", state.document.strokes()},
      {"faces", state.document.world().live_faces()},
      {"faces_removed", state.removed_faces},
      {"pieces", state.document.world().live_pieces()},
      {"undo_depth", 0},
      {"recuts", state.recuts},
      {"pieces_chosen", chosen_pieces(state.look.pieces)},
      {"pieces_hidden", hidden_pieces(state.look.pieces)},
      {"spread", state.spread},
      {"bodies", state.document.world().ids().size()},
      {"files", names},
      {"message", state.message},
      {"view", view_of(state)},
      {"split", {{"shown", state.split.shown}, {"faces", state.split.twin.world().live_faces()}}},
      {"layout", layout_of(state)},
  };
  return write_file_atomically(
      file, report.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
}

}  // namespace kerf
