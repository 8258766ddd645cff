#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <map>
#include <span>
#include <unordered_map>
#include <vector>

#include "core/base/geometry.h"
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

// Maps a piece label to 16 bits for the GPU; only label 0 is mapped to 0.
uint16_t packed_piece(uint32_t label);

// Returns the three corners for the slot of f, with their distances from the nearest rim [widths]; three
// equal points if the face is dead.
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
  // Returns true if slots marked by mark_all are left.
  bool has_all() const { return all_ > 0; }
  // The number of slots left of those marked by mark_all.
  uint32_t left() const { return all_ - from_; }

  // Returns and clears all of them as ascending ranges. Up to `gap` consecutive clean slots are included to
  // join ranges, and no range crosses a multiple of `chunk`. Of the slots of mark_all, takes only the first
  // `most`.
  static constexpr uint32_t kAll = 0xffffffffu;
  std::vector<SlotRange> take(uint32_t gap, uint32_t chunk, uint32_t most = kAll);

 private:
  std::vector<uint32_t> slots_;
  uint32_t from_ = 0, all_ = 0;  // everything between is dirty
};

// The slots of a chunk to draw, without gaps and in unspecified order: the last one replaces a removed one,
// so removed faces cost nothing to draw.
class LiveList {
 public:
  // Reserves `slots` slots, at least as many as before.
  void make_room(uint32_t slots) { place_.resize(slots, kNone); }

  // Precondition of contains() and set(): the slot is reserved.
  bool contains(uint32_t slot) const { return place_[slot] != kNone; }
  // Adds or removes a slot. Returns true if that changed anything. O(1).
  bool set(uint32_t slot, bool live);

  std::span<const uint32_t> slots() const { return slots_; }
  // Returns the ranges of slots() changed since the last call; joins ranges separated by at most `gap`
  // unchanged places.
  std::vector<SlotRange> take_changes(uint32_t gap);

  size_t bytes() const { return (slots_.capacity() + place_.capacity()) * sizeof(uint32_t); }

 private:
  static constexpr uint32_t kNone = 0xffffffffu;
  std::vector<uint32_t> slots_;
  std::vector<uint32_t> place_;  // by slot
  DirtySlots changed_;
};

using FaceCorners = std::array<glm::vec3, 3>;  // in the body's float frame

struct RemovedFace {
  FaceId face, base;
  FaceCorners corners{};
};

// The faces removed from a body.
//
// The surface as loaded is drawn slightly behind the remaining surface, so that it is visible exactly in
// removed areas, however the faces were split before. Stores the base faces, and those of their parts that
// were drawn and are not tiny; at most kMost parts, which bounds the memory.
class RemovedFaces {
 public:
  static constexpr size_t kMost = 20'000;
  static constexpr float kSmallest = 0.006f;  // minimum longest edge of recorded parts, in the float frame

  // Records the current corners of a part of a base face; may be called repeatedly.
  void saw(FaceId f, const FaceCorners& corners);
  void died(FaceId f, FaceId base);
  // Reports that the slot has a face, perhaps again.
  void came_back(FaceId f) { parts_.erase(f.index); }

  std::vector<RemovedFace> list(const Mesh& mesh, const BaseFaces& bases) const;

  // Uploads the incomplete base faces if forget() was called since the last update; O(base faces) then.
  void update(const Mesh& mesh, const BaseFaces& bases);
  void forget() { old_ = true; }  // after a change of the mesh
  // Draws them; attribute 0 is the position, 1 the index of the base face.
  void draw() const;

 private:
  std::unordered_map<uint32_t, FaceCorners> seen_;  // by slot; only for lookup, never iterated
  std::map<uint32_t, RemovedFace> parts_;           // by slot
  gl::Buffer buffer_;
  gl::VertexArray layout_;
  GLsizei count_ = 0;
  bool old_ = true;
};

}  // namespace kerf
