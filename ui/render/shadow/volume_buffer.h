#pragma once

#include <vector>

#include "core/shadow/shadow_volume.h"
#include "ui/gl/objects.h"
#include "ui/gl/program.h"
#include "ui/render/bodies/face_buffer.h"

namespace kerf {

// The shadow volume of one body for one light on the GPU: the sign of every face, in the same chunks as in
// FaceBuffer, and the silhouette with one instance per edge. Updates send only changes.
class VolumeBuffer {
 public:
  explicit VolumeBuffer(ShadowMethod method) : volume_(method) {}

  ShadowVolume& volume() { return volume_; }
  const ShadowVolume& volume() const { return volume_; }

  // Memory of the buffers on the GPU, in bytes.
  size_t bytes() const;

  // Sends the changes of the volume since the last call. Precondition: the volume has followed the caster.
  void update(const ShadowCaster& caster);

  // Binds the signs of a chunk for `program`, which contains shadow_cap.vert and is in use.
  void bind_signs(const gl::Program& program, size_t chunk) const;
  // Draws every side as often as its multiplicity demands, each with so many vertices. Precondition:
  // `program`, which contains shadow_side.vert, is in use.
  void draw_sides(const gl::Program& program, int vertices_of_side) const;
  // Draws one instance with so many vertices per edge, whatever its multiplicity.
  void draw_edges(int vertices) const;

 private:
  // An edge as the GPU reads it.
  struct Side {
    glm::vec3 low, high;  // in the body's float frame
    uint32_t piece;       // packed_piece of its label
    int32_t multiplicity;
  };
  struct Signs {
    gl::Buffer buffer;
    gl::Texture texture;
  };
  struct Sides {
    gl::Buffer buffer;
    gl::VertexArray layout;
    size_t room = 0;
    GLsizei count = 0;
    Sides();
    void replace(const std::vector<Side>& all);
  };

  Side side(const ShadowCaster& caster, const SilhouetteEdge& edge) const;
  void send_signs(const ShadowVolume::Touched& touched);
  void make_room(uint32_t faces);
  void send_sides(const ShadowCaster& caster, const ShadowVolume::Touched& touched);
  void send_many(const ShadowCaster& caster);

  ShadowVolume volume_;
  std::vector<Signs> signs_;  // by chunk
  uint32_t signs_room_ = 0;   // of them all together
  Sides sides_;               // the silhouette; the shader draws at most two copies
  Sides many_;                // the remaining copies of edges with higher multiplicity
};

}  // namespace kerf
