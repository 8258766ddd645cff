#include "app/console.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>
#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iostream>
#include <tuple>

#include "core/mesh/files/scanner.h"
#include "core/mesh/mesh_file.h"

namespace kerf {

namespace {

namespace fs = std::filesystem;

// The files that stand for standard input and standard output; empty if there is none.
std::string input_name, output_name;

Status copy_input(int file) {
  std::array<char, 1 << 16> buffer;
  for (;;) {
    const ssize_t count = ::read(STDIN_FILENO, buffer.data(), buffer.size());
    if (count == 0) return Done{};
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return failed("standard input: reading failed: " + std::string(std::strerror(errno)));
    for (ssize_t done = 0; done < count;) {
      const ssize_t written = ::write(file, buffer.data() + done, static_cast<size_t>(count - done));
      if (written < 0) return failed("standard input: not enough memory to hold it");
      done += written;
    }
  }
}

void replace_all(std::string& text, const std::string& file, const std::string& name) {
  if (file.empty()) return;
  for (size_t at = text.find(file); at != std::string::npos; at = text.find(file, at + name.size()))
    text.replace(at, file.size(), name);
}

bool quiet = false;

constexpr std::chrono::milliseconds kBetweenUpdates{100};
// Shorter work shows nothing.
constexpr std::chrono::milliseconds kBeforeFirst{200};
constexpr const char* kClearLine = "\r\x1b[K";
constexpr size_t kMaxWork = 60;  // a wrapped line could not be overwritten

volatile std::sig_atomic_t interrupt_seen = 0;

}  // namespace

Result<std::string> input_file(const std::string& argument) {
  if (argument != kStream) return argument;
  if (!input_name.empty()) return bad_input("only one input can be \"-\", standard input");
  const int file = ::memfd_create("standard-input", MFD_CLOEXEC);
  if (file < 0) return failed("standard input: not enough memory to hold it");
  if (const Status copied = copy_input(file); !copied) return copied.error();
  input_name = "/proc/self/fd/" + std::to_string(file);
  return input_name;
}

void open_standard_streams() {
  for (const int file : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(file, F_GETFD) < 0)
      std::ignore = ::open("/dev/null", file == STDIN_FILENO ? O_WRONLY : O_RDONLY);
  }
}

std::string with_stream_names(std::string message) {
  replace_all(message, input_name, "standard input");
  replace_all(message, output_name, "standard output");
  return message;
}

Status write_to_output(const std::string& extension,
                       const std::function<Status(const fs::path& file)>& write) {
  std::error_code error;
  std::string folder = (fs::temp_directory_path(error) / "kerf-XXXXXX").string();
  if (error || ::mkdtemp(folder.data()) == nullptr) return failed("cannot create a temporary folder");
  const fs::path file = fs::path(folder) / ("mesh." + extension);
  output_name = file.string();
  const auto copy = [&]() -> Status {
    if (const Status written = write(file); !written) return written;
    std::ifstream stream(file, std::ios::binary);
    std::cout << stream.rdbuf();
    return flush_output();
  };
  const Status copied = copy();
  fs::remove_all(folder, error);
  return copied;
}

Status flush_output() {
  return std::cout.flush() ? Status(Done{}) : failed("cannot write to standard output");
}

void set_quiet() { quiet = true; }

void summarize(const std::string& outcome) {
  if (!quiet) std::cerr << "kerf: " << one_line(outcome) << '\n';
}

void warn(const std::string& warning) {
  std::cerr << "kerf: warning: " << one_line(with_stream_names(warning)) << '\n';
}

void print_repairs(const MeshReport& report) {
  for (const std::string& warning : report.warnings) warn(warning);
  for (const std::string& note : dropped_notes(report.repairs)) std::cerr << "kerf: note: " << note << '\n';
}

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
  work_ = one_line(with_stream_names(std::move(work_)));
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

Result<BuiltMesh> load_mesh(const std::filesystem::path& file, const MeshReading& reading) {
  return load_showing_progress(file, [&](const std::filesystem::path& path, const Progress* progress) {
    return load_mesh(path, progress, reading);
  });
}

Result<OpenedFile> load_file(const std::filesystem::path& file, FileUnit unit) {
  auto opened = load_showing_progress(file, [&](const std::filesystem::path& path, const Progress* progress) {
    return open_file(path, progress, unit);
  });
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
