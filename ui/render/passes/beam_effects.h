#pragma once

#include <optional>
#include <vector>

#include "core/base/random.h"
#include "core/cut/cut_step.h"
#include "core/world/world.h"
#include "ui/gl/buffers.h"
#include "ui/render/bodies/body_picture.h"
#include "ui/render/view/camera.h"

namespace kerf {

// A beam to draw, in world coordinates [m].
struct BeamPicture {
  Vec3 from, to;
  std::optional<Vec3> strike;  // first hit on a surface
  double radius = 0.01;        // m
  bool on_ground = false;      // it ends on the ground, at `to`
  double strength = 1;         // of its light: less than 1 for a beam that is not on yet
};

// Returns the beam with its visible end: on the ground, a plane at a height [m], if it meets that before
// `to`.
BeamPicture ended_on_ground(BeamPicture beam, double ground, UpAxis up = UpAxis::kY);

// Returns half the side [pixels] of the square with the spot of a strike in a frame of this height, for a
// beam of radius `radius_pixels`. The glow stays visible around a thin beam, but never exceeds a fifth of
// the frame's height.
double spot_half_width(double radius_pixels, int height);

// Draws the beam as a bright core with a soft halo that always faces the eye, and a white-hot spot at the
// strike. The core is as wide as the beam, within limits, and at least a pixel. A beam that does not end on
// the ground fades out over its last metre.
class BeamPass {
 public:
  explicit BeamPass(Shaders& shaders);

  // Sets the uniforms for the light that the spot casts on its environment.
  static void fill_in(FrameUniforms& frame, const FrameSpace& space, const BeamPicture& beam);
  // Adds the beam to a frame of width x height pixels that already has the colour and depth of opaque
  // surfaces, with the near plane at a distance of `near` [m].
  void draw(const CameraView& view, const BeamPicture& beam, const FrameSpace& space, double near, int width,
            int height) const;

 private:
  void draw_ribbon(const CameraView& view, const BeamPicture& beam, double near, int width, int height) const;
  void draw_spot(const CameraView& view, const BeamPicture& beam, const FrameSpace& space, int height) const;

  gl::Program ribbon_, spot_;
  gl::NoVertices no_vertices_;
};

// Returns the length [m] at which a ray first hits a body that a beam can cut (see cuttable); nullopt on a
// miss.
std::optional<double> first_hit(const World& world, const Pose& ray);

// Returns the length [m] at which a beam first hits such a body. Casts rays along its axis, around its
// radius and around the edge of the burnt zone, which is `overshoot` metres farther out. Returns nullopt if
// no ray hits within `reach` metres.
std::optional<double> find_impact(const World& world, const Pose& beam, double radius, double overshoot,
                                  double reach);

// Returns a beam to draw with at most a given length [m], with its first hit on a body.
BeamPicture picture_of_beam(const World& world, const CutSettings& settings, const Pose& beam, double length);

// A glowing droplet of metal, drawn as a streak.
struct Spark {
  Vec3 at, tail;     // m, world: its position, and the beginning of its streak
  double width = 0;  // m, half the width
  double heat = 1;   // from 0 (invisible) over red and orange to 1 (nearly white)
};

// A puff of smoke, drawn as a soft disc that faces the eye.
struct Puff {
  Vec3 at;             // m, world
  double radius = 0;   // m
  double opacity = 0;  // 0 to 1
};

// A scorch mark on a surface that beams do not cut.
struct Scorch {
  Vec3 at, normal;    // m and unit, world
  double radius = 0;  // m
  double heat = 0;    // from 1 (just burnt, glowing) to 0
};

// The visible effects of lasers.
struct Effects {
  std::vector<BeamPicture> beams;  // in addition to the one whose spot lights its environment
  std::vector<Spark> sparks;
  std::vector<Puff> puffs;
  std::vector<Scorch> scorches;
};

// Sparks and smoke of burnt and abraded material, in proportion to its mass. Visual only: nothing in a
// world depends on them.
class Particles {
 public:
  struct Removal {
    Vec3 at;          // m, world
    Vec3 direction;   // of the beam, unit
    double size = 1;  // size of the cut body relative to a car (> 0); scales lengths and speeds
    double mass = 0;  // kg removed since the last call (>= 0)
  };

  // Adds sparks, which fly mostly back along the beam, and smoke, which rises along `up`, a unit vector.
  // Sheet thickness hardly depends on the size of a body, so the same number of particles represents a mass
  // smaller by the square of the size.
  void add(const Removal& removal, const Vec3& up);
  // Advances by a time [s], >= 0. Sparks bounce off the ground, a plane at a height [m] along `up`, a unit
  // vector.
  void advance(double seconds, const Vec3& up, double ground);

  bool empty() const { return sparks_.empty() && puffs_.empty(); }
  void clear();
  void append_to(Effects& effects) const;

 private:
  struct MovingSpark {
    Vec3 at, velocity;
    double size, age, life;
  };
  struct RisingPuff {
    Vec3 at, velocity;
    double size, age, life;
  };

  Vec3 direction_in_ball();
  void throw_spark(const Removal& removal, const Vec3& up);
  void raise_puff(const Removal& removal, const Vec3& up);

  Random random_{0x5eed};
  double owed_sparks_ = 0, owed_puffs_ = 0;  // fractions of particles carried over to the next removal
  std::vector<MovingSpark> sparks_;
  std::vector<RisingPuff> puffs_;
};

// Draws scorch marks, sparks as emissive streaks, and smoke as soft discs, with depth test, over a frame.
class EffectsPass {
 public:
  explicit EffectsPass(Shaders& shaders);

  // Draws into the bound framebuffer. O(particles * log(particles)).
  void draw(const Effects& effects, const FrameSpace& space);

 private:
  // A quad's corners are offset in the shader.
  struct Corner {
    glm::vec3 at;       // frame
    glm::vec3 towards;  // beginning of the streak; equal to `at` for a disc
    glm::vec2 across;   // -1 .. 1 over the quad
    glm::vec2 look;     // half the width in the frame's unit; heat or opacity
  };
  void draw_scorches(const std::vector<Scorch>& scorches, const FrameSpace& space);
  void draw_sparks(const std::vector<Spark>& sparks, const FrameSpace& space);
  void draw_smoke(const std::vector<Puff>& puffs, const FrameSpace& space);
  void send(const std::vector<Corner>& corners);
  static void add_quad(std::vector<Corner>& corners, Corner corner);

  gl::Program sparks_, smoke_, scorches_;
  gl::Stream<Corner> corners_{gl::ItemsAre::kVertices,
                              {{3, offsetof(Corner, at)},
                               {3, offsetof(Corner, towards)},
                               {2, offsetof(Corner, across)},
                               {2, offsetof(Corner, look)}}};
};

}  // namespace kerf
