#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec4.hpp>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "core/mesh/files/surface_look.h"
#include "ui/gl/buffers.h"
#include "ui/gl/program.h"

namespace kerf {

// The materials of a mesh file on the GPU, with their images in two arrays of layers of equal size: colours,
// which the sampler converts to linear light, and data such as normals. A thread decodes the images; until
// they are uploaded, materials have their factors only. An image that is missing or damaged is a
// checkerboard.
class SurfaceTextures {
 public:
  // Maximum memory of all layers. If the images need more, all are scaled down.
  static constexpr size_t kMaxBytes = size_t{1} << 30;

  // Begins to decode the images.
  explicit SurfaceTextures(std::shared_ptr<const SurfaceLibrary> library);
  ~SurfaceTextures();
  SurfaceTextures(const SurfaceTextures&) = delete;
  SurfaceTextures& operator=(const SurfaceTextures&) = delete;

  const std::shared_ptr<const SurfaceLibrary>& library() const { return library_; }
  // By material number; nullopt if the file only names it.
  const std::vector<std::optional<SurfaceLook>>& looks() const { return looks_; }
  // Returns true if a material has traits that a paint lacks even without its maps: metal, emission, opacity
  // or two equal sides.
  bool has_traits() const { return has_traits_; }

  // Uploads the images once they are decoded; optionally waits for the decoding. Returns true if it uploaded
  // them.
  bool update(bool waits);
  bool is_loading() const { return decoding_ != nullptr; }

  // Binds the block "Surfaces" and the samplers of `program`, whose maps are off for faces without UVs.
  // Precondition: `program` is in use.
  void bind(const gl::Program& program, bool has_uvs) const;

  size_t bytes() const { return bytes_; }  // of the layers

 private:
  struct Decoding;
  struct Layer {
    uint32_t image = 0;
    bool colours = false;  // else data such as normals
  };

  int layer_of(const SurfaceLook& look, SurfaceMap map);
  void fill_block();

  std::shared_ptr<const SurfaceLibrary> library_;
  std::vector<std::optional<SurfaceLook>> looks_;
  bool has_traits_;
  std::vector<Layer> layers_;
  std::unique_ptr<Decoding> decoding_;  // null once the images are uploaded
  gl::Buffer block_;
  std::optional<gl::Texture> colours_, numbers_;
  size_t bytes_ = 0;
};

}  // namespace kerf
