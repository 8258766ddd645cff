#include "ui/render/bodies/face_buffer.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <glm/glm.hpp>
#include <glm/gtc/packing.hpp>

#include "core/base/assert.h"
#include "core/base/parallel.h"
#include "core/document/piece_looks.h"
#include "core/mesh/looks.h"
#include "core/mesh/refinement.h"

namespace kerf {

namespace {

// Fraction of the matrix's trace added to its diagonal, so that rounding decides nothing in undetermined
// directions.
constexpr double kOpenShare = 1e-4;
// Maximum deviation of the vertex beyond the temperatures of the faces, relative to their range.
constexpr double kMaxBeyond = 0.5;

double weight_of(const FaceSample& sample) {
  const double size2 = sample.size * sample.size;
  return 1 / (size2 * size2);
}

struct Mean {
  double weight = 0;
  Vec3 offset{0};  // from the vertex
  std::array<double, 2> temperatures{};
};

Mean mean_of(const Vec3& vertex, std::span<const FaceSample> samples) {
  Mean mean;
  for (const FaceSample& sample : samples) {
    const double weight = weight_of(sample);
    mean.weight += weight;
    mean.offset += weight * (sample.centroid - vertex);
    for (size_t i = 0; i < 2; ++i) mean.temperatures[i] += weight * sample.temperatures[i];
  }
  mean.offset /= mean.weight;
  for (double& temperature : mean.temperatures) temperature /= mean.weight;
  return mean;
}

constexpr double kColdWithin = 0.5;  // K, invisible
constexpr double kUnknown = -1;      // J, which no face has
// The maximum temperature of a corner at the outline of the heated area, between the temperatures of its
// faces.
constexpr double kAtOutline = 0.25;

// Packs a half float; never infinite.
uint16_t packed_half(double x) {
  constexpr double kLargest = 65504;
  return glm::packHalf1x16(static_cast<float>(std::clamp(x, -kLargest, kLargest)));
}

CornerTemperature packed(const LocalHeat& heat, double scale) {
  CornerTemperature corner;
  const Vec3 gradient = heat.gradient / (scale * kHeatGradientUnit);
  for (int i = 0; i < 3; ++i) corner.gradient[static_cast<size_t>(i)] = packed_half(gradient[i]);
  if (heat.at >= kAmbient + kColdWithin)
    corner.at = static_cast<uint16_t>(std::min(65535.0, std::round(heat.at / kHeatUnit)));
  return corner;
}

// Faces that were never hot enough to keep their maximum temperature only bound it: the heated area ends
// between their centroids and those of the others, where the temperature falls to the bound, not at the
// edge of a face. Removes their samples.
CornerTemperature hottest_at(const Vec3& vertex, std::vector<FaceSample>& samples, double scale) {
  const size_t cold =
      std::erase_if(samples, [](const FaceSample& s) { return s.temperatures[1] <= kAmbient; });
  if (samples.empty()) return {};
  LocalHeat heat = fit_heat(vertex, samples)[1];
  if (cold > 0) {
    const auto [least, most] =
        std::ranges::minmax(samples, {}, [](const FaceSample& s) { return s.temperatures[1]; });
    heat.at = std::min(heat.at, glm::mix(least.temperatures[1], most.temperatures[1], kAtOutline));
  }
  return packed(heat, scale);
}

using Indices = std::array<uint32_t, 3>;

constexpr GLuint kScalarAttribute = 9, kUvAttribute = 10;
constexpr size_t kMinRoom = 64;  // slots

FaceCorners corners_of(const FaceVertices& face) {
  const auto at = [&](size_t i) {
    return glm::vec3(face[i].position[0], face[i].position[1], face[i].position[2]);
  };
  return {at(0), at(1), at(2)};
}

}  // namespace

std::array<LocalHeat, 2> fit_heat(const Vec3& vertex, std::span<const FaceSample> samples) {
  KERF_ASSERT(!samples.empty() && std::all_of(samples.begin(), samples.end(),
                                              [](const FaceSample& sample) { return sample.size > 0; }));
  const Mean mean = mean_of(vertex, samples);
  glm::dmat3 spread(0);
  std::array<Vec3, 2> moments{Vec3(0), Vec3(0)};
  std::array<double, 2> least = samples[0].temperatures, most = least;
  for (const FaceSample& sample : samples) {
    const Vec3 offset = sample.centroid - vertex - mean.offset;
    const Vec3 weighted = weight_of(sample) * offset;
    spread += glm::outerProduct(offset, weighted);
    for (size_t i = 0; i < 2; ++i) {
      moments[i] += weighted * (sample.temperatures[i] - mean.temperatures[i]);
      least[i] = std::min(least[i], sample.temperatures[i]);
      most[i] = std::max(most[i], sample.temperatures[i]);
    }
  }
  const double trace = spread[0][0] + spread[1][1] + spread[2][2];
  glm::dmat3 inverse(0);
  if (trace > 0) inverse = glm::inverse(spread / trace + glm::dmat3(kOpenShare)) / trace;
  std::array<LocalHeat, 2> fits;
  for (size_t i = 0; i < 2; ++i) {
    const Vec3 gradient = inverse * moments[i];
    const double beyond = kMaxBeyond * (most[i] - least[i]);
    fits[i] = {std::clamp(mean.temperatures[i] - glm::dot(gradient, mean.offset), least[i] - beyond,
                          most[i] + beyond),
               gradient};
  }
  return fits;
}

// Computes the marks of vertices from the known temperatures of their faces.
class CornerHeat::Fitter {
 public:
  Fitter(const CornerHeat& heat, const Body& body, double scale) : heat_(heat), body_(body), scale_(scale) {}

