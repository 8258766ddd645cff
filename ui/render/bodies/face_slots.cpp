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

}  // namespace kerf
