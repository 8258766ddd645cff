#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "ui/editor/shared/gizmo.h"

struct ImDrawList;

namespace kerf {

// The pace at which the emitter fires in shots: shots are due at equal times on one clock, and those that
// nobody took in time are left out, so that slow frames make gaps and no bursts.
class FirePace {
 public:
  static constexpr double kSlowest = 0.1, kFastest = 60;  // shots a second

  double per_second() const { return per_second_; }
  // Limited to the slowest and the fastest pace.
  void set(double per_second);

  // The next shot is due at once.
  void begin() { last_.reset(); }
  // `now` (s) is of a clock that never goes back.
  bool is_due(double now) const;
  // A shot was fired. Precondition: it was due.
  void take(double now);

 private:
  double per_second_ = 4;
  std::optional<double> last_;  // when the last shot was due, s
};

// A part of the emitter that is dragged: the arrows that move it along an axis of the world, the emitter
// itself, which moves parallel to the picture, and the place that it aims at. Their names: "emitter X",
// "emitter body", "emitter target".
struct EmitterHandle : GizmoHandle {
  enum class Part { kX, kY, kZ, kBody, kTarget };
  Part part = Part::kBody;
};

// A laser that stands in the scene and fires while it is switched on, with the settings of the Laser panel.
class Emitter {
 public:
  bool placed() const { return placed_; }
  // Places it at a point of the world (m), aimed at another one. Precondition: they differ.
  void place(const Vec3& at, const Vec3& target);
  // Takes it out of the scene. A stroke that is being drawn has to be ended by whoever draws it.
  void remove() { placed_ = firing = false; }

  const Vec3& at() const { return at_; }
  const Vec3& target() const { return target_; }
  double distance() const { return glm::length(target_ - at_); }
  Pose pose() const;

  // Moves the emitter, which goes on to aim at the same place, or aims it anew. Nothing changes where the two
  // would meet.
  void stand_at(const Vec3& at);
  void aim_at(const Vec3& target);

  // Whether the user has switched it on.
  bool firing = false;
  // Whether its stroke is being drawn, for whoever draws it.
  bool drawing = false;
  // Whether it fires single shots, each a stroke that stands still, and not one stroke without a break.
  bool in_shots = false;
  FirePace pace;

  // Dragging a part. Precondition of drag(): take() was called.
  void take(EmitterHandle::Part part, Vec2 pointer);
  void drag(const FirstPicture& picture, Vec2 pointer, const std::optional<Vec3>& surface);

 private:
  bool placed_ = false;
  Vec3 at_{0}, target_{0, 0, -1};  // m
  EmitterHandle::Part held_ = EmitterHandle::Part::kBody;
  Vec2 pressed_at_{0};
  Vec3 held_at_{0};  // where the emitter stood
};

// Places the emitter above and to the right of the line from a point to the eye, at this distance (m, > 0)
// from the point at which it aims.
void place_in_view(Emitter& emitter, const CameraView& view, const Vec3& target, double distance);

// The handles; none where it is not placed or behind the eye.
std::vector<EmitterHandle> emitter_handles(const Emitter& emitter, const FirstPicture& picture);

// Draws the emitter, its line of aim and its handles; the one at `pointer` is highlighted.
void draw_emitter(const Emitter& emitter, const FirstPicture& picture, Vec2 pointer, ImDrawList& list);

// The key of the emitter in the head of a document.
inline constexpr const char* kEmitterKey = "emitter";

// The entry of the emitter in the head of a document: {"at": [x, y, z], "target": [x, y, z] (m), "in_shots",
// "pace": shots/s}; null where none stands in the scene.
nlohmann::json emitter_entry(const Emitter& emitter);

// The emitter of such an entry, switched off; one that is not placed where the entry cannot be read.
Emitter emitter_of_entry(const nlohmann::json& entry);

}  // namespace kerf
