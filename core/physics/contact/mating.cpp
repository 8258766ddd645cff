#include "core/physics/contact/mating.h"

#include <algorithm>
#include <cmath>

#include "core/base/assert.h"
#include "core/physics/contact/penetration.h"

namespace kerf {

namespace {

constexpr double kSeated = 0.5;      // share of the skin
constexpr double kMinCosine = 0.25;  // between the way off all walls and their normals
constexpr uint64_t kMatingFeature = uint64_t{1} << 28;

bool face_each_other(const WallCorner& a, const WallCorner& b) {
  return a.at == b.at && are_opposite(a.normal, b.normal);
}

// Appends the corners of a wall, unless it has no area.
void append_wall_corners(const Mesh& mesh, FaceId f, std::vector<WallCorner>& corners) {
  const Triangle t = mesh.triangle(f);
  const Vec3 area = glm::cross(t[1] - t[0], t[2] - t[0]);
  const double length = glm::length(area);
  if (!(length > 0)) return;
  for (const Vec3& at : t) corners.push_back({at, area / length});
}

// Returns the corners in `second` that face one in `first`, once for each position and normal.
std::vector<WallCorner> mating_corners(const std::vector<WallCorner>& first,
                                       const std::vector<WallCorner>& second) {
  std::vector<WallCorner> found;
  auto begin = first.begin();
  for (const WallCorner& b : second) {
    while (begin != first.end() && lexicographic_less(begin->at, b.at)) ++begin;
    const auto is_known = [&](const WallCorner& k) {
      return k.at == b.at && are_opposite(k.normal, -b.normal);
    };
    for (auto a = begin; a != first.end() && a->at == b.at; ++a) {
      if (!face_each_other(*a, b)) continue;
      const auto known = std::find_if(found.rbegin(), found.rend(),
                                      [&](const WallCorner& k) { return k.at != b.at || is_known(k); });
      if (known == found.rend() || !is_known(*known)) found.push_back(b);
      break;
    }
  }
  return found;
}

// Returns the shortest way, in the frame of the walls, that leads off all of them by a distance; nullopt if
// there is none, or only one almost along a wall.
std::optional<Vec3> way_off(const std::vector<WallCorner>& walls, double distance) {
  KERF_ASSERT(!walls.empty() && distance > 0);
  std::vector<Vec3> normals;
  Vec3 sum(0);
  for (const WallCorner& w : walls) {
    const auto same = [&](const Vec3& n) { return are_opposite(n, -w.normal); };
    if (std::ranges::any_of(normals, same)) continue;
    normals.push_back(w.normal);
    sum += w.normal;
  }
  const double length = glm::length(sum);
  if (!(length > 0)) return std::nullopt;
  double least = 1;
  for (const Vec3& n : normals) least = std::min(least, glm::dot(sum, n) / length);
  if (least < kMinCosine) return std::nullopt;
  return distance / (least * length) * sum;
}

}  // namespace

std::vector<WallCorner> wall_corners(const Body& body) {
  std::vector<WallCorner> corners;
  if (!body.solid) return corners;
  for (uint32_t slot = 0; slot < body.mesh.face_slots(); ++slot) {
    const FaceId f(slot);
    if (body.mesh.is_live(f) && body.walls.contain(body.mesh, f)) append_wall_corners(body.mesh, f, corners);
  }
  std::ranges::stable_sort(corners, lexicographic_less, &WallCorner::at);
  return corners;
}

std::set<uint32_t> mating_labels(const Body& body) {
  std::set<uint32_t> labels;
  if (!body.solid) return labels;
  struct Labelled {
    WallCorner corner;
    uint32_t label = 0;
  };
  std::vector<Labelled> all;
  std::vector<WallCorner> own;
  for (uint32_t slot = 0; slot < body.mesh.face_slots(); ++slot) {
    const FaceId f(slot);
    if (!body.mesh.is_live(f) || !body.walls.contain(body.mesh, f)) continue;
    own.clear();
    append_wall_corners(body.mesh, f, own);
    for (const WallCorner& c : own) all.push_back({c, body.label(f)});
  }
  std::ranges::stable_sort(all, lexicographic_less, [](const Labelled& l) { return l.corner.at; });
  for (auto a = all.begin(); a != all.end(); ++a) {
    for (auto b = a + 1; b != all.end() && b->corner.at == a->corner.at; ++b) {
      if (a->label != b->label && face_each_other(a->corner, b->corner)) labels.insert({a->label, b->label});
    }
  }
  return labels;
}

PairGeometry::PairGeometry(const MovingBody& first, const MovingBody& second)
    : first_(&first), second_(&second) {
  KERF_ASSERT(first.id < second.id);
  mating_ = mating_corners(first.collider->wall_corners, second.collider->wall_corners);
  if (mating_.empty()) return;
  const double skin = kContactLengths.skin * std::min(first.scale, second.scale);
  const RigidMap map = into(second.now, first.now);
  seated_ = true;
  for (const WallCorner& c : mating_) {
    const Vec3 moved = map(c.at) - c.at;
    if (std::abs(glm::dot(moved, c.normal)) > kSeated * skin) {
      mating_.clear();
      seated_ = false;
      return;
    }
    seated_ = seated_ && glm::length(moved) <= kSeated * skin;
  }
  move_apart(skin);
}

void PairGeometry::move_apart(double skin) {
  const std::optional<Vec3> way = way_off(mating_, skin);
  if (!way) return;
  way_apart_ = second_->now.turn * *way;
  apart_ = *first_;
  for (RigidMap* map : {&apart_->now, &apart_->next}) map->shift += way_apart_;
}

bool PairGeometry::cross() const { return !(seated_ && is_enclosed()) && sheets_cross(first(), second()); }

bool PairGeometry::pass_through() const {
  return !(seated_ && is_enclosed()) && kerf::pass_through(first(), second());
}

std::vector<Contact> PairGeometry::contacts(PairMemory& memory) const {
  if (mating_.empty() || memory.crossed > 0) return find_contacts(*first_, *second_, kContactLengths, memory);
  if (!seated_) {
    // An edge may rest on an edge, where the same distance is kept as between a point and a face.
    ContactLengths lengths;
    lengths.chord_skin = lengths.skin;
    std::vector<Contact> contacts = find_contacts(first(), second(), lengths, memory);
    for (Contact& c : contacts) c.at -= way_apart_;
    return contacts;
  }
  const RigidMap map = into(second_->now, first_->now);
  std::vector<Contact> contacts;
  for (uint64_t i = 0; i < mating_.size(); ++i) {
    const WallCorner& c = mating_[i];
    const Vec3 at = map(c.at);
    contacts.push_back({second_->now(at),
                        second_->now.turn * c.normal,
                        glm::dot(at - c.at, c.normal),
                        kMatingFeature + i,
                        {}});
  }
  memory.points_of_first.clear();
  memory.points_of_second.clear();
  reduce_contacts(contacts);
  take_impulses(memory, contacts);
  return contacts;
}

}  // namespace kerf
