#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "ui/render/bodies/base_faces.h"
#include "ui/render/bodies/curved_area.h"

namespace kerf {

namespace {

std::array<float, 3> place(const glm::vec3& p) { return {p.x, p.y, p.z}; }

double angle_at(const glm::dvec3& u, const glm::dvec3& w) {
  const double lengths = glm::length(u) * glm::length(w);
  return lengths > 0 ? std::acos(std::clamp(glm::dot(u, w) / lengths, -1.0, 1.0)) : 0;
}

}  // namespace

// Joins the corners of each position to one corner, and gives it its normal.
class BaseFaces::Smoother {
 public:
  explicit Smoother(const BaseFaces& from) : smooth_(from) {}

  BaseFaces run() {
    join_corners();
    std::vector<glm::dvec3> sums(smooth_.corners_.size(), glm::dvec3(0));
    for_each_face([&](const auto& face, const auto& at, const glm::dvec3& across) {
      const double size = glm::length(across);
      for (size_t i = 0; i < 3; ++i)
        sums[face[i]] += angle_at(at[(i + 1) % 3] - at[i], at[(i + 2) % 3] - at[i]) / size * across;
    });
    for (size_t i = 0; i < sums.size(); ++i) {
      const double length = glm::length(sums[i]);
      if (length > 0) smooth_.corners_[i].normal = pack_normal(glm::vec3(sums[i] / length));
    }
    find_deviation();
    return std::move(smooth_);
  }

 private:
  void join_corners() {
    const std::vector<Corner> all = std::exchange(smooth_.corners_, {});
    std::vector<uint32_t> order(all.size()), joined(all.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(),
              [&](uint32_t a, uint32_t b) { return place(all[a].at) < place(all[b].at); });
    for (const uint32_t c : order) {
      if (smooth_.corners_.empty() || smooth_.corners_.back().at != all[c].at)
        smooth_.corners_.push_back(all[c]);
      joined[c] = static_cast<uint32_t>(smooth_.corners_.size() - 1);
    }
    for (auto& face : smooth_.faces_) {
      if (face[0] == kNone) continue;
      for (uint32_t& c : face) c = joined[c];
    }
  }

  // Calls visit(indices of corners, their positions, normal of twice the area) for faces that have an area.
  template <typename Visit>
  void for_each_face(const Visit& visit) const {
    for (const auto& face : smooth_.faces_) {
      if (face[0] == kNone) continue;
      std::array<glm::dvec3, 3> at;
      for (size_t i = 0; i < 3; ++i) at[i] = smooth_.corners_[face[i]].at;
      const glm::dvec3 across = glm::cross(at[1] - at[0], at[2] - at[0]);
      if (across != glm::dvec3(0)) visit(face, at, across);
    }
  }

  void find_deviation() {
    CurvedArea curved_area;
    for_each_face([&](const auto& face, const auto&, const glm::dvec3& across) {
      const double size = glm::length(across);
      for (const uint32_t c : face) {
        const glm::dvec3 normal(unpack_normal(smooth_.corners_[c].normal));
        curved_area.note(std::min(1.0, glm::length(glm::cross(normal, across)) / size), size);
      }
    });
    smooth_.deviation_ = curved_area.deviation();
  }

  BaseFaces smooth_;
};

BaseFaces BaseFaces::smoothed() const { return Smoother(*this).run(); }

}  // namespace kerf
