#include "ui/render/bodies/base_faces.h"

#include <cmath>
#include <mutex>
#include <numeric>
#include <utility>

#include "core/base/containers.h"
#include "core/base/random.h"
#include "core/document/piece_looks.h"
#include "core/mesh/face_batches.h"

namespace kerf {

namespace {

constexpr size_t kMaxFan = 512;   // corners around a position; faces with more are shaded flat
constexpr double kOnSide = 1e-4;  // barycentric; positions are floats
constexpr size_t kAlike = 8;      // latest normals at a position searched for an equal one

uint64_t position_hash(const Vec3& p) {
  return hash_combine(hash_combine(mix64(number_bits(p.x)), number_bits(p.y)), number_bits(p.z));
}

glm::dvec3 unit_or_zero(const glm::dvec3& v) {
  const double length = glm::length(v);
  return length > 0 ? v / length : glm::dvec3(0);
}

double angle_between(const glm::dvec3& u, const glm::dvec3& w) {
  return std::acos(std::clamp(glm::dot(unit_or_zero(u), unit_or_zero(w)), -1.0, 1.0));
}

glm::vec3 flat_normal(const std::array<glm::vec3, 3>& t) {
  const glm::dvec3 a(t[0]), b(t[1]), c(t[2]);
  const glm::dvec3 n = unit_or_zero(glm::cross(b - a, c - a));
  return n == glm::dvec3(0) ? glm::vec3(0, 1, 0) : glm::vec3(n);
}

// Returns the weights of the three corners at p; the first corner alone if the triangle has no area.
glm::dvec3 barycentric(const std::array<glm::vec3, 3>& t, const glm::vec3& p) {
  const glm::dvec3 a(t[0]), u = glm::dvec3(t[1]) - a, w = glm::dvec3(t[2]) - a, d = glm::dvec3(p) - a;
  const glm::dvec3 n = glm::cross(u, w);
  const double area2 = glm::dot(n, n);
  if (!(area2 > 0)) return {1, 0, 0};
  const double second = glm::dot(glm::cross(d, w), n) / area2, third = glm::dot(glm::cross(u, d), n) / area2;
  return {1 - second - third, second, third};
}

std::array<float, 3> place(const glm::vec3& p) { return {p.x, p.y, p.z}; }

double angle_at(const glm::dvec3& u, const glm::dvec3& w) {
  const double lengths = glm::length(u) * glm::length(w);
  return lengths > 0 ? std::acos(std::clamp(glm::dot(u, w) / lengths, -1.0, 1.0)) : 0;
}

FloatFrame picture_frame(const Body& body) {
  return FloatFrame::around(body.bounds().min, body.bounds().max);
}

// Calls what(id, body, progress) for each body, with progress in proportion to their faces, until one
// fails.
template <typename What>
Status for_each_body(const World& world, const Progress* progress, What what) {
  ProgressShares shares(progress);
  const auto all = static_cast<double>(world.live_faces());
  for (const BodyId id : world.ids()) {
    const Body& body = world.body(id);
    const Progress own = shares.next(static_cast<double>(body.mesh.live_faces()) / all);
    if (const Status done = what(id, body, &own); !done) return done;
  }
  return Done{};
}

// The progress of two concurrent computations, each of which is half of the work.
class JointProgress {
 public:
  explicit JointProgress(const Progress* whole) : whole_(whole) {}
  Progress of(size_t computation) {
    return {[this, computation](double fraction) {
      const std::lock_guard lock(mutex_);
      done_[computation] = fraction;
      stopped_ = stopped_ || (whole_ && !whole_->report(0.5 * (done_[0] + done_[1])));
      return !stopped_;
    }};
  }

 private:
  const Progress* whole_;
  std::mutex mutex_;
  std::array<double, 2> done_{};
  bool stopped_ = false;
};

}  // namespace

uint32_t pack_normal(const glm::vec3& n) {
  const auto ten_bits = [](float x) {
    return static_cast<uint32_t>(std::lround(std::clamp(x, -1.0f, 1.0f) * 511.0f)) & 0x3ffu;
  };
  return ten_bits(n.x) | ten_bits(n.y) << 10 | ten_bits(n.z) << 20;
}

glm::vec3 unpack_normal(uint32_t packed) {
  const auto number = [&](int shift) {
    const int bits = static_cast<int>(packed >> shift & 0x3ffu);
    return static_cast<float>(bits >= 512 ? bits - 1024 : bits) / 511.0f;
  };
  return {number(0), number(10), number(20)};
}

// Gathers the face corners around each position, in the order of their slots, and sums over each of these
// fans. A corner is identified by its side: three times its face, plus its index.
class BaseFaces::Builder {
 public:
  Builder(const Mesh& mesh, const FloatFrame& frame, BaseFaces& out)
      : mesh_(mesh),
        frame_(frame),
        out_(out),
        planes_(mesh.face_slots(), glm::dvec3(0)),
        areas_(mesh.face_slots(), 0),
        angles_(3 * size_t{mesh.face_slots()}),
        position_(3 * size_t{mesh.face_slots()}, kNone) {}

