#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <map>
#include <span>
#include <unordered_map>
#include <vector>

#include "core/base/float_frame.h"
#include "core/mesh/mesh.h"
#include "ui/gl/buffers.h"
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

// The slots of a chunk that are to be drawn, without gaps and in unspecified order: the last one takes the
// place of a removed one. Removed faces therefore cost nothing to draw.
class LiveList {
 public:
  // Makes room for so many slots, at least as many as before.
  void make_room(uint32_t slots) { place_.resize(slots, kNone); }

  // Precondition of this and the next one: there is room for the slot.
  bool contains(uint32_t slot) const { return place_[slot] != kNone; }
  // Adds or removes a slot. Returns whether that changed anything. Constant time.
  bool set(uint32_t slot, bool live);

  std::span<const uint32_t> slots() const { return slots_; }
  // The ranges of slots() that changed since the last call; ranges separated by at most `gap` unchanged
  // places are joined.
  std::vector<SlotRange> take_changes(uint32_t gap);

  // Memory allocated, in bytes.
  size_t bytes() const { return (slots_.capacity() + place_.capacity()) * sizeof(uint32_t); }

 private:
  static constexpr uint32_t kNone = 0xffffffffu;
  std::vector<uint32_t> slots_;
  std::vector<uint32_t> place_;  // by slot
  DirtySlots changed_;
};

using FaceCorners = std::array<glm::vec3, 3>;  // in the body's float frame

// A removed face with its last known corners.
struct RemovedFace {
  FaceId face, base;
  FaceCorners corners{};
};

// The faces that were removed from a body.
//
// The surface as loaded is drawn slightly behind the remaining surface, so that it is visible exactly where
// faces were removed, however they were split before. As individual faces, the base faces are known, and
// those parts of base faces that were seen and are not tiny; at most kMost of them, so that memory is
// bounded.
class RemovedFaces {
 public:
  static constexpr size_t kMost = 20'000;
  static constexpr float kSmallest =
      0.006f;  // longest edge below which parts are not recorded, in the float frame

  // Records the current corners of a part of a base face; may be called repeatedly.
  void saw(FaceId f, const FaceCorners& corners);
  // Reports that the face of a slot was removed.
  void died(FaceId f, FaceId base);
  // Reports that the slot has a face, perhaps again.
  void came_back(FaceId f) { parts_.erase(f.index); }

  // All removed base faces and recorded parts.
  std::vector<RemovedFace> list(const Mesh& mesh, const BaseFaces& bases) const;

  // Uploads the base faces that are incomplete, if forget() was called since. O(base faces) then.
  void update(const Mesh& mesh, const BaseFaces& bases);
  // Reports that the mesh has changed.
  void forget() { old_ = true; }
  // Draws them; attribute 0 is the position, 1 the index of the base face.
  void draw() const;

 private:
  std::unordered_map<uint32_t, FaceCorners> seen_;  // by slot; looked up, never walked
  std::map<uint32_t, RemovedFace> parts_;           // by slot
  gl::Buffer buffer_;
  gl::VertexArray layout_;
  GLsizei count_ = 0;
  bool old_ = true;
};

}  // namespace kerf