  // Appends the changed marks at a vertex of the mesh.
  void fit(VertexId v, NewMarks& found) {
    body_.mesh.star(v, star_);
    std::vector<FaceId>& faces = star_.faces;
    const auto is_wall = [&](FaceId f) { return heat_.walls_.contain(body_.mesh, f); };
    auto walls = faces.end();
    if (std::ranges::any_of(faces, is_wall))
      walls = std::stable_partition(faces.begin(), faces.end(), std::not_fn(is_wall));
    const std::span<const FaceId> surface(faces.begin(), walls), beside(walls, faces.end());
    note(heat_.marks_, v, mark_at(v, surface), surface, found.of_surface, found.affected);
    HeatMark of_wall = mark_at(v, beside);
    of_wall.now.gradient = of_wall.hottest.gradient = {};
    note(heat_.wall_marks_, v, of_wall, beside, found.of_walls, found.affected);
  }

 private:
  HeatMark mark_at(VertexId v, std::span<const FaceId> faces) {
    samples_.clear();
    double most = 0;
    for (const FaceId f : faces) {
      const Triangle t = body_.mesh.triangle(f);
      const double size2 = longest_edge2(t);
      if (size2 == 0) continue;
      const Known known = heat_.known_.get(f.index);
      samples_.push_back({(t[0] + t[1] + t[2]) / 3.0, std::sqrt(size2), {known.now, known.hottest}});
      most = std::max({most, known.now, known.hottest});
    }
    if (most < kAmbient + kColdWithin) return {};
    const Vec3& at = body_.mesh.position(v);
    const CornerTemperature now = packed(fit_heat(at, samples_)[0], scale_);
    return {now, hottest_at(at, samples_, scale_)};
  }

  static void note(const std::vector<HeatMark>& marks, VertexId v, const HeatMark& mark,
                   std::span<const FaceId> faces, std::vector<std::pair<VertexId, HeatMark>>& found,
                   std::vector<FaceId>& affected) {
    if (mark == (v.index < marks.size() ? marks[v.index] : HeatMark{})) return;
    found.emplace_back(v, mark);
    affected.insert(affected.end(), faces.begin(), faces.end());
  }

