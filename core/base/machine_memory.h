#pragma once

#include <cstdint>

namespace kerf {

// The memory that this process may use, in bytes: that of the machine, or the smallest of the limits that its
// control group and its resource limits set. Reads a few small files; to be asked once.
uint64_t machine_memory();

}  // namespace kerf
