#pragma once

#include <functional>
#include <span>
#include <vector>

#include "core/document/commands.h"
#include "core/document/stroke_path.h"

namespace kerf {

// The length, or the nearest one that a journal can hold: one that follows from others may vanish or be
// infinite.
double positive(double length);

// The settings of a stroke: those of its file, and where it gives none, defaults that follow from the
// diagonal D of the bounding box of all meshes (m): radius D/400, range 0 to 10 D, faces down to a quarter of
// the radius.
CutSettings default_settings(const StrokePath& stroke, double diagonal);

// The width over which a geometric cut leaves heat in the editor (m; see CutSettings::heat_width), for a beam
// of this radius (m): twice the geometric mean of the radius and 6 mm, over which steel glows for a few
// seconds, but at most eight radii. So the rim of a wide beam is seen to glow from where the whole of what it
// cuts is seen.
double default_heat_width(double radius);

// The commands that draw a stroke: its keys with their times, counted from the first key. Precondition: it
// has a key.
std::vector<Command> stroke_commands(const StrokePath& stroke, const CutSettings& settings);

// The commands that draw the strokes of a path one after the other, with default_settings(): what `kerf cut
// --path` does with a path file without further options. With `resolution`, a function of the radius of the
// beam (m), they are drawn at that resolution instead. Precondition: each stroke has a key.
std::vector<Command> path_commands(std::span<const StrokePath> strokes, double diagonal,
                                   const std::function<Resolution(double)>& resolution = {});

// The commands that draw a stroke of a scene: those of its default settings with a smooth rim that
// is hot, as in the editor. None if it has no key.
std::vector<Command> scene_stroke_commands(const StrokePath& stroke, double diagonal);

}  // namespace kerf