  const CornerHeat& heat_;
  const Body& body_;
  double scale_;
  Mesh::Star star_;
  std::vector<FaceSample> samples_;
};

// Returns true if it was not in the list.
bool CornerHeat::list_corner(VertexId v) {
  if (is_listed_.size() <= v.index) is_listed_.resize(v.index + 1, 0);
  if (std::exchange(is_listed_[v.index], 1) != 0) return false;
  to_fit_.push_back(v);
  return true;
}

void CornerHeat::list_corners(const Mesh& mesh, FaceId f) {
  for (const VertexId v : mesh.corners(f)) list_corner(v);
}

// A face with other corners has another temperature with the same energy.
void CornerHeat::forget_temperatures(const Body& body, std::span<const VertexId> changed) {
  Mesh::Star star;
  for (const VertexId v : changed) {
    if (v.index >= body.mesh.vertex_slots() || !list_corner(v)) continue;
    body.mesh.star(v, star);
    for (const FaceId f : star.faces) {
      if (known_.get(f.index).energy != 0) known_.at(f.index).energy = kUnknown;
    }
  }
}

// Lists the corners of faces whose energy has changed since the last update.
void CornerHeat::find_reheated(const Body& body) {
  const FaceColumns& columns = body.mesh.columns();
  const auto note = [&](FaceId f) {
    const double energy = columns.get(body.heat.energy, f);
    if (known_.get(f.index).energy != energy) {
      Known& known = known_.at(f.index);
      known.energy = energy;
      const bool lives = body.mesh.is_live(f);
      known.now = lives ? body.heat.temperature(body.mesh, f, sheet_.substance, sheet_.thickness) : kAmbient;
      if (lives) list_corners(body.mesh, f);
    }
    warmest_ = std::max(warmest_, known_.get(f.index).now);
  };
  warmest_ = kAmbient;
  for (const FaceId f : std::exchange(hot_, {})) note(f);
  columns.for_each_set(body.heat.energy, [&](FaceId f) {
    hot_.push_back(f);
    note(f);
  });
}

// Lists the corners of faces whose maximum temperature has changed since the last update.
void CornerHeat::find_tinted(const Body& body) {
  const auto note = [&](FaceId f) {
    const double hottest = body.heat.hottest_of(body.mesh, f);
    if (known_.get(f.index).hottest == hottest) return;
    known_.at(f.index).hottest = hottest;
    if (body.mesh.is_live(f)) list_corners(body.mesh, f);
  };
  for (const FaceId f : std::exchange(tinted_, {})) note(f);
  body.mesh.columns().for_each_set(body.heat.hottest, [&](FaceId f) {
    tinted_.push_back(f);
    note(f);
  });
}

void CornerHeat::update(const Body& body, double scale, std::span<const VertexId> changed,
                        std::vector<FaceId>& affected) {
  KERF_ASSERT(scale > 0);
  constexpr size_t kTogether = 1024;  // vertices
  if (sheet_ != body.sheet) {
    for (const FaceId f : hot_) known_.at(f.index).energy = kUnknown;
  }
  sheet_ = body.sheet;
  walls_ = body.walls;
  forget_temperatures(body, changed);
  find_reheated(body);
  find_tinted(body);
  std::vector<NewMarks> found(range_count(to_fit_.size(), kTogether));
  for_each_range(to_fit_.size(), kTogether, [&](size_t begin, size_t end) {
    Fitter fitter(*this, body, scale);
    for (size_t i = begin; i < end; ++i) fitter.fit(to_fit_[i], found[begin / kTogether]);
  });
  for (const NewMarks& part : found) {
    set_marks(marks_, part.of_surface);
    set_marks(wall_marks_, part.of_walls);
    affected.insert(affected.end(), part.affected.begin(), part.affected.end());
  }
  for (const VertexId v : to_fit_) is_listed_[v.index] = 0;
  to_fit_.clear();
}

void CornerHeat::set_marks(std::vector<HeatMark>& marks,
                           std::span<const std::pair<VertexId, HeatMark>> found) {
  for (const auto& [v, mark] : found) {
    if (marks.size() <= v.index) marks.resize(v.index + 1);
    marks[v.index] = mark;
  }
}

std::array<HeatMark, 3> CornerHeat::of(const Mesh& mesh, FaceId f) const {
  const std::vector<HeatMark>& known = walls_.contain(mesh, f) ? wall_marks_ : marks_;
  std::array<HeatMark, 3> marks;
  const std::array<VertexId, 3> corners = mesh.corners(f);
  for (size_t i = 0; i < 3; ++i) {
    if (corners[i].index < known.size()) marks[i] = known[corners[i].index];
  }
  return marks;
}

void FaceBuffer::Chunk::make_room(uint32_t slots) {
  KERF_ASSERT(slots > room && slots <= kChunkFaces);
  free_scalars();
  gl::enlarge_buffer(vertices, room * sizeof(FaceVertices), slots * sizeof(FaceVertices));
  gl::enlarge_buffer(labels, room * sizeof(Labels), slots * sizeof(Labels));
  gl::enlarge_buffer(indices, room * sizeof(Indices), slots * sizeof(Indices));
  if (heat) {
    const std::vector<Heat> cold(slots);
    gl::enlarge_buffer(*heat, room * sizeof(Heat), slots * sizeof(Heat), cold.data());
  }
  if (uvs) gl::enlarge_buffer(*uvs, room * sizeof(Uvs), slots * sizeof(Uvs));
  room = slots;
  live.make_room(slots);
  glBindVertexArray(layout.name());
  glBindBuffer(GL_ARRAY_BUFFER, vertices.name());
  constexpr size_t kSize = sizeof(FaceVertex);
  gl::read_floats(0, {3, GL_FLOAT, offsetof(FaceVertex, position)}, kSize);
  gl::read_floats(1, {4, GL_INT_2_10_10_10_REV, offsetof(FaceVertex, normal), true}, kSize);
  gl::read_floats(3, {1, GL_HALF_FLOAT, offsetof(FaceVertex, rim)}, kSize);
  gl::read_whole(4, {2, GL_UNSIGNED_BYTE, offsetof(FaceVertex, halvings)}, kSize);
  glBindBuffer(GL_ARRAY_BUFFER, labels.name());
  gl::read_whole(2, {1, GL_UNSIGNED_SHORT}, sizeof(uint16_t));
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices.name());
  if (heat) read_heat();
  if (uvs) read_uvs();
  glBindVertexArray(0);
}

