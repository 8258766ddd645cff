#include "ui/render/bodies/face_slots.h"

#include <algorithm>
#include <glm/gtc/packing.hpp>

namespace kerf {

uint16_t packed_piece(uint32_t label) {
  return static_cast<uint16_t>(label < 65536u ? label : 1u + label % 65535u);
}

FaceVertices face_vertices(const Mesh& mesh, const BaseFaces& bases, const FloatFrame& frame, FaceId f,
                           const std::array<float, 3>& rim) {
  FaceVertices out{};
  if (!mesh.is_live(f)) return out;
  const Triangle t = mesh.triangle(f);
  const std::array<glm::vec3, 3> at{frame.to_float(t[0]), frame.to_float(t[1]), frame.to_float(t[2])};
  const FaceData& data = mesh.data(f);
  const std::array<glm::vec3, 3> normals = bases.normals_at(data.base, at);
  const auto material = static_cast<uint8_t>(std::min<uint32_t>(data.material, 255u));
  for (size_t i = 0; i < 3; ++i) {
    out[i] = {{at[i].x, at[i].y, at[i].z},
              pack_normal(normals[i]),
              glm::packHalf1x16(rim[i]),
              data.halvings,
              material};
  }
  return out;
}

void DirtySlots::mark(std::span<const FaceId> faces) {
  for (const FaceId f : faces) slots_.push_back(f.index);
}

void DirtySlots::mark_all(uint32_t slots) {
  all_ = std::max(all_, slots);
  from_ = 0;
}

std::vector<SlotRange> DirtySlots::take(uint32_t gap, uint32_t chunk, uint32_t most) {
  std::sort(slots_.begin(), slots_.end());
  std::vector<SlotRange> ranges;
  const auto add = [&](uint32_t begin, uint32_t end) {
    while (begin < end) {
      const uint32_t stop = std::min(end, (begin / chunk + 1) * chunk);
      const bool joins =
          !ranges.empty() && begin <= ranges.back().end + gap && ranges.back().begin / chunk == begin / chunk;
      if (joins) {
        ranges.back().end = std::max(ranges.back().end, stop);
      } else {
        ranges.push_back({begin, stop});
      }
      begin = stop;
    }
  };
  const auto below = std::lower_bound(slots_.begin(), slots_.end(), from_);
  const auto above = std::lower_bound(below, slots_.end(), all_);
  const uint32_t to = all_ - from_ > most ? from_ + most : all_;
  for (auto slot = slots_.begin(); slot != below; ++slot) add(*slot, *slot + 1);
  add(from_, to);
  for (auto slot = above; slot != slots_.end(); ++slot) add(*slot, *slot + 1);
  slots_.clear();
  from_ = to;
  if (from_ == all_) from_ = all_ = 0;
  return ranges;
}

bool LiveList::set(uint32_t slot, bool live) {
  if (contains(slot) == live) return false;
  if (live) {
    place_[slot] = static_cast<uint32_t>(slots_.size());
    slots_.push_back(slot);
    changed_.mark(place_[slot]);
    return true;
  }
  const uint32_t place = place_[slot], last = slots_.back();
  slots_[place] = last;
  place_[last] = place;
  place_[slot] = kNone;
  slots_.pop_back();
  changed_.mark(place);
  return true;
}

std::vector<SlotRange> LiveList::take_changes(uint32_t gap) {
  const auto count = static_cast<uint32_t>(slots_.size());
  std::vector<SlotRange> ranges = changed_.take(gap, kNone);
  std::erase_if(ranges, [&](const SlotRange& r) { return r.begin >= count; });
  if (!ranges.empty()) ranges.back().end = std::min(ranges.back().end, count);
  return ranges;
}

namespace {

struct Corner {
  glm::vec3 position;
  uint32_t base;
};

float longest_edge(const FaceCorners& c) {
  return std::max({glm::distance(c[0], c[1]), glm::distance(c[1], c[2]), glm::distance(c[2], c[0])});
}

}  // namespace

void RemovedFaces::saw(FaceId f, const FaceCorners& corners) {
  if (longest_edge(corners) < kSmallest || (seen_.size() >= kMost && !seen_.contains(f.index))) {
    seen_.erase(f.index);
  } else {
    seen_[f.index] = corners;
  }
}

void RemovedFaces::died(FaceId f, FaceId base) {
  const auto found = seen_.find(f.index);
  if (found == seen_.end()) return;
  if (parts_.size() < kMost) parts_.emplace(f.index, RemovedFace{f, base, found->second});
  seen_.erase(found);
}

std::vector<RemovedFace> RemovedFaces::list(const Mesh& mesh, const BaseFaces& bases) const {
  std::vector<RemovedFace> all;
  for (const auto& [slot, part] : parts_) all.push_back(part);
  for (uint32_t f = 0; f < bases.count(); ++f) {
    const std::optional<FaceCorners> corners = bases.corners(FaceId(f));
    if (corners && !mesh.is_live(FaceId(f))) all.push_back({FaceId(f), FaceId(f), *corners});
  }
  return all;
}

void RemovedFaces::update(const Mesh& mesh, const BaseFaces& bases) {
  if (!old_) return;
  old_ = false;
  std::vector<Corner> corners;
  for (uint32_t f = 0; f < bases.count(); ++f) {
    const std::optional<FaceCorners> base = bases.corners(FaceId(f));
    if (!base || (mesh.is_live(FaceId(f)) && mesh.data(FaceId(f)).halvings == 0)) continue;
    for (const glm::vec3& p : *base) corners.push_back({p, f});
  }
  count_ = static_cast<GLsizei>(corners.size());
  glBindVertexArray(layout_.name());
  gl::fill_buffer(GL_ARRAY_BUFFER, buffer_, corners.size() * sizeof(Corner), corners.data());
  gl::read_floats(0, {3, GL_FLOAT, offsetof(Corner, position)}, sizeof(Corner));
  gl::read_whole(1, {1, GL_UNSIGNED_INT, offsetof(Corner, base)}, sizeof(Corner));
  glBindVertexArray(0);
}

void RemovedFaces::draw() const {
  if (count_ == 0) return;
  glBindVertexArray(layout_.name());
  glDrawArrays(GL_TRIANGLES, 0, count_);
}

}  // namespace kerf
