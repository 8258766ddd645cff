#pragma once

#include <vector>

#include "core/shadow/shadow_volume.h"
#include "ui/gl/objects.h"
#include "ui/gl/program.h"
#include "ui/render/face_buffer.h"

namespace kerf {

// The shadow volume of one body under one light on the GPU: the sign of every face in chunks as those of its
// FaceBuffer, and the silhouette, one instance an edge. An update sends what changed.
class VolumeBuffer {
 public:
  explicit VolumeBuffer(ShadowMethod method) : volume_(method) {}

  ShadowVolume& volume() { return volume_; }
  const ShadowVolume& volume() const { return volume_; }

  // Of the buffers on the GPU.
  size_t bytes() const;

  // Sends what the volume changed since the last time.
  void update(const ShadowCaster& caster);

  // For a program of shadow_cap.vert in use: the signs of a chunk.
  void bind_signs(const gl::Program& program, size_t chunk) const;
  // For a program of shadow_side.vert in use: every side as often as its multiplicity says, each with so many
  // vertices.
  void draw_sides(const gl::Program& program, int vertices_of_side) const;
  // One instance of so many vertices an edge, whatever its multiplicity.
  void draw_edges(int vertices) const;

 private:
  // An edge as the GPU reads it.
  struct Side {
    glm::vec3 low, high;  // in the body's float frame
    uint32_t attributes;  // its piece, as pack_attributes places it
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
  void send_sides(const ShadowCaster& caster, const ShadowVolume::Touched& touched);
  void send_many(const ShadowCaster& caster);

  ShadowVolume volume_;
  std::vector<Signs> signs_;  // by chunk
  Sides sides_;               // as the silhouette; the shader draws two copies at most
  Sides many_;                // what is left of edges with more copies than that
};

}  // namespace kerf
