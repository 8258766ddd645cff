#include <unistd.h>

#include <filesystem>
#include <string>

#include "tests/fuzz/library/session.h"

namespace kerf::fuzz {
namespace {

namespace fs = std::filesystem;

// A folder of this process, on a disk of memory where there is one, which the session works in.
class Folder {
 public:
  Folder() {
    const fs::path memory = "/dev/shm";
    const fs::path base = fs::is_directory(memory) ? memory : fs::temp_directory_path();
    path_ = base / ("kerf-fuzz-library-" + std::to_string(::getpid()));
  }
  ~Folder() { fs::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  const fs::path& emptied() const {
    fs::remove_all(path_);
    fs::create_directories(path_);
    return path_;
  }

 private:
  fs::path path_;
};

}  // namespace
}  // namespace kerf::fuzz

// Calls functions of kerf_c.h in the order and with the arguments that the bytes say.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {  // NOLINT: libFuzzer's name
  static const kerf::fuzz::Folder folder;
  kerf::fuzz::ByteSource bytes(data, size);
  kerf::fuzz::Session session(bytes, folder.emptied());
  while (!bytes.empty()) session.act();
  return 0;
}
