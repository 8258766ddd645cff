#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/base/containers.h"
#include "core/base/geometry.h"
#include "core/joints/joined_parts.h"
#include "core/world/world.h"
#include "core/world/world_delta.h"
#include "ui/gl/buffers.h"
#include "ui/gl/program.h"
#include "ui/render/bodies/base_faces.h"
#include "ui/render/bodies/face_slots.h"
#include "ui/render/bodies/rim_distance.h"
#include "ui/render/view/view_options.h"

namespace kerf {

// The heat of a face at a vertex: its current and maximum mean temperatures, which hold at its centroid.
struct FaceSample {
  Vec3 centroid;
  double size;                           // its longest edge [m]
  std::array<double, 2> temperatures{};  // K
};

// A temperature at a vertex [K] and its gradient there [K/m].
struct LocalHeat {
  double at = 0;
  Vec3 gradient{0};
};

// Fits linear temperature fields to the faces around a vertex. The mean of a few faces of different sizes
// would be the temperature of another place than the vertex. Least squares, weighted by the inverse fourth
// power of the face size, since the mean of a large face says little about the vicinity of one of its
// corners. The gradient is zero in directions not determined by the centroids. Preconditions: there are
// samples, and none has the size 0.
std::array<LocalHeat, 2> fit_heat(const Vec3& vertex, std::span<const FaceSample> samples);

// A temperature at a face corner in the format of the GPU: in units of kHeatUnit, 0 at the ambient, and its
// gradient as half floats, in units of kHeatGradientUnit over the unit of the float frame.
struct CornerTemperature {
  uint16_t at = 0;
  std::array<uint16_t, 3> gradient{};
  friend bool operator==(const CornerTemperature&, const CornerTemperature&) = default;
};

// The heat shown at a face corner.
struct HeatMark {
  CornerTemperature now;
  CornerTemperature hottest;  // maximum so far
  friend bool operator==(const HeatMark&, const HeatMark&) = default;
};
static_assert(sizeof(HeatMark) == 16);

inline constexpr double kHeatUnit = 1.0 / 16;     // K
inline constexpr double kHeatGradientUnit = 256;  // K

// The temperatures of face corners with their gradients, fitted to the faces around each corner on its
// sheet (see fit_heat). Heat known per face then shows no facets, and a large face next to a hot place is
// hot only near it: the temperature of a point is the barycentric mean of the extrapolations from its three
// corners, clamped between the ambient and the same mean of the corner temperatures. It is continuous
// across edges. Visits only corners of faces that are or were hot; a body that was never hot costs nothing.
class CornerHeat {
 public:
  // Returns true if any corner is or was hot.
  bool any() const { return !marks_.empty() || !wall_marks_.empty(); }
  // The temperature of the hottest face at the last update [K].
  double warmest() const { return warmest_; }

  // Follows the heat of the body, whose float frame has this scale (> 0), the same at each update.
  // `changed` are corners of faces that were added, removed or got new corners; vertices missing in the
  // mesh are skipped. Appends the faces with new marks at their corners to `affected`. Fits the corners of
  // faces that changed or have another temperature, in parallel; compares each face that is or was hot.
  void update(const Body& body, double scale, std::span<const VertexId> changed,
              std::vector<FaceId>& affected);

  // Precondition: f is live.
  std::array<HeatMark, 3> of(const Mesh& mesh, FaceId f) const;

 private:
  struct Known {
    double energy = 0;  // J
    double now = kAmbient, hottest = kAmbient;
  };
  // New marks of vertices, and the faces at them.
  struct NewMarks {
    std::vector<std::pair<VertexId, HeatMark>> of_surface, of_walls;
    std::vector<FaceId> affected;
  };
  class Fitter;

  void forget_temperatures(const Body& body, std::span<const VertexId> changed);
  void find_reheated(const Body& body);
  void find_tinted(const Body& body);
  void list_corners(const Mesh& mesh, FaceId f);
  bool list_corner(VertexId v);
  static void set_marks(std::vector<HeatMark>& marks, std::span<const std::pair<VertexId, HeatMark>> found);

  // By vertex: of the surface, and of walls, which are larger and meet it at an angle, so neither fit
  // applies to the other.
  std::vector<HeatMark> marks_, wall_marks_;
  WallFaces walls_;
  Sheet sheet_;
  PagedArray<Known> known_;         // by face
  std::vector<FaceId> hot_;         // faces that had energy
  std::vector<FaceId> tinted_;      // faces hot enough to keep their maximum temperature
  std::vector<VertexId> to_fit_;    // of an update
  std::vector<uint8_t> is_listed_;  // by vertex: it is in to_fit_
  double warmest_ = kAmbient;
};

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
