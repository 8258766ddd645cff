#pragma once

#include "core/document/files/scene.h"
#include "core/document/journal/journal.h"

namespace kerf {

// The content of any file that Kerf opens: a scene with its meshes loaded and, if the file is a journal, the
// commands that were applied to it.
struct OpenedFile {
  Scene scene;
  Journal journal;  // with the scene as the file describes it; empty if the file is no journal
};

// Reads a scene (.json), a journal (.kerf) or a mesh.
Result<OpenedFile> open_file(const std::filesystem::path& file, const Progress* progress = nullptr);

// Reads a journal regardless of the extension of its name.
Result<OpenedFile> open_journal(const std::filesystem::path& file, const Progress* progress = nullptr);

// Whether the extension of a file is that of a journal (.kerf) or of its previous version (.kerf~).
bool is_journal(const std::filesystem::path& file);

}  // namespace kerf
