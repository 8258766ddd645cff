#include "ui/editor/laser/stroke_watch.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/render/bodies/pick.h"
#include "ui/render/passes/beam_effects.h"

namespace kerf {

namespace {
constexpr double kMinCosine = 0.2;
}

std::optional<SheetHit> sheet_hit(const World& world, const ViewOptions& options, const Pose& ray) {
  const std::optional<Pick> met = pick(world, options, ray);
  if (!met) return std::nullopt;
  const Body& body = world.body(met->body);
  const Triangle t = body.mesh.triangle(met->face);
  const Vec3 across = glm::cross(t[1] - t[0], t[2] - t[0]);
  const double along = std::abs(glm::dot(across, body.placement.to_body(ray).direction));
  const double cosine = std::max(along / glm::length(across), kMinCosine);
  return SheetHit{body.sheet, 1 / cosine, met->length};
}

namespace {

constexpr double kEven = 0.2;   // s, time constant of the smoothing
constexpr double kResting = 5;  // pixels/s, max. speed at rest

}  // namespace

void PointerSpeed::follow(const Vec2& pointer, double seconds) {
  const std::optional<Vec2> before = std::exchange(last_, pointer);
  if (!before || seconds <= 0) return;
  const double now = glm::distance(*before, pointer) / seconds;
  speed_ += (now - speed_) * std::min(1.0, seconds / kEven);
}

std::optional<PointerAim> aim_of(const Workspace& workspace, const PointerSpeed& pointer) {
  const CameraView view = workspace.view.seen();
  const Vec2 p = workspace.view.in_picture(workspace.input.pointer);
  const std::optional<SheetHit> met = sheet_hit(workspace.world(), workspace.view.look, view.ray(p.x, p.y));
  if (!met) return std::nullopt;
  const double half_height = view.parallel ? view.half_height() : met->length * view.tan_half_fov;
  const double pixel = 2 * half_height / workspace.view.pane().size.y;
  const double speed = pointer.pixels_per_second();
  return PointerAim{*met, speed > kResting ? speed * pixel : 0};
}

namespace {

constexpr double kPlaceSpacing = 0.5;  // beam radii, between places
constexpr double kBehind = 2;          // beam radii, distance at which the beam has no more effect
constexpr double kSteepest = 5;        // assumed slant if only the axis of the beam misses the sheet
constexpr double kRests = 0.25;        // s in one place until a beam is judged there

const HistoryStep& stroke_of(const Document& document) {
  return document.history().step(*document.history().last_cut());
}

// Distance [m] perpendicular to the beam.
double way_across(const Pose& axis, const Vec3& from, const Vec3& to) {
  const Vec3 way = to - from;
  return glm::length(way - glm::dot(way, axis.direction) * axis.direction);
}

}  // namespace

void StrokeWatch::follow(const Document& document, const std::optional<BeamPicture>& beam) {
  const bool thermal =
      document.history().last_cut() && document.history().last_settings().model == Model::kThermal;
  if (!beam || !thermal) return end(document);
  if (!runs_) begin(document);
  pass(document, *beam);
}

void StrokeWatch::begin(const Document& document) {
  runs_ = true;
  way_.clear();
  through_ = not_through_ = 0;
  too_fast_ = 0;
  crossing_ = {};
  crossing_.settings = document.history().last_settings();
  now_.reset();
}

// Returns the extent [m] along the beam of a sheet that the whole width of the beam hits.
double StrokeWatch::record_sheet(const World& world, const Pose& axis) {
  const double width = 2 * crossing_.settings.laser.radius;
  const std::optional<SheetHit> met = sheet_hit(world, {}, axis);
  if (!met) return width * kSteepest;
  crossing_.met = *met;
  return width * met->slant;
}

void StrokeWatch::pass(const Document& document, const BeamPicture& beam) {
  if (!beam.strike) return now_.reset();
  const World& world = document.world();
  Place place{{beam.from, glm::normalize(beam.to - beam.from)}, *beam.strike, world.energy().beam_on};
  const double radius = crossing_.settings.laser.radius;
  if (!way_.empty()) {
    const Place& before = way_.back();
    const double way = way_across(place.axis, before.strike, place.strike), time = place.clock - before.clock;
    if (way < kPlaceSpacing * radius) return rest(world, before);
    if (time <= 0) return;
    place.speed = way / time;
  }
  place.thickness = record_sheet(world, place.axis);
  way_.push_back(place);
  while (way_.size() > 1 && way_across(place.axis, way_[1].strike, place.strike) >= kBehind * radius) {
    way_.pop_front();
    judge(world, way_.front());
  }
}

bool StrokeWatch::is_open(const World& world, const Place& place) {
  const std::optional<double> left = first_hit(world, place.axis);
  return !left || *left > glm::distance(place.axis.origin, place.strike) + place.thickness;
}

void StrokeWatch::judge(const World& world, const Place& place) {
  const bool through = is_open(world, place);
  (through ? through_ : not_through_) += 1;
  if (!through) too_fast_ += place.speed;
  now_ = Now{through, place.speed};
}

void StrokeWatch::rest(const World& world, const Place& place) {
  if (world.energy().beam_on - place.clock >= kRests) now_ = Now{is_open(world, place), 0};
}

void StrokeWatch::end(const Document& document) {
  if (!std::exchange(runs_, false)) return;
  now_.reset();
  if (!document.history().last_cut()) return;
  for (size_t i = 1; i < way_.size(); ++i) judge(document.world(), way_[i]);
  now_.reset();
  way_.clear();
  const size_t all = through_ + not_through_;
  last_.reset();
  if (all == 0) return;
  crossing_.step = *document.history().last_cut();
  crossing_.removed_faces = stroke_of(document).totals().removed_faces;
  crossing_.share = static_cast<double>(through_) / static_cast<double>(all);
  crossing_.speed = not_through_ > 0 ? too_fast_ / static_cast<double>(not_through_) : 0;
  last_ = crossing_;
}

const StrokeWatch::Crossing* StrokeWatch::last(const Document& document) const {
  if (!last_ || document.history().last_cut() != last_->step) return nullptr;
  return stroke_of(document).totals().removed_faces == last_->removed_faces ? &*last_ : nullptr;
}

}  // namespace kerf