  // Returns false if it was stopped.
  bool run(const Progress* progress) {
    ProgressShares shares(progress);
    const Progress grouping = shares.next(0.3), measuring = shares.next(0.3), gathering = shares.next(0.1),
                   smoothing = shares.next(0.3);
    return group_vertices(&grouping) && measure(&measuring) && gather(&gathering) && smooth(&smoothing);
  }

 private:
  static constexpr size_t kItems = 1 << 14;  // per range

  bool group_vertices(const Progress* progress) {
    const Positions at = mesh_.positions();
    const uint32_t vertices = mesh_.vertex_slots();
    KeyTable table;
    table.reserve(vertices);
    first_.resize(vertices);
    Pace pace(progress, vertices);
    for (uint32_t v = 0; v < vertices; ++v) {
      first_[v] = table.find_or_add(
          position_hash(at[v]), v, [&](uint32_t other) { return at[other] == at[v]; },
          [&](uint32_t other) { return position_hash(at[other]); });
      if (!pace.step()) return false;
    }
    return true;
  }

  bool measure(const Progress* progress) {
    out_.faces_.assign(planes_.size(), {kNone, kNone, kNone});
    out_.open_.assign(planes_.size(), 0);
    out_.live_ = mesh_.live_faces();
    return for_each_range(planes_.size(), kItems, progress, [&](size_t first, size_t end) {
      std::vector<Mesh::Side> others;
      for_each_batch(mesh_, first, end, [&](const TriangleBatch& batch) {
        for (uint32_t i = 0; i < batch.count(); ++i)
          measure_face(batch.face(i), batch.corners(i), batch.triangle(i), others);
      });
    });
  }

  void measure_face(FaceId face, const std::array<VertexId, 3>& corners, const Triangle& t,
                    std::vector<Mesh::Side>& others) {
    const uint32_t f = face.index;
    const std::array<glm::dvec3, 3> s{frame_.scaled(t[0]), frame_.scaled(t[1]), frame_.scaled(t[2])};
    const glm::dvec3 across = glm::cross(s[1] - s[0], s[2] - s[0]);
    planes_[f] = unit_or_zero(across);
    areas_[f] = static_cast<float>(glm::length(across));
    for (uint32_t c = 0; c < 3; ++c) {
      others.clear();
      mesh_.append_edge_sides(face, corners[c], corners[(c + 1) % 3], others);
      if (others.empty()) out_.open_[f] |= static_cast<uint8_t>(1u << c);
      position_[3 * f + c] = first_[corners[c].index];
      angles_[3 * f + c] = angle_between(s[(c + 1) % 3] - s[c], s[(c + 2) % 3] - s[c]);
    }
  }

  // A counting sort of all corners by their position.
  bool gather(const Progress* progress) {
    Pace pace(progress, position_.size());
    fan_end_.assign(first_.size() + 1, 0);
    for (const uint32_t v : position_) {
      if (v != kNone) ++fan_end_[v + 1];
    }
    for (size_t v = 1; v < fan_end_.size(); ++v) fan_end_[v] += fan_end_[v - 1];
    fans_ = std::make_unique_for_overwrite<uint32_t[]>(fan_end_.back());
    for (uint32_t side = 0; side < position_.size(); ++side) {
      if (!pace.step()) return false;
      if (position_[side] != kNone) fans_[fan_end_[position_[side]]++] = side;
    }
    return true;
  }

  // Precondition: gather() was called.
  std::span<const uint32_t> fan(size_t v) const {
    const size_t begin = v > 0 ? fan_end_[v - 1] : 0;
    return {fans_.get() + begin, fan_end_[v] - begin};
  }

  // The smoothed corners of a range of positions: they have indices from `first` on.
  struct Smoothed {
    std::vector<Corner> corners;
    CurvedArea curved_area;
    uint32_t first = 0;
  };

  bool smooth(const Progress* progress) {
    std::vector<Smoothed> parts(range_count(first_.size(), kItems));
    const bool done = for_each_range(first_.size(), kItems, progress, [&](size_t v, size_t end) {
      Smoothed& part = parts[v / kItems];
      for (; v < end; ++v)
        smooth_fan(frame_.to_float(mesh_.position(VertexId(static_cast<uint32_t>(v)))), fan(v), part);
    });
    if (!done) return false;
    put_together(parts);
    find_deviation(parts);
    return true;
  }

