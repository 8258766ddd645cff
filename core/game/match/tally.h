#pragma once

#include <cstddef>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/ids.h"
#include "core/base/tick.h"
#include "core/cut/cut_step.h"
#include "core/game/match/rules.h"
#include "core/game/vehicle/damage.h"
#include "core/game/vehicle/vehicle.h"
#include "core/world/world.h"

namespace kerf {

// An event in a tick of a match, for the screen and for statistics.
struct Event {
  enum class Kind {
    kCut,         // a beam removed `size` kg of `body`
    kPieceOff,    // `body` came off, with an area of `size` m^2
    kCleanPart,   // that piece is a part that came off whole
    kWheelLost,   // `part` is the index of the wheel, `body` the wheel
    kTurretLost,  // `body` is the turret
    kBarrelLost,  // `body` is the barrel
    kVitalLost,   // `part` is the index of the vital part
    kInHalves,    // `body`, a piece of at least a quarter of the chassis, came off
    kKilled,
    kOverheated,   // the laser of `vehicle`
    kImpact,       // the velocity of `vehicle` changed by `size` m/s
    kRighted,      // `vehicle` was put upright, or moved from where it was stuck
    kWaveBegins,   // `part` is the number of the wave, from 0
    kWaveCleared,  // likewise
    kCarLost,      // the player's; `part` are left
    kWon,
    kLost,
  };
  static constexpr size_t kNobody = static_cast<size_t>(-1);

  Kind kind;
  size_t vehicle = kNobody;  // affected vehicle, an index of Match::vehicles()
  size_t by = kNobody;       // vehicle whose beam caused it
  size_t part = 0;
  BodyId body{};
  Vec3 at{0};  // m, in the world
  double size = 0;
  double points = 0;  // that the player got for it
};

struct Standing {
  enum class Phase {
    kFight,
    kPause,  // a wave is cleared, the next one follows soon
    kDown,   // the player's car is wrecked, the next one follows soon
    kWon,
    kLost,
    kEnded,  // neither: the time of a sandbox is up
  };
  Phase phase = Phase::kFight;
  size_t wave = 0;       // from 0
  Ticks ticks = 0;       // since the start
  Ticks aftermath = 0;   // since the match was over
  Ticks pause_left = 0;  // of kPause and kDown
  size_t cars_left = 0;  // of the player, not counting the current one
  double score = 0;
  size_t enemies_destroyed = 0;
  size_t wheels_lost = 0;  // of the player's vehicles
  size_t pieces = 0;       // that came off bodies
  size_t faces_removed = 0;
  bool over() const { return phase >= Phase::kWon; }
  Ticks elapsed() const { return ticks + aftermath; }
};

// Keeps the score of a match: cuts, points, and the state of the match. Vehicles are identified by their
// index in the wave; the player has index 0.
class Tally {
 public:
  static constexpr size_t kPlayer = 0;

  Tally() = default;
  // `scores`: the points of the rules, which must outlive it. `strokes`: see strokes().
  Tally(const Scores& scores, const Standing& standing, size_t strokes)
      : scores_(&scores), standing_(standing), strokes_(strokes) {}

  Standing& standing() { return standing_; }
  const Standing& standing() const { return standing_; }
  // The number of times that the player switched the beam on.
  size_t strokes() const { return strokes_; }
  void count_stroke() { ++strokes_; }
  const std::vector<Event>& events() const { return events_; }

  void begin_wave(size_t vehicles) { records_.assign(vehicles, Record{}); }
  void add_vehicle() { records_.emplace_back(); }
  void begin_tick() { events_.clear(); }

  // Adds an event of a vehicle, with points if the player caused it to an enemy.
  void add_event(Event event, double points = 0);
  // Records that the beam of a vehicle cut a body of the vehicle `victim` (Event::kNobody: of none).
  void record_cut(size_t shooter, size_t victim, BodyId id, const Body& body, const StepResult& cut);
  // Records that a piece came off a body of that vehicle (null: of none). `clean`: see is_clean.
  void record_piece(const Detached& piece, const Body& body, size_t victim, const Vehicle* vehicle,
                    bool clean);
  // Returns true once after a vehicle was cut or a piece came off it, i.e. if its damage must be read from
  // its meshes.
  bool takes_assessment(size_t vehicle);
  void record_damage(const World& world, size_t index, const Vehicle& vehicle, const Damage& damage);

 private:
  // Data of a vehicle in addition to its state.
  struct Record {
    size_t last_cut_by = Event::kNobody;
    size_t first_stroke = 0;  // of the player that cut it, from 1; 0 if none did
    bool changed = false;     // faces of it changed, or a piece came off, since the last assessment
  };
  const Scores* scores_ = nullptr;
  Standing standing_;
  size_t strokes_ = 0;
  std::vector<Record> records_;  // by vehicle
  std::vector<Event> events_;
};

// The centre of the bounding box of a body in the world [m].
Vec3 middle_of(const Body& body);

}  // namespace kerf
