#pragma once

namespace kerf {

// The version of Kerf. CMake reads it from this line.
inline constexpr const char* kVersion = "0.2.0";

}  // namespace kerf
