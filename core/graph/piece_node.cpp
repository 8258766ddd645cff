#include "core/graph/piece_node.h"

#include <array>

namespace kerf {

namespace {

// Every piece but the first is connected, and of the first the counts of its components are kept.
size_t parts_of(const Body& body, uint32_t label) {
  if (label != 0 || body.components.left.empty()) return 1;
  size_t parts = 0;
  for (uint32_t i = 0; i < body.components.left.size(); ++i) parts += body.components.left[i].faces > 0;
  return parts;
}

Holder holder_of(const Body& body, const PieceNode& node) {
  const bool first = node.piece.label == 0;
  if (body.pinned && (first || node.beside == 0)) return Holder::kPin;
  if (!first) return Holder::kNothing;
  return node.parts > 1 ? Holder::kBody : Holder::kItself;
}

}  // namespace

const char* name_of(Holder holder) {
  constexpr std::array kNames{"nothing", "itself", "body", "pin"};
  return kNames.at(static_cast<size_t>(holder));
}

std::vector<PieceNode> piece_nodes(const World& world) {
  std::vector<PieceNode> all;
  for (const BodyId id : world.ids()) {
    const Body& body = world.body(id);
    const size_t first = all.size();
    for (uint32_t label = 0; label < body.pieces.size(); ++label) {
      if (body.pieces[label].faces == 0) continue;
      PieceNode node;
      node.piece = {id, label};
      node.parts = parts_of(body, label);
      all.push_back(node);
    }
    for (size_t i = first; i < all.size(); ++i) {
      all[i].beside = all.size() - first - 1;
      all[i].held_by = holder_of(body, all[i]);
    }
  }
  return all;
}

}  // namespace kerf
