#pragma once

#include <cstddef>
#include <cstdint>

namespace kerf::fuzz {

// Numbers from the bytes of an input, which a fuzzer may change one by one. Behind the end all bytes are 0.
class ByteSource {
 public:
  ByteSource(const uint8_t* data, size_t size) : data_(data), end_(data + size) {}

  bool empty() const { return data_ == end_; }
  uint8_t byte() { return empty() ? 0 : *data_++; }
  // A number below n. Precondition: 0 < n <= 256.
  size_t below(size_t n) { return byte() * n / 256; }
  // The same as a factor.
  double factor_below(size_t n) { return static_cast<double>(below(n)); }
  // A number from `low` to `high`, both of which occur.
  double between(double low, double high) { return low + (high - low) * byte() / 255; }

 private:
  const uint8_t* data_;
  const uint8_t* end_;
};

}  // namespace kerf::fuzz
