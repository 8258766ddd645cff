#include "ui/render/bodies/removed_faces.h"

#include <algorithm>

#include "ui/gl/buffers.h"
#include "ui/render/bodies/face_slots.h"

namespace kerf {

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
