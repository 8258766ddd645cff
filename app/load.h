#pragma once

#include "app/progress_line.h"
#include "core/document/journal/opened_file.h"
#include "core/mesh/build_mesh.h"

namespace kerf {

// Loads a file by `load`, showing a ProgressLine. Fails with the error of `load`, or with stopped() after
// Ctrl-C.
template <typename Loaded>
Result<Loaded> load_showing_progress(const std::filesystem::path& file,
                                     Result<Loaded> (*load)(const std::filesystem::path&, const Progress*)) {
  ProgressLine line("loading " + file.filename().string());
  const Progress progress = line.progress();
  Result<Loaded> loaded = load(file, &progress);
  if (!loaded) return error_or_stopped(loaded.error());
  return loaded;
}

// Reads a mesh file and builds its mesh, showing a ProgressLine. Fails with an error that names the file, or
// with stopped() after Ctrl-C.
Result<BuiltMesh> load_mesh(const std::filesystem::path& file);

// Opens any file that Kerf reads, showing a ProgressLine, and warns of a damaged journal. Fails like
// load_mesh.
Result<OpenedFile> load_file(const std::filesystem::path& file);

}  // namespace kerf
