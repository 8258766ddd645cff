#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/base/assert.h"
#include "core/document/stroke_path.h"
#include "core/world/world.h"
#include "ui/editor/shared/viewport.h"

struct ImDrawList;

namespace kerf {

// A point of a path: a key of one of its strokes.
struct PathPoint {
  size_t stroke = 0, key = 0;
  friend bool operator==(const PathPoint&, const PathPoint&) = default;
};

// The laser path that the user edits, with its own undo. In addition to its key, each point has the distance
// from the origin of the beam to its target, where the point is drawn.
class PathWork {
 public:
  const std::vector<StrokePath>& strokes() const { return now_.strokes; }
  bool empty() const { return now_.strokes.empty(); }
  size_t points() const;
  bool has(PathPoint p) const {
    return p.stroke < now_.strokes.size() && p.key < now_.strokes[p.stroke].keys.size();
  }
  // Precondition of all functions that take a point: the path has it.
  const Pose& pose(PathPoint p) const {
    KERF_ASSERT(has(p));
    return now_.strokes[p.stroke].keys[p.key];
  }
  double distance(PathPoint p) const {
    KERF_ASSERT(p.stroke < now_.distances.size() && p.key < now_.distances[p.stroke].size());
    return now_.distances[p.stroke][p.key];
  }
  // One per key of each stroke [m].
  const std::vector<std::vector<double>>& distances() const { return now_.distances; }
  Vec3 target(PathPoint p) const { return pose(p).origin + pose(p).direction * distance(p); }

  // Speed of the origin of the beam [m/s]: the one set, else the mean speed of the path, or 0 if it does not
  // move.
  double speed() const;
  // Returns true if the times of the points are those of the loaded file.
  bool has_times_of_file() const { return !empty() && !now_.speed; }

  const std::optional<PathPoint>& selected() const { return selected_; }
  void select(std::optional<PathPoint> point) {
    KERF_ASSERT(!point || has(*point));
    selected_ = point;
  }

  // Begins an undo step, which contains all edits until the next call.
  void begin_edit();
  // Edits. Precondition of all: begin_edit() was called, or the path is new. Directions are results of
  // beam_direction(), i.e. unit vectors.
  //
  // Adds a point after the selected one, or at the end, and selects it. A first point, or any with
  // `new_stroke`, begins a stroke with a beam of this radius [m]. An empty path gets this speed [m/s]; a new
  // stroke of a path with the times of its file gets the mean speed of the path.
  void add(const Pose& pose, double distance, bool new_stroke, double radius, double speed);
  void set(PathPoint point, const Pose& pose, double distance);
  // Removes a point, and its stroke with its last point. Selects the previous point.
  void remove(PathPoint point);
  void set_radius(size_t stroke, double radius);
  void set_speed(double speed);
  // Adds strokes; they replace the selected point if it is a stroke of its own. Their points aim at the
  // surfaces of the world, or have this distance [m] if their beams hit nothing. A path of these strokes
  // alone gets this speed [m/s] unless another one was set; else the strokes get the speed of the path.
  void add_strokes(const std::vector<StrokePath>& strokes, const World& world, double distance, double speed);
  // Replaces the path by that of a file. Its points aim at the surfaces of the world.
  void load(std::vector<StrokePath> strokes, const World& world);
  void clear() { replace({}); }
  // Replaces the path by a stored one. `speed`: the one set, if any. Precondition: as many distances as keys
  // in each stroke.
  void restore(std::vector<StrokePath> strokes, std::vector<std::vector<double>> distances,
               std::optional<double> speed) {
    replace({std::move(strokes), std::move(distances), speed});
  }

  bool can_undo() const { return !undone_to_.empty(); }
  bool can_redo() const { return !redone_to_.empty(); }
  void undo();
  void redo();

  // File that the path was loaded from or saved to; empty: none.
  const std::filesystem::path& file() const { return file_; }
  void record_file(std::filesystem::path file) { file_ = std::move(file); }
  // Counter that increases with each change of the path.
  size_t changes() const { return changes_; }

