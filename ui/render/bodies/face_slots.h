#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/float_frame.h"
#include "core/mesh/mesh.h"
#include "ui/render/bodies/base_faces.h"

namespace kerf {

// A corner of a face in the format of the GPU.
struct FaceVertex {
  std::array<float, 3> position{};  // in the body's float frame
  uint32_t normal = 0;              // pack_normal
  uint16_t rim = 0;      // half float: distance from the nearest rim (see RimDistance) in its widths
  uint8_t halvings = 0;  // of the face
  uint8_t material = 0;  // of the face; the last of 256 stands for all others
  friend bool operator==(const FaceVertex&, const FaceVertex&) = default;
};
static_assert(sizeof(FaceVertex) == 20);

using FaceVertices = std::array<FaceVertex, 3>;

// Maps the label of a piece to the 16 bits that the GPU has for it; only label 0 is mapped to 0.
uint16_t packed_piece(uint32_t label);

// The three corners for the slot of f, whose corners are so far from the nearest rim, in widths; three equal
// points if the face is dead.
FaceVertices face_vertices(const Mesh& mesh, const BaseFaces& bases, const FloatFrame& frame, FaceId f,
                           const std::array<float, 3>& rim);

// Slots [begin, end).
struct SlotRange {
  uint32_t begin = 0, end = 0;
  friend bool operator==(const SlotRange&, const SlotRange&) = default;
};

// The slots whose data on the GPU are out of date.
class DirtySlots {
 public:
  void mark(uint32_t slot) { slots_.push_back(slot); }
  void mark(std::span<const FaceId> faces);
  void mark_all(uint32_t slots);
  bool empty() const { return slots_.empty() && !has_all(); }
  // Whether slots that mark_all marked are left.
  bool has_all() const { return all_ > 0; }
  // The number of slots that mark_all marked and that are left.
  uint32_t left() const { return all_ - from_; }

  // Returns and clears all of them as ascending ranges. Up to `gap` consecutive clean slots are included to
  // join ranges, and no range crosses a multiple of `chunk`. Of the slots of mark_all only the first `most`
  // are taken.
  static constexpr uint32_t kAll = 0xffffffffu;
  std::vector<SlotRange> take(uint32_t gap, uint32_t chunk, uint32_t most = kAll);

 private:
  std::vector<uint32_t> slots_;
  uint32_t from_ = 0, all_ = 0;  // everything between is dirty
};

}  // namespace kerf
