#pragma once

#include <epoxy/gl.h>
#include <filesystem>
#include <glm/vec4.hpp>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "core/base/ids.h"
#include "core/base/result.h"
#include "core/document/scene.h"
#include "core/joints/joined_parts.h"
#include "core/world/world.h"
#include "ui/gl/buffers.h"
#include "ui/gl/program.h"
#include "ui/render/bodies/base_faces.h"
#include "ui/render/bodies/face_buffer.h"
#include "ui/render/bodies/surface_textures.h"
#include "ui/render/view/camera.h"
#include "ui/render/view/view_options.h"

namespace kerf {

// The looks of the face groups of one body (see PieceGroups). A loose part has the look of its own piece, but
// moves with another piece. All groups of a hidden body are hidden.
class BodyLooks {
 public:
  BodyLooks(BodyId id, const Body& body, const ViewOptions& options);

  // The groups with a look other than the default.
  const std::map<uint32_t, PieceLook>& by_group() const { return by_group_; }
  const PieceLook& of(uint32_t group) const;
  const PieceLook& of(const Mesh& mesh, FaceId f) const {
    return of(groups_ ? groups_->of(mesh, f) : mesh.data(f).piece);
  }
  // By group: true if a stage of a cut separated it, false if it is the group from which another was
  // separated.
  const std::map<uint32_t, bool>& came_off() const { return came_off_; }

  // Null if the group of each face is the label of its piece.
  const std::shared_ptr<const PieceGroups>& groups() const { return groups_; }

 private:
  void record_separation(BodyId id, const ViewOptions& options);

  std::map<uint32_t, PieceLook> by_group_;
  std::map<uint32_t, bool> came_off_;
  std::shared_ptr<const PieceGroups> groups_;
};

// The groups of the faces as ShadowCaster takes them.
std::span<const uint32_t> labels_of(const std::shared_ptr<const PieceGroups>& groups);

// The looks of one body's groups of faces on the GPU, for programs that contain placed.glsl.
class PieceLooks {
 public:
  // Applies the looks of the body. A part that was not separated by a cut keeps its paint (see
  // is_loaded_part). Returns true if anything changed. O(pieces).
  bool update(const Body& body, const BodyLooks& looks, const FrameSpace& space);

  // Binds the looks for `program`. Precondition: it is in use.
  void bind(const gl::Program& program) const;

  // Returns true if any piece is hidden, displaced or turned; or if any is selected.
  bool any_away() const { return any_away_; }
  bool any_selected() const { return any_selected_; }

 private:
  static void add_row(std::vector<glm::vec4>& table, size_t row);

  std::map<uint32_t, PieceLook> looks_;  // by group
  std::map<uint32_t, bool> came_off_;    // by group
  std::set<uint32_t> parts_;             // groups with the look of the body itself
  UpAxis up_ = UpAxis::kY;               // of the displacements on the GPU
  gl::Buffer buffer_;
  gl::Texture table_;
  int count_ = 0;
  bool any_away_ = false, any_turned_ = false, any_selected_ = false;
};

struct Pick {
  BodyId body;
  FaceId face;
  double length = 0;  // m, from the ray's origin
};

// Returns the first visible face along a ray of the world with the given options: ignores hidden bodies
// and pieces and the cut-away side of the section plane, tests displaced pieces at their drawn position, and
// back faces only if they are drawn. Precondition: the ray's direction is a unit vector. Costs one traversal
// of each body's tree per distinct offset of its pieces.
std::optional<Pick> pick(const World& world, const ViewOptions& options, const Pose& ray);

// Loads the programs of passes from assets/shaders into the current context, and binds their blocks "Frame"
// and "Paints". Check status() after the creation of passes: after the first program that fails to load,
// all others are empty, and the passes must not draw.
class Shaders {
 public:
  Shaders();

  // Same file arguments as gl::Program::load.
  gl::Program load(const gl::ProgramFiles& files);
  const Status& status() const { return status_; }

