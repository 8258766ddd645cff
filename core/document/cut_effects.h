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

// A speck is a piece that was smaller than this fraction of the beam's cross-section when it was cut off.
// Slow strokes of the thermal model leave many specks at the rim, which users do not regard as pieces.
inline constexpr double kSpeckShare = 0.125;
// Returns true if a piece of this area [m^2] cut off by a beam of this radius [m] is a speck.
bool is_speck(double area, double radius);

// Returns the specks among the pieces that a step separated. `radius`: of the beam [m]. `world`: after the
// step.
std::set<PieceId> new_specks(const World& world, const Delta& delta, double radius);

// Returns the specks that still have faces. O((s + d) log s) for s specks and d detached pieces of all steps.
std::set<PieceId> specks(const Document& document);

// Counts the faces that the beam removed from a body, by name: of the outermost part of the mesh file that is
// not the whole mesh ("wheel_front_left"), else of the piece ("sphere 2"). `world`: after the step. O(removed
// faces + parts * removed base faces).
void count_cut_names(const World& world, const BodyDelta& delta, std::map<std::string, size_t>& names);

// Returns the graph of pieces: all pieces that have faces, in ascending order, each with the piece from which
// it was cut off and with its support. O(p log p) for p pieces of the world and of the history, per later
// step.
std::vector<PieceNode> piece_origins(const Document& document);

// Returns the component graph around the last stroke that was not undone, ready to draw, with the completed
// traversal from start_next_to_cut(); without a stroke, the graph of all bodies. Returns nullopt if no face
// is live. Linear in the faces of the bodies that the stroke cut (see draw_graph).
std::optional<DrawnGraph> graph_around_last_cut(const Document& document);

}  // namespace kerf
