#include "core/mesh/remesh/flat_sheets_internal.h"

#include <algorithm>
#include <utility>

#include "core/base/assert.h"
#include "core/base/containers.h"
#include "core/mesh/weld.h"

namespace kerf {

namespace {

uint32_t next(uint32_t i) { return i == 2 ? 0 : i + 1; }

class FlatCopier {
 public:
  FlatCopier(const Mesh& mesh, const Progress* progress)
      : mesh_(mesh), pace_(progress, mesh.live_faces()), fans_(3 * size_t{mesh.live_faces()}) {}

  Result<FlatSheets> copy(const RemeshLimits& limits) {
    limits_ = &limits;
    number_faces();
    for (uint32_t f = 0; f < out_.faces.size(); ++f) {
      if (!pace_.step()) return cancelled();
      for (uint32_t i = 0; i < 3; ++i) look_at_side(f, i);
    }
    add_vertices();
    lock_features();
    for (const FaceId f : limits.kept) {
      for (const uint32_t v : out_.corners[number_[f.index]]) out_.locked[v] = true;
    }
    lock_shared_positions();
    for (const std::vector<FaceUvs>& set : limits.uv_sets) {
      std::vector<FaceUvs>& own = out_.uv_sets.emplace_back();
      for (const FaceId f : out_.faces) own.push_back(set[f.index]);
    }
    return std::move(out_);
  }

 private:
  void number_faces() {
    number_.assign(mesh_.face_slots(), kNoIndex);
    for (uint32_t f = 0; f < mesh_.face_slots(); ++f) {
      if (!mesh_.is_live(FaceId(f))) continue;
      number_[f] = static_cast<uint32_t>(out_.faces.size());
      out_.faces.emplace_back(f);
      corners_.push_back(mesh_.corners(FaceId(f)));
    }
    out_.feature.assign(3 * out_.faces.size(), false);
  }

  // Joins the fans at both ends with those of the face on the other side, if there is one on the same sheet.
  void look_at_side(uint32_t f, uint32_t i) {
    const VertexId from = corners_[f][i], to = corners_[f][next(i)];
    sides_.clear();
    mesh_.append_edge_sides(out_.faces[f], from, to, sides_);
    const auto beside = std::find_if(sides_.begin(), sides_.end(),
                                     [&](const Mesh::Side& s) { return s.from == to && s.to == from; });
    out_.feature[3 * size_t{f} + i] =
        sides_.size() != 1 || beside == sides_.end() ||
        mesh_.data(beside->face).material != mesh_.data(out_.faces[f]).material ||
        (limits_->is_seam && limits_->is_seam(out_.faces[f], beside->face));
    if (beside == sides_.end()) return;
    const uint32_t other = number_[beside->face.index];
    const auto& c = corners_[other];
    const auto at = [&](VertexId v) {
      return 3 * other + static_cast<uint32_t>(std::find(c.begin(), c.end(), v) - c.begin());
    };
    fans_.unite(3 * f + i, at(from));
    fans_.unite(3 * f + next(i), at(to));
  }

  // Adds one vertex for each fan, in the order of the slots of vertices and, at one vertex, of the faces.
  void add_vertices() {
    std::vector<std::pair<VertexId, uint32_t>> fans;  // with the first corner
    for (uint32_t f = 0; f < out_.faces.size(); ++f) {
      for (uint32_t i = 0; i < 3; ++i) {
        if (fans_.find(3 * f + i) == 3 * f + i) fans.emplace_back(corners_[f][i], 3 * f + i);
      }
    }
    std::sort(fans.begin(), fans.end());
    Vec3 min = fans.empty() ? Vec3(0) : mesh_.position(fans[0].first), max = min;
    std::vector<uint32_t> vertex_of(3 * out_.faces.size());  // by the first corner of a fan
    for (const auto& [v, corner] : fans) {
      vertex_of[corner] = static_cast<uint32_t>(out_.vertices.size());
      out_.vertices.push_back(v);
      min = glm::min(min, mesh_.position(v));
      max = glm::max(max, mesh_.position(v));
    }
    out_.frame = FloatFrame::around(min, max);
    out_.corners.resize(out_.faces.size());
    for (uint32_t f = 0; f < out_.faces.size(); ++f) {
      for (uint32_t i = 0; i < 3; ++i) out_.corners[f][i] = vertex_of[fans_.find(3 * f + i)];
    }
  }

