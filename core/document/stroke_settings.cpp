#include "core/document/stroke_settings.h"

#include <algorithm>
#include <cmath>

#include "core/base/assert.h"
#include "core/base/number_format.h"

namespace kerf {

double positive(double length) { return std::clamp(length, kPositive.least, kPositive.most); }

CutSettings default_settings(const StrokePath& stroke, double diagonal) {
  CutSettings settings;
  settings.laser.radius = stroke.radius.value_or(positive(diagonal / 400));
  settings.laser.range = stroke.range.value_or(Interval{0, positive(10 * diagonal)});
  settings.laser.power = stroke.power.value_or(settings.laser.power);
  settings.laser.wavelength = stroke.wavelength.value_or(0);
  settings.laser.focus = stroke.focus;
  settings.laser.pulse_rate = stroke.pulse_rate.value_or(0);
  settings.laser.duty = stroke.duty.value_or(1);
  settings.resolution.target_edge = positive(settings.laser.radius / 4);
  settings.resolution.tolerance = positive(settings.laser.radius / 8);
  return settings;
}

double default_heat_width(double radius) {
  constexpr double kGlowsForSeconds = 0.006;  // m, of steel
  return std::min(8 * radius, 2 * std::sqrt(kGlowsForSeconds * radius));
}

std::vector<Command> stroke_commands(const StrokePath& stroke, const CutSettings& settings) {
  KERF_ASSERT(!stroke.keys.empty() && stroke.keys.size() == stroke.times.size());
  std::vector<Command> commands{BeginStroke{settings, stroke.keys.front()}};
  for (size_t k = 1; k < stroke.keys.size(); ++k)
    commands.emplace_back(MoveBeam{stroke.keys[k], stroke.times[k] - stroke.times.front()});
  commands.emplace_back(EndStroke{});
  return commands;
}

std::vector<Command> path_commands(std::span<const StrokePath> strokes, double diagonal,
                                   const std::function<Resolution(double)>& resolution) {
  std::vector<Command> all;
  for (const StrokePath& stroke : strokes) {
    CutSettings settings = default_settings(stroke, diagonal);
    if (resolution) settings.resolution = resolution(settings.laser.radius);
    const std::vector<Command> own = stroke_commands(stroke, settings);
    all.insert(all.end(), own.begin(), own.end());
  }
  return all;
}

std::vector<Command> scene_stroke_commands(const StrokePath& stroke, double diagonal) {
  if (stroke.keys.empty()) return {};
  CutSettings settings = default_settings(stroke, diagonal);
  settings.resolution.rim = Rim::kSmooth;
  settings.heat_width = default_heat_width(settings.laser.radius);
  return stroke_commands(stroke, settings);
}

}  // namespace kerf
