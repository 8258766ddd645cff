#include "app/console.h"

#include <unistd.h>
#include <algorithm>
#include <cmath>
#include <csignal>
#include <iostream>

#include "app/standard_streams.h"
#include "core/mesh/mesh_file.h"

namespace kerf {

Status flush_output() {
  return std::cout.flush() ? Status(Done{}) : failed("cannot write to standard output");
}

namespace {

bool quiet = false;

}  // namespace

void set_quiet() { quiet = true; }

void summarize(const std::string& outcome) {
  if (!quiet) std::cerr << "kerf: " << outcome << '\n';
}

void warn(const std::string& warning) {
  std::cerr << "kerf: warning: " << with_stream_names(warning) << '\n';
}

void print_repairs(const MeshReport& report) {
  for (const std::string& warning : report.warnings) warn(warning);
  for (const std::string& note : dropped_notes(report.repairs)) std::cerr << "kerf: note: " << note << '\n';
}

namespace {

constexpr std::chrono::milliseconds kBetweenUpdates{100};
// Shorter work shows nothing.
constexpr std::chrono::milliseconds kBeforeFirst{200};
constexpr const char* kClearLine = "\r\x1b[K";
constexpr size_t kMaxWork = 60;  // a wrapped line could not be overwritten

volatile std::sig_atomic_t interrupt_seen = 0;

}  // namespace

void catch_interrupts() {
  const auto remember = [](int signal) { interrupt_seen = signal; };
  std::signal(SIGINT, remember);
  std::signal(SIGTERM, remember);
}

void end_on_interrupt() {
  const auto end = [](int signal) { ::_exit(kSignalStatus + signal); };
  std::signal(SIGINT, end);
  std::signal(SIGTERM, end);
}

bool interrupted() { return interrupt_seen != 0; }

int interrupt_status() { return interrupted() ? kSignalStatus + interrupt_seen : 0; }

ProgressLine::ProgressLine(std::string work)
    : work_(std::move(work)),
      terminal_(!quiet && ::isatty(STDERR_FILENO) == 1),
      next_(std::chrono::steady_clock::now() + kBeforeFirst) {
  work_ = with_stream_names(std::move(work_));
  if (work_.size() > kMaxWork) work_ = work_.substr(0, kMaxWork - 3) + "...";
}

ProgressLine::~ProgressLine() {
  if (shown_) std::cerr << kClearLine << std::flush;
}

bool ProgressLine::update(double fraction) {
  if (interrupted()) return false;
  if (!terminal_) return true;
  const auto now = std::chrono::steady_clock::now();
  if (now < next_) return true;
  next_ = now + kBetweenUpdates;
  shown_ = true;
  const int percent = static_cast<int>(std::floor(100 * std::clamp(fraction, 0.0, 1.0)));
  std::cerr << kClearLine << "kerf: " << work_ << ' ' << percent << " %" << std::flush;
  return true;
}

Error stopped() { return failed("interrupted"); }

Error error_or_stopped(const Error& error) { return interrupted() ? stopped() : error; }

Result<BuiltMesh> load_mesh(const std::filesystem::path& file) {
  return load_showing_progress<BuiltMesh>(file, load_mesh);
}

Result<BuiltMesh> load_mesh_with_corners(const std::filesystem::path& file) {
  return load_showing_progress<BuiltMesh>(file, load_mesh_with_corners);
}

Result<OpenedFile> load_file(const std::filesystem::path& file) {
  auto opened = load_showing_progress<OpenedFile>(file, open_file);
  if (opened && !opened->journal.damage.empty()) warn(opened->journal.damage);
  return opened;
}

InputFiles inputs_of(const std::filesystem::path& file, const OpenedFile& opened) {
  InputFiles inputs;
  inputs.add(file);
  inputs.add_meshes(opened.scene);
  inputs.add_meshes(opened.journal.commands);
  return inputs;
}

InputFiles inputs_of(std::span<const std::string> files) {
  InputFiles inputs;
  for (const std::string& file : files) {
    inputs.add(file);
    if (is_journal(file)) {
      const auto journal = read_journal(file);
      if (journal) inputs.add_meshes(journal->scene);
      if (journal) inputs.add_meshes(journal->commands);
    } else if (const auto scene = read_description(file)) {
      inputs.add_meshes(*scene);
    }
  }
  return inputs;
}

Status check_frames(const std::string& option, const std::filesystem::path& folder,
                    const InputFiles& inputs) {
  return inputs.check_folder(option, folder, [](std::string_view name) {
    return name.starts_with("frame-") && name.ends_with(".png");
  });
}

}  // namespace kerf
