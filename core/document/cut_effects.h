#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/document/document.h"
#include "core/graph/component_graph.h"
#include "core/graph/drawn_graph.h"
#include "core/world/world.h"
#include "core/world/world_delta.h"

namespace kerf {

// A speck is a piece that was smaller than this fraction of the beam's cross-section when it came off. Slow
// strokes of the thermal model leave many at the rim, which users do not count as pieces.
inline constexpr double kSpeckShare = 0.125;
// Returns true if a piece of this area [m^2] cut off by a beam of this radius [m] is a speck.
bool is_speck(double area, double radius);

// The specks among the pieces that a step with a beam of this radius [m] made; `world` is the one after it.
std::set<PieceId> new_specks(const World& world, const Delta& delta, double radius);

// The specks that have faces. O((s + d) log s) for s specks and d detached pieces of all steps.
std::set<PieceId> specks(const Document& document);

// Counts the faces that the beam removed from a body, by name: the outermost part of its mesh file that is
// not the whole mesh ("wheel_front_left"), else the piece ("sphere 2"). `world` is the one after the delta.
// O(removed faces + parts * removed base faces).
void count_cut_names(const World& world, const BodyDelta& delta, std::map<std::string, size_t>& names);

// The graph of pieces: those that have faces, in ascending order, with the piece each came off and what
// holds it. O(p log p) for p pieces of the world and of the history, per later step.
std::vector<PieceNode> piece_origins(const Document& document);

// The component graph around the last stroke that was not undone, ready to draw, with the traversal from
// start_next_to_cut() at its end; without a stroke, the graph of all bodies. Returns nullopt if no face is
// live. Linear in the faces of the bodies that the stroke cut (see draw_graph).
std::optional<DrawnGraph> graph_around_last_cut(const Document& document);

}  // namespace kerf