  void smooth_fan(const glm::vec3& at, std::span<const uint32_t> fan, Smoothed& part) {
    const size_t first = part.corners.size();
    for (const uint32_t side : fan) {
      const FaceId face(side / 3);
      const FaceData& data = mesh_.data(face);
      if (data.halvings != 0 || data.base != face) continue;
      const glm::dvec3 smooth = normal(side, fan);
      out_.faces_[face.index][side % 3] = corner(part.corners, first, {at, pack_normal(glm::vec3(smooth))});
      part.curved_area.note(glm::length(glm::cross(smooth, planes_[face.index])), areas_[face.index]);
    }
  }

  // Sums the normals around the corner that join it smoothly.
  glm::dvec3 normal(uint32_t side, std::span<const uint32_t> fan) const {
    const glm::dvec3 own = planes_[side / 3];
    glm::dvec3 sum(0);
    if (fan.size() <= kMaxFan) {
      for (const uint32_t other : fan) {
        const glm::dvec3& plane = planes_[other / 3];
        if (own == glm::dvec3(0) || glm::dot(own, plane) >= kCreaseCosine) sum += angles_[other] * plane;
      }
    }
    return sum == glm::dvec3(0) ? own : unit_or_zero(sum);
  }

  // Returns the index among `all`; reuses one of the last few, from `first` on, if equal.
  static uint32_t corner(std::vector<Corner>& all, size_t first, const Corner& wanted) {
    const size_t from = std::max(first, all.size() - std::min(all.size(), kAlike));
    for (size_t i = from; i < all.size(); ++i) {
      if (all[i].normal == wanted.normal) return static_cast<uint32_t>(i);
    }
    all.push_back(wanted);
    return static_cast<uint32_t>(all.size() - 1);
  }

  void put_together(std::vector<Smoothed>& parts) {
    size_t count = 0;
    for (Smoothed& part : parts) {
      part.first = static_cast<uint32_t>(count);
      count += part.corners.size();
    }
    out_.corners_.resize(count);
    for_each_range(first_.size(), kItems, [&](size_t v, size_t end) {
      const Smoothed& part = parts[v / kItems];
      std::copy(part.corners.begin(), part.corners.end(), out_.corners_.begin() + part.first);
      for (; v < end; ++v) {
        for (const uint32_t side : fan(v)) {
          uint32_t& index = out_.faces_[side / 3][side % 3];
          if (index != kNone) index += part.first;
        }
      }
    });
  }

  void find_deviation(const std::vector<Smoothed>& parts) {
    CurvedArea curved_area;
    for (const Smoothed& part : parts) curved_area.add(part.curved_area);
    out_.deviation_ = curved_area.deviation();
  }

  const Mesh& mesh_;
  const FloatFrame& frame_;
  BaseFaces& out_;
  std::vector<glm::dvec3> planes_;    // by face: its unit normal
  std::vector<float> areas_;          // by face: twice its area
  std::vector<double> angles_;        // by side: at its corner
  std::vector<uint32_t> position_;    // by side: the first vertex at its corner; kNone without a face
  std::vector<uint32_t> first_;       // by vertex: the lowest at the same position
  std::vector<uint32_t> fan_end_;     // by vertex, in fans_; empty fans for all but the first at a position
  std::unique_ptr<uint32_t[]> fans_;  // sides, by position
};

BaseFaces::BaseFaces(const Mesh& mesh, const FloatFrame& frame) { Builder(mesh, frame, *this).run(nullptr); }

Result<BaseFaces> BaseFaces::build(const Mesh& mesh, const FloatFrame& frame, const Progress* progress) {
  BaseFaces bases;
  if (!Builder(mesh, frame, bases).run(progress)) return cancelled();
  return bases;
}

BaseFaces BaseFaces::pick(std::span<const FaceId> faces) const {
  std::vector<uint32_t> used;
  for (const FaceId f : faces) {
    if (knows(f)) used.insert(used.end(), faces_[f.index].begin(), faces_[f.index].end());
  }
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  BaseFaces picked;
  picked.corners_.reserve(used.size());
  for (const uint32_t c : used) picked.corners_.push_back(corners_[c]);
  picked.faces_.assign(faces.size(), {kNone, kNone, kNone});
  picked.open_.assign(faces.size(), 0);
  picked.deviation_ = deviation_;
  for (size_t i = 0; i < faces.size(); ++i) {
    if (!knows(faces[i])) continue;
    picked.open_[i] = open_[faces[i].index];
    for (size_t c = 0; c < 3; ++c) {
      const auto at = std::lower_bound(used.begin(), used.end(), faces_[faces[i].index][c]);
      picked.faces_[i][c] = static_cast<uint32_t>(at - used.begin());
    }
  }
  return picked;
}

std::optional<std::array<glm::vec3, 3>> BaseFaces::corners(FaceId base) const {
  if (!knows(base)) return std::nullopt;
  const auto& [a, b, c] = faces_[base.index];
  return std::array{corners_[a].at, corners_[b].at, corners_[c].at};
}

bool BaseFaces::was_open(FaceId base, const glm::vec3& from, const glm::vec3& to) const {
  if (!knows(base) || open_[base.index] == 0) return false;
  const std::array<glm::vec3, 3> at = *corners(base);
  const glm::dvec3 a = barycentric(at, from), b = barycentric(at, to);
  for (int side = 0; side < 3; ++side) {
    const int across = (side + 2) % 3;
    const bool on_it = std::max(std::abs(a[across]), std::abs(b[across])) < kOnSide;
    if (on_it && (open_[base.index] & 1u << side) != 0) return true;
  }
  return false;
}

size_t BaseFaces::bytes() const {
  return open_.capacity() + corners_.capacity() * sizeof(Corner) + faces_.capacity() * sizeof(faces_[0]);
}

std::array<glm::vec3, 3> BaseFaces::normals_at(FaceId base, const std::array<glm::vec3, 3>& points) const {
  const glm::vec3 flat = flat_normal(points);
  if (!knows(base)) return {flat, flat, flat};
  const auto& [a, b, c] = faces_[base.index];
  const std::array<glm::vec3, 3> at{corners_[a].at, corners_[b].at, corners_[c].at};
  std::array<glm::vec3, 3> normals;
  for (size_t i = 0; i < 3; ++i) {
    const glm::vec3 weight(barycentric(at, points[i]));
    const glm::vec3 n = weight.x * unpack_normal(corners_[a].normal) +
                        weight.y * unpack_normal(corners_[b].normal) +
                        weight.z * unpack_normal(corners_[c].normal);
    const float length = glm::length(n);
    normals[i] = length > 1e-6f ? n / length : flat;
  }
  return normals;
}

// Merges the corners of each position into one, and computes its normal.
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

