#pragma once

#include <cstddef>
#include <span>

#include "core/world/world.h"
#include "ui/render/bodies/picture_memory.h"

namespace kerf {

// The memory usage of the process, in bytes.
struct MemoryFigures {
  size_t process = 0;
  size_t meshes = 0, trees = 0;  // of all worlds that are held
  PictureMemory pictures;
  size_t history = 0;  // before-images

  // The memory of the process minus all of these parts: the program itself, drivers and their buffers. It is
  // too small by `graphics` if the graphics card has its own memory.
  size_t other() const;
};

// The current figures, for these worlds (entries may be null) and a history of the given size in bytes.
// O(bodies).
MemoryFigures memory_figures(std::span<const World* const> worlds, size_t history,
                             const PictureMemory& pictures);

}  // namespace kerf
