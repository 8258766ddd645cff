#pragma once

#include <compare>
#include <cstdint>

namespace kerf {

// The clock of a world counts ticks of 1/120 s. Motion and cooling in a world advance by whole ticks.
using Ticks = uint64_t;

inline constexpr Ticks kTicksPerSecond = 120;
inline constexpr double kTick = 1.0 / kTicksPerSecond;  // s

// Converts ticks to seconds, correctly rounded up to 2^53 ticks, i.e. more than two million years.
inline double seconds_of_ticks(Ticks ticks) {
  return static_cast<double>(ticks) / static_cast<double>(kTicksPerSecond);
}

// The index or label of no element.
inline constexpr uint32_t kNoIndex = 0xffffffffu;

// The index of a slot in an array of items of one kind. Such an array only grows while a document is open: a
// slot is reused only after undo removes it. Tag separates ids of different kinds.
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

// Identifies a body of a world. Undoing the command that created a body frees its slot, and the next body
// created gets the same slot; the generation distinguishes the two, so that an id never refers to a second
// body. It is 0 for the bodies of a new document, and 1 + n for a body created by the n-th command (from 0)
// of the journal; redo and replay of that command give the body the same id again.
struct BodyId {
  static constexpr uint32_t kNone = kNoIndex;
  uint32_t slot = kNone;
  uint32_t generation = 0;
  constexpr bool valid() const { return slot != kNone; }
  friend constexpr auto operator<=>(BodyId, BodyId) = default;
};

// Identifies a piece: the body that owns its faces, and their label there (FaceData::piece). Label 0 is the
// remainder of the body itself.
struct PieceId {
  BodyId body;
  uint32_t label = 0;
  friend constexpr auto operator<=>(PieceId, PieceId) = default;
};

}  // namespace kerf
