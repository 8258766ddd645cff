#include "ui/render/shadow/volume_buffer.h"

#include <algorithm>
#include <bit>
#include <cstdlib>

#include "core/base/assert.h"
#include "ui/gl/buffers.h"
#include "ui/render/bodies/face_slots.h"

namespace kerf {

namespace {

constexpr int kSignsUnit = 4;         // of the textures; no program of shadow_cap.vert uses it for another
constexpr int kCopies = 2;            // of a side that are drawn at once
constexpr uint32_t kGapOfItems = 16;  // clean items worth sending to save a call
constexpr uint32_t kNoChunks = 0x80000000u;

}  // namespace

VolumeBuffer::Sides::Sides() {
  glBindVertexArray(layout.name());
  glBindBuffer(GL_ARRAY_BUFFER, buffer.name());
  gl::read_floats(0, {3, GL_FLOAT, offsetof(Side, low)}, sizeof(Side));
  gl::read_floats(1, {3, GL_FLOAT, offsetof(Side, high)}, sizeof(Side));
  gl::read_whole(2, {1, GL_UNSIGNED_INT, offsetof(Side, piece)}, sizeof(Side));
  gl::read_whole(3, {1, GL_INT, offsetof(Side, multiplicity)}, sizeof(Side));
  for (const GLuint i : {0u, 1u, 2u, 3u}) glVertexAttribDivisor(i, 1);
  glBindVertexArray(0);
}

void VolumeBuffer::Sides::replace(const std::vector<Side>& all) {
  count = static_cast<GLsizei>(all.size());
  room = all.size() + all.size() / 2;
  gl::fill_buffer(GL_ARRAY_BUFFER, buffer, room * sizeof(Side));
  gl::put_items<Side>(GL_ARRAY_BUFFER, buffer, 0, all);
}

VolumeBuffer::Side VolumeBuffer::side(const ShadowCaster& caster, const SilhouetteEdge& edge) const {
  const ShadowCaster::Ends ends = caster.ends(edge.edge);
  return {ends.low, ends.high, packed_piece(ends.piece), edge.multiplicity};
}

size_t VolumeBuffer::bytes() const { return signs_room_ + (sides_.room + many_.room) * sizeof(Side); }

void VolumeBuffer::update(const ShadowCaster& caster) {
  KERF_ASSERT(volume_.signs().size() == caster.face_slots());
  const ShadowVolume::Touched touched = volume_.take_touched();
  if (!touched.all && touched.faces.empty() && touched.places.empty()) return;
  send_signs(touched);
  send_sides(caster, touched);
  send_many(caster);
}

void VolumeBuffer::send_signs(const ShadowVolume::Touched& touched) {
  constexpr uint32_t kChunk = FaceBuffer::kChunkFaces;
  const auto faces = static_cast<uint32_t>(volume_.signs().size());
  const bool anew = faces > signs_room_;
  if (anew) make_room(faces);
  DirtySlots dirty;
  if (touched.all || anew) dirty.mark_all(faces);
  for (const uint32_t f : touched.faces) dirty.mark(f);
  for (const SlotRange range : dirty.take(kGapOfItems, kChunk)) {
    glBindBuffer(GL_TEXTURE_BUFFER, signs_[range.begin / kChunk].buffer.name());
    glBufferSubData(GL_TEXTURE_BUFFER, range.begin % kChunk, range.end - range.begin,
                    &volume_.signs()[range.begin]);
  }
}

// All signs are sent anew then.
void VolumeBuffer::make_room(uint32_t faces) {
  constexpr uint32_t kChunk = FaceBuffer::kChunkFaces;
  signs_room_ = faces <= kChunk ? std::bit_ceil(faces) : (faces + kChunk - 1) / kChunk * kChunk;
  signs_.resize((signs_room_ + kChunk - 1) / kChunk);
  for (const Signs& signs : signs_)
    gl::fill_buffer(GL_TEXTURE_BUFFER, signs.buffer, std::min(signs_room_, kChunk));
}

void VolumeBuffer::send_sides(const ShadowCaster& caster, const ShadowVolume::Touched& touched) {
  const std::span<const SilhouetteEdge> edges = volume_.silhouette();
  std::vector<Side> sides;
  if (touched.all || edges.size() > sides_.room) {
    for (const SilhouetteEdge& e : edges) sides.push_back(side(caster, e));
    return sides_.replace(sides);
  }
  DirtySlots dirty;
  for (const uint32_t place : touched.places) {
    if (place < edges.size()) dirty.mark(place);
  }
  for (const SlotRange range : dirty.take(kGapOfItems, kNoChunks)) {
    sides.clear();
    const uint32_t end = std::min<uint32_t>(range.end, static_cast<uint32_t>(edges.size()));
    for (uint32_t i = range.begin; i < end; ++i) sides.push_back(side(caster, edges[i]));
    gl::put_items<Side>(GL_ARRAY_BUFFER, sides_.buffer, range.begin, sides);
  }
  sides_.count = static_cast<GLsizei>(edges.size());
}

// Few edges have more than two copies, but the silhouette must be walked for them; it is short beside the
// mesh.
void VolumeBuffer::send_many(const ShadowCaster& caster) {
  std::vector<Side> more;
  for (const SilhouetteEdge& e : volume_.silhouette()) {
    for (int left = std::abs(e.multiplicity) - kCopies; left > 0; left -= kCopies) {
      const int copies = std::min(left, kCopies);
      more.push_back(side(caster, {e.edge, e.multiplicity > 0 ? copies : -copies}));
    }
  }
  if (!more.empty() || many_.count > 0) many_.replace(more);
}

void VolumeBuffer::bind_signs(const gl::Program& program, size_t chunk) const {
  program.set("signs", kSignsUnit);
  glActiveTexture(GL_TEXTURE0 + kSignsUnit);
  glBindTexture(GL_TEXTURE_BUFFER, signs_[chunk].texture.name());
  glTexBuffer(GL_TEXTURE_BUFFER, GL_R8I, signs_[chunk].buffer.name());
  glActiveTexture(GL_TEXTURE0);
}

void VolumeBuffer::draw_sides(const gl::Program& program, int vertices_of_side) const {
  program.set("vertices_of_side", vertices_of_side);
  for (const Sides* sides : {&sides_, &many_}) {
    if (sides->count == 0) continue;
    glBindVertexArray(sides->layout.name());
    glDrawArraysInstanced(GL_TRIANGLES, 0, kCopies * vertices_of_side, sides->count);
  }
}

void VolumeBuffer::draw_edges(int vertices) const {
  if (sides_.count == 0) return;
  glBindVertexArray(sides_.layout.name());
  glDrawArraysInstanced(GL_TRIANGLES, 0, vertices, sides_.count);
}

}  // namespace kerf
