#include "ui/editor/changes/long_step.h"

namespace kerf {

namespace {

constexpr size_t kManyFaces = 40'000;  // from here on changes of bodies take longer than a part of a frame
constexpr size_t kManyMoves = 20;      // of the queue, that take longer than a part of a frame

// The faces of bodies that the next step detaches, or makes colliders of, before bodies move for a tick.
size_t faces_to_prepare(const Document& document) {
  if (document.waiting() == 0 || document.next_searches() || document.next_move()) return 0;
  const World& world = document.world();
  size_t faces = 0;
  for (const BodyId id : world.ids()) {
    const Body& body = world.body(id);
    size_t pieces = 0;
    for (uint32_t label = 0; label < body.pieces.size(); ++label)
      pieces += body.pieces[label].faces > 0 ? 1 : 0;
    const bool ready = pieces < 2 && document.physics().colliders().contains(id);
    if (!body.hidden && !ready) faces += body.mesh.live_faces();
  }
  return faces;
}

}  // namespace

bool is_small(const Document& document) { return document.world().live_faces() <= kManyFaces; }

bool is_quick(const Document& document, const Command& command) {
  const bool small = is_small(document);
  const size_t now = document.history().position();
  return std::visit(
      Overloaded{
          [](const BeginStroke&) { return true; },
          [](const MoveStroke&) { return true; },
          [](const EndStroke&) { return true; },
          [](const Recut&) { return true; },
          [](const HappensInTime auto&) { return true; },
          [](const Play&) { return true; },
          [&](const Undo&) { return small && (now == 0 || document.remembers_way_to(now - 1)); },
          [&](const Redo&) { return small; },
          [](const AddMesh&) { return false; },
          [&](const HappensAtOnce auto&) { return small && document.waiting() <= kManyMoves; },
      },
      command);
}

const char* why_beside(const Document& document) {
  if (document.next_closes_rim())
    return document.world().live_faces() > kManyFaces ? "Smoothing the rim" : nullptr;
  return faces_to_prepare(document) > kManyFaces ? "Making bodies of the pieces" : nullptr;
}

}  // namespace kerf
