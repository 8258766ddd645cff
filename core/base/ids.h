#pragma once

#include <compare>
#include <cstdint>

namespace kerf {

// A slot in an array of one kind of thing. Slots only grow while a document is open; a slot that died is not
// handed out again. Tag keeps the kinds apart.
template <typename Tag>
struct Id {
  static constexpr uint32_t kNone = 0xffffffffu;
  uint32_t index = kNone;

  constexpr Id() = default;
  constexpr explicit Id(uint32_t i) : index(i) {}
  constexpr bool valid() const { return index != kNone; }
  friend constexpr auto operator<=>(Id, Id) = default;
};

using VertexId = Id<struct VertexTag>;
using EdgeId = Id<struct EdgeTag>;
using FaceId = Id<struct FaceTag>;

// A body of a world: its slot and how often that slot was reused, so that an old id never names a new body.
struct BodyId {
  uint32_t slot = 0xffffffffu;
  uint32_t generation = 0;
  constexpr bool valid() const { return slot != 0xffffffffu; }
  friend constexpr auto operator<=>(BodyId, BodyId) = default;
};

}  // namespace kerf
