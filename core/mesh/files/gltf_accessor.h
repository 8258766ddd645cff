#pragma once

// Private to core/mesh/files.
#include "core/base/vec3.h"
#include "core/mesh/files/gltf_file.h"

namespace kerf {

// The elements of an accessor of a glTF file: rows of numbers in a buffer.
class GltfAccessor {
 public:
  // Positions: three floats each. Fails for sparse and quantised ones, and where the buffer ends too early.
  static Result<GltfAccessor> positions(const GltfFile& file, uint32_t accessor);
  // Indices: one unsigned whole number each. Fails likewise.
  static Result<GltfAccessor> indices(const GltfFile& file, uint32_t accessor);

  size_t size() const { return size_; }
  // Precondition: i < size(), and it is one of positions, or of indices.
  Vec3 position(size_t i) const;
  uint32_t index(size_t i) const;

 private:
  static Result<GltfAccessor> rows(const GltfFile& file, uint32_t accessor, const char* type, uint64_t row);

  std::string_view bytes_;
  size_t size_ = 0, stride_ = 0, width_ = 0;
};

}  // namespace kerf