// Corners that were never uploaded are cold; without the buffer all are.
void FaceBuffer::Chunk::make_heat() {
  if (heat) return;
  const std::vector<Heat> cold(room);
  glBindVertexArray(layout.name());
  gl::fill_buffer(GL_ARRAY_BUFFER, heat.emplace(), cold.size() * sizeof(Heat), cold.data());
  read_heat();
  glBindVertexArray(0);
}

// Precondition: the layout is bound.
void FaceBuffer::Chunk::read_heat() const {
  glBindBuffer(GL_ARRAY_BUFFER, heat->name());
  for (const auto& [attribute, start] :
       {std::pair(5u, offsetof(HeatMark, now)), std::pair(7u, offsetof(HeatMark, hottest))}) {
    const size_t at = start + offsetof(CornerTemperature, at),
                 gradient = start + offsetof(CornerTemperature, gradient);
    gl::read_floats(attribute, {1, GL_UNSIGNED_SHORT, at, true}, sizeof(HeatMark));
    gl::read_floats(attribute + 1, {3, GL_HALF_FLOAT, gradient}, sizeof(HeatMark));
  }
}

void FaceBuffer::Chunk::make_uvs() {
  if (uvs) return;
  glBindVertexArray(layout.name());
  gl::fill_buffer(GL_ARRAY_BUFFER, uvs.emplace(), room * sizeof(Uvs));
  read_uvs();
  glBindVertexArray(0);
}

