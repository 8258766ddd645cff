#pragma once

#include <optional>
#include <vector>

#include "core/base/random.h"
#include "core/cut/cut_step.h"
#include "core/world/world.h"
#include "ui/gl/buffers.h"
#include "ui/render/bodies/body_picture.h"
#include "ui/render/view/frame_space.h"

namespace kerf {

// A beam to be drawn, in world coordinates (m).
struct BeamPicture {
  Vec3 from, to;
  std::optional<Vec3> strike;  // where it first meets a surface
  double radius = 0.01;        // m
  bool on_ground = false;      // it ends on the ground, at `to`
  double strength = 1;         // of its light: less than 1 for one that is not on yet
};

// The beam with the end that it is seen to have: the ground, a plane at a height (m), if the beam meets it
// before `to`.
BeamPicture ended_on_ground(BeamPicture beam, double ground, UpAxis up = UpAxis::kY);

// Half the side, in pixels, of the square on which the spot of a strike is drawn in a picture of this height,
// for a beam whose radius is `radius_pixels` there. The glow stays visible around a thin beam, but never
// spreads over more than a fifth of the picture's height.
double spot_half_width(double radius_pixels, int height);

// Draws the beam as a bright core with a soft halo that always faces the eye, and a white-hot spot where it
// strikes. The core is as wide as the beam, within limits, and never thinner than a pixel. A beam that does
// not end on the ground fades out over its last metre.
class BeamPass {
 public:
  explicit BeamPass(Shaders& shaders);

  // Sets the uniforms for the light that the spot casts on its environment.
  static void fill_in(FrameUniforms& frame, const FrameSpace& space, const BeamPicture& beam);
  // Adds the beam to a picture of width x height pixels whose opaque surfaces and depth are drawn already,
  // with the near plane at a distance of `near` (m).
  void draw(const CameraView& view, const BeamPicture& beam, const FrameSpace& space, double near, int width,
            int height) const;

 private:
  void draw_ribbon(const CameraView& view, const BeamPicture& beam, double near, int width, int height) const;
  void draw_spot(const CameraView& view, const BeamPicture& beam, const FrameSpace& space, int height) const;

  gl::Program ribbon_, spot_;
  gl::NoVertices no_vertices_;
};

// The length in metres at which a ray first meets a body that a beam can cut (see cuttable); nothing if it
// misses all.
std::optional<double> first_hit(const World& world, const Pose& ray);

// The length in metres at which a beam first meets such a body. Rays are cast along its axis, around its
// radius and around the rim of what it burns, which lies `overshoot` metres farther out. Nothing if no ray
// hits within `reach` metres.
std::optional<double> find_strike(const World& world, const Pose& beam, double radius, double overshoot,
                                  double reach);

// A beam as it is drawn over at most a length (m), with the place where it first meets a body.
BeamPicture picture_of_beam(const World& world, const CutSettings& settings, const Pose& beam, double length);

// A glowing droplet of metal, drawn as a streak.
struct Spark {
  Vec3 at, tail;     // m, world: where it is, and where its streak begins
  double width = 0;  // m, half of it
  double heat = 1;   // from 0, where it is invisible, over red and orange to 1, nearly white
};

// A puff of smoke, drawn as a soft disc that faces the eye.
struct Puff {
  Vec3 at;             // m, world
  double radius = 0;   // m
  double opacity = 0;  // 0 to 1
};

// A burnt place of a surface that beams do not cut.
struct Scorch {
  Vec3 at, normal;    // m and unit, world
  double radius = 0;  // m
  double heat = 0;    // from 1, where it was just burnt and glows, to 0
};

// What is drawn of lasers and of what they throw off.
struct Effects {
  std::vector<BeamPicture> beams;  // besides the one whose spot lights its environment
  std::vector<Spark> sparks;
  std::vector<Puff> puffs;
  std::vector<Scorch> scorches;
};

// The sparks and the smoke of what lasers burn away and crashes rub off: as many as its mass says. They are
// only seen: nothing in a world depends on them.
class Particles {
 public:
  struct Bite {
    Vec3 at;          // m, world
    Vec3 direction;   // of the beam, unit
    double size = 1;  // of what is cut, compared with a car (> 0); lengths and speeds are multiplied by it
    double mass = 0;  // kg that was removed since the last call (>= 0)
  };

  // Sparks fly off, most of them back along the beam, and smoke rises along `up`, a unit vector. Sheets of
  // things of all sizes have about the same thickness, so that the same number stands for a mass that is
  // smaller by the square of the size.
  void add(const Bite& bite, const Vec3& up);
  // Lets time pass (s, >= 0). Sparks bounce off the ground, a plane at a height (m) along `up`, a unit
  // vector.
  void advance(double seconds, const Vec3& up, double ground);

  bool empty() const { return sparks_.empty() && puffs_.empty(); }
  void clear();
  // Adds what is to be drawn.
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
  void throw_spark(const Bite& bite, const Vec3& up);
  void raise_puff(const Bite& bite, const Vec3& up);

  Random random_{0x5eed};
  double owed_sparks_ = 0, owed_puffs_ = 0;  // parts of one that are to be added with the next bite
  std::vector<MovingSpark> sparks_;
  std::vector<RisingPuff> puffs_;
};

// Draws burnt places, sparks as streaks that shine, and smoke as soft discs, over a picture whose depth
// buffer hides what lies behind its surfaces.
class EffectsPass {
 public:
  explicit EffectsPass(Shaders& shaders);

  // Draws into the bound picture. O(particles * log(particles)).
  void draw(const Effects& effects, const FrameSpace& space);

 private:
  // The corners of a quad are spread in the shader.
  struct Corner {
    glm::vec3 at;       // frame
    glm::vec3 towards;  // where the streak begins; the same as `at` for a disc
    glm::vec2 across;   // -1 .. 1 over the quad
    glm::vec2 look;     // half the width in the frame's unit, heat or opacity
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
