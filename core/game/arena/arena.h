#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/parallel.h"
#include "core/base/result.h"
#include "core/document/scene.h"
#include "core/world/world.h"

namespace kerf {

struct SightHit {
  BodyId body;           // invalid for the ground
  double length = 0;     // m, along the ray
  Vec3 normal{0, 1, 0};  // unit, in the world, against the ray
};

// Casts rays in a world, of which neither bodies nor faces may change in the meantime. Keeps a sphere
// around every visible body to skip most of them.
class Sight {
 public:
  explicit Sight(const World& world);

  using Stops = std::function<bool(BodyId)>;

  // The first hit of a ray within a length, including the ground. Precondition: the direction is a unit
  // vector.
  std::optional<SightHit> nearest(const Pose& ray, double length, const Stops& stops) const;

  // A body whose faces may be near a beam.
  struct Near {
    BodyId id;
    const Body* body;
    Vec3 centre;    // m, of a sphere around its faces, in the world
    double radius;  // m
  };
  const std::vector<Near>& bodies() const { return bodies_; }

 private:
  const World& world_;
  std::vector<Near> bodies_;
};

// Returns true if a segment of this length [m] comes within `reach` [m] of a sphere.
bool passes_near(const Pose& ray, double length, const Vec3& centre, double radius, double reach = 0);

// A loaded body, of which copies are added to worlds, and the joints within it.
struct ModelBody {
  Body body;
  std::vector<Joint> joints;  // of the body in the world to which it will be added
};

// Fails like make_joint.
Status add_joints(std::span<const JointDescription> joints, ModelBody& model);

BodyId add_body(World& world, const ModelBody& model, uint32_t generation);

// Start of a vehicle: the origin of its frame and its heading.
struct Start {
  Vec3 position{0};    // m
  double heading = 0;  // rad, see direction_of
  Placement placement() const;
};

struct ArenaBody {
  SceneBody body;
  bool cuttable = false;  // otherwise beams end at it
};

// The content of an arena file; the initial values are the defaults of missing keys.
struct ArenaDescription {
  std::string name;
  double ground = 0;    // m, the height of the ground plane
  Vec2 size{100, 100};  // m along x and z, around the origin; a wall for all bodies
  std::vector<ArenaBody> bodies;
  std::map<std::string, Paint> paints;
  std::vector<Light> lamps;
  Start player;
  std::vector<Start> enemies;  // not empty
};

// Reads an arena file:
//
//   {"name": "yard", "ground": 0, "size": [90, 70],
//    "bodies": [{"mesh": "../meshes/ramp.obj", "name": "ramp", "position": [..], "orientation": [w,x,y,z],
//                "cuttable": false}],
//    "lamps": as the "lights" of scenes, "paints": as in scenes,
//    "starts": {"player": {"position": [..], "heading": 90}, "enemies": [{..}, {..}]}}
//
// A body may have its placement in an object "pose", and a "heading" in degrees instead of an orientation.
// Only "starts" is required. Fails with bad input, with the file and the JSON pointer. Does not read meshes.
Result<ArenaDescription> read_arena(const std::filesystem::path& file);

// An arena with its meshes loaded. Cuttable bodies sleep until something touches them; the others are
// pinned.
struct Arena {
  ArenaDescription description;
  std::vector<ModelBody> bodies;  // in the order of the description
};

// Loads each mesh once. Fails like load_body, and if a joint does not fit. `progress` may be null.
Result<Arena> load_arena(ArenaDescription description, const Progress* progress = nullptr);

// Cosine of the steepest slope on which a vehicle drives.
inline constexpr double kDrivable = 0.7;

// The faces of the fixed bodies of an arena, in the world [m]. O(faces).
std::vector<Triangle> fixed_faces(const Arena& arena);

// Returns true if a vehicle can drive on a face; false for a face without area.
bool is_drivable(const Triangle& t);

// The drivable space of an arena: a grid of spots on two floors. The lower floor is the ground; the upper
// one is the highest slope below kHighest, such as ramps and bridges, without parapets. A spot is blocked if
// a fixed body leaves no room for a vehicle above it, or if it cannot be reached from the start of the
// player.
class FreeSpace {
 public:
  static constexpr double kCell = 0.75;    // m
  static constexpr double kFar = 3;        // m, the largest clearance
  static constexpr double kHighest = 5;    // m, above the ground
  static constexpr double kVehicle = 1.0;  // m, the clearance that a vehicle needs

