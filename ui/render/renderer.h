#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>

#include "core/base/assert.h"
#include "core/base/result.h"
#include "core/document/scene.h"
#include "core/world/world.h"
#include "core/world/world_delta.h"
#include "ui/render/bodies/base_faces.h"
#include "ui/render/bodies/body_picture.h"
#include "ui/render/lit_scene.h"
#include "ui/render/passes/beam_effects.h"
#include "ui/render/passes/mark_passes.h"
#include "ui/render/passes/post_processing.h"
#include "ui/render/passes/surface_overlays.h"
#include "ui/render/shadow_pass.h"
#include "ui/render/shadow_reference.h"
#include "ui/render/view/camera.h"
#include "ui/render/view/view_options.h"

namespace kerf {

// Returns `wanted` if the memory of OpenGL suffices for images of this size [pixels] with this choice of
// anti-aliasing, and false if it suffices only without. Fails if it does not suffice at all. Precondition: an
// OpenGL 3.3 context is current.
Result<bool> affordable_antialias(int width, int height, bool wanted);

// Draws a world. Precondition: an OpenGL 3.3 context is current and outlives the renderer; no window is
// needed.
class Renderer {
 public:
  // Compiles the shaders in assets/shaders. Fails if one of them is missing or does not compile.
  static Result<Renderer> create();

  // Starts showing a world. `prepared` holds its bodies as loaded, by Body::loaded_as; for missing bodies,
  // smooth normals are computed from their faces, which should be as loaded.
  void show(const World& world, const std::map<std::string, Paint>& paints, PreparedBodies prepared = {});
  // Updates the renderer after a change of the shown world; `world` is the state after the change. Adds,
  // removes and renames individual bodies; uploads changed faces with the next frame. Nothing is uploaded for
  // a body that only moved. The ground follows that of the world, and is lowered below meshes that are added.
  // `prepared` may lack created bodies.
  void follow(const World& world, const Delta& delta, PreparedBodies prepared = {});
  // Uploads every face of the world again, in case a Delta was lost. An id may denote another body than
  // before, unless it is a Body::loaded_as. `prepared` may lack bodies. Parts that were removed from split
  // faces lose their numbers.
  void resend(const World& world, PreparedBodies prepared = {});

  // The shading of the bodies as loaded, for prepare_shading() of future bodies.
  const LoadedShadings& loaded_shadings() const { return loaded_; }

  // Uploads changed faces now instead of with the next frame, so that faces removed before they were drawn
  // are recorded with their current corners. O(changes).
  void send_faces(const World& world);

  // Uploads all changes now: faces, and the heat of bodies. O(changes + hot faces).
  void catch_up(const World& world);

  // Draws a frame. Precondition: the world is the shown one, with all changes followed.
  void draw(const World& world, const CameraView& view, const ViewOptions& options,
            std::optional<BeamPicture> beam, const Target& target);

  // Shows the last frame again. Returns false if there is none of this size.
  bool draw_again(const Target& target);

  // Returns the stencil counts of the shadow of one of the options' lights for a view, with one sample per
  // pixel, with or without the ground. Preconditions: the options have this light, and the size is
  // positive.
  ShadowCounts shadow_counts(const World& world, const CameraView& view, const ViewOptions& options,
                             size_t light, ShadowMethod method, bool ground, int width, int height);

  // Returns a tracer of this shadow that has traced no ray yet. Preconditions as for shadow_counts().
  ShadowReference shadow_reference(const World& world, const CameraView& view, const ViewOptions& options,
                                   size_t light, bool ground, int width, int height);

  // Draws the traced shadows over a frame just drawn to `target`. Precondition: the tracer, the counts and
  // the target have the same size.
  void draw_reference(const ShadowReference& traced, const ShadowCounts& drawn, const Target& target) const;

  // Traces the shadows of the inspected light for a whole frame just drawn to `target`, and draws them over
  // it.
  void draw_traced(const World& world, const CameraView& view, const ViewOptions& options,
                   const Target& target);

  // The number of pixels lit by only one of two methods in the last frame that compared them.
  size_t differing_pixels() const { return differing_; }

  // Takes the shadow casters of its bodies from `prepared`, if present. Precondition: they match the
  // current world.
  void take_casters(PreparedBodies prepared);

  // The work for shadows since the renderer was created.
  ShadowWork shadow_work() const { return passes_.scene.shadows().work(); }

