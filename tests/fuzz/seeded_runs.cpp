#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "core/base/random.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size);  // NOLINT: libFuzzer's name

// seeded_TARGET SEED COUNT BYTES: hands COUNT inputs of up to BYTES random bytes to the fuzz target, the same
// ones for the same seed. The target ends the program where what it checks does not hold; the last number
// printed is that of the input.
int main(int count, char** arguments) {
  if (count != 4) return 2;
  const unsigned long first = std::strtoul(arguments[1], nullptr, 10);
  const unsigned long inputs = std::strtoul(arguments[2], nullptr, 10);
  const unsigned long most = std::strtoul(arguments[3], nullptr, 10);
  for (unsigned long i = 0; i < inputs; ++i) {
    std::printf("seed %lu\n", first + i);
    std::fflush(stdout);
    kerf::Random random(first + i);
    std::vector<uint8_t> bytes(1 + random.below(most));
    for (uint8_t& byte : bytes) byte = static_cast<uint8_t>(random.below(256));
    LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
  }
  return 0;
}
