#include "core/document/history/cut_names.h"

#include <unordered_map>

namespace kerf {

namespace {

// Null: no part of the file but one that is all of it has the face.
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

}  // namespace kerf