  // Calls visit(indices of corners, their positions, normal of twice the area) for faces with an area.
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

PreparedBody prepare_shading(const Body& body, const LoadedShadings& loaded) {
  const auto found = loaded.find(body.loaded_as);
  if (found == loaded.end()) {
    const FloatFrame frame = picture_frame(body);
    return {frame, std::make_shared<const BaseFaces>(body.mesh, frame), nullptr};
  }
  const auto& [frame, bases] = found->second;
  if (body.loaded_faces.empty()) return {frame, bases, nullptr};
  return {frame, std::make_shared<const BaseFaces>(bases->pick(body.loaded_faces)), nullptr};
}

Result<PreparedBodies> prepare_shading(const World& world, const Progress* progress) {
  PreparedBodies prepared;
  const Status done = for_each_body(world, progress, [&](BodyId id, const Body& body, const Progress* own) {
    const FloatFrame frame = picture_frame(body);
    Result<BaseFaces> bases = BaseFaces::build(body.mesh, frame, own);
    if (!bases) return Status(bases.error());
    prepared.emplace(id, PreparedBody{frame, std::make_shared<const BaseFaces>(std::move(*bases)), nullptr});
    return Status(Done{});
  });
  if (!done) return done.error();
  return prepared;
}

Status prepare_shadows(const World& world, PreparedBodies& prepared, const Progress* progress) {
  return for_each_body(world, progress, [&](BodyId id, const Body& body, const Progress* own) {
    const auto found = prepared.find(id);
    if (found == prepared.end()) return Status(Done{});
    Result<ShadowCaster> caster = ShadowCaster::build(body.mesh, found->second.frame, own);
    if (!caster) return Status(caster.error());
    found->second.caster = std::make_unique<ShadowCaster>(std::move(*caster));
    return Status(Done{});
  });
}

Result<PreparedBodies> prepare_drawing(const World& world, const Progress* progress) {
  PreparedBodies prepared;
  const Status done = for_each_body(world, progress, [&](BodyId id, const Body& body, const Progress* own) {
    const FloatFrame frame = picture_frame(body);
    JointProgress joint(own);
    const Progress shading = joint.of(0), casting = joint.of(1);
    Result<BaseFaces> bases = cancelled();
    Result<ShadowCaster> caster = cancelled();
    do_both([&] { bases = BaseFaces::build(body.mesh, frame, &shading); },
            [&] { caster = ShadowCaster::build(body.mesh, frame, &casting); });
    if (!bases || !caster) return Status(cancelled());
    prepared.emplace(id, PreparedBody{frame, std::make_shared<const BaseFaces>(std::move(*bases)),
                                      std::make_unique<ShadowCaster>(std::move(*caster))});
    return Status(Done{});
  });
  if (!done) return done.error();
  return prepared;
}

}  // namespace kerf
