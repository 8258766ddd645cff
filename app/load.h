#pragma once

#include "app/progress_line.h"
#include "core/document/files/input_files.h"
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

// The files that were read for an opened one: itself and its meshes.
InputFiles inputs_of(const std::filesystem::path& file, const OpenedFile& opened);
// Those that opening the file will read, as far as its own text names them.
InputFiles inputs_of(std::span<const std::string> files);

// Bad input if a frame of a film in a folder (see frame_file) is an input.
Status check_frames(const std::string& option, const std::filesystem::path& folder, const InputFiles& inputs);

}  // namespace kerf