  void lock_features() {
    out_.locked.assign(out_.vertices.size(), false);
    for (uint32_t f = 0; f < out_.faces.size(); ++f) {
      for (uint32_t i = 0; i < 3; ++i) {
        if (!out_.feature[3 * size_t{f} + i]) continue;
        out_.locked[out_.corners[f][i]] = out_.locked[out_.corners[f][next(i)]] = true;
      }
    }
  }

  void lock_shared_positions() {
    std::vector<Vec3> positions;
    positions.reserve(out_.vertices.size());
    for (const VertexId v : out_.vertices) positions.push_back(mesh_.position(v));
    const std::vector<uint32_t> first = weld_positions(positions);
    out_.shared.assign(positions.size(), false);
    for (uint32_t i = 0; i < first.size(); ++i) {
      if (first[i] == i) continue;
      for (const uint32_t v : {i, first[i]}) out_.shared[v] = out_.locked[v] = true;
    }
  }

  const Mesh& mesh_;
  const RemeshLimits* limits_ = nullptr;
  Pace pace_;
  UnionFind fans_;                                // of corners
  std::vector<uint32_t> number_;                  // by face slot
  std::vector<std::array<VertexId, 3>> corners_;  // by face number
  std::vector<Mesh::Side> sides_;
  FlatSheets out_;
};

}  // namespace

Result<FlatSheets> to_flat_sheets(const Mesh& mesh, const RemeshLimits& limits, const Progress* progress) {
  return FlatCopier(mesh, progress).copy(limits);
}

FlatSurface::FlatSurface(std::vector<Vec3> points, std::vector<std::array<uint32_t, 3>> corners)
    : points_(std::move(points)),
      corners_(std::move(corners)),
      next_(3 * corners_.size()),
      previous_(next_.size()),
      first_(points_.size(), kNoIndex),
      valence_(points_.size(), 0) {
  for (uint32_t c = 0; c < next_.size(); ++c) {
    const uint32_t v = corners_[c / 3][c % 3];
    ++valence_[v];
    if (first_[v] == kNoIndex) {
      first_[v] = next_[c] = previous_[c] = c;
    } else {
      const uint32_t after = next_[first_[v]];
      link(first_[v], c);
      link(c, after);
    }
  }
}

void FlatSurface::link(uint32_t corner, uint32_t after) {
  next_[corner] = after;
  previous_[after] = corner;
}

void FlatSurface::unlink(uint32_t corner) {
  const uint32_t before = previous_[corner], v = corners_[corner / 3][corner % 3];
  link(before, next_[corner]);
  first_[v] = before == corner ? kNoIndex : before;
  --valence_[v];
}

void FlatSurface::collapse(uint32_t from, uint32_t to) {
  std::array<uint32_t, 2> removed{};
  size_t count = 0;
  for_each_face(from, [&](const Opposite& side) {
    if (side.from != to && side.to != to) return;
    KERF_ASSERT(count < removed.size());
    removed[count++] = side.face;
  });
  KERF_ASSERT(count == removed.size());
  for (const uint32_t f : removed) {
    for (uint32_t i = 0; i < 3; ++i) unlink(3 * f + i);
    corners_[f].fill(kNoIndex);
  }
  const uint32_t first = std::exchange(first_[from], kNoIndex);
  KERF_ASSERT(first != kNoIndex);
  uint32_t c = first;
  do {
    corners_[c / 3][c % 3] = to;
    c = next_[c];
  } while (c != first);
  if (first_[to] == kNoIndex) {
    first_[to] = first;
  } else {
    const uint32_t after = next_[first], after_to = next_[first_[to]];
    link(first, after_to);
    link(first_[to], after);
  }
  valence_[to] += std::exchange(valence_[from], 0);
}

}  // namespace kerf
