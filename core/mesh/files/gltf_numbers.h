#pragma once

#include <cstdint>

namespace kerf {

// The head of a binary glTF file and the kinds of its chunks, as little-endian words.
inline constexpr uint32_t kGlbMagic = 0x46546C67, kGlbVersion = 2, kGlbJson = 0x4E4F534A,
                          kGlbBinary = 0x004E4942;

// The types of the numbers of accessors.
inline constexpr uint64_t kGltfByte = 5121, kGltfShort = 5123, kGltfInt = 5125,
                          kGltfFloat = 5126;  // unsigned, and float

}  // namespace kerf
