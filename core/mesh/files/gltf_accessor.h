#pragma once

#include "core/base/vec3.h"
#include "core/mesh/files/gltf_file.h"
#include "core/mesh/files/vertex_colour.h"

namespace kerf {

// The elements of an accessor of a glTF file: rows of numbers in a buffer.
class GltfAccessor {
 public:
  // Positions: three floats each. Fails for sparse and quantised ones, and where the buffer ends too early.
  static Result<GltfAccessor> positions(const GltfFile& file, uint32_t accessor);
  // Indices: one unsigned whole number each. Fails likewise.
  static Result<GltfAccessor> indices(const GltfFile& file, uint32_t accessor);

  // Colours: three or four floats or normalised whole numbers each. Fails likewise.
  static Result<GltfAccessor> colours(const GltfFile& file, uint32_t accessor);

  size_t size() const { return size_; }
  // Precondition of each: i < size(), and it is an accessor of this kind.
  Vec3 position(size_t i) const;
  VertexColour colour(size_t i) const;  // brought from linear light to sRGB
  uint32_t index(size_t i) const;

 private:
  static Result<GltfAccessor> rows(const GltfFile& file, uint32_t accessor, const char* type, uint64_t row);

  std::string_view bytes_;
  size_t size_ = 0, stride_ = 0, width_ = 0;
  size_t parts_ = 0;  // of a colour
};

}  // namespace kerf
