#include "ui/editor/shell/session_statistics.h"

#include <nlohmann/json.hpp>

#include "core/base/assert.h"
#include "core/document/history/specks.h"
#include "core/document/text/hash_text.h"
#include "core/world/state_hash.h"

namespace kerf {

namespace {

nlohmann::ordered_json memory_of(const MemoryStatistics& memory) {
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
          {"second_side", area(l.second_side)},
          {"strip", area(l.strip)},
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
                   {"solid", world.body(id).solid},
                   {"position", {at.x, at.y, at.z}},
                   {"orientation", {turned.w, turned.x, turned.y, turned.z}}});
  }
  return all;
}

nlohmann::ordered_json times_of(const FrameStatistics& frames) {
  return {{"p50", frames.percentile(0.5)}, {"p99", frames.percentile(0.99)}, {"max", frames.longest()}};
}

nlohmann::ordered_json times_of_cutting(const Statistics& statistics) {
  return {{"frames", statistics.cutting_frames.frames()},
          {"frame_ms", times_of(statistics.cutting_frames)},
          {"between_pictures_ms", times_of(statistics.between_cutting_pictures)},
          {"each_frame_ms", statistics.cutting_frames.each()},
          {"each_between_pictures_ms", statistics.between_cutting_pictures.each()}};
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
  return {{"radius", document.history().last_settings().laser.radius},
          {"faces_made", step.statistics().faces_made},
          {"faces_removed", step.removed_faces()},
          {"removed_area", step.removed_area()}};
}

}  // namespace

nlohmann::ordered_json session_report(const Workspace& on) {
  const Document& document = on.work.document;
  const Statistics& statistics = on.statistics;
  return {
      {"frames", statistics.frames.frames()},
      {"frame_ms", times_of(statistics.frames)},
      {"between_pictures_ms", times_of(statistics.between_pictures)},
      {"while_cutting", times_of_cutting(statistics)},
      {"process_bytes", process_bytes()},
      {"memory_bytes", memory_of(statistics.shown.memory)},
      {"strokes", document.history().strokes()},
      {"waiting", document.waiting()},
      {"state_hash", hash_text(state_hash(document.world()))},
      {"faces", document.world().live_faces()},
      {"faces_removed", document.history().removed_faces()},
      {"removed_area", document.history().removed_area()},
      {"last_stroke", last_stroke_of(document)},
      {"pieces", document.world().live_pieces()},
      {"specks", specks(document).size()},
      {"recuts", statistics.recuts},
      {"bodies", bodies_with_faces(document.world()).size()},
      {"placements", placements_of(document.world())},
      {"message", on.message.text},
      {"messages", texts_of(on.message.log)},
      {"layout", layout_of(on.view.layout)},
  };
}

void bring_up_to_date(Workspace& on) {
  Statistics& statistics = on.statistics;
  ShownStatistics& shown = statistics.shown;
  shown.unit = on.view.frame.unit;
  const World* as_loaded = on.work.as_loaded ? &*on.work.as_loaded : nullptr;
  shown.frame_ms = 1000 * on.picture->seconds();
  shown.memory = memory_statistics(std::array{&on.world(), on.second, as_loaded},
                                   on.work.document.history().bytes(), on.picture->memory());
  const bool depth_missing = statistics.depth_wanted && !shown.tree_depth;
  if (!std::exchange(statistics.world_changed, false) && !depth_missing) return;
  count_world(shown, on.work.document, statistics.depth_wanted);
  note_stroke(shown, on.work.document);
}

}  // namespace kerf
