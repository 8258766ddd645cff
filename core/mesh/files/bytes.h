#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <string>

namespace kerf {

// Numbers in the bytes of a file.

// Reads a number in the given byte order, aligned or not. Precondition: sizeof(T) bytes are readable there.
template <typename T>
T load(const char* bytes, std::endian order) {
  std::array<char, sizeof(T)> raw;
  std::memcpy(raw.data(), bytes, sizeof(T));
  if (order != std::endian::native) std::reverse(raw.begin(), raw.end());
  return std::bit_cast<T>(raw);
}

// Stores a number in little-endian order; returns its end. Precondition: sizeof(T) bytes are writable there.
template <typename T>
char* store_little(T value, char* to) {
  auto raw = std::bit_cast<std::array<char, sizeof(T)>>(value);
  if (std::endian::native != std::endian::little) std::reverse(raw.begin(), raw.end());
  std::memcpy(to, raw.data(), raw.size());
  return to + raw.size();
}

// Appends the bytes of a number in little-endian order.
template <typename T>
void append_little(T value, std::string& bytes) {
  std::array<char, sizeof(T)> raw;
  store_little(value, raw.data());
  bytes.append(raw.data(), raw.size());
}

}  // namespace kerf