// Precondition: the layout is bound.
void FaceBuffer::Chunk::read_uvs() const {
  glBindBuffer(GL_ARRAY_BUFFER, uvs->name());
  gl::read_floats(kUvAttribute, {2}, sizeof(glm::vec2));
}

void FaceBuffer::Chunk::make_scalars() {
  if (scalars) return;
  scalars.emplace();
  glBindVertexArray(layout.name());
  gl::fill_buffer(GL_ARRAY_BUFFER, *scalars, room * sizeof(Scalars));
  gl::read_floats(kScalarAttribute, {1}, sizeof(float));
  glBindVertexArray(0);
}

void FaceBuffer::Chunk::free_scalars() {
  if (!scalars) return;
  glBindVertexArray(layout.name());
  glDisableVertexAttribArray(kScalarAttribute);
  glBindVertexArray(0);
  scalars.reset();
}

FaceBuffer::FaceBuffer(const Mesh& mesh, const FloatFrame& frame, std::shared_ptr<const BaseFaces> bases,
                       double glow_width)
    : frame_(frame),
      first_bases_(std::move(bases)),
      bases_(first_bases_),
      rims_(static_cast<float>(glow_width * frame.scale)) {
  KERF_ASSERT(bases_ != nullptr);
  dirty_.mark_all(mesh.face_slots());
}

void FaceBuffer::follow(const BodyDelta& delta) {
  dirty_.mark(delta.added);
  dirty_.mark(delta.dead);
  relabelled_.mark(delta.relabelled);
  removed_.forget();
}

void FaceBuffer::shade(const Mesh& mesh, std::shared_ptr<const BaseFaces> bases) {
  smooth_ = bases != nullptr;
  bases_ = bases ? std::move(bases) : first_bases_;
  dirty_.mark_all(mesh.face_slots());
}

void FaceBuffer::group(const Mesh& mesh, const std::shared_ptr<const PieceGroups>& groups) {
  relabelled_.mark(regrouped(mesh, groups_.get(), groups.get()));
  groups_ = groups;
}

PictureMemory FaceBuffer::memory() const {
  PictureMemory memory;
  memory.shading = first_bases_->bytes() + (smooth_ ? bases_->bytes() : 0);
  memory.graphics = halvings_.capacity() + corners_.capacity() * sizeof(Corners) +
                    staging_.capacity() * sizeof(FaceVertices) + staged_labels_.capacity() * sizeof(Labels);
  for (const Chunk& chunk : chunks_)
    memory.graphics += chunk.live.bytes() +
                       chunk.room * (sizeof(FaceVertices) + sizeof(Labels) + sizeof(Indices) +
                                     (chunk.heat ? sizeof(Heat) : 0) + (chunk.scalars ? sizeof(Scalars) : 0) +
                                     (chunk.uvs ? sizeof(Uvs) : 0));
  return memory;
}

size_t FaceBuffer::update(const Body& body, uint32_t most) {
  if (dirty_.empty() && relabelled_.empty()) return 0;
  const Mesh& mesh = body.mesh;
  has_uvs_ = has_uvs_ || (body.looks && body.looks->uv_sets() > 0);
  DirtySlots added = take_added(mesh, most);
  find_rims(mesh, added);
  size_t bytes = 0;
  for (const SlotRange range : added.take(kGap, kChunkFaces)) {
    bytes += update_slots(body, range) + update_uvs(range) + update_labels(mesh, range);
  }
  for (const SlotRange range : relabelled_.take(kGap, kChunkFaces)) bytes += update_labels(mesh, range);
  for (Chunk& chunk : chunks_) bytes += update_list(chunk);
  return bytes;
}

