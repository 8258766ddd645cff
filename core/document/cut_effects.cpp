#include "core/document/cut_effects.h"

#include <unordered_map>

#include "core/base/deterministic_math.h"
#include "core/document/extract.h"

namespace kerf {

bool is_speck(double area, double radius) { return area < kSpeckShare * kPi * radius * radius; }

std::set<PieceId> new_specks(const World& world, const Delta& delta, double radius) {
  std::set<PieceId> found;
  for (const BodyDelta& b : delta.bodies) {
    for (const uint32_t label : b.new_pieces) {
      const PieceId piece = id_after(delta, PieceId{b.body, label});
      if (has_faces(world, piece) && is_speck(world.body(piece.body).pieces[label].area, radius))
        found.insert(piece);
    }
  }
  return found;
}

std::set<PieceId> specks(const Document& document) {
  const UndoStack& history = document.history();
  std::set<PieceId> all;
  for (size_t i = 0; i < history.position(); ++i) {
    const HistoryStep& step = history.step(i);
    for (const Detached& d : step.body_changes().detached) {
      if (all.erase({d.from, d.label}) > 0) all.insert({d.to, d.label});
    }
    if (!history.is_cut_again(i)) all.insert(step.totals().specks.begin(), step.totals().specks.end());
  }
  std::erase_if(all, [&](const PieceId& id) { return !has_faces(document.world(), id); });
  return all;
}

namespace {

// Returns null if only a part that is the whole mesh has the face.
const MeshPart* outermost_part(const Body& loaded, FaceId face) {
  const size_t all = loaded.loaded.faces;
  const MeshPart* best = nullptr;
  for (const MeshPart& part : loaded.named_parts) {
    const size_t size = part.last - part.first;
    const bool has_it = part.first <= face.index && face.index < part.last && size < all;
    if (has_it && (best == nullptr || size > best->last - best->first)) best = &part;
  }
  return best;
}

// Maps the id of a piece after a step to its id at the position of the history.
PieceId at_position(const UndoStack& history, size_t step, PieceId piece) {
  for (size_t i = step + 1; i < history.position(); ++i)
    piece = id_after(history.step(i).body_changes(), piece);
  return piece;
}

}  // namespace

void count_cut_names(const World& world, const BodyDelta& delta, std::map<std::string, size_t>& names) {
  if (delta.removed.empty() || !world.contains(delta.body)) return;
  const Body& body = world.body(delta.body);
  const Body* loaded = world.contains(body.loaded_as) ? &world.body(body.loaded_as) : nullptr;
  std::unordered_map<uint32_t, const MeshPart*> part_of;  // of base faces; never iterated
  std::map<uint32_t, size_t> of_pieces;
  for (const CutFace& face : delta.removed) {
    const MeshPart* part = nullptr;
    if (loaded != nullptr && !loaded->named_parts.empty()) {
      const auto [known, is_new] = part_of.try_emplace(face.base.index, nullptr);
      if (is_new) known->second = outermost_part(*loaded, body.loaded_face(face.base));
      part = known->second;
    }
    if (part != nullptr) {
      ++names[part->name];
    } else {
      ++of_pieces[face.piece];
    }
  }
  for (const auto& [label, count] : of_pieces) names[body.name_of(label)] += count;
}

std::vector<PieceNode> piece_origins(const Document& document) {
  const UndoStack& history = document.history();
  std::vector<PieceNode> all = piece_nodes(document.world());
  std::map<PieceId, PieceNode*> nodes;
  for (PieceNode& node : all) nodes[node.piece] = &node;
  for (size_t step = 0; step < history.position(); ++step) {
    for (const auto& [piece, from] : history.step(step).totals().came_off) {
      const auto found = nodes.find(at_position(history, step, piece));
      if (found == nodes.end()) continue;
      found->second->came_off = at_position(history, step, {piece.body, from});
      found->second->step = step;
    }
  }
  return all;
}

std::optional<DrawnGraph> graph_around_last_cut(const Document& document) {
  const CutGraph graph = cut_graph(document.world(), last_cut_faces(document.history()));
  const std::optional<uint32_t> start = start_next_to_cut(graph);
  if (!start) return std::nullopt;
  return draw_graph(graph, traverse_cut(graph, *start), GraphScope::kAroundCut);
}

}  // namespace kerf
