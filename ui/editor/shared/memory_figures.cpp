#include "ui/editor/shared/memory_figures.h"

#include <algorithm>

#include "ui/editor/shared/step_chart.h"

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

MemoryFigures memory_figures(std::span<const World* const> worlds, size_t history,
                             const PictureMemory& pictures) {
  MemoryFigures figures;
  figures.process = process_bytes();
  figures.pictures = pictures;
  figures.history = history;
  for (const World* world : worlds) {
    if (world != nullptr) add(*world, figures);
  }
  return figures;
}

}  // namespace kerf