// Removes slots that died, since their corners need no upload, from the list, and returns the others.
DirtySlots FaceBuffer::take_added(const Mesh& mesh, uint32_t most) {
  if (halvings_.size() < mesh.face_slots()) {
    halvings_.resize(mesh.face_slots(), kDead);
    corners_.resize(mesh.face_slots());
  }
  DirtySlots added;
  for (const SlotRange range : dirty_.take(0, kChunkFaces, most)) {
    // An undo may have removed slots that were never uploaded.
    if (halvings_.size() < range.end) {
      halvings_.resize(range.end, kDead);
      corners_.resize(range.end);
    }
    LiveList& live = chunk_of(range).live;
    for (uint32_t f = range.begin; f < range.end; ++f) {
      const bool lives = mesh.is_live(FaceId(f));
      if (live.set(f % kChunkFaces, lives)) record_change(mesh, FaceId(f), lives);
      count(mesh, f);
      record_corners(mesh, f);
      if (lives) added.mark(f);
      if (lives && heat_.any()) reheated_.mark(f);
    }
  }
  return added;
}

void FaceBuffer::record_corners(const Mesh& mesh, uint32_t slot) {
  const Corners before = corners_[slot];
  corners_[slot] = mesh.is_live(FaceId(slot)) ? mesh.corners(FaceId(slot)) : Corners{};
  for (const Corners& corners : {before, corners_[slot]}) {
    if (corners[0].valid()) moved_corners_.insert(moved_corners_.end(), corners.begin(), corners.end());
  }
}

// Adds the faces whose look changed because a rim near them was created or removed. A mesh as loaded has no
// rim.
void FaceBuffer::find_rims(const Mesh& mesh, DirtySlots& added) {
  std::vector<VertexId> changed = std::exchange(moved_corners_, {});
  if (heat_.any()) reheated_corners_.insert(reheated_corners_.end(), changed.begin(), changed.end());
  if (bases_->are_whole(mesh) && !rims_.any()) return;
  std::sort(changed.begin(), changed.end());
  changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
  std::vector<VertexId> affected;
  rims_.update(mesh, *bases_, frame_, changed, affected);
  Mesh::Star star;
  for (const VertexId v : affected) {
    mesh.star(v, star);
    for (const FaceId f : star.faces) {
      if (halvings_[f.index] != kDead) added.mark(f.index);
    }
  }
}

std::array<float, 3> FaceBuffer::rim_of(const Mesh& mesh, FaceId f) const {
  if (!rims_.any() || !mesh.is_live(f)) return {RimDistance::kFar, RimDistance::kFar, RimDistance::kFar};
  const auto [a, b, c] = mesh.corners(f);
  const auto widths = [&](VertexId v) { return std::min(rims_.of(v) / rims_.width(), RimDistance::kFar); };
  return {widths(a), widths(b), widths(c)};
}

// A slot behind the last one was undone with the command that created it: its face was never removed.
void FaceBuffer::record_change(const Mesh& mesh, FaceId f, bool lives) {
  if (lives) {
    removed_.came_back(f);
  } else if (f.index < mesh.face_slots()) {
    removed_.died(f, mesh.data(f).base);
  }
}

FaceBuffer::Chunk& FaceBuffer::chunk_of(const SlotRange& range) {
  KERF_ASSERT(range.begin < range.end && (range.end - 1) / kChunkFaces == range.begin / kChunkFaces);
  const size_t chunk = range.begin / kChunkFaces;
  while (chunks_.size() <= chunk) chunks_.emplace_back();
  Chunk& found = chunks_[chunk];
  const uint32_t needed = (range.end - 1) % kChunkFaces + 1;
  if (needed <= found.room) return found;
  const size_t begin = chunk * kChunkFaces;
  const size_t known = halvings_.size() > begin ? halvings_.size() - begin : 0;
  const size_t wanted = std::clamp<size_t>(std::max<size_t>(known, needed), kMinRoom, kChunkFaces);
  found.make_room(static_cast<uint32_t>(std::bit_ceil(wanted)));
  chunks_with_scalars_ = std::min(chunks_with_scalars_, chunk);
  return found;
}

