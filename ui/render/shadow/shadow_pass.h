#pragma once

#include <map>
#include <memory>
#include <optional>

#include "core/base/assert.h"
#include "core/world/delta.h"
#include "ui/render/bodies/picture_memory.h"
#include "ui/render/bodies/shaders.h"
#include "ui/render/bodies/subject.h"
#include "ui/render/shadow/volume_buffer.h"

namespace kerf {

// The work since the pass was created.
struct ShadowWork {
  uint64_t casters = 0;  // whole bodies whose edges were found
  uint64_t faces = 0;    // whose sign was computed, over all lights
  uint64_t edges = 0;    // whose multiplicity was computed, over all lights
  uint64_t rebuilt = 0;  // volumes computed from nothing
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

  // Discards all shadows, for another world or a Delta that was lost.
  void forget() { bodies_.clear(); }
  // Discards the shadows of one body.
  void forget(BodyId id) { bodies_.erase(id); }
  // Renames the body `from` to `to`, with its shadows.
  void carry_on(BodyId from, BodyId to);
  // Follows changes of faces. Bodies that came or went have to be adopted or forgotten.
  void follow(const Delta& delta);
  // Takes over a shadow caster of a body, in its picture frame. Precondition: the caster is not null.
  void adopt(BodyId id, std::unique_ptr<ShadowCaster> caster) {
    KERF_ASSERT(caster != nullptr);
    bodies_[id].caster = std::move(caster);
  }

  // Counts into the stencil of what is bound, where the scissor lets it, the shadow of a light of
  // subject.options. What casts must be in the depth, drawn with `clip_from_frame * vec4(placed(...), 1.0)`
  // and an invariant position, with depth func GL_LESS. Afterwards a pixel is lit where the stencil is 0, and
  // with kRobust it holds the number of occluders modulo 256, so 256 surfaces over one another cast no
  // shadow. Where something hides all that lies below a height (frame coordinates), volumes that light from
  // above casts end there: what they cover beyond costs a software renderer most of their time.
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
    DirtySlots relabelled;  // slots whose label alone changed
    std::shared_ptr<const PieceGroups> groups;
  };

  void catch_up(BodyShadows& shadows, const Body& body, const FloatFrame& frame, const BodyLooks& looks);
  Kept& bring_up_to_date(const Subject& subject, BodyId id, const Body& body, const BodyPicture& picture,
                         VolumeKey key);
  void note_effort(const ShadowVolume::Effort& before, const ShadowVolume::Effort& after);
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

}  // namespace kerf
