#include "core/mesh/files/readers.h"
#include "tests/fuzz/reader_check.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {  // NOLINT: libFuzzer's name
  kerf::fuzz::check_reader(kerf::read_3mf, kerf::MeshFormat::k3mf, data, size);
  return 0;
}
