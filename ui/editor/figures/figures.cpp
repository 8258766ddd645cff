#include "ui/editor/figures/figures.h"

namespace kerf {

void Figures::note_step(const StepResult& step, size_t revision_of_step, size_t faces_before) {
  if (revision != revision_of_step) stroke = {};
  revision = revision_of_step;
  stroke.add(step.figures);
  last_step = step.figures;
  chart.note_step(step);
  faces_before_step = faces_before;
}

void Figures::forget_strokes() {
  last_step = stroke = {};
  faces_before_step = 0;
}

void count_world(ShownFigures& shown, const World& world, bool depth_shown) {
  shown.faces = world.live_faces();
  shown.pieces = world.live_pieces();
  shown.tree_nodes = 0;
  shown.tree_depth = 0;
  for (const BodyId id : world.ids()) {
    const AabbTree& tree = world.body(id).tree;
    shown.tree_nodes += tree.box_count();
    if (!depth_shown) continue;
    tree.for_each_box(
        [&](const AabbTree::Box& box) { shown.tree_depth = std::max(shown.tree_depth, box.depth); });
  }
}

}  // namespace kerf
