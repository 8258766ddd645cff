#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "tests/fuzz/library/session.h"

namespace kerf::fuzz {
namespace {

namespace fs = std::filesystem;

// A folder of this process, on a disk of memory where there is one, which the session works in.
const fs::path& folder() {
  static const fs::path made = [] {
    const fs::path memory = "/dev/shm";
    const fs::path base = fs::is_directory(memory) ? memory : fs::temp_directory_path();
    const fs::path own = base / ("kerf-fuzz-library-" + std::to_string(::getpid()));
    std::atexit([] { fs::remove_all(folder()); });
    return own;
  }();
  return made;
}

}  // namespace
}  // namespace kerf::fuzz

// Calls functions of kerf_c.h in the order and with the arguments that the bytes say.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {  // NOLINT: libFuzzer's name
  const std::filesystem::path& folder = kerf::fuzz::folder();
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  kerf::fuzz::ByteSource bytes(data, size);
  kerf::fuzz::Session session(bytes, folder);
  while (!bytes.empty()) session.act();
  return 0;
}
