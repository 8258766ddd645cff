#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace kerf {

// Arrays in the format .npz of NumPy: a ZIP archive of stored entries, each an array in format 1.0 of .npy.
class NpzFile {
 public:
  // Appends an array, little-endian and in row-major order. Precondition: the shape has as many elements.
  void add(std::string_view name, std::span<const double> values, std::span<const size_t> shape);
  void add(std::string_view name, std::span<const int64_t> values, std::span<const size_t> shape);

  // Returns the bytes of the archive, or fails if they exceed 4 GiB. Must be called once.
  Result<std::string> take();

 private:
  void add_entry(std::string_view name, std::string_view type, std::span<const size_t> shape,
                 std::string_view bytes);

  std::string bytes_, directory_;
  uint16_t entries_ = 0;
};

}  // namespace kerf
