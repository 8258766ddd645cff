#pragma once

#include <compare>
#include <cstdint>

namespace kerf {

// The index or label of no element.
inline constexpr uint32_t kNoIndex = 0xffffffffu;

// The index of a slot in an array that holds things of one kind. Such an array only grows while a document is
// open: the slot of a thing that died is not used again, unless undo takes the slot itself back. Tag keeps
// ids of different kinds apart.
template <typename Tag>
struct Id {
  static constexpr uint32_t kNone = kNoIndex;
  uint32_t index = kNone;

  constexpr Id() = default;
  constexpr explicit Id(uint32_t i) : index(i) {}
  constexpr bool valid() const { return index != kNone; }
  friend constexpr auto operator<=>(Id, Id) = default;
};

using VertexId = Id<struct VertexTag>;
using EdgeId = Id<struct EdgeTag>;
using FaceId = Id<struct FaceTag>;

// Names a body of a world. Undo of the command that made a body gives its slot free, and the next body that
// is made gets the same slot; the generation tells the two apart, so that an id never names a second body. It
// is 0 for the bodies that a document begins with, and 1 + n for a body that the n-th command (from 0) of the
// journal made; redo and replay of that command give the body the same id again.
struct BodyId {
  static constexpr uint32_t kNone = kNoIndex;
  uint32_t slot = kNone;
  uint32_t generation = 0;
  constexpr bool valid() const { return slot != kNone; }
  friend constexpr auto operator<=>(BodyId, BodyId) = default;
};

// Names a piece: the body that its faces belong to, and their label there (FaceData::piece). Label 0 is what
// is left of the body itself.
struct PieceId {
  BodyId body;
  uint32_t label = 0;
  friend constexpr auto operator<=>(PieceId, PieceId) = default;
};

}  // namespace kerf
