#pragma once

#include <cstddef>
#include <span>

#include "core/world/world.h"
#include "ui/render/picture_memory.h"

namespace kerf {

// Where the memory of the process goes, bytes.
struct MemoryFigures {
  size_t process = 0;
  size_t meshes = 0, trees = 0;  // of all worlds that are held
  PictureMemory pictures;
  size_t history = 0;  // before-images

  // The process less all of its parts: the program itself, drivers, and what they keep for pictures. Too
  // little by `graphics` where the card has memory of its own.
  size_t other() const;
};

// The figures as they are, of these worlds (null: none) and a history that holds so many bytes.
// O(bodies).
MemoryFigures memory_figures(std::span<const World* const> worlds, size_t history,
                             const PictureMemory& pictures);

}  // namespace kerf
