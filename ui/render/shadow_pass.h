#pragma once

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/base/assert.h"
#include "core/shadow/shadow_volume.h"
#include "core/world/rigid_body.h"
#include "core/world/world_delta.h"
#include "ui/gl/buffers.h"
#include "ui/gl/program.h"
#include "ui/render/bodies/base_faces.h"
#include "ui/render/bodies/body_picture.h"
#include "ui/render/bodies/face_buffer.h"
#include "ui/render/passes/surface_overlays.h"
#include "ui/render/view/camera.h"

namespace kerf {

// Transforms a light to the frame of a body at `placement` with these looks.
LightOnBody light_on_body(const Light& light, const Placement& placement, const FloatFrame& frame,
                          const BodyLooks& looks);

// The uniform "light" of the shaders: the light in frame coordinates. Precondition: the direction of a
// directional light is not zero.
glm::vec4 light_in_frame(const Light& light, const FrameSpace& space);

// The uniform "light_colour" (see Light::intensity).
glm::vec4 light_colour(const Light& light, const FrameSpace& space);

// The unit direction from a point of the world towards a light.
Vec3 direction_to(const Light& light, const Vec3& from);

// The shadow volume of one body for one light on the GPU: the sign of every face, in the same chunks as in
// FaceBuffer, and the silhouette with one instance per edge. Updates upload only changes.
class VolumeBuffer {
 public:
  explicit VolumeBuffer(ShadowMethod method) : volume_(method) {}

  ShadowVolume& volume() { return volume_; }
  const ShadowVolume& volume() const { return volume_; }

  size_t bytes() const;

  // Uploads the changes of the volume since the last call. Precondition: the volume is up to date with the
  // caster.
  void update(const ShadowCaster& caster);

  // Binds the signs of a chunk for `program`, which contains shadow_cap.vert and is in use.
  void bind_signs(const gl::Program& program, size_t chunk) const;
  // Draws every side |multiplicity| times, with `vertices_of_side` vertices each. Precondition: `program`,
  // which contains shadow_side.vert, is in use.
  void draw_sides(const gl::Program& program, int vertices_of_side) const;
  // Draws one instance of `vertices` vertices per edge, whatever its multiplicity.
  void draw_edges(int vertices) const;

 private:
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
  uint32_t signs_room_ = 0;   // of all chunks together
  Sides sides_;               // the silhouette; the shader draws at most two copies
  Sides many_;                // the remaining copies of edges with higher multiplicity
};

struct ShadowWork {
  uint64_t casters = 0;  // whole bodies whose edges were found
  uint64_t faces = 0;    // signs computed, over all lights
  uint64_t edges = 0;    // multiplicities computed, over all lights
  uint64_t rebuilt = 0;  // volumes computed from scratch
};

// Counts for every pixel the surfaces that occlude a light, with shadow volumes in the stencil buffer (F.
// Crow: Shadow algorithms for computer graphics, 1977; T. Heidmann: Real shadows, real time, 1991) by depth
// fail (W. Bilodeau, M. Songy and, independently, J. Carmack), with volumes that extend to infinity and a
// projection without a far plane (C. Everitt, M. Kilgard: Practical and robust stenciled shadow volumes,
// 2002).
//
// Volumes are cached per body, light and method. They follow Deltas and do not depend on the viewpoint.
class ShadowPass {
 public:
  explicit ShadowPass(Shaders& shaders);

  // Discards all shadows, for another world or after a lost Delta.
  void forget() { bodies_.clear(); }
  void forget(BodyId id) { bodies_.erase(id); }
  // Moves the shadows of the body `from` to the id `to`.
  void rename_body(BodyId from, BodyId to);
  // Updates the casters after changes of faces. The caller must adopt created bodies and forget destroyed
  // ones.
  void follow(const Delta& delta);
  // Takes ownership of the shadow caster of a body, in the frame in which the body is drawn. Precondition:
  // the caster is not null.
  void adopt(BodyId id, std::unique_ptr<ShadowCaster> caster) {
    KERF_ASSERT(caster != nullptr);
    bodies_[id].caster = std::move(caster);
  }

