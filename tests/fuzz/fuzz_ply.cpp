#include "core/mesh/files/readers.h"
#include "tests/fuzz/reader_check.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {  // NOLINT: libFuzzer's name
  const auto read = [](std::string_view bytes, const std::string& name, const kerf::Progress* progress) {
    return kerf::read_ply(bytes, name, progress);
  };
  kerf::fuzz::check_reader(read, kerf::MeshFormat::kPly, data, size);
  return 0;
}