  // Records that the path was run at this position of the document history. Until the next edit of the path,
  // only positions up to this one are older than its last edit.
  void record_run(size_t position) { run_at_ = position; }
  bool was_run() const { return run_at_.has_value(); }  // since its last edit
  bool is_newer_than(size_t position) const { return !run_at_ || position <= *run_at_; }

 private:
  struct Version {
    std::vector<StrokePath> strokes;
    std::vector<std::vector<double>> distances;  // one per key [m]
    std::optional<double> speed;                 // as set [m/s]
  };
  void replace(Version version);
  void keep_speed(size_t stroke);
  double speed_or(double other) const;  // speed(), or another one if the path does not move

  Version now_;
  std::vector<Version> undone_to_, redone_to_;
  std::optional<PathPoint> selected_;
  std::filesystem::path file_;
  size_t changes_ = 0;
  std::optional<size_t> run_at_;
};

// Writes the entry of the path in the head of a document: {"strokes": as in a path file, "distances": [[..],
// ..], "speed": m/s, if set}; null for an empty path.
nlohmann::json path_entry(const PathWork& path);

// Reads such an entry. Returns an empty path if it is invalid. Without distances, the points aim at the
// surfaces of the world.
PathWork path_of_entry(const nlohmann::json& entry, const World& world);

// A visible point of the path in the first half. Places are in the window, in screen coordinates.
struct PathMark {
  PathPoint point;
  size_t number = 0;    // from 0, over all strokes
  Vec2 target{0};       // place of the target
  bool hidden = false;  // behind a surface
};

// Returns the points to draw: those in front of the eye, except those whose dot would cover that of the
// previous one.
std::vector<PathMark> path_marks(const PathWork& path, const World& world, const PrimaryViewport& picture);

// Handle that turns the beam of the selected point: a knob on its beam, towards its origin.
struct PathKnob {
  Vec3 at{0};           // world [m]
  double distance = 0;  // from the target [m]
  Vec2 place{0};
};
std::optional<PathKnob> path_knob(const PathWork& path, const PrimaryViewport& picture);

// Hit test at a place: the dot of a point, or the knob of the selected one if that is nearer.
struct PathGrip {
  PathPoint point;
  bool is_knob = false;
};
std::optional<PathGrip> path_grip(const PathWork& path, const World& world, const PrimaryViewport& picture,
                                  Vec2 at);

// Draws the path: lines and dots on the surface, an arrow for the beam of each point, and the knob of the
// selected one. Parts behind a surface are drawn faintly.
void draw_path(const PathWork& path, const World& world, const PrimaryViewport& picture, ImDrawList& list);

// Left button of the Path tool. A press on a surface adds a point there, which the drag moves; its beam is
// perpendicular to the surface. Dragging a dot moves its point over the surfaces and keeps the angle of its
// beam to them. Dragging the knob turns the beam of the selected point about its target. `pointer` is in the
// window, in screen coordinates. The drag ends if its point is deleted.
class PathTool {
 public:
  struct Beam {
    double radius = 0.01;  // [m]
    double height = 0.1;   // of its origin over the surface [m]
    double speed = 1;      // of a path that begins with it [m/s]
  };

  // Returns the default beam for a world, with this radius [m].
  static Beam beam_for(const World& world, double radius);

  // Returns the reason if nothing happened, else an empty text.
  std::string press(PathWork& path, const World& world, const ViewState& view, Vec2 pointer, bool new_stroke,
                    const Beam& beam);
  void move(PathWork& path, const World& world, const ViewState& view, Vec2 pointer);
  void release() { grip_ = Grip::kNone; }

 private:
  enum class Grip { kNone, kTarget, kKnob };
  void take(const PathWork& path, Grip grip, bool edits, Vec2 pointer);
  void drag_target(PathWork& path, const World& world, const ViewState& view, Vec2 pointer) const;
  void drag_knob(PathWork& path, const ViewState& view, Vec2 pointer) const;

  Grip grip_ = Grip::kNone;
  bool edits_ = false;                // the drag has begun an undo step
  std::optional<PathPoint> dragged_;  // the selected point at the press
  size_t points_ = 0;                 // of the path at the press
  Vec2 pressed_at_{0};
};

}  // namespace kerf
