#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/document/files/input_files.h"
#include "core/document/files/scene.h"
#include "core/document/history/document.h"
#include "core/document/journal/journal.h"

namespace kerf {

// What is open: its document, where that came from, and how much of it is saved.
struct OpenWork {
  Document document;
  std::vector<std::filesystem::path> files;  // that the document was read from
  std::optional<World> as_loaded;            // a copy, where the world is not too large for one
  std::map<std::string, Paint> paints;

  SceneDescription scene;      // as it was opened
  std::filesystem::path file;  // the journal that Save writes to; empty: none yet
  std::vector<StateMark> marks;
  size_t saved_commands = 0;        // of the document's journal; kNothing: not even as it was opened
  std::vector<Light> saved_lights;  // that are in the file
  std::string saved_head = "{}";    // SceneDescription::others that is in the file

  static constexpr size_t kNothing = static_cast<size_t>(-1);
};

// The files that the document was read from, and its meshes.
inline InputFiles inputs_of(const OpenWork& work) {
  InputFiles inputs = input_files(work.files);
  inputs.add_meshes(work.scene);
  inputs.add_meshes(work.document.journal());
  return inputs;
}

}  // namespace kerf
