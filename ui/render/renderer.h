#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "core/base/result.h"
#include "core/document/scene.h"
#include "core/world/delta.h"
#include "core/world/world.h"
#include "ui/render/beam_pass.h"
#include "ui/render/bloom_pass.h"
#include "ui/render/body_picture.h"
#include "ui/render/camera.h"
#include "ui/render/face_numbers.h"
#include "ui/render/line_overlay.h"
#include "ui/render/lit_scene.h"
#include "ui/render/outline_pass.h"
#include "ui/render/picture_memory.h"
#include "ui/render/prepared_body.h"
#include "ui/render/reference_pass.h"
#include "ui/render/shadow_overlay.h"
#include "ui/render/shadow_probe.h"
#include "ui/render/shadow_reference.h"
#include "ui/render/veil_pass.h"
#include "ui/render/view_options.h"

namespace kerf {

// Where a picture goes: a rectangle of a framebuffer (0: the window), pixels from its lower left corner.
struct Target {
  GLuint framebuffer = 0;
  int x = 0, y = 0;
  int width = 1, height = 1;
};

// Draws a world as it stands. Needs a current OpenGL 3.3 context that outlives it, and nothing else of a
// window.
class Renderer {
 public:
  // Compiles the shaders of assets/shaders.
  static Result<Renderer> create();

  // Looks at a world anew. Smooth normals are taken from the faces of bodies that are not prepared, which
  // should be as they were loaded.
  void show(const World& world, const std::map<std::string, Paint>& paints, PreparedBodies prepared = {});
  // Follows what a step changed in the world that is shown, which is `world` after the step: bodies are
  // added, dropped and carried on one by one, and faces that changed are sent to the GPU with the next
  // picture. A body that only moved sends nothing. `prepared` may lack bodies that came.
  void follow(const World& world, const Delta& delta, PreparedBodies prepared = {});
  // For when a Delta was lost: every face of the world is sent again. `prepared` may lack bodies, and the
  // bases of those that are shown already.
  void resend(const World& world, PreparedBodies prepared = {});

  // Of the bodies that are shown: in which their faces are drawn.
  std::map<BodyId, FloatFrame> frames() const;

  // Sends what was followed now and not with the next picture: faces that are gone before they are drawn are
  // remembered for it as they are now.
  void catch_up(const World& world);

  // The world must be the one that was shown, changed by what was followed.
  void draw(const World& world, const CameraView& view, const ViewOptions& options,
            const std::optional<BeamPicture>& beam, const Target& target);

  // Hands over the last picture once more; false where there is none of this size.
  bool draw_again(const Target& target);

  // How the shadow of a light of the options falls on the pixels of a view, seen with one sample and, where
  // asked for, with the ground.
  ShadowCounts shadow_counts(const World& world, const CameraView& view, const ViewOptions& options,
                             size_t light, ShadowMethod method, bool ground, int width, int height);

  // The same by rays, none of which is traced yet.
  ShadowReference shadow_reference(const World& world, const CameraView& view, const ViewOptions& options,
                                   size_t light, bool ground, int width, int height);

  // Lays what rays found over a picture of the same size that was just drawn to `target`.
  void draw_reference(const ShadowReference& traced, const ShadowCounts& drawn, const Target& target) const;

  // Traces all of a picture that was just drawn to `target`, under the light that is inspected, and lays it
  // over.
  void draw_traced(const World& world, const CameraView& view, const ViewOptions& options,
                   const Target& target);

  // Of the last picture that compared two methods: pixels that are lit with one of them alone.
  size_t differing_pixels() const { return differing_; }

  // What shadows cost since the renderer was made.
  ShadowWork shadow_work() const { return passes_.scene.shadows().work(); }

  // Lets no picture send more than so many faces of a body that is shown or sent anew; the pictures after it
  // go on. Without a limit every picture is whole.
  void limit_sending(uint32_t faces) { most_faces_sent_ = faces; }
  // Whether such faces are left to be sent.
  bool is_sending() const;

  // Of what grows with the faces of the world.
  PictureMemory memory() const;

  // Bytes of faces sent to the GPU since the renderer was made.
  size_t uploaded_bytes() const { return uploaded_; }

 private:
  // What is drawn one after the other.
  struct Passes {
    LitScene scene;
    BloomPass bloom;
    BeamPass beam;
    LineOverlay lines;
    VeilPass veil;
    OutlinePass outline;
    FaceNumbers numbers;
    ShadowProbe probe;
    ShadowOverlay shadow_overlay;
    ReferencePass reference;
  };
  static Result<Passes> load_passes(const std::filesystem::path& shaders);
  explicit Renderer(Passes passes) : passes_(std::move(passes)) {}

  void add(BodyId id, const Body& body, PreparedBodies& prepared);
  void drop(BodyId id);
  void carry_on(BodyId from, BodyId to);
  void update_looks(const ViewOptions& options);
  double near_of(const World& world, const CameraView& view, const ViewOptions& options);
  void set_up(const World& world, const CameraView& view, const ViewOptions& options,
              const std::optional<BeamPicture>& beam, const Target& target);
  void draw_bodies(const World& world, const gl::Program& program) const;
  void choose_canvas(const Target& target, bool antialias);
  void draw_overlays(const Subject& subject, const CameraView& view, const std::optional<BeamPicture>& beam);
  void draw_comparison(const Subject& subject, const gl::Framebuffer& picture);
  void hand_over(const Target& target);
  void find_white_hot();

  Passes passes_;
  gl::Buffer uniforms_;
  // Pictures are drawn on one of these and then handed over; both are kept, so that changing between them is
  // free.
  struct Canvas {
    std::optional<gl::Framebuffer> drawn, resolved;  // resolved: only with several samples
  };
  std::array<Canvas, 2> canvases_;  // without and with anti-aliasing
  size_t canvas_ = 0;               // that of the last picture

  std::map<BodyId, BodyPicture> bodies_;
  std::map<std::string, Paint> paints_;
  Vec3 middle_{0};  // of the world as it was shown
  FrameSpace space_;
  FrameUniforms frame_;
  uint32_t white_hot_ = 0;  // halvings since the base face; 0 where nothing is small
  bool contact_old_ = true;
  bool shining_ = false;  // the last picture has something that glows
  size_t uploaded_ = 0;
  uint32_t most_faces_sent_ = DirtySlots::kAll;
  size_t differing_ = 0;
};

}  // namespace kerf