void FaceBuffer::count(const Mesh& mesh, uint32_t slot) {
  uint8_t& known = halvings_[slot];
  if (known != kDead) --faces_of_[known];
  known = kDead;
  if (!mesh.is_live(FaceId(slot))) return;
  known = static_cast<uint8_t>(std::min<size_t>(mesh.data(FaceId(slot)).halvings, faces_of_.size() - 1));
  ++faces_of_[known];
}

size_t FaceBuffer::update_slots(const Body& body, const SlotRange& range) {
  const Mesh& mesh = body.mesh;
  staging_.clear();
  for (uint32_t f = range.begin; f < range.end; ++f) {
    staging_.push_back(face_vertices(mesh, *bases_, frame_, FaceId(f), rim_of(mesh, FaceId(f))));
    if (halvings_[f] != kDead && halvings_[f] > 0) removed_.saw(FaceId(f), corners_of(staging_.back()));
  }
  stage_looks(body, range);
  gl::put_items<FaceVertices>(GL_ARRAY_BUFFER, chunk_of(range).vertices, range.begin % kChunkFaces, staging_);
  return staging_.size() * sizeof(FaceVertices);
}

static glm::mat3x2 uv_transform_of(const Body& body, FaceId face) {
  const SurfaceLibrary* library = body.looks->surfaces().get();
  const size_t material = body.mesh.data(face).material;
  const bool is_known = library && material < library->materials.size();
  return is_known ? library->materials[material].uv_transform : SurfaceMaterial().uv_transform;
}

// Gives the staged faces the normals of the file, unless all are smoothed, and stages their UVs.
void FaceBuffer::stage_looks(const Body& body, const SlotRange& range) {
  if (has_uvs_) staged_uvs_.assign(range.end - range.begin, {});
  if (!body.looks || !body.looks->has_corners()) return;
  std::vector<FaceId> live;
  for (uint32_t f = range.begin; f < range.end; ++f) {
    if (halvings_[f] != kDead) live.emplace_back(f);
  }
  const CornerLooks looks = looks_of(body, live, LookNormals::kLoaded);
  const auto has_value = [](const auto& channel, size_t i) {
    return channel.any() && channel.corners[i][0] != LookChannel<glm::vec2>::kNone;
  };
  for (size_t i = 0; i < live.size(); ++i) {
    const size_t slot = live[i].index - range.begin;
    const glm::mat3x2 uv_transform = uv_transform_of(body, live[i]);
    for (size_t c = 0; c < 3; ++c) {
      if (!smooth_ && has_value(looks.normals, i))
        staging_[slot][c].normal = pack_normal(looks.normals.values[looks.normals.corners[i][c]]);
      if (!has_uvs_ || looks.uv_sets.empty() || !has_value(looks.uv_sets[0], i)) continue;
      const glm::vec2 uv = looks.uv_sets[0].values[looks.uv_sets[0].corners[i][c]];
      const glm::vec3 from_top(uv.x, looks.v_points_down ? uv.y : 1 - uv.y, 1);
      staged_uvs_[slot][c] = uv_transform * from_top;
    }
  }
}

size_t FaceBuffer::update_uvs(const SlotRange& range) {
  if (!has_uvs_) return 0;
  Chunk& chunk = chunk_of(range);
  chunk.make_uvs();
  gl::put_items<Uvs>(GL_ARRAY_BUFFER, *chunk.uvs, range.begin % kChunkFaces, staged_uvs_);
  return staged_uvs_.size() * sizeof(Uvs);
}

size_t FaceBuffer::update_labels(const Mesh& mesh, const SlotRange& range) {
  staged_labels_.clear();
  for (uint32_t f = range.begin; f < range.end; ++f) {
    uint16_t label = 0;
    if (mesh.is_live(FaceId(f)))
      label = packed_piece(groups_ ? groups_->of(mesh, FaceId(f)) : mesh.data(FaceId(f)).piece);
    staged_labels_.push_back({label, label, label});
  }
  gl::put_items<Labels>(GL_ARRAY_BUFFER, chunk_of(range).labels, range.begin % kChunkFaces, staged_labels_);
  return staged_labels_.size() * sizeof(Labels);
}

