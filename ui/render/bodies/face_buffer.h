#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "core/joints/piece_groups.h"
#include "core/world/world.h"
#include "core/world/world_delta.h"
#include "ui/gl/buffers.h"
#include "ui/gl/program.h"
#include "ui/render/bodies/corner_heat.h"
#include "ui/render/bodies/face_slots.h"
#include "ui/render/bodies/prepared_body.h"
#include "ui/render/bodies/rim_distance.h"
#include "ui/render/view/view_options.h"

namespace kerf {

// The faces of one body on the GPU. Every face slot of the mesh has a fixed slot of three corners, in
// chunks of a fixed size, so that growth copies little; a chunk begins small and doubles up to that size,
// because worlds have many small bodies. Each chunk has a list of its live slots, and only these are drawn.
// The buffer follows Deltas, and the cost of an update is proportional to the changes. Piece labels are in
// a separate buffer, so that a relabelled face uploads only its label.
class FaceBuffer {
 public:
  // Uploads nothing yet. `glow_width` [m] is that of RimDistance. Precondition: `bases` is not null and
  // belongs to the mesh, with the same frame.
  FaceBuffer(const Mesh& mesh, const FloatFrame& frame, std::shared_ptr<const BaseFaces> bases,
             double glow_width);

  void follow(const BodyDelta& delta);
  // Makes the next update upload the groups of the faces instead of the labels of their pieces, or, if
  // null, the labels again.
  void group(const Mesh& mesh, const std::shared_ptr<const PieceGroups>& groups);
  // Shades by other bases of the same faces from the next update on; null: by the initial ones.
  void shade(const Mesh& mesh, std::shared_ptr<const BaseFaces> bases);
  // Returns true if shade() has set other bases.
  bool is_smooth() const { return smooth_; }
  // Marks every slot as changed, in case Deltas were lost.
  void forget_all(const Mesh& mesh) {
    dirty_.mark_all(std::max(mesh.face_slots(), static_cast<uint32_t>(halvings_.size())));
    removed_.forget();
    if (heat_.any()) reheated_.mark_all(mesh.face_slots());
  }

  // Uploads the changes of the body's current mesh. If every slot changed, uploads at most `most` of them;
  // later calls upload the others. Returns the number of bytes uploaded.
  size_t update(const Body& body, uint32_t most = DirtySlots::kAll);
  // Uploads the changes of the body's heat. Precondition: its mesh is that of the last update.
  // `time_passed`: heat may have flowed since the last call. Returns the number of bytes uploaded.
  size_t update_heat(const Body& body, bool time_passed);
  // Uploads the changes of the scalar field that colours the faces; null frees it. Returns the number of
  // bytes uploaded.
  size_t update_scalars(const std::shared_ptr<const FaceScalars>& scalars);
  const CornerHeat& heat() const { return heat_; }
  // Returns true if slots are left for later calls.
  bool is_sending() const { return dirty_.has_all(); }
  // Returns true if faces have UVs.
  bool has_uvs() const { return has_uvs_; }
  // The number of slots, and how many of them are left for later calls.
  size_t slots() const { return corners_.size(); }
  size_t unsent() const { return dirty_.left(); }
  PictureMemory memory() const;

  // The largest number of slots in a chunk.
  static constexpr uint32_t kChunkFaces = 1u << 16;

  // Draws three vertices per live face; gl_VertexID % 3 is the corner.
  void draw() const;
  // Draws like draw(), and calls before_chunk(i) before the faces of each chunk, whose slots start at i *
  // kChunkFaces; gl_VertexID / 3 is the slot within the chunk.
  template <typename Before>
  void draw_chunks(const Before& before_chunk) const {
    for (size_t i = 0; i < chunks_.size(); ++i) {
      if (chunks_[i].live.slots().empty()) continue;
      before_chunk(i);
      chunks_[i].draw();
    }
  }
  // Draws with a program that needs face slots: its uniform first_slot is set to the slot of vertex 0.
  void draw_numbered(const gl::Program& program) const;