  // Limits the number of faces of a newly shown body uploaded per frame; later frames upload the rest, and
  // images of materials when they are decoded. Without a limit every frame is complete. Precondition: faces >
  // 0.
  void limit_sending(uint32_t faces) {
    KERF_ASSERT(faces > 0);
    max_faces_sent_ = faces;
  }
  // Returns true if faces are left for later frames to upload.
  bool is_sending() const;
  // Returns true if images of materials are still being decoded.
  bool is_loading_images() const;
  // The fraction of uploaded faces, from 0 to 1.
  double sent_share() const;

  // Memory that grows with the number of faces.
  PictureMemory memory() const;

  // The temperature of the hottest face as of the last frame [K].
  double warmest() const;

  // The number of bytes of faces uploaded since the renderer was created.
  size_t uploaded_bytes() const { return uploaded_; }

 private:
  struct Passes {
    LitScene scene;
    BloomPass bloom;
    BeamPass beam;
    EffectsPass effects;
    LineOverlay lines;
    VeilPass veil;
    OutlinePass outline;
    FaceNumbers numbers;
    ShadowProbe probe;
    ShadowOverlay shadow_overlay;
    ReferencePass reference;
    GraphPass graph;
    StagePass stage;
    SectionPass section;
    BodyPass bodies;
    WirePass wire;
  };
  explicit Renderer(Shaders& shaders);

  void place_ground(const World& world);
  bool adds_mesh_below_ground(const World& world, const Delta& delta);
  void add(BodyId id, const Body& body, PreparedBodies& prepared);
  std::shared_ptr<const SurfaceTextures> textures_of(const Body& body);
  void drop(BodyId id);
  void rename_body(BodyId from, BodyId to);
  void look_from(const World& world, const CameraView& view);
  void update_looks(const World& world, const ViewOptions& options);
  void update_scalars(const ViewOptions& options);
  void update_shading(const World& world, const ViewOptions& options);
  std::shared_ptr<const BaseFaces> smooth_bases(const Body& body);
  double near_of(const World& world, const CameraView& view, const ViewOptions& options);
  void set_up(const World& world, const CameraView& view, const ViewOptions& options,
              const std::optional<BeamPicture>& beam, const Target& target);
  void select_canvas(const Target& target, bool antialias);
  void draw_overlays(const Subject& subject, const CameraView& view, const std::optional<BeamPicture>& beam);
  void draw_comparison(const Subject& subject, const gl::Framebuffer& picture);
  void hand_over(const Target& target);
  void find_finest();
  void follow_heat(const World& world);
  void draw_beams(const CameraView& view, const ViewOptions& options, const std::optional<BeamPicture>& beam);
  bool has_rims(const ViewOptions& options) const;
  bool glows(const ViewOptions& options) const;

  Passes passes_;
  gl::Buffer uniforms_;
  // Off-screen canvases of frames; both are kept, so that switching is free.
  struct Canvas {
    std::optional<gl::Framebuffer> drawn, resolved;  // resolved: only with several samples
  };
  std::array<Canvas, 2> canvases_;  // without and with anti-aliasing
  size_t canvas_ = 0;               // of the last frame

  std::map<BodyId, BodyPicture> bodies_;
  LoadedShadings loaded_;
  std::map<BodyId, std::shared_ptr<const BaseFaces>> smooth_;  // by Body::loaded_as, while they are shown
  std::map<std::string, Paint> paints_;
  std::vector<std::shared_ptr<SurfaceTextures>> textures_;  // one for each file that describes materials
  Vec3 middle_{0};                                          // of the world when it was first shown
  FrameSpace space_;
  FrameUniforms frame_;
  double near_ = 0;        // m, of the last frame
  double glow_width_ = 0;  // m
  // The clock and energy to which the temperatures on the GPU belong.
  struct HeatMoment {
    Ticks clock = 0;
    EnergyLedger energy;
    friend bool operator==(const HeatMoment&, const HeatMoment&) = default;
  };
  std::optional<HeatMoment> heat_of_;
  uint32_t finest_ = 0;  // maximum halvings of a face
  bool contact_old_ = true;
  bool shining_ = false;  // the last frame contains glowing pixels
  size_t uploaded_ = 0;
  uint32_t max_faces_sent_ = DirtySlots::kAll;
  size_t differing_ = 0;
};

}  // namespace kerf
