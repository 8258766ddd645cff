#pragma once

#include <string>

namespace kerf {

// The kind of machine on which bodies move to the same bits: its processor, C library and solver, and the
// revision of Kerf's own part, such as "x86_64 glibc-2.36 bullet-3.24 motion-2". The solver uses functions of
// the C library whose last bits differ between kinds.
std::string machine_kind();

}  // namespace kerf
