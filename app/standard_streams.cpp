#include "app/standard_streams.h"

#include <sys/mman.h>
#include <unistd.h>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iostream>

#include "app/console.h"

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

}  // namespace kerf