  // Counts the shadow of a light of subject.options into the stencil of the bound framebuffer, within the
  // scissor. Casters must be in the depth buffer, drawn with `clip_from_frame * vec4(placed(...), 1.0)` and
  // an invariant position, with depth func GL_LESS. Afterwards a pixel is lit if its stencil is 0, and with
  // kRobust it holds the number of occluders modulo 256, so 256 surfaces over one another cast no shadow. If
  // everything below the height `hidden_below` (frame coordinates) is hidden, volumes of light from above end
  // at that height, because a software renderer would spend most of its time on the area below.
  void count(const Subject& subject, size_t light, ShadowMethod method,
             std::optional<float> hidden_below = std::nullopt);

  // The current volume of a body, or null if the body is not drawn.
  const VolumeBuffer* volume(const Subject& subject, BodyId id, size_t light, ShadowMethod method);
  const ShadowCaster* caster(BodyId id) const;

  // Discards volumes that were not used since the last call.
  void drop_unused();

  ShadowWork work() const { return work_; }

  // The memory of casters, volumes and their buffers.
  PictureMemory memory() const;

 private:
  using VolumeKey = std::pair<size_t, ShadowMethod>;
  struct Kept {
    VolumeBuffer buffer;
    bool used = true;
    explicit Kept(ShadowMethod method) : buffer(method) {}
  };
  struct BodyShadows {
    std::unique_ptr<ShadowCaster> caster;
    std::map<VolumeKey, Kept> volumes;
    DirtySlots dirty;
    DirtySlots relabelled;  // slots with a new label only
    std::shared_ptr<const PieceGroups> groups;
  };

  void catch_up(BodyShadows& shadows, const Body& body, const FloatFrame& frame, const BodyLooks& looks);
  Kept& bring_up_to_date(const Subject& subject, BodyId id, const Body& body, const BodyPicture& picture,
                         VolumeKey key);
  void record_effort(const ShadowVolume::Effort& before, const ShadowVolume::Effort& after);
  void count_near_caps(const Subject& subject, VolumeKey key);
  void count_robustly(const Subject& subject, VolumeKey key, const glm::vec4& light,
                      std::optional<float> floor);
  void count_as_the_paper(const Subject& subject, VolumeKey key, const glm::vec4& light);
  void draw_caps(const Subject& subject, VolumeKey key, int sign, bool pushed);
  void draw_sides(const Subject& subject, VolumeKey key, int vertices_of_side);

  gl::Program cap_, side_;
  std::map<BodyId, BodyShadows> bodies_;
  ShadowWork work_;
};

// Draws the construction of shadow volumes over a frame: the silhouette in blue, thin and light for
// multiplicity 1, stronger for 2 and violet above; the volumes as sheets and wire, blue from outside and
// orange from inside; the stencil counts as a heat map; light-facing polygons in pale yellow and
// back-facing ones in dark blue. A legend at the lower left explains the colours.
class ShadowOverlay {
 public:
  explicit ShadowOverlay(Shaders& shaders);

  // Draws for the light that the options inspect, over a frame whose depth is kept; overwrites its stencil.
  void draw(const Subject& subject, ShadowPass& shadows, FaceNumbers& numbers,
            const gl::Framebuffer& picture) const;

 private:
  struct Inspected;
  void draw_facing(const Inspected& seen) const;
  void draw_counts(const Inspected& seen, FaceNumbers& numbers) const;
  void draw_volumes(const Inspected& seen) const;
  void draw_silhouette(const Inspected& seen, FaceNumbers& numbers) const;
  void draw_lines(const Inspected& seen, float half_width, float reach,
                  std::span<const glm::vec4> colours) const;

  gl::Program line_, sheet_, facing_, solid_;
  gl::NoVertices no_vertices_;
};

}  // namespace kerf
