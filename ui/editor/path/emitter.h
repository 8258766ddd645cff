#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "ui/editor/shared/gizmo.h"
#include "ui/editor/shared/laser_controls.h"

struct ImDrawList;

namespace kerf {

// Schedule of pulsed fire. Shots are due at equal intervals; overdue shots are dropped, so that slow frames
// cause gaps rather than bursts.
class FirePace {
 public:
  static constexpr double kSlowest = 0.1, kFastest = 60;  // shots/s

  double per_second() const { return per_second_; }
  // Sets the pace, limited to kSlowest .. kFastest.
  void set(double per_second);

  // Makes the next shot due immediately.
  void begin() { last_.reset(); }
  // Returns true if a shot is due at `now` [s], on a monotonic clock.
  bool is_due(double now) const;
  // Records a shot. Precondition: is_due(now).
  void take(double now);

 private:
  double per_second_ = 4;
  std::optional<double> last_;  // due time of the last shot [s]
};

// A handle of the emitter: an arrow that moves it along a world axis, its body, which moves parallel to the
// screen, or its target. Landmarks: "emitter X", "emitter body", "emitter target".
struct EmitterHandle : GizmoHandle {
  enum class Part { kX, kY, kZ, kBody, kTarget };
  Part part = Part::kBody;
};

// A laser placed in the scene. It fires while switched on, with the settings of the Laser panel.
class Emitter {
 public:
  bool placed() const { return placed_; }
  // Places the emitter at a point and aims it at another one [m, world]. Precondition: the points differ.
  void place(const Vec3& at, const Vec3& target);
  // Removes it from the scene. The caller ends a stroke in progress.
  void remove() { placed_ = firing = false; }

  const Vec3& at() const { return at_; }
  const Vec3& target() const { return target_; }
  double distance() const { return glm::length(target_ - at_); }
  Pose pose() const;

  // Moves the emitter and keeps its target, or changes the target. No-op if both would coincide. A drag in
  // progress continues from the new position.
  void move_to(const Vec3& at);
  void aim_at(const Vec3& target);

  // The user has switched it on.
  bool firing = false;
  // Its stroke is being drawn; for use by the caller.
  bool drawing = false;
  // Fires single shots, each a stroke at a fixed place; else one continuous stroke.
  bool in_shots = false;
  FirePace pace;

  // Drag of a handle. Precondition of drag(): take() was called.
  void take(EmitterHandle::Part part, Vec2 pointer);
  void drag(const PrimaryViewport& picture, Vec2 pointer, const std::optional<Vec3>& surface);

 private:
  bool placed_ = false;
  Vec3 at_{0}, target_{0, 0, -1};  // m
  EmitterHandle::Part held_ = EmitterHandle::Part::kBody;
  Vec2 pressed_at_{0};
  Vec3 held_at_{0};  // position of the emitter at the press
};

// Places the emitter above and to the right of the line from `target` to the eye, at this distance [m, > 0]
// from the target.
void place_in_view(Emitter& emitter, const CameraView& view, const Vec3& target, double distance);

// Returns the handles, or none if the emitter is not placed or lies behind the eye.
std::vector<EmitterHandle> emitter_handles(const Emitter& emitter, const PrimaryViewport& picture);

// Draws the emitter, its line of aim and its handles, with the handle at `pointer` highlighted.
void draw_emitter(const Emitter& emitter, const PrimaryViewport& picture, Vec2 pointer, ImDrawList& list);

// Writes the entry of the emitter in the head of a document: {"at": [x, y, z], "target": [x, y, z] (m),
// "in_shots", "pace": shots/s}; null if no emitter is placed.
nlohmann::json emitter_entry(const Emitter& emitter);

// Reads such an entry. The emitter is switched off, and not placed if the entry is invalid.
Emitter emitter_of_entry(const nlohmann::json& entry);

}  // namespace kerf
