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

// A speck is a piece that was smaller than this share of the beam's cross-section when it came off. Slow
// strokes that melt their way leave many at the rim, which nobody means by a piece.
inline constexpr double kSpeckShare = 0.125;
// Whether a piece of this area (m^2) that a beam of this radius (m) cuts off is one.
bool is_speck(double area, double radius);

// The specks among the pieces that a step of such a beam made, which led to this world.
std::set<PieceId> new_specks(const World& world, const Delta& delta, double radius);

// The specks that have faces. O((s + d) log s) in the specks and detached pieces of all steps.
std::set<PieceId> specks(const Document& document);

// Adds, for each face that the beam removed from a body, one to the count of what it belonged to: the
// outermost part of its mesh file that is not all of the mesh ("wheel_front_left"), else the piece ("sphere
// 2"). The world is the one after the step of the delta. O(removed faces + parts times base faces removed).
void count_cut_names(const World& world, const BodyDelta& delta, std::map<std::string, size_t>& names);

// The graph of pieces: those that have faces, ascending by piece, with what they came off and what holds
// them. O(p log p) in the pieces of the world and those that came off in the history, for each step that
// follows.
std::vector<PieceNode> piece_origins(const Document& document);

// What is drawn of the component graph around the last stroke that was not undone, with the traversal from
// start_beside_cut() at its end; without a stroke, of the graph of all bodies. Nothing if no face is live.
// Linear in the faces of the bodies that the stroke cut (see draw_graph).
std::optional<DrawnGraph> graph_around_last_cut(const Document& document);

}  // namespace kerf
