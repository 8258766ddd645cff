#pragma once

#include "core/document/journal.h"
#include "core/document/scene.h"

namespace kerf {

// What any file that Kerf opens holds: a scene with its meshes loaded and, of a journal, what was done to it.
struct Work {
  Scene scene;
  Journal journal;  // its scene is as the file has it; empty where the file is no journal
};

// Reads a scene (.json), a journal (.kerf) or a mesh.
Result<Work> read_work(const std::filesystem::path& file, const Progress* progress = nullptr);

// Reads a journal whatever its name.
Result<Work> read_journal_work(const std::filesystem::path& file, const Progress* progress = nullptr);

// Whether a file's name says that it is a journal, or the version of one before it was saved last (.kerf~).
bool is_journal(const std::filesystem::path& file);

}  // namespace kerf
