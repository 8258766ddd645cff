#pragma once

#include <memory>
#include <vector>

#include "core/game/arena/free_space.h"
#include "core/game/arena/obstacles.h"
#include "core/game/arena/sight.h"
#include "core/game/driver/pilot.h"
#include "core/game/laser/fire.h"
#include "core/game/match/event.h"
#include "core/game/match/joint_faces.h"
#include "core/game/match/rules.h"
#include "core/game/match/stale_colliders.h"
#include "core/game/vehicle/damage.h"
#include "core/physics/physics.h"
#include "core/world/delta.h"

namespace kerf {

struct MatchSetup {
  std::shared_ptr<const Rules> rules;  // not null
  uint64_t seed = 1;
  Difficulty difficulty = Difficulty::kNormal;
};

// How a match stands.
struct Standing {
  enum class Phase {
    kFight,
    kPause,  // a wave is cleared, the next one comes soon
    kWon,
    kLost,
    kEnded,  // neither: the time of a sandbox is over
  };
  Phase phase = Phase::kFight;
  size_t wave = 0;       // from 0
  Ticks ticks = 0;       // since the beginning
  Ticks pause_left = 0;  // of kPause
  double score = 0;
  size_t enemies_destroyed = 0;
  size_t wheels_lost = 0;  // of the player's vehicles
  size_t pieces = 0;       // that came off bodies
  size_t faces_removed = 0;
  bool over() const { return phase != Phase::kFight && phase != Phase::kPause; }
};

// How a match stands where a wave begins: all that a wave depends on besides the setup of the match.
struct WaveStart {
  Standing standing;
  Placement player;    // of the player's vehicle
  size_t strokes = 0;  // of the player before
};

// A match: the player's vehicle against waves of enemies in an arena.
//
// It owns its world. A tick turns the controls of all drivers into forces and beams, moves the bodies, cuts,
// makes what came off bodies of their own, and reads from the meshes what the vehicles have lost. The result
// is a function of the setup and of the player's controls: the same ones give the same world, to the bit, on
// one kind of machine. A wave begins with a world that is made anew, so that memory does not grow: the
// player's vehicle is whole again where it was, and wrecks and pieces are gone.
class Match {
 public:
  explicit Match(MatchSetup setup);
  // Goes on where a wave of a match with the same setup began. Precondition: the wave exists.
  Match(MatchSetup setup, const WaveStart& start);

  // Advances by 1/120 s. Does nothing once it is over.
  void tick(const Controls& player);

  const Rules& rules() const { return *setup_.rules; }
  const MatchSetup& setup() const { return setup_; }
  const Standing& standing() const { return standing_; }
  // Where the present wave began.
  const WaveStart& wave_start() const { return wave_start_; }
  // The seconds that are left to win.
  double seconds_left() const;
  // How often the player switched the beam on.
  size_t strokes() const { return strokes_; }

  const World& world() const { return world_; }
  const Physics& physics() const { return physics_; }
  // The vehicles of the wave, the player's first, then its enemies.
  static constexpr size_t kPlayer = 0;
  const std::vector<Vehicle>& vehicles() const { return vehicles_; }
  // The index of the vehicle that a body is or is carried by, or Event::kNobody.
  size_t vehicle_of(BodyId body) const;
  // Whether a body stops a beam.
  bool is_wall(BodyId body) const;

  // What the last tick changed in the world, and what happened in it.
  const Delta& delta() const { return delta_; }
  const std::vector<Event>& events() const { return events_; }

  // What the driver of a vehicle sees. `sight` must be of world(), as it is.
  DriverView view(size_t vehicle, const Sight& sight) const;

 private:
  void begin_wave(size_t wave, const Placement& player);
  void take_controls(const Controls& player, const Sight& sight);
  void take_turns();
  std::vector<Guided> guided() const;
  void move_bodies(PlacementsBefore& before);
  void keep_inside();
  void note_impacts(const std::vector<Vec3>& velocities);
  std::vector<Vec3> velocities() const;
  void fire_beams(const PlacementsBefore& before);
  void note_cut(size_t shooter, const std::map<BodyId, StepResult>& cut);
  void separate();
  void note_piece(const Detached& piece, std::vector<BodyId>& crumbs);
  void assess();
  void note_damage(size_t vehicle, const Damage& damage);
  void recover();
  void cool_bodies();
  void clear_debris();
  void remove(const std::vector<BodyId>& bodies);
  void judge();
  void follow(Delta change);
  void make_colliders();
  void renew_colliders();
  Delta news_for_physics(const Delta& change) const;
  // Tells of something that happened to a vehicle, with points if the player did it to an enemy.
  void tell(Event event, double points = 0);

  static constexpr uint32_t kGeneration = 0;  // of all bodies, for slots are never used again within a wave

  MatchSetup setup_;
  Obstacles obstacles_;
  FreeSpace space_;
  Standing standing_;
  WaveStart wave_start_;
  World world_;
  Physics physics_;
  StaleColliders stale_colliders_;
  JointFaces joint_faces_;
  std::vector<BodyId> lost_joint_faces_;  // which the physics does not know yet
  std::vector<BodyId> arena_;             // by index of the bodies of the arena
  std::vector<Vehicle> vehicles_;
  std::vector<Disc> traffic_;    // as it was when drivers last looked around
  std::vector<Pilot> pilots_;    // of the enemies
  std::vector<size_t> enemies_;  // indices of vehicles
  // What is known of a vehicle besides its state.
  struct Record {
    size_t last_cut_by = Event::kNobody;
    size_t first_stroke = 0;  // of the player that cut it, from 1; 0 if none did
    bool changed = false;     // faces of it changed since it was last assessed
    bool lost_piece = false;  // likewise, a piece came off
  };
  std::vector<Record> records_;  // by vehicle
  size_t strokes_ = 0;           // how often the player switched the beam on
  Delta delta_;
  std::vector<Event> events_;
};

}  // namespace kerf