  // Draws the removed parts of the loaded surface; see RemovedFaces.
  void draw_removed(const Mesh& mesh);
  std::vector<RemovedFace> removed(const Mesh& mesh) const { return removed_.list(mesh, *bases_); }

  const FloatFrame& frame() const { return frame_; }
  float deviation() const { return bases_->deviation(); }
  // Returns true if a cut has left a rim, which glows.
  bool has_rim() const { return rims_.any(); }
  // The number of live faces by their number of halvings; the last element includes all larger numbers.
  using Halvings = std::array<uint32_t, 64>;
  const Halvings& halvings_of_faces() const { return faces_of_; }

 private:
  static constexpr uint32_t kGap = 4;  // largest gap of unchanged slots within one upload

  static constexpr uint8_t kDead = 0xff;
  using Corners = std::array<VertexId, 3>;
  using Labels = std::array<uint16_t, 3>;  // of a face, one per corner
  using Heat = std::array<HeatMark, 3>;
  using Scalars = std::array<float, 3>;  // of a face, one per corner
  using Uvs = std::array<glm::vec2, 3>;  // v = 0 is the top row of an image

  struct Chunk {
    gl::Buffer vertices, labels, indices;
    gl::VertexArray layout;
    LiveList live;
    std::optional<gl::Buffer> heat;     // of chunks with faces that were ever hot
    std::optional<gl::Buffer> scalars;  // while a scalar field is shown
    std::optional<gl::Buffer> uvs;      // if faces have UVs
    uint32_t room = 0;                  // slots
    // Reserves `slots` slots, more than before. Frees the scalars.
    void make_room(uint32_t slots);
    void make_heat();
    void read_heat() const;
    void make_uvs();
    void read_uvs() const;
    void make_scalars();
    void free_scalars();
    void draw() const;
  };
  // Returns the chunk of a range, which lies in one chunk; creates or enlarges it if necessary.
  Chunk& chunk_of(const SlotRange& range);
  void count(const Mesh& mesh, uint32_t slot);
  void record_change(const Mesh& mesh, FaceId f, bool lives);
  DirtySlots take_added(const Mesh& mesh, uint32_t most);
  void record_corners(const Mesh& mesh, uint32_t slot);
  void find_rims(const Mesh& mesh, DirtySlots& added);
  std::array<float, 3> rim_of(const Mesh& mesh, FaceId f) const;
  size_t update_slots(const Body& body, const SlotRange& range);
  size_t update_uvs(const SlotRange& range);
  void stage_looks(const Body& body, const SlotRange& range);
  size_t update_labels(const Mesh& mesh, const SlotRange& range);
  size_t update_heat_of(const Mesh& mesh, const SlotRange& range);
  size_t update_list(Chunk& chunk);

  FloatFrame frame_;
  std::shared_ptr<const BaseFaces> first_bases_, bases_;
  bool smooth_ = false, has_uvs_ = false;
  RemovedFaces removed_;
  RimDistance rims_;
  CornerHeat heat_;
  Sheet sheet_;  // of the temperatures
  std::shared_ptr<const PieceGroups> groups_;
  std::shared_ptr<const FaceScalars> scalars_;
  size_t chunks_with_scalars_ = 0;
  DirtySlots dirty_, relabelled_, reheated_;
  std::vector<Chunk> chunks_;
  std::vector<FaceVertices> staging_;
  std::vector<Uvs> staged_uvs_;
  std::vector<Labels> staged_labels_;
  std::vector<VertexId> moved_corners_;     // of faces changed since the last search for rims
  std::vector<VertexId> reheated_corners_;  // of faces changed since the last update of heat
  std::vector<Corners> corners_;            // by slot, as last drawn
  std::vector<uint8_t> halvings_;           // by slot; kDead without a live face
  Halvings faces_of_{};
};

}  // namespace kerf
