#include "ui/editor/editor_report.h"

#include <nlohmann/json.hpp>

#include "core/base/assert.h"
#include "core/base/atomic_file.h"
#include "core/document/hash_text.h"
#include "core/document/json_value.h"
#include "core/world/state_hash.h"
#include "ui/editor/tools/light_handle.h"
#include "ui/editor/view/piece_set.h"
#include "ui/editor/view/settings.h"
#include "ui/render/view_switches.h"

namespace kerf {

namespace {

nlohmann::ordered_json view_of(const ViewState& view) {
  nlohmann::ordered_json all;
  for (const ViewSwitch& s : view_switches()) {
    const size_t state = s.get(view.look);
    KERF_ASSERT(state < s.states.size());
    all[s.report] = s.is_two_state() ? nlohmann::ordered_json(state == 1) : s.states[state];
  }
  all["section_plane"] = nullptr;
  if (const SectionPlane* plane = shown_section(view.look)) all["section_plane"] = section_text(*plane);
  all["boxes_deepest"] = view.look.tree.deepest;
  all["boxes_leaves_only"] = view.look.tree.leaves_only;
  const Vec3 eye = view.seen().near().eye;
  all["eye"] = {eye.x, eye.y, eye.z};
  all["orthographic"] = view.camera.parallel();
  all["frame"] = frame_to_json(view.frame);
  return all;
}

nlohmann::ordered_json graph_of(const GraphState& graph, const ViewState& view) {
  return {{"nodes", graph.drawn() ? graph.drawn()->nodes.size() : 0},
          {"marked", graph.marked()},
          {"reached", graph.reached()},
          {"total", graph.total()},
          {"removed", graph.removed()},
          {"removals", graph.removals()},
          {"closings", graph.closings().size()},
          {"loops", graph.drawn() ? graph.drawn()->loops.size() : 0},
          {"of_piece", graph.shows_piece()},
          {"any_open", graph.any_open()},
          {"face_lit", view.look.lit_face.has_value()}};
}

nlohmann::ordered_json stages_of(const StageState& stages) {
  const QueryWalk& query = stages.log.query();
  return {{"on", stages.wishes.on},
          {"playing", stages.wishes.playing},
          {"done", stages.log.done()},
          {"told", stages.log.told()},
          {"query", {{"drawn", query.drawn}, {"visited", query.visited()}, {"boxes", query.size()}}}};
}

// Where each light is, and its handle in the window where that is shown.
nlohmann::ordered_json lights_of(const ViewState& view, const Settings& settings) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (size_t i = 0; i < view.look.lights.size(); ++i) {
    const Vec3& at = view.look.lights[i].at;
    nlohmann::ordered_json light{{"at", {at.x, at.y, at.z}}};
    const auto handle = light_handle(view, i);
    if (handle && shows_light_handles(settings)) light["handle"] = {handle->x, handle->y};
    all.push_back(light);
  }
  return all;
}

nlohmann::ordered_json path_of(const PathWork& path) {
  nlohmann::ordered_json targets = nlohmann::ordered_json::array();
  for (size_t i = 0; i < path.strokes().size(); ++i) {
    for (size_t k = 0; k < path.strokes()[i].keys.size(); ++k)
      targets.push_back(vector_json(path.target({i, k})));
  }
  return {{"strokes", path.strokes().size()},
          {"targets", targets},
          {"speed", path.speed()},
          {"unsaved", path.is_unsaved()}};
}

nlohmann::ordered_json emitter_of(const Emitter& emitter) {
  return {{"placed", emitter.placed()},
          {"at", vector_json(emitter.at())},
          {"target", vector_json(emitter.target())},
          {"firing", emitter.firing},
          {"in_shots", emitter.in_shots},
          {"pace", emitter.pace.per_second()}};
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

nlohmann::ordered_json layout_of(const Layout& l) {
  const auto area = [](const Area& a) { return nlohmann::ordered_json{a.at.x, a.at.y, a.size.x, a.size.y}; };
  return {{"viewport", area(l.viewport)},
          {"first", area(l.first)},
          {"second", area(l.second)},
          {"side", area(l.side)},
          {"status", area(l.status)}};
}

// Not those of which all faces were cut away.
std::vector<BodyId> bodies_with_faces(const World& world) {
  std::vector<BodyId> ids = world.ids();
  std::erase_if(ids, [&](BodyId id) { return world.body(id).mesh.live_faces() == 0; });
  return ids;
}

nlohmann::ordered_json placements_of(const World& world) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const BodyId id : bodies_with_faces(world)) {
    const auto& [at, turned] = world.body(id).placement;
    all.push_back({{"name", world.body(id).own_name()},
                   {"pinned", world.body(id).pinned},
                   {"position", {at.x, at.y, at.z}},
                   {"orientation", {turned.w, turned.x, turned.y, turned.z}}});
  }
  return all;
}

