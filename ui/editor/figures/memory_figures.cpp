#include "ui/editor/figures/memory_figures.h"

#include <algorithm>

#include "ui/editor/editor_state.h"

namespace kerf {

namespace {

void add(const World& world, MemoryFigures& figures) {
  for (const BodyId id : world.ids()) {
    const Body& body = world.body(id);
    figures.trees += body.tree.bytes();
    figures.meshes += body.bytes() - body.tree.bytes();
  }
}

}  // namespace

size_t MemoryFigures::other() const {
  const size_t parts = meshes + trees + pictures.shading + pictures.shadows + pictures.graphics + history;
  return process - std::min(process, parts);
}

MemoryFigures memory_figures(const EditorState& state, const PictureMemory& pictures) {
  MemoryFigures figures;
  figures.process = process_bytes();
  figures.pictures = pictures;
  figures.history = state.document.history().bytes();
  add(state.document.world(), figures);
  add(state.split.twin.world(), figures);
  if (state.as_loaded) add(*state.as_loaded, figures);
  return figures;
}

}  // namespace kerf
