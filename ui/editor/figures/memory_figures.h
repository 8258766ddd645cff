#pragma once

#include <cstddef>

#include "ui/render/picture_memory.h"

namespace kerf {

struct EditorState;

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

// As they are now. O(bodies + steps of the history), and what little grows with what was cut.
MemoryFigures memory_figures(const EditorState& state, const PictureMemory& pictures);

}  // namespace kerf
