#include "ui/editor/editor_report.h"

#include <nlohmann/json.hpp>

#include "core/base/atomic_file.h"
#include "ui/editor/tools/light_handle.h"
#include "ui/editor/tools/piece_set.h"

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
          {"shadows", look.show.shadows},
          {"silhouette", look.show.silhouette},
          {"shadow_volumes", look.show.shadow_volumes},
          {"shadow_counts", look.show.shadow_stencil},
          {"shadow_facing", look.show.shadow_facing},
          {"shadow_compare", look.show.shadow_compare},
          {"shadow_rays", look.show.shadow_reference},
          {"eye", {state.view().eye.x, state.view().eye.y, state.view().eye.z}}};
}

// Where each light is, and its handle in the window where that is shown.
nlohmann::ordered_json lights_of(const EditorState& state) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (size_t i = 0; i < state.look.lights.size(); ++i) {
    const Vec3& at = state.look.lights[i].at;
    nlohmann::ordered_json light{{"at", {at.x, at.y, at.z}}};
    if (const auto handle = light_handle(state, i)) light["handle"] = {handle->x, handle->y};
    all.push_back(light);
  }
  return all;
}

nlohmann::ordered_json memory_of(const MemoryFigures& memory) {
  return {{"meshes", memory.meshes},
          {"trees", memory.trees},
          {"shading", memory.pictures.shading},
          {"shadows", memory.pictures.shadows},
          {"graphics", memory.pictures.graphics},
          {"history", memory.history},
          {"process", process_bytes()}};
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

nlohmann::ordered_json times_of(const FrameStatistics& frames) {
  return {{"p50", frames.percentile(0.5)}, {"p99", frames.percentile(0.99)}, {"max", frames.longest()}};
}

}  // namespace

Status write_editor_report(const EditorState& state, const std::filesystem::path& file) {
  const FrameStatistics& frames = state.frames;
  nlohmann::ordered_json names = nlohmann::ordered_json::array();
  for (const std::filesystem::path& name : state.files) names.push_back(name.filename().string());
  const nlohmann::ordered_json report{
      {"frames", frames.frames()},
      {"frame_ms", times_of(frames)},
      {"between_pictures_ms", times_of(state.between_pictures)},
      {"while_cutting",
       {{"frames", state.cutting_frames.frames()},
        {"frame_ms", times_of(state.cutting_frames)},
        {"between_pictures_ms", times_of(state.between_cutting_pictures)},
        {"each_frame_ms", state.cutting_frames.each()},
        {"each_between_pictures_ms", state.between_cutting_pictures.each()}}},
      {"process_bytes", process_bytes()},
      {"memory_bytes", memory_of(state.shown.memory)},
      {"strokes", state.document.strokes()},
      {"faces", state.document.world().live_faces()},
      {"faces_removed", state.document.removed_faces()},
      {"pieces", state.document.world().live_pieces()},
      {"undo_depth", state.document.history().position()},
      {"recuts", state.recuts},
      {"pieces_chosen", chosen_pieces(state.look.pieces)},
      {"pieces_hidden", hidden_pieces(state.look.pieces).size()},
      {"spread", state.spread},
      {"bodies", state.document.world().ids().size()},
      {"files", names},
      {"message", state.message},
      {"view", view_of(state)},
      {"lights", lights_of(state)},
      {"pixels_that_rays_have_otherwise", state.shadow_figures.wrong},
      {"split", {{"shown", state.split.shown}, {"faces", state.split.twin.world().live_faces()}}},
      {"layout", layout_of(state)},
  };
  return write_file_atomically(
      file, report.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
}

}  // namespace kerf
