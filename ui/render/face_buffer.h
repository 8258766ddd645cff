#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/world/world.h"
#include "ui/gl/objects.h"
#include "ui/gl/program.h"
#include "ui/render/corner_heat.h"
#include "ui/render/face_slots.h"
#include "ui/render/live_list.h"
#include "ui/render/picture_memory.h"
#include "ui/render/removed_faces.h"

namespace kerf {

// The faces of one body on the GPU. Every face slot of the mesh has a fixed slot of three corners, in chunks
// of a fixed size, so that growing never copies what is there; beside it each chunk has the list of the slots
// that live, and only those are drawn. It follows Deltas; an update costs what changed.
class FaceBuffer {
 public:
  // Nothing is uploaded yet. `bases` are of the mesh as it was loaded, in the frame in which it is drawn.
  FaceBuffer(const Mesh& mesh, const FloatFrame& frame, BaseFaces bases);

  void follow(const BodyDelta& delta) {
    dirty_.mark(delta);
    removed_.forget();
  }
  // Takes every slot as changed: for when Deltas were lost.
  void forget_all(const Mesh& mesh) {
    dirty_.mark_all(std::max(mesh.face_slots(), static_cast<uint32_t>(halvings_.size())));
    removed_.forget();
  }

  // Uploads what changed, from the mesh as it is now; where every slot did, `most` of them and the others in
  // later updates. Returns the number of bytes.
  size_t update(const Mesh& mesh, uint32_t most = DirtySlots::kAll);
  // Whether others are left.
  bool is_sending() const { return dirty_.has_all(); }
  PictureMemory memory() const;

  // How many slots a chunk has.
  static constexpr uint32_t kChunkFaces = 1u << 16;

  // Three vertices a live face; gl_VertexID % 3 is the corner.
  void draw() const;
  // The same, calling before_chunk(i) ahead of the faces of each chunk, whose slots begin at i * kChunkFaces;
  // gl_VertexID / 3 is the slot within the chunk.
  template <typename Before>
  void draw_chunks(const Before& before_chunk) const {
    for (size_t i = 0; i < chunks_.size(); ++i) {
      before_chunk(i);
      chunks_[i].draw();
    }
  }
  // The same for a program that wants to know the slots: its uniform first_slot is that of vertex 0.
  void draw_numbered(const gl::Program& program) const;

  // Draws the surface as loaded where it was cut; see RemovedFaces.
  void draw_removed(const Mesh& mesh);
  std::vector<RemovedFace> removed(const Mesh& mesh) const { return removed_.list(mesh, bases_); }

  const FloatFrame& frame() const { return frame_; }
  // How many live faces there are of each number of halvings; the last counts all above.
  using Halvings = std::array<uint32_t, 64>;
  const Halvings& halvings_of_faces() const { return faces_of_; }

 private:
  static constexpr uint32_t kGap = 4;  // clean slots worth sending to save a call

  static constexpr uint8_t kDead = 0xff;

  struct Chunk {
    gl::Buffer vertices, indices;
    gl::VertexArray layout;
    LiveList live{kChunkFaces};
    Chunk();
    void draw() const;
  };
  Chunk& chunk_of(const SlotRange& range);  // made where it is not there yet
  void count(const Mesh& mesh, uint32_t slot);
  void note_change(const Mesh& mesh, FaceId f, bool lives);
  size_t update_slots(const Mesh& mesh, const SlotRange& range);
  size_t update_list(Chunk& chunk);

  FloatFrame frame_;
  BaseFaces bases_;
  RemovedFaces removed_;
  CornerHeat heat_;
  DirtySlots dirty_;
  std::vector<Chunk> chunks_;
  std::vector<FaceVertices> staging_;
  std::vector<uint8_t> halvings_;  // by slot; kDead where nothing lives
  Halvings faces_of_{};
};

}  // namespace kerf
