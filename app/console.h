#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <string>

#include "core/base/parallel.h"
#include "core/base/result.h"
#include "core/document/journal.h"
#include "core/document/save.h"
#include "core/mesh/mesh_file.h"

namespace kerf {

// The name that stands for standard input or standard output on the command line.
inline constexpr const char* kStream = "-";

// Returns the file to read for an argument: the argument itself or, for "-", a file in memory with all of
// standard input, which exists until the program ends. Fails if standard input was read before or cannot be
// read. Call it before catch_interrupts(), because a signal does not end the wait for input.
Result<std::string> input_file(const std::string& argument);

// Opens closed standard streams, so that no other file gets their numbers and the messages of the program.
// Reading from them and writing to them still fails. Call it before any file is opened.
void open_standard_streams();

// Returns a message with "standard input" and "standard output" in place of the files that stand for them.
std::string with_stream_names(std::string message);

// Calls `write` with a file of this extension in a temporary folder, and copies the file to standard output.
Status write_to_output(const std::string& extension,
                       const std::function<Status(const std::filesystem::path& file)>& write);

// Flushes standard output. Fails if it cannot be written.
Status flush_output();

// Omits progress and summaries from now on (--quiet). Warnings and notes are still printed.
void set_quiet();
// Prints the outcome of a command as one line on standard error.
void summarize(const std::string& outcome);

// Prints a warning as one line on standard error.
void warn(const std::string& warning);

// Prints warnings and notes on dropped elements of a mesh file, one line each on standard error.
void print_repairs(const MeshReport& report);

// Added to the number of the signal that ended the program, as in shells: 130 for Ctrl-C, 143 for SIGTERM.
inline constexpr int kSignalStatus = 128;

// Makes Ctrl-C and SIGTERM set a flag instead of ending the program. Long computations check it and stop.
void catch_interrupts();
// Returns true if the flag is set.
bool interrupted();
// Returns the exit status for the signal, 130 or 143; 0 if the flag is not set.
int interrupt_status();
// Makes both signals end the program at once with that status, for work that does not check the flag.
void end_on_interrupt();

// Shows the progress of a long computation and lets Ctrl-C stop it (see catch_interrupts): one line on
// standard error, "kerf: cutting 42 %", overwritten at most ten times a second and erased by the destructor.
// Shows nothing if standard error is not a terminal.
class ProgressLine {
 public:
  // `work` is the text of the line: "cutting".
  explicit ProgressLine(std::string work);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  // Shows a fraction from 0 to 1. Returns false after Ctrl-C.
  bool update(double fraction);
  // Returns a Progress that calls update(). It must not outlive this object.
  Progress progress() {
    return {[this](double fraction) { return update(fraction); }};
  }

 private:
  std::string work_;
  bool terminal_;
  bool shown_ = false;
  std::chrono::steady_clock::time_point next_;
};

// Returns the error to report after Ctrl-C.
Error stopped();
// Returns stopped() after Ctrl-C, else `error`.
Error error_or_stopped(const Error& error);

// Loads a file by `load`, showing a ProgressLine. Fails with the error of `load`, or with stopped() after
// Ctrl-C.
template <typename Load>
auto load_showing_progress(const std::filesystem::path& file, const Load& load) {
  ProgressLine line("loading " + file.filename().string());
  const Progress progress = line.progress();
  auto loaded = load(file, &progress);
  if (!loaded) loaded = error_or_stopped(loaded.error());
  return loaded;
}

// Reads a mesh file and builds its mesh, showing a ProgressLine. Fails with an error that names the file, or
// with stopped() after Ctrl-C.
Result<BuiltMesh> load_mesh(const std::filesystem::path& file, const MeshReading& reading = {});

// Opens any file that Kerf reads, showing a ProgressLine, and warns of a damaged journal. `unit`: see
// open_file. Fails like load_mesh.
Result<OpenedFile> load_file(const std::filesystem::path& file, FileUnit unit);

// Returns the files that were read for an opened one: itself and its meshes.
InputFiles inputs_of(const std::filesystem::path& file, const OpenedFile& opened);
// Returns the files that opening these will read, as far as their own text names them.
InputFiles inputs_of(std::span<const std::string> files);

// Fails with bad input if a frame that a film would write to the folder is an input.
Status check_frames(const std::string& option, const std::filesystem::path& folder, const InputFiles& inputs);

}  // namespace kerf