 private:
  std::filesystem::path folder_;
  Status status_ = Done{};
};

// Binding points of the shaders' uniform blocks.
inline constexpr GLuint kFrameBlock = 0;
inline constexpr GLuint kPaintBlock = 1;
inline constexpr GLuint kSurfaceBlock = 2;

// Returns true if a buffer is bound as the uniform block of the frame; for preconditions.
bool is_frame_bound();

// One body on the GPU: its faces, its paints and the looks of its pieces.
class BodyPicture {
 public:
  // `textures` are those of the materials of its file, or null. `glow_width` [m] is that of RimDistance.
  // Precondition: `prepared` was made for this body.
  BodyPicture(const Body& body, const std::map<std::string, Paint>& paints, PreparedBody prepared,
              std::shared_ptr<const SurfaceTextures> textures, double glow_width);

  FaceBuffer& faces() { return faces_; }
  const FaceBuffer& faces() const { return faces_; }

  PieceLooks& looks() { return looks_; }
  const PieceLooks& looks() const { return looks_; }

  // Returns true if programs with TEXTURED draw it.
  bool is_textured() const { return textures_ && (faces_.has_uvs() || textures_->has_traits()); }

  // Sets placements and paints in `program`, which is in use and draws faces.
  void bind(const gl::Program& program, const FrameSpace& space, const Placement& placement) const;
  void draw(const gl::Program& program, const FrameSpace& space, const Placement& placement) const;

 private:
  PieceLooks looks_;
  FaceBuffer faces_;
  gl::Buffer paints_;
  std::shared_ptr<const SurfaceTextures> textures_;
};

// Returns the colours (linear light) of the pieces of a body, by number from 1 on, cyclically: each is as
// far as possible from the paints of the body and from the colours before it.
std::vector<glm::dvec3> piece_colours(const std::vector<std::string>& materials,
                                      const std::map<std::string, Paint>& paints);

// Returns colour and gloss of up to 256 materials by index: of their paints, otherwise as their file
// describes them, with kDescribed added to the gloss. Any other material looks like blue-grey painted metal.
inline constexpr float kDescribed = 2;  // as in body.vert
std::vector<glm::vec4> paint_table(const std::vector<std::string>& materials,
                                   const std::map<std::string, Paint>& paints,
                                   std::span<const std::optional<SurfaceLook>> looks = {});

// While an object exists, programs that write gl_ClipDistance[0] draw only the kept side of the section
// plane, and programs that do not write it must not draw. No-op without a section plane.
class SectionClip {
 public:
  explicit SectionClip(const ViewOptions& options) : enabled_(shown_section(options) != nullptr) {
    if (enabled_) glEnable(GL_CLIP_DISTANCE0);
  }
  ~SectionClip() {
    if (enabled_) glDisable(GL_CLIP_DISTANCE0);
  }
  SectionClip(const SectionClip&) = delete;
  SectionClip& operator=(const SectionClip&) = delete;

 private:
  bool enabled_;
};

// The input of a pass: what to draw, and with which options.
struct Subject {
  const World& world;
  std::map<BodyId, BodyPicture>& bodies;
  const FrameSpace& space;
  const ViewOptions& options;

  // The culled sides of faces.
  GLenum culled() const { return options.cull_backs ? GL_BACK : GL_NONE; }
};

// Calls visit(id, body, picture) for every body of the world that is on the GPU, in the order of ids.
template <typename Visit>
void for_each_body(const Subject& subject, const Visit& visit) {
  for (auto& [id, picture] : subject.bodies) {
    if (subject.world.contains(id)) visit(id, subject.world.body(id), picture);
  }
}

// Draws the bodies with a program that is in use.
inline void draw_bodies(const Subject& subject, const gl::Program& program) {
  for_each_body(subject, [&](BodyId, const Body& body, const BodyPicture& picture) {
    picture.draw(program, subject.space, body.placement);
  });
}

}  // namespace kerf
