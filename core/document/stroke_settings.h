#pragma once

#include <functional>
#include <span>
#include <vector>

#include "core/document/commands.h"
#include "core/document/stroke_path.h"

namespace kerf {

// Clamps a derived length, which may vanish or be infinite, to what a journal can store.
double positive(double length);

// The settings of a stroke: those of its file, and otherwise defaults derived from the diagonal D of the
// bounding box of all meshes [m]: radius D/400, range 0 to 10 D, faces down to a quarter of the radius.
CutSettings default_settings(const StrokePath& stroke, double diagonal);

// The width over which a geometric cut leaves heat in the editor [m] (see CutSettings::heat_width), for a
// beam of this radius [m]: twice the geometric mean of the radius and 6 mm, over which steel glows for a
// few seconds, but at most eight radii. So the glowing rim of a wide beam remains visible from a distance
// that shows the whole cut.
double default_heat_width(double radius);

// The commands that draw a stroke: its keys with their times relative to the first key. Precondition: it
// has a key.
std::vector<Command> stroke_commands(const StrokePath& stroke, const CutSettings& settings);

// The commands that draw the strokes of a path in order, with default_settings(), like `kerf cut --path`
// without further options. `resolution`, a function of the beam radius [m], overrides their resolution.
// Precondition: each stroke has a key.
std::vector<Command> path_commands(std::span<const StrokePath> strokes, double diagonal,
                                   const std::function<Resolution(double)>& resolution = {});

// The commands that draw a stroke of a scene with its default settings and a hot smooth rim, as in the
// editor. Empty if it has no key.
std::vector<Command> scene_stroke_commands(const StrokePath& stroke, double diagonal);

}  // namespace kerf
