#include "ui/editor/shared/statistics/statistics.h"

#include <algorithm>

#include "core/document/history/specks.h"
#include "core/joints/loaded_part.h"

namespace kerf {

namespace {

// Without parts that no cut separated, which joints hold or held.
void count_pieces(ShownStatistics& shown, const World& world, const std::set<PieceId>& specks) {
  shown.pieces = shown.specks = 0;
  for (const BodyId id : world.ids()) {
    const Body& body = world.body(id);
    for (uint32_t label = 0; label < body.pieces.size(); ++label) {
      if (body.pieces[label].faces == 0 || is_loaded_part(body, label)) continue;
      ++(specks.contains({id, label}) ? shown.specks : shown.pieces);
    }
  }
}

void add(const World& world, MemoryStatistics& statistics) {
  for (const BodyId id : world.ids()) {
    const Body& body = world.body(id);
    statistics.trees += body.tree.bytes();
    statistics.meshes += body.bytes() - body.tree.bytes();
  }
}

}  // namespace

void count_world(ShownStatistics& shown, const Document& document, bool depth_shown) {
  const World& world = document.world();
  shown.faces = world.live_faces();
  count_pieces(shown, world, specks(document));
  shown.tree_nodes = 0;
  shown.tree_depth.reset();
  if (depth_shown) shown.tree_depth = 0;
  for (const BodyId id : world.ids()) {
    const Body& body = world.body(id);
    shown.tree_nodes += body.tree.box_count();
    if (!depth_shown) continue;
    body.tree.for_each_box(body.mesh, [&](const AabbTree::Box& box) {
      shown.tree_depth = std::max(*shown.tree_depth, box.depth);
    });
  }
}

void note_stroke(ShownStatistics& shown, const Document& document) {
  shown.stroke.reset();
  const History& history = document.history();
  if (const auto last = history.last_cut()) {
    const HistoryStep& step = history.step(*last);
    shown.stroke = ShownStatistics::Stroke{step.statistics(), step.removed_area()};
  }
}

size_t MemoryStatistics::other() const {
  const size_t parts = meshes + trees + pictures.shading + pictures.shadows + pictures.graphics + history;
  return process - std::min(process, parts);
}

MemoryStatistics memory_statistics(std::span<const World* const> worlds, size_t history,
                                   const PictureMemory& pictures) {
  MemoryStatistics statistics;
  statistics.process = process_bytes();
  statistics.pictures = pictures;
  statistics.history = history;
  for (const World* world : worlds) {
    if (world != nullptr) add(*world, statistics);
  }
  return statistics;
}

}  // namespace kerf