size_t FaceBuffer::update_heat(const Body& body, bool time_passed) {
  if (body.mesh.columns().blank() && !heat_.any()) return 0;
  KERF_ASSERT(halvings_.size() >= body.mesh.face_slots());
  if (time_passed || !reheated_corners_.empty() || body.sheet != sheet_) {
    sheet_ = body.sheet;
    std::vector<FaceId> affected;
    heat_.update(body, frame_.scale, std::exchange(reheated_corners_, {}), affected);
    reheated_.mark(affected);
  }
  size_t bytes = 0;
  if (!heat_.any() || reheated_.empty()) return bytes;
  for (const SlotRange range : reheated_.take(kGap, kChunkFaces)) bytes += update_heat_of(body.mesh, range);
  return bytes;
}

size_t FaceBuffer::update_heat_of(const Mesh& mesh, const SlotRange& range) {
  std::vector<Heat> marks;
  for (uint32_t f = range.begin; f < range.end; ++f)
    marks.push_back(mesh.is_live(FaceId(f)) ? heat_.of(mesh, FaceId(f)) : Heat{});
  Chunk& chunk = chunk_of(range);
  chunk.make_heat();
  gl::put_items<Heat>(GL_ARRAY_BUFFER, *chunk.heat, range.begin % kChunkFaces, marks);
  return marks.size() * sizeof(Heat);
}

size_t FaceBuffer::update_scalars(const std::shared_ptr<const FaceScalars>& scalars) {
  if (scalars != scalars_) chunks_with_scalars_ = 0;
  scalars_ = scalars;
  if (!scalars_) {
    for (Chunk& chunk : chunks_) chunk.free_scalars();
    return 0;
  }
  if (chunks_with_scalars_ == chunks_.size()) return 0;
  size_t bytes = 0;
  std::vector<Scalars> staged;
  for (; chunks_with_scalars_ < chunks_.size(); ++chunks_with_scalars_) {
    const size_t first = chunks_with_scalars_ * kChunkFaces;
    Chunk& chunk = chunks_[chunks_with_scalars_];
    if (chunk.room == 0) continue;
    staged.assign(chunk.room, {});
    for (size_t i = 0; i < chunk.room; ++i) {
      const float number = first + i < scalars_->size() ? (*scalars_)[first + i] : kNoScalar;
      staged[i] = {number, number, number};
    }
    chunk.make_scalars();
    gl::put_items<Scalars>(GL_ARRAY_BUFFER, *chunk.scalars, 0, staged);
    bytes += staged.size() * sizeof(Scalars);
  }
  return bytes;
}

size_t FaceBuffer::update_list(Chunk& chunk) {
  size_t bytes = 0;
  std::vector<Indices> indices;
  glBindVertexArray(chunk.layout.name());
  for (const SlotRange range : chunk.live.take_changes(kGap)) {
    indices.clear();
    for (const uint32_t slot : chunk.live.slots().subspan(range.begin, range.end - range.begin)) {
      indices.push_back({3 * slot, 3 * slot + 1, 3 * slot + 2});
    }
    gl::put_items<Indices>(GL_ELEMENT_ARRAY_BUFFER, chunk.indices, range.begin, indices);
    bytes += indices.size() * sizeof(Indices);
  }
  glBindVertexArray(0);
  return bytes;
}

void FaceBuffer::draw() const {
  for (const Chunk& chunk : chunks_) chunk.draw();
}

void FaceBuffer::draw_numbered(const gl::Program& program) const {
  draw_chunks([&](size_t i) { program.set("first_slot", static_cast<int>(i * kChunkFaces)); });
}

void FaceBuffer::draw_removed(const Mesh& mesh) {
  removed_.update(mesh, *bases_);
  removed_.draw();
}

void FaceBuffer::Chunk::draw() const {
  glBindVertexArray(layout.name());
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(3 * live.slots().size()), GL_UNSIGNED_INT, nullptr);
}

}  // namespace kerf
