#pragma once

#include <chrono>
#include <string>

#include "core/base/parallel.h"
#include "core/base/result.h"
#include "core/document/input_files.h"
#include "core/document/journal.h"
#include "core/mesh/build_mesh.h"

namespace kerf {

// Flushes standard output. Fails if it cannot be written.
Status flush_output();

// Prints a warning as one line on standard error.
void warn(const std::string& warning);

// Prints the notes about a mesh file, i.e. what was dropped and what is unusual, one line each on standard
// error.
void tell(const MeshReport& report);

// What shells add to the number of a signal that ended a program: 130 for Ctrl-C, 143 for SIGTERM.
inline constexpr int kSignalStatus = 128;

// From this call on Ctrl-C and SIGTERM set a flag instead of ending the program. Long computations check the
// flag and stop.
void catch_interrupts();
// Whether the flag is set.
bool interrupted();
// The exit status of a program that such a signal ended, 130 or 143; 0 where the flag is not set.
int interrupt_status();
// From this call on both signals end the program at once with that status, for work that does not check the
// flag.
void let_interrupts_end();

// Shows the progress of a long computation and lets Ctrl-C stop it (see catch_interrupts). It is one line on
// standard error, "kerf: cutting 42 %", that is overwritten at most ten times a second and erased by the
// destructor. Nothing is shown if standard error is not a terminal.
class ProgressLine {
 public:
  // `work` is what the line says: "cutting".
  explicit ProgressLine(std::string work);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  // Shows a fraction from 0 to 1. Returns whether to go on, i.e. false after Ctrl-C.
  bool update(double fraction);
  // Makes a Progress that calls update(). It must not outlive this object.
  Progress progress() {
    return {[this](double fraction) { return update(fraction); }};
  }

 private:
  std::string work_;
  bool terminal_;
  bool shown_ = false;
  std::chrono::steady_clock::time_point next_;
};

// The error that is reported after Ctrl-C, in place of the one that stopping caused.
Error stopped();
// stopped() after Ctrl-C, else `error`.
Error error_or_stopped(const Error& error);

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
