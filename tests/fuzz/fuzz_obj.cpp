#include "core/mesh/files/mtl_file.h"
#include "core/mesh/files/readers.h"
#include "tests/fuzz/reader_check.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {  // NOLINT: libFuzzer's name
  (void)kerf::parse_mtl({reinterpret_cast<const char*>(data), size});
  kerf::fuzz::check_reader(kerf::read_obj, kerf::MeshFormat::kObj, data, size);
  return 0;
}
