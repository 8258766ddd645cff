#include "ui/editor/shared/laser_controls.h"

#include <imgui.h>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/assert.h"
#include "core/base/geometry.h"
#include "core/base/json.h"
#include "ui/editor/shared/command_labels.h"
#include "ui/editor/shared/panel_rows.h"
#include "ui/editor/shared/user_input.h"
#include "ui/window/layout.h"
#include "ui/window/number_text.h"
#include "ui/window/widgets.h"

namespace kerf {

std::optional<double> radius_of_entry(const nlohmann::json& entry) {
  if (!entry.is_object() || !entry.contains("radius") || !entry["radius"].is_number()) return std::nullopt;
  const double radius = entry["radius"].get<double>();
  return radius > 0 ? std::optional(radius) : std::nullopt;
}

Resolution ResolutionControls::of(double radius) const {
  KERF_ASSERT(radius > 0);
  Resolution resolution;
  resolution.rule = rule;
  resolution.scheme = scheme;
  resolution.rim = rim;
  resolution.target_edge = radius * edge_fraction;
  resolution.tolerance = radius * tolerance_fraction;
  resolution.depth = depth;
  return resolution;
}

void ResolutionControls::show(const Resolution& resolution, double radius) {
  KERF_ASSERT(radius > 0);
  const auto fraction = [&](double length) {
    return std::clamp(length / radius, kMinFraction, kMaxFraction);
  };
  scheme = resolution.scheme;
  rule = resolution.rule;
  rim = resolution.rim;
  if (rule == Resolution::Rule::kTargetEdge) edge_fraction = fraction(resolution.target_edge);
  if (rule == Resolution::Rule::kTolerance) tolerance_fraction = fraction(resolution.tolerance);
  if (rule == Resolution::Rule::kDepth) depth = std::clamp(resolution.depth, 0, kMaxDepth);
}

void LaserControls::show(const CutSettings& settings) {
  const double cut = settings.laser.radius;
  radius = std::clamp(cut, default_radius / kRadiusSpan, default_radius * kRadiusSpan);
  resolution.show(settings.resolution, cut);
}

void make_finer(ResolutionControls& controls, int steps) {
  using Controls = ResolutionControls;
  const auto divide = [&](double& fraction) {
    fraction = std::clamp(std::ldexp(fraction, -steps), Controls::kMinFraction, Controls::kMaxFraction);
  };
  switch (controls.rule) {
    case Resolution::Rule::kTargetEdge:
      return divide(controls.edge_fraction);
    case Resolution::Rule::kTolerance:
      return divide(controls.tolerance_fraction);
    case Resolution::Rule::kDepth:
      controls.depth = std::clamp(controls.depth + steps, 0, Controls::kMaxDepth);
  }
}

CutSettings LaserControls::settings(double diagonal) const {
  CutSettings settings;
  settings.laser = beam();
  settings.laser.range = {0, 10 * diagonal};
  settings.model = model;
  if (model == Model::kGeometric) settings.heat_width = width_of_heat();
  settings.resolution = resolution.of(radius);
  return settings;
}

std::vector<Command> LaserControls::commands_of(std::span<const StrokePath> strokes, double diagonal,
                                                bool with_knife) const {
  std::vector<Command> commands;
  for (const StrokePath& stroke : strokes) {
    LaserControls own = *this;
    const bool is_knife = with_knife || stroke.radius == 0.0;
    if (!is_knife) own.radius = stroke.radius.value_or(radius);
    own.power = stroke.power.value_or(power);
    CutSettings cut = own.settings(diagonal);
    if (is_knife) cut.laser.radius = 0;
    cut.laser.range = stroke.range.value_or(cut.laser.range);
    cut.laser.wavelength = stroke.wavelength.value_or(cut.laser.wavelength);
    cut.laser.focus = stroke.focus;
    cut.laser.pulse_rate = stroke.pulse_rate.value_or(cut.laser.pulse_rate);
    cut.laser.duty = stroke.duty.value_or(cut.laser.duty);
    const std::vector<Command> of_stroke = stroke_commands(stroke, cut);
    commands.insert(commands.end(), of_stroke.begin(), of_stroke.end());
  }
  return commands;
}

namespace {

bool rule_row(ResolutionControls& to) {
  return choice_row(
      "Refine By", "##rule", to.rule, "Edge Length\0Tolerance\0Depth\0", nullptr,
      "Splits faces under the beam up to an edge length, a maximum overshoot of removed faces, or "
      "a number of splits.");
}

bool scheme_row(ResolutionControls& to) {
  return choice_row(
      "Scheme", "##scheme", to.scheme, "One to Four\0Longest Edge\0", nullptr,
      "Splits faces in four, as in the paper, or in two at the longest edge, which creates far fewer faces.");
}

// A length as a share of the radius, from a 32nd of it to twice the radius.
bool fraction_row(const char* name, double& fraction, double standard, const ShownRadius& radius,
                  const char* meaning) {
  property(name);
  const double before = fraction;
  const LengthUnit unit = label_unit(radius.length, radius.unit);
  const double one = radius.length / unit.metres;
  double shown = fraction * one;
  const double low = ResolutionControls::kMinFraction * one, high = ResolutionControls::kMaxFraction * one;
  if (real_slider({name, "##fraction", meaning, true}, shown, low, high, "%.3g ", length_unit(unit.name)))
    fraction = shown / one;
  mark_last_item("resolution size");
  const bool reset = reset_item(fraction, standard);
  return reset || fraction != before;
}

bool edge_row(ResolutionControls& to, const ShownRadius& radius) {
  return fraction_row(
      "Edge", to.edge_fraction, ResolutionControls().edge_fraction, radius,
      "Longest edge under the beam, 1/32 to 2 radii; finer to the left. Right-click for the default.");
}

bool tolerance_row(ResolutionControls& to, const ShownRadius& radius) {
  return fraction_row("Tolerance", to.tolerance_fraction, ResolutionControls().tolerance_fraction, radius,
                      "Maximum overshoot of removed faces, 1/32 to 2 radii; finer to the left. Right-click "
                      "for the default.");
}

bool depth_row(ResolutionControls& to) {
  property("Depth");
  const int before = to.depth;
  const std::string text = to.depth == 0 ? "whole faces" : count_text(static_cast<size_t>(to.depth), "split");
  constexpr const char* kMeaning =
      "Number of splits of a face under the beam. 0: no refinement, faces are removed whole.";
  whole_slider({"Depth", "##depth", kMeaning}, to.depth, 0, ResolutionControls::kMaxDepth, text);
  return to.depth != before;
}

// Offset of the emitter to the right of and above the eye, as a share of the focus: large enough to see the
// beam from the side, small enough to cut under the pointer at all depths.
constexpr double kEmitterAside = 0.004;
constexpr double kMinMove = 0.5;  // pixels

// Returns the depth of the nearest corner of the world's box, or of the camera's pivot if that is nearer.
double min_depth(const World& world, const CameraView& view) {
  const World::Bounds b = world.bounds();
  double least = view.focus;
  for (int i = 0; i < 8; ++i) {
    const Vec3 corner(i & 1 ? b.max.x : b.min.x, i & 2 ? b.max.y : b.min.y, i & 4 ? b.max.z : b.min.z);
    least = std::min(least, glm::dot(corner - view.eye, view.forward));
  }
  return least;
}

}  // namespace

bool resolution_size_row(ResolutionControls& to, const ShownRadius& radius) {
  switch (to.rule) {
    case Resolution::Rule::kTargetEdge:
      return edge_row(to, radius);
    case Resolution::Rule::kTolerance:
      return tolerance_row(to, radius);
    case Resolution::Rule::kDepth:
      break;
  }
  return depth_row(to);
}

bool rim_row(ResolutionControls& to) {
  return choice_row(
      "Rim", "##rim", to.rim, "Faces\0Smooth\0", nullptr,
      "Faces removes every face the beam touches (jagged edge); Smooth cuts faces along the beam.");
}

bool resolution_rows(ResolutionControls& to, const ShownRadius& radius) {
  bool changed = rule_row(to);
  changed = resolution_size_row(to, radius) || changed;
  changed = scheme_row(to) || changed;
  return rim_row(to) || changed;
}

// Returns the distance from the target back to the emitter: in an orthographic view from in front of the
// whole world; from the eye otherwise, and in an empty world.
double LaserTool::distance_of_emitter(const World& world, const CameraView& view) const {
  const double diagonal = world.bounds().diagonal();
  if (!view.parallel || !(diagonal > 0)) return focus_;
  return focus_ - min_depth(world, view) + 0.1 * diagonal;
}

// In an orthographic view the emitter moves with the pointer, so that all poses are parallel.
Pose LaserTool::aim(const CameraView& view, Vec2 pointer) const {
  const Pose ray = view.ray(pointer.x, pointer.y);
  const Vec3 target = ray.origin + ray.direction * focus_;
  const Vec3 before = view.parallel ? target - view.forward * emitter_ : view.eye;
  const Vec3 emitter = before + (view.right + view.up) * (kEmitterAside * emitter_);
  return {emitter, glm::normalize(target - emitter)};
}

void LaserTool::set_up(const CutSettings& settings) {
  radius_ = settings.laser.radius;
  const bool by_edge = settings.resolution.rule == Resolution::Rule::kTargetEdge;
  overshoot_ = by_edge ? settings.resolution.target_edge : 0.5 * radius_;
  reach_ = settings.laser.range.high;
}

void LaserTool::take_over(const CutSettings& settings, double emitter) {
  if (cutting_) return;
  set_up(settings);
  emitter_ = emitter;
}

void LaserTool::press(Document& document, const CameraView& view, Vec2 pointer, const LaserControls& controls,
                      double time) {
  const Pose ray = view.ray(pointer.x, pointer.y);
  const double diagonal = document.world().bounds().diagonal();
  const std::optional<double> hit = first_hit(document.world(), ray);
  focus_ = hit.value_or(view.focus);
  emitter_ = distance_of_emitter(document.world(), view);
  pointer_ = pointer;
  pose_ = aim(view, pointer);
  begin(document, controls.settings(diagonal), time);
  is_fired_ = false;
  held_ = {BeginStroke{settings_, pose_}};
  if (hit) begin_held(document);
}

void LaserTool::begin(const Document& document, const CutSettings& settings, double time) {
  settings_ = settings;
  set_up(settings);
  if (!document.queue().pending().holds_beam()) {
    beam_ = pose_;
    strike_.reset();
  }
  cutting_ = true;
  began_ = time;
  last_time_ = 0;
}

void LaserTool::fire(Document& document, const Pose& pose, double distance, const CutSettings& settings,
                     double time) {
  KERF_ASSERT(!cutting_ && distance > 0 && is_unit(pose.direction));
  emitter_ = distance;
  pose_ = pose;
  begin(document, settings, time);
  is_fired_ = true;
  held_ = {BeginStroke{settings_, pose_}};
  if (time_passes_ || hits_anything(document.world(), settings_.laser, pose_)) begin_held(document);
}

void LaserTool::carry_to(Document& document, const Pose& pose, double time) {
  if (!cutting_ || (pose.origin == pose_.origin && pose.direction == pose_.direction)) return;
  if (are_opposite(pose_.direction, pose.direction)) {
    release(document);
    return fire(document, pose, emitter_, settings_, time);
  }
  move_to(document, pose, time);
}

// A beam that meets nothing is drawn at once.
void LaserTool::move_to(Document& document, const Pose& pose, double time) {
  const Pose before = std::exchange(pose_, pose);
  last_time_ = std::max(last_time_, time - began_);
  const MoveBeam move{pose_, last_time_};
  if (held_.empty()) {
    document.apply(move);
    return;
  }
  held_.emplace_back(move);
  if (time_passes_ || hits_anything(document.world(), settings_.laser, BeamMove{before, pose_, 0}))
    return begin_held(document);
  if (!document.queue().pending().holds_beam()) beam_ = pose_;
}

void LaserTool::begin_held(Document& document) {
  for (const Command& command : std::exchange(held_, {})) document.apply(command);
}

void LaserTool::follow_time(Document& document, bool passes) {
  time_passes_ = passes;
  if (passes && (has_moved() || is_fired_)) begin_held(document);
}

void LaserTool::move(Document& document, const CameraView& view, Vec2 pointer, double pixel, double time) {
  if (!cutting_) return;
  const Vec2 moved = (pointer - pointer_) * Vec2(view.aspect, 1) / pixel;
  const bool is_click = !held_.empty() && !has_moved();
  if (glm::length(moved) < (is_click ? kClickReach : kMinMove)) return;
  pointer_ = pointer;
  KERF_ASSERT(time >= began_);
  move_to(document, aim(view, pointer), time);
}

void LaserTool::hold_beam(Document& document, double time) {
  if (!emits() || document.waiting() > 0 || time - began_ <= last_time_) return;
  last_time_ = time - began_;
  document.apply(MoveBeam{pose_, last_time_});
}

bool LaserTool::release(Document& document) {
  if (!cutting_) return false;
  cutting_ = false;
  // The ray of the pointer met nothing, but the beam may touch a body with its edge.
  if (!held_.empty() && hits_anything(document.world(), settings_.laser, pose_)) begin_held(document);
  const bool missed = !std::exchange(held_, {}).empty();
  if (!missed) document.apply(EndStroke{});
  return missed;
}

void LaserTool::find_impact(const Document& document) {
  strike_ = kerf::find_impact(document.world(), beam_, radius_, overshoot_, reach_);
}

std::optional<BeamPicture> LaserTool::picture(const Document& document) const {
  if (!cutting_ && !document.queue().pending().holds_moves()) return std::nullopt;
  BeamPicture beam{beam_.origin, beam_.origin + beam_.direction * std::min(reach_, 20 * emitter_),
                   std::nullopt, radius_};
  if (strike_) beam.strike = beam_.origin + beam_.direction * *strike_;
  return beam;
}

}  // namespace kerf
