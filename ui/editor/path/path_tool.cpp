#include "ui/editor/path/path_tool.h"

#include <imgui.h>
#include <cmath>

#include "core/base/geometry.h"
#include "core/base/json.h"
#include "ui/editor/shared/gizmo.h"
#include "ui/editor/shared/viewport_pointer.h"
#include "ui/render/passes/beam_effects.h"
#include "ui/window/theme.h"
#include "ui/window/widgets.h"

namespace kerf {

namespace {

constexpr size_t kMaxSteps = 200;  // undo steps

// Returns the distance to the first surface that the beam hits, else to the plane through the centre of the
// world perpendicular to it.
double distance_to_surface(const World& world, const Pose& pose) {
  if (const auto hit = first_hit(world, pose)) return *hit;
  const World::Bounds bounds = world.bounds();
  const double middle = glm::dot(0.5 * (bounds.min + bounds.max) - pose.origin, pose.direction);
  return middle > 0 ? middle : std::max(bounds.diagonal(), 1e-9) / 16;
}

constexpr const char* kDistancesKey = "distances";
constexpr const char* kSpeedKey = "speed";

// Returns one number per point, which is 0 for a beam that begins on a surface, or nullopt if the entry is
// invalid.
std::optional<std::vector<std::vector<double>>> distances_of(const nlohmann::json& json,
                                                             const std::vector<StrokePath>& strokes) {
  if (!json.is_array() || json.size() != strokes.size()) return std::nullopt;
  std::vector<std::vector<double>> distances;
  for (size_t i = 0; i < strokes.size(); ++i) {
    if (!json[i].is_array() || json[i].size() != strokes[i].keys.size()) return std::nullopt;
    std::vector<double>& of_stroke = distances.emplace_back();
    for (const nlohmann::json& number : json[i]) {
      if (!number.is_number() || !std::isfinite(number.get<double>()) || number.get<double>() < 0)
        return std::nullopt;
      of_stroke.push_back(number.get<double>());
    }
  }
  return distances;
}

std::optional<double> speed_of(const nlohmann::json& json) {
  if (!json.is_number() || !std::isfinite(json.get<double>()) || json.get<double>() <= 0) return std::nullopt;
  return json.get<double>();
}

constexpr float kDot = 4.5f, kKnob = 6;  // screen coordinates
constexpr double kMarkReach = 9;         // screen coordinates
constexpr double kMinApart = 14;         // of dots, screen coordinates
constexpr double kMarkArrowEms = 3, kKnobEms = 5.5;
constexpr double kNearEnough = 0.998;  // of the depth of a point, from which on a surface does not hide it
constexpr size_t kMaxLookedFor = 600;  // points, above which occlusion is not tested
constexpr size_t kMaxNumbered = 40;
constexpr size_t kMaxFollowed = 64;  // segments, above which lines do not follow the surface
constexpr int kParts = 12;           // of a segment that follows the surface

constexpr ImU32 kMarkShade = IM_COL32(10, 12, 16, 150);

ImU32 faded(ImU32 colour, bool hidden) {
  return hidden ? (colour & ~IM_COL32_A_MASK) | (IM_COL32_A_MASK & IM_COL32(0, 0, 0, 80)) : colour;
}

bool is_hidden(const World& world, const PrimaryViewport& picture, const Vec3& p, Vec2 place) {
  const Pose ray = picture.ray(place);
  const auto hit = first_hit(world, ray);
  return hit && *hit < kNearEnough * glm::dot(p - ray.origin, ray.direction);
}

// Returns where the beam hits the surface between two points of a stroke; where the surface is cut away, an
// estimate of where it was.
Vec3 target_between(const PathWork& path, const World& world, PathPoint a, PathPoint b, double share) {
  const Vec3 origin = glm::mix(path.pose(a).origin, path.pose(b).origin, share);
  const Vec3 mixed = glm::mix(path.pose(a).direction, path.pose(b).direction, share);
  const double length = glm::length(mixed);
  if (!(length > 0)) return origin;
  const double distance = glm::mix(path.distance(a), path.distance(b), share);
  const auto hit = first_hit(world, {origin, mixed / length});
  const double reach = 0.5 * distance + 0.25 * glm::length(path.target(b) - path.target(a));
  const bool near = hit && std::abs(*hit - distance) < reach;
  return origin + mixed * ((near ? *hit : distance) / length);
}

void line_twice(ImDrawList& list, Vec2 from, Vec2 to, ImU32 colour, float width) {
  list.AddLine(to_im(from), to_im(to), kMarkShade, width + 2.2f);
  list.AddLine(to_im(from), to_im(to), colour, width);
}

void draw_segment(const PathWork& path, const World& world, PathPoint a, PathPoint b,
                  const PrimaryViewport& picture, ImU32 colour, ImDrawList& list) {
  const int parts = path.points() <= kMaxFollowed ? kParts : 1;
  std::vector<ImVec2> line;
  for (int i = 0; i <= parts; ++i) {
    const double share = static_cast<double>(i) / parts;
    const Vec3 p = i == 0       ? path.target(a)
                   : i == parts ? path.target(b)
                                : target_between(path, world, a, b, share);
    if (const auto place = picture.place_of(p)) line.push_back(to_im(*place));
  }
  const auto count = static_cast<int>(line.size());
  list.AddPolyline(line.data(), count, kMarkShade, 0, 3.8f);
  list.AddPolyline(line.data(), count, colour, 0, 1.6f);
}

void draw_lines(const PathWork& path, const World& world, const PrimaryViewport& picture, ImDrawList& list) {
  for (size_t i = 0; i < path.strokes().size(); ++i) {
    const bool selected = path.selected() && path.selected()->stroke == i;
    const ImU32 colour = selected ? colours::kPictureText : colours::kPictureSecondary;
    for (size_t k = 1; k < path.strokes()[i].keys.size(); ++k)
      draw_segment(path, world, {i, k - 1}, {i, k}, picture, colour, list);
  }
}

// Draws the end of the beam of a point, with an arrowhead at its target.
void draw_arrow(const PathWork& path, const PathMark& mark, const PrimaryViewport& picture, double ems,
                ImU32 colour, ImDrawList& list) {
  const Vec3 target = path.target(mark.point);
  const double length = std::min(path.distance(mark.point), ems * picture.metres_of_em(target));
  const auto tail = picture.place_of(target - path.pose(mark.point).direction * length);
  if (!tail || glm::length(mark.target - *tail) < 2.0 * kDot) return;
  const Vec2 along = glm::normalize(mark.target - *tail), across(-along.y, along.x);
  const Vec2 tip = mark.target - along * (kDot + 1.0), base = tip - along * 7.0;
  line_twice(list, *tail, base, colour, 1.3f);
  list.AddTriangleFilled(to_im(tip), to_im(base + across * 3.5), to_im(base - across * 3.5), colour);
}

// Draws one arrow for several points that are close together and have parallel beams.
void draw_arrows(const PathWork& path, const std::vector<PathMark>& marks, const PrimaryViewport& picture,
                 ImDrawList& list) {
  const PathMark* before = nullptr;
  for (const PathMark& mark : marks) {
    const bool selected = path.selected() == mark.point;
    const bool close = before != nullptr && before->point.stroke == mark.point.stroke &&
                       glm::length(before->target - mark.target) < kMarkArrowEms * picture.em() &&
                       path.pose(before->point).direction == path.pose(mark.point).direction;
    if (close && !selected) continue;
    before = &mark;
    const ImU32 colour = selected ? colours::accent() : colours::kPictureSecondary;
    draw_arrow(path, mark, picture, selected ? kKnobEms : kMarkArrowEms,
               faded(colour, (mark.hidden || path.was_run()) && !selected), list);
  }
}

// Draws a dot, small and faint if it is not selected and its path was run.
void draw_dot(const PathMark& mark, bool selected, bool numbered, bool was_run, ImDrawList& list) {
  const bool past = was_run && !selected;
  const ImU32 colour =
      faded(selected ? colours::accent() : colours::kPictureText, (mark.hidden || past) && !selected);
  if (past) return list.AddCircleFilled(to_im(mark.target), 0.6f * kDot, colour);
  list.AddCircleFilled(to_im(mark.target), kDot + 1.8f, kMarkShade);
  list.AddCircleFilled(to_im(mark.target), kDot, colour);
  if (!numbered) return;
  const std::string number = std::to_string(mark.point.key + 1);
  const ImVec2 at = to_im(mark.target + Vec2(kDot + 4, kDot));
  list.AddText({at.x + 1, at.y + 1}, IM_COL32(10, 12, 16, 220), number.c_str());
  list.AddText(at, colour, number.c_str());
}

void draw_knob(const PathKnob& knob, ImDrawList& list) {
  list.AddCircleFilled(to_im(knob.place), kKnob + 1.8f, kMarkShade);
  list.AddCircleFilled(to_im(knob.place), kKnob, IM_COL32(0x1b, 0x1f, 0x26, 255));
  list.AddCircle(to_im(knob.place), kKnob, colours::accent(), 0, 2);
}

constexpr double kMinDrag = 3;  // screen coordinates; less is a click that selects

// Returns the normal of the surface at the target of a point, as seen from its origin; opposite to its beam
// if there is no surface.
Vec3 normal_under(const PathWork& path, const World& world, const ViewState& view, PathPoint point) {
  const Pose& pose = path.pose(point);
  const auto surface = surface_point(world, view.look, pose);
  const bool there = surface && glm::length(surface->at - path.target(point)) < 0.01 * path.distance(point);
  return there ? surface->normal : -pose.direction;
}

}  // namespace

size_t PathWork::points() const {
  size_t points = 0;
  for (const StrokePath& stroke : strokes()) points += stroke.keys.size();
  return points;
}

double PathWork::speed() const {
  if (now_.speed) return *now_.speed;
  double way = 0, duration = 0;
  for (const StrokePath& stroke : strokes()) {
    way += way_of(stroke);
    duration += duration_of(stroke);
  }
  return duration > 0 ? way / duration : 0;
}

void PathWork::begin_edit() {
  undone_to_.push_back(now_);
  if (undone_to_.size() > kMaxSteps) undone_to_.erase(undone_to_.begin());
  redone_to_.clear();
  ++changes_;
  run_at_.reset();
}

void PathWork::keep_speed(size_t stroke) {
  if (now_.speed) retime(now_.strokes[stroke], *now_.speed);
}

double PathWork::speed_or(double other) const {
  const double own = speed();
  return own > 0 ? own : other;
}

void PathWork::add(const Pose& pose, double distance, bool new_stroke, double radius, double speed) {
  const double mean = speed_or(speed);
  if (empty()) now_.speed = speed;
  size_t stroke = selected_ ? selected_->stroke : now_.strokes.size() - 1;
  if (empty() || new_stroke) {
    stroke = now_.strokes.size();
    now_.strokes.emplace_back().radius = radius;
    now_.distances.emplace_back();
  }
  const size_t keys = now_.strokes[stroke].keys.size();
  const size_t at = selected_ && selected_->stroke == stroke ? selected_->key + 1 : keys;
  insert_key(now_.strokes[stroke], at, pose);
  std::vector<double>& distances = now_.distances[stroke];
  distances.insert(distances.begin() + static_cast<std::ptrdiff_t>(at), distance);
  keep_speed(stroke);
  if (!now_.speed && keys == 1) retime(now_.strokes[stroke], mean);  // a single point states no speed
  selected_ = PathPoint{stroke, at};
}

void PathWork::set(PathPoint p, const Pose& pose, double distance) {
  KERF_ASSERT(has(p) && is_unit(pose.direction));
  now_.strokes[p.stroke].keys[p.key] = pose;
  now_.distances[p.stroke][p.key] = distance;
  ++changes_;
  keep_speed(p.stroke);
}

void PathWork::remove(PathPoint p) {
  KERF_ASSERT(has(p));
  StrokePath& stroke = now_.strokes[p.stroke];
  std::vector<double>& distances = now_.distances[p.stroke];
  erase_key(stroke, p.key);
  distances.erase(distances.begin() + static_cast<std::ptrdiff_t>(p.key));
  if (!stroke.keys.empty()) {
    keep_speed(p.stroke);
    selected_ = PathPoint{p.stroke, p.key > 0 ? p.key - 1 : 0};
    return;
  }
  now_.strokes.erase(now_.strokes.begin() + static_cast<std::ptrdiff_t>(p.stroke));
  now_.distances.erase(now_.distances.begin() + static_cast<std::ptrdiff_t>(p.stroke));
  selected_.reset();
  if (empty()) return;
  const size_t before = p.stroke > 0 ? p.stroke - 1 : 0;
  selected_ = PathPoint{before, now_.strokes[before].keys.size() - 1};
}

void PathWork::set_radius(size_t stroke, double radius) {
  KERF_ASSERT(stroke < now_.strokes.size() && radius > 0);
  now_.strokes[stroke].radius = radius;
}

void PathWork::set_speed(double speed) {
  now_.speed = speed;
  for (size_t i = 0; i < now_.strokes.size(); ++i) keep_speed(i);
}

void PathWork::add_strokes(const std::vector<StrokePath>& strokes, const World& world, double distance,
                           double speed) {
  const bool has_speed = !empty() && now_.speed;
  const double mean = speed_or(speed);
  if (selected_ && now_.strokes[selected_->stroke].keys.size() == 1) remove(*selected_);
  if (empty() && !has_speed) now_.speed = speed;
  for (const StrokePath& stroke : strokes) {
    now_.strokes.push_back(stroke);
    std::vector<double>& distances = now_.distances.emplace_back();
    for (const Pose& pose : stroke.keys) distances.push_back(first_hit(world, pose).value_or(distance));
    retime(now_.strokes.back(), now_.speed.value_or(mean));
  }
  selected_.reset();
}

void PathWork::load(std::vector<StrokePath> strokes, const World& world) {
  Version version;
  for (const StrokePath& stroke : strokes) {
    std::vector<double>& distances = version.distances.emplace_back();
    for (const Pose& pose : stroke.keys) distances.push_back(distance_to_surface(world, pose));
  }
  version.strokes = std::move(strokes);
  replace(std::move(version));
}

void PathWork::replace(Version version) {
  now_ = std::move(version);
  selected_.reset();
}

void PathWork::undo() {
  KERF_ASSERT(can_undo());
  ++changes_;
  redone_to_.push_back(std::exchange(now_, std::move(undone_to_.back())));
  undone_to_.pop_back();
  selected_.reset();
}

void PathWork::redo() {
  KERF_ASSERT(can_redo());
  ++changes_;
  undone_to_.push_back(std::exchange(now_, std::move(redone_to_.back())));
  redone_to_.pop_back();
  selected_.reset();
}

nlohmann::json path_entry(const PathWork& path) {
  if (path.empty()) return nullptr;
  nlohmann::json entry = nlohmann::json::parse(path_file_text(path.strokes()));
  entry[kDistancesKey] = path.distances();
  if (!path.has_times_of_file()) entry[kSpeedKey] = path.speed();
  return entry;
}

PathWork path_of_entry(const nlohmann::json& entry, const World& world) {
  PathWork path;
  if (!entry.is_object()) return path;
  nlohmann::json file{{"strokes", entry.value("strokes", nlohmann::json())}};
  Result<std::vector<StrokePath>> strokes = read_path_draft(file.dump(), "path");
  if (!strokes) return path;
  const auto distances = distances_of(entry.value(kDistancesKey, nlohmann::json()), *strokes);
  const auto speed = speed_of(entry.value(kSpeedKey, nlohmann::json()));
  if (distances) {
    path.restore(std::move(*strokes), *distances, speed);
  } else {
    path.load(std::move(*strokes), world);
  }
  return path;
}

std::vector<PathMark> path_marks(const PathWork& path, const World& world, const PrimaryViewport& picture) {
  std::vector<PathMark> marks;
  const bool look_for_surfaces = path.points() <= kMaxLookedFor;
  size_t number = 0;
  for (size_t i = 0; i < path.strokes().size(); ++i) {
    std::optional<Vec2> before;
    for (size_t k = 0; k < path.strokes()[i].keys.size(); ++k, ++number) {
      const PathPoint point{i, k};
      const auto place = picture.place_of(path.target(point));
      const bool selected = path.selected() == point;
      if (!place || (before && !selected && glm::length(*place - *before) < kMinApart)) continue;
      before = place;
      const bool hidden = look_for_surfaces && is_hidden(world, picture, path.target(point), *place);
      marks.push_back({point, number, *place, hidden});
    }
  }
  return marks;
}

std::optional<PathKnob> path_knob(const PathWork& path, const PrimaryViewport& picture) {
  if (!path.selected()) return std::nullopt;
  const Vec3 target = path.target(*path.selected());
  const double distance = std::min(path.distance(*path.selected()), kKnobEms * picture.metres_of_em(target));
  const Vec3 at = target - path.pose(*path.selected()).direction * distance;
  const auto place = picture.place_of(at);
  if (!place || !(distance > 0)) return std::nullopt;
  return PathKnob{at, distance, *place};
}

std::optional<PathGrip> path_grip(const PathWork& path, const World& world, const PrimaryViewport& picture,
                                  Vec2 at) {
  std::optional<PathGrip> found;
  double least = kMarkReach;
  for (const PathMark& mark : path_marks(path, world, picture)) {
    const double distance = glm::length(mark.target - at);
    if (distance > least) continue;
    least = distance;
    found = PathGrip{mark.point};
  }
  const auto knob = path_knob(path, picture);
  if (knob && glm::length(knob->place - at) < least) found = PathGrip{*path.selected(), true};
  return found;
}

void draw_path(const PathWork& path, const World& world, const PrimaryViewport& picture, ImDrawList& list) {
  draw_lines(path, world, picture, list);
  const std::vector<PathMark> marks = path_marks(path, world, picture);
  draw_arrows(path, marks, picture, list);
  for (const PathMark& mark : marks)
    draw_dot(mark, path.selected() == mark.point, marks.size() <= kMaxNumbered, path.was_run(), list);
  if (const auto knob = path_knob(path, picture)) draw_knob(*knob, list);
}

PathTool::Beam PathTool::beam_for(const World& world, double radius) {
  const double diagonal = world.bounds().diagonal();
  if (!(diagonal > 0)) return {.radius = radius};
  return {.radius = radius, .height = diagonal / 16, .speed = diagonal / 4};
}

std::string PathTool::press(PathWork& path, const World& world, const ViewState& view, Vec2 pointer,
                            bool new_stroke, const Beam& beam) {
  const PrimaryViewport picture(view);
  if (const auto grip = path_grip(path, world, picture, pointer); grip && !new_stroke) {
    path.select(grip->point);
    take(path, grip->is_knob ? Grip::kKnob : Grip::kTarget, false, pointer);
    return "";
  }
  const auto surface = surface_point(world, view.look, picture.ray(pointer));
  if (!surface) return "Click on a surface to add a point of the path.";
  const Vec3 direction = beam_direction(-surface->normal);
  path.begin_edit();
  path.add({surface->at - direction * beam.height, direction}, beam.height, new_stroke, beam.radius,
           beam.speed);
  take(path, Grip::kTarget, true, pointer);
  return "";
}

void PathTool::take(const PathWork& path, Grip grip, bool edits, Vec2 pointer) {
  grip_ = grip;
  edits_ = edits;
  dragged_ = path.selected();
  points_ = path.points();
  pressed_at_ = pointer;
}

void PathTool::move(PathWork& path, const World& world, const ViewState& view, Vec2 pointer) {
  if (path.selected() != dragged_ || path.points() != points_) release();
  if (grip_ == Grip::kNone || !path.selected()) return;
  if (glm::length(pointer - pressed_at_) < kMinDrag && !edits_) return;
  if (!edits_) path.begin_edit();
  edits_ = true;
  if (grip_ == Grip::kTarget) {
    drag_target(path, world, view, pointer);
  } else {
    drag_knob(path, view, pointer);
  }
}

void PathTool::drag_target(PathWork& path, const World& world, const ViewState& view, Vec2 pointer) const {
  const PathPoint point = *path.selected();
  const auto surface = surface_point(world, view.look, PrimaryViewport(view).ray(pointer));
  if (!surface) return;
  const Vec3 before = normal_under(path, world, view, point);
  const Vec3 direction = beam_direction(turned_with(path.pose(point).direction, before, surface->normal));
  const double distance = path.distance(point);
  path.set(point, {surface->at - direction * distance, direction}, distance);
}

void PathTool::drag_knob(PathWork& path, const ViewState& view, Vec2 pointer) const {
  const PrimaryViewport picture(view);
  const auto knob = path_knob(path, picture);
  if (!knob) return;
  const PathPoint point = *path.selected();
  const Vec3 target = path.target(point);
  const Vec3 to = dragged_around(picture, target, knob->distance, knob->at, pointer);
  const Vec3 direction = beam_direction(target - to);
  const double distance = path.distance(point);
  path.set(point, {target - direction * distance, direction}, distance);
}

}  // namespace kerf