nlohmann::ordered_json times_of(const FrameStatistics& frames) {
  return {{"p50", frames.percentile(0.5)}, {"p99", frames.percentile(0.99)}, {"max", frames.longest()}};
}

nlohmann::ordered_json times_of_cutting(const Figures& figures) {
  return {{"frames", figures.cutting_frames.frames()},
          {"frame_ms", times_of(figures.cutting_frames)},
          {"between_pictures_ms", times_of(figures.between_cutting_pictures)},
          {"each_frame_ms", figures.cutting_frames.each()},
          {"each_between_pictures_ms", figures.between_cutting_pictures.each()}};
}

nlohmann::ordered_json time_of(const EditorState& state) {
  const World& world = state.work.document.world();
  return {{"ticks", world.clock()},
          {"playing", state.play.playing},
          {"speed", state.play.speed().of_real_time},
          {"gravity", vector_json(world.surroundings().gravity)},
          {"ground", world.surroundings().ground ? nlohmann::ordered_json(*world.surroundings().ground)
                                                 : nlohmann::ordered_json(nullptr)}};
}

nlohmann::ordered_json heat_of(const World& world) {
  double hottest = kAmbient;
  for (const BodyId id : world.ids()) {
    const Body& body = world.body(id);
    body.mesh.columns().for_each_set(body.heat.energy, [&](FaceId f) {
      const Sheet& sheet = body.sheet;
      hottest = std::max(hottest, body.heat.temperature(body.mesh, f, sheet.substance, sheet.thickness));
    });
  }
  return {{"hottest", hottest}, {"emitted", world.energy().emitted}, {"absorbed", world.energy().absorbed}};
}

nlohmann::ordered_json texts_of(const std::deque<Message::Said>& log) {
  nlohmann::ordered_json texts = nlohmann::ordered_json::array();
  for (const Message::Said& said : log) texts.push_back(said.text);
  return texts;
}

// Null where nothing is cut.
nlohmann::ordered_json last_stroke_of(const Document& document) {
  const auto last = document.history().last_cut();
  if (!last) return nullptr;
  const HistoryStep& step = document.history().step(*last);
  return {{"radius", document.stroke_settings().laser.radius},
          {"faces_made", step.figures().faces_made},
          {"faces_removed", step.removed_faces()},
          {"removed_area", step.removed_area()}};
}

nlohmann::ordered_json names_of(const std::vector<std::filesystem::path>& files) {
  nlohmann::ordered_json names = nlohmann::ordered_json::array();
  for (const std::filesystem::path& file : files) names.push_back(file.filename().string());
  return names;
}

}  // namespace

nlohmann::ordered_json editor_report(const EditorState& state) {
  const Document& document = state.work.document;
  const Figures& figures = state.figures;
  const PieceMap& pieces = state.view.look.pieces;
  return {
      {"frames", figures.frames.frames()},
      {"frame_ms", times_of(figures.frames)},
      {"between_pictures_ms", times_of(figures.between_pictures)},
      {"while_cutting", times_of_cutting(figures)},
      {"process_bytes", process_bytes()},
      {"memory_bytes", memory_of(figures.shown.memory)},
      {"strokes", document.strokes()},
      {"waiting", document.waiting()},
      {"state_hash", hash_text(state_hash(document.world()))},
      {"faces", document.world().live_faces()},
      {"faces_removed", document.removed_faces()},
      {"removed_area", document.removed_area()},
      {"last_stroke", last_stroke_of(document)},
      {"pieces", document.world().live_pieces()},
      {"undo_depth", document.history().position()},
      {"recuts", figures.recuts},
      {"pieces_chosen", chosen_pieces(pieces)},
      {"pieces_hidden", hidden_pieces(pieces).size()},
      {"spread", state.view.spread},
      {"bodies", bodies_with_faces(document.world()).size()},
      {"placements", placements_of(document.world())},
      {"files", names_of(state.work.files)},
      {"message", state.message.text},
      {"messages", texts_of(state.message.log)},
      {"view", view_of(state.view)},
      {"graph", graph_of(state.graph, state.view)},
      {"path", path_of(state.lasers.path)},
      {"emitter", emitter_of(state.lasers.emitter)},
      {"stages", stages_of(state.stages)},
      {"time", time_of(state)},
      {"heat", heat_of(document.world())},
      {"lights", lights_of(state.view, state.settings)},
      {"pixels_that_rays_have_otherwise",
       figures.shadows.wrong ? nlohmann::ordered_json(*figures.shadows.wrong) : nlohmann::ordered_json()},
      {"split", {{"shown", state.split.shown}, {"faces", state.split.twin.world().live_faces()}}},
      {"layout", layout_of(state.view.layout)},
  };
}

Status write_editor_report(const EditorState& state, const std::filesystem::path& file) {
  return write_file_atomically(
      file,
      editor_report(state).dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
}

}  // namespace kerf
