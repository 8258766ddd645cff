#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/float_frame.h"
#include "core/mesh/mesh.h"
#include "core/world/delta.h"
#include "ui/render/base_faces.h"

namespace kerf {

// A corner of a face as the GPU reads it.
struct FaceVertex {
  std::array<float, 3> position{};  // in the body's float frame
  uint32_t normal = 0;              // pack_normal
  uint32_t attributes = 0;          // pack_attributes
  friend bool operator==(const FaceVertex&, const FaceVertex&) = default;
};
static_assert(sizeof(FaceVertex) == 20);

using FaceVertices = std::array<FaceVertex, 3>;

// A piece's label in 16 bits; the body's own, 0, stays alone.
uint32_t packed_piece(uint32_t label);

// Heat (halvings, as CornerHeat tells them) times 8 in 8 bits, material in 8, piece in 16. What does not fit
// is folded or cut off.
uint32_t pack_attributes(const FaceData& data, float heat);

// The three corners of the slot of f, each with the heat given: those of the face where it lives, three equal
// points where it does not.
FaceVertices face_vertices(const Mesh& mesh, const BaseFaces& bases, const FloatFrame& frame, FaceId f,
                           const std::array<float, 3>& heat = {});

// Slots [begin, end).
struct SlotRange {
  uint32_t begin = 0, end = 0;
  friend bool operator==(const SlotRange&, const SlotRange&) = default;
};

// The slots whose picture is older than the mesh.
class DirtySlots {
 public:
  void mark(uint32_t slot) { slots_.push_back(slot); }
  void mark(const BodyDelta& delta);
  void mark_all(uint32_t slots);
  bool empty() const { return slots_.empty() && !has_all(); }
  // Whether slots are left that mark_all marked.
  bool has_all() const { return all_ > 0; }

  // All of them, ascending, as ranges in which no more than `gap` clean slots in a row are taken along; none
  // crosses a multiple of `chunk`. Nothing is dirty after, but for slots of mark_all beyond the first `most`.
  static constexpr uint32_t kAll = 0xffffffffu;
  std::vector<SlotRange> take(uint32_t gap, uint32_t chunk, uint32_t most = kAll);

 private:
  std::vector<uint32_t> slots_;
  uint32_t from_ = 0, all_ = 0;  // everything between is dirty
};

}  // namespace kerf
