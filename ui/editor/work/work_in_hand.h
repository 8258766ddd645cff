#pragma once

#include <filesystem>
#include <vector>

#include "core/document/journal.h"
#include "core/document/scene.h"

namespace kerf {

// What is known of the open work besides its document: where it came from, and how much of it is saved.
struct WorkInHand {
  SceneDescription scene;      // as it was opened
  std::filesystem::path file;  // the journal that Save writes to; empty: none yet
  std::vector<StateMark> marks;
  size_t saved_commands = 0;        // of the document's journal; kNothing: not even as it was opened
  std::vector<Light> saved_lights;  // that are in the file

  static constexpr size_t kNothing = static_cast<size_t>(-1);
};

}  // namespace kerf
