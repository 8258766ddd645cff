#include "ui/editor/shared/laser_controls.h"

#include <imgui.h>
#include <algorithm>
#include <cmath>

#include "core/base/assert.h"
#include "ui/editor/shared/command_labels.h"
#include "ui/editor/shared/panel_rows.h"
#include "ui/window/layout.h"
#include "ui/window/number_text.h"
#include "ui/window/property_rows.h"

namespace kerf {

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

namespace {

bool rule_row(ResolutionControls& to) {
  return choice_row(
      "Refine by", "##rule", to.rule, "Edge length\0Tolerance\0Depth\0", nullptr,
      "When faces under the beam are small enough: by edge length, by overshoot of the removed area, or by "
      "number of splits.");
}

bool scheme_row(ResolutionControls& to) {
  return choice_row(
      "Scheme", "##scheme", to.scheme, "One to four\0Longest edge\0", nullptr,
      "Split faces in four, as in the paper, or in two at the longest edge: far fewer faces from thin ones.");
}

bool rim_row(ResolutionControls& to) {
  return choice_row(
      "Rim", "##rim", to.rim, "Faces\0Smooth\0", nullptr,
      "Faces: removes every face the beam touches; the edge is jagged. Smooth: cuts faces along the beam's "
      "boundary when the stroke ends.");
}

// A share of the radius, from twice the radius to a 32nd of it; finer to the right, as with depth.
bool fraction_row(const char* name, double& fraction, double standard, const ShownRadius& radius,
                  const char* meaning) {
  property(name);
  double halvings = -std::log2(fraction);
  const double low = -std::log2(ResolutionControls::kMaxFraction),
               high = -std::log2(ResolutionControls::kMinFraction);
  const std::string text = length_label(radius.length * fraction, radius.unit);
  const double before = fraction;
  if (real_slider({name, "##fraction", meaning, false, false}, halvings, low, high, "%.3f", {}, text))
    fraction = std::exp2(-std::round(4 * halvings) / 4);
  mark_last_item("resolution size");
  const bool reset = reset_item(fraction, standard);
  return reset || fraction != before;
}

bool edge_row(ResolutionControls& to, const ShownRadius& radius) {
  return fraction_row(
      "Edge", to.edge_fraction, ResolutionControls().edge_fraction, radius,
      "Longest edge under the beam, from twice the radius to a 32nd of it. Finer to the right. "
      "Right click for the default.");
}

bool tolerance_row(ResolutionControls& to, const ShownRadius& radius) {
  return fraction_row(
      "Tolerance", to.tolerance_fraction, ResolutionControls().tolerance_fraction, radius,
      "How far what is removed may overshoot the beam, from twice the radius to a 32nd of it. "
      "Finer to the right. Right click for the default.");
}

bool depth_row(ResolutionControls& to) {
  property("Depth");
  const int before = to.depth;
  const std::string text = to.depth == 0 ? "whole faces" : count_text(static_cast<size_t>(to.depth), "split");
  constexpr const char* kMeaning =
      "How often a face under the beam is split in four. 0 turns refinement off: faces are removed whole, "
      "as in the paper's figure 3.";
  whole_slider({"Depth", "##depth", kMeaning}, to.depth, 0, ResolutionControls::kMaxDepth, text);
  return to.depth != before;
}

}  // namespace

bool resolution_rows(ResolutionControls& to, const ShownRadius& radius) {
  bool changed = rule_row(to);
  switch (to.rule) {
    case Resolution::Rule::kTargetEdge:
      changed = edge_row(to, radius) || changed;
      break;
    case Resolution::Rule::kTolerance:
      changed = tolerance_row(to, radius) || changed;
      break;
    case Resolution::Rule::kDepth:
      changed = depth_row(to) || changed;
      break;
  }
  changed = scheme_row(to) || changed;
  return rim_row(to) || changed;
}

}  // namespace kerf