  FreeSpace() = default;
  // O(area of the faces + spots).
  explicit FreeSpace(const Arena& arena);

  // Index of a spot, by floor and grid cell, below spots().
  using Spot = uint32_t;
  uint32_t spots() const { return 2 * cells(); }
  // The spot at a place, or the nearest one of the grid; on the upper floor, unless the place lies below
  // it.
  Spot spot_at(const Vec3& p) const;
  // The centre of a spot, at the height of its floor.
  Vec3 place_of(Spot spot) const;
  // The distance to blocked spots and drops [m], at most kFar; 0 on blocked spots.
  double clearance(Spot spot) const { return clearance_[spot]; }
  bool has_room(Spot spot) const { return clearance_[spot] >= kVehicle; }
  // The nearest spot with room within `reach` [m] of a place; spots() if there is none.
  Spot with_room_near(const Vec3& p, double reach) const;

  // Calls visit(spot, metres) for each neighbour to which a vehicle could drive if there were room.
  template <typename Visit>
  void for_each_beside(Spot spot, Visit visit) const {
    const bool upper = spot >= cells();
    const int x = static_cast<int>(spot % cells()) % columns_,
              z = static_cast<int>(spot % cells()) / columns_;
    for (int dz = -1; dz <= 1; ++dz) {
      for (int dx = -1; dx <= 1; ++dx) {
        if ((dx == 0 && dz == 0) || !is_inside(x + dx, z + dz)) continue;
        const double metres = dx != 0 && dz != 0 ? kDiagonal : kCell;
        for (const bool to_upper : {false, true}) {
          const Spot to = spot_of(x + dx, z + dz, to_upper);
          if ((upper || to_upper) && !is_step(spot, to)) continue;
          visit(to, metres);
        }
      }
    }
  }

 private:
  static constexpr double kDiagonal = 1.0606601717798212;  // m, of a cell
  uint32_t cells() const { return static_cast<uint32_t>(columns_ * rows_); }
  bool is_inside(int x, int z) const { return x >= 0 && x < columns_ && z >= 0 && z < rows_; }
  Spot spot_of(int x, int z, bool upper) const {
    return static_cast<Spot>(z * columns_ + x) + (upper ? cells() : 0);
  }
  bool is_step(Spot from, Spot to) const;
  bool has_floor(Spot spot) const;
  bool is_parapet(Spot spot) const;
  int column(double x) const;
  int row(double z) const;

  void find_upper_floor(const std::vector<Triangle>& faces);
  void find_blocked(const std::vector<Triangle>& faces, std::vector<bool>& blocked) const;
  bool is_at_drop(int x, int z) const;
  void measure(const std::vector<bool>& blocked);
  void forget_unreachable(const Vec3& start);

  double ground_ = 0;
  Vec2 half_{0};
  int columns_ = 0, rows_ = 0;
  std::vector<double> heights_;   // m, by cell, of the upper floor, or of the ground if there is none
  std::vector<float> clearance_;  // by spot
};

// The steep fixed faces of an arena, with which vehicles collide.
class Obstacles {
 public:
  Obstacles() = default;
  // O(faces).
  explicit Obstacles(const Arena& arena);

  struct Touch {
    Vec3 at{0};           // m, the nearest point of a steep face
    double distance = 0;  // m, from it to the centre of the ball, > 0
  };
  // The deepest contact of a ball with a steep face from the side. Ignores faces below the centre by more
  // than the steepest drivable slope. Usually constant time.
  std::optional<Touch> touched_by(const Vec3& centre, double radius) const;

 private:
  static constexpr double kCell = 2;  // m
  int column(double x) const { return static_cast<int>((x + half_.x) / kCell); }
  int row(double z) const { return static_cast<int>((z + half_.y) / kCell); }
  struct Cells {
    int left, right, low, high;
  };
  Cells cells_between(const Vec3& low, const Vec3& high) const;

  Vec2 half_{0};  // m, of the arena
  int columns_ = 0, rows_ = 0;
  std::vector<Triangle> faces_;
  std::vector<std::vector<uint32_t>> in_cell_;  // indices of faces, ascending
};

}  // namespace kerf
