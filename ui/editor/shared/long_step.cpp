#include "ui/editor/shared/long_step.h"

namespace kerf {

namespace {

constexpr size_t kManyFaces = 40'000;  // from here on changes of bodies take longer than a part of a frame
constexpr size_t kManyMoves = 20;      // of the queue, that take longer than a part of a frame

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
          [&](const StopStroke&) { return document.execution().stop_here().has_value(); },
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
  return document.execution().next_makes_ready() > kManyFaces ? "Making bodies of the pieces" : nullptr;
}

}  // namespace kerf
