#include "core/joints/loaded_part.h"

#include <algorithm>
#include <vector>

namespace kerf {

namespace {

// The loaded faces from which those of a piece were made, ascending, each as often as it has faces.
std::vector<uint32_t> loaded_faces_of(const Body& body, uint32_t label) {
  std::vector<uint32_t> faces;
  for (const FaceId f : body.faces_of(label)) faces.push_back(body.loaded_face(body.loaded_base(f)).index);
  std::sort(faces.begin(), faces.end());
  return faces;
}

}  // namespace

bool is_loaded_part(const Body& body, uint32_t label) {
  return label != 0 && body.pieces[label].faces > 0 && body.pieces[label].cut_off.faces == 0;
}

std::string loaded_part_name(const World& world, const PieceId& piece) {
  const Body& body = world.body(piece.body);
  if (!world.contains(body.loaded_as)) return "";
  const std::vector<uint32_t> faces = loaded_faces_of(body, piece.label);
  const MeshPart* best = nullptr;
  ptrdiff_t most = 0;
  for (const MeshPart& part : world.body(body.loaded_as).named_parts) {
    const auto first = std::lower_bound(faces.begin(), faces.end(), part.first);
    const ptrdiff_t held = std::lower_bound(first, faces.end(), part.last) - first;
    const bool smaller = best != nullptr && part.last - part.first < best->last - best->first;
    if (held < most || held == 0 || (held == most && !smaller)) continue;
    best = &part;
    most = held;
  }
  return best != nullptr ? best->name : "";
}

}  // namespace kerf
