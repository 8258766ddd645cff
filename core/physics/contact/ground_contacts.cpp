#include "core/physics/contact/ground_contacts.h"

#include <algorithm>

#include "core/base/assert.h"
#include "core/physics/contact/impulse_memory.h"
#include "core/physics/contact/reduce_contacts.h"

namespace kerf {

namespace {

constexpr double kStays = 0.1;       // of the skin: see reduce_on_plane
constexpr double kNearLowest = 0.3;  // of the reach, above the lowest point: where the ground is looked at

// The height of points of a body above a plane, m.
class Height {
 public:
  Height(const RigidMap& map, const Vec3& up, double level)
      : up_(glm::transpose(map.turn) * up), offset_(glm::dot(map.shift, up) - level) {}

  double operator()(const Vec3& p) const { return glm::dot(up_, p) + offset_; }
  // The height of the lowest corner of a box.
  double least(const Box& box) const {
    return (*this)(0.5 * (box.min + box.max)) - glm::dot(glm::abs(up_), 0.5 * (box.max - box.min));
  }

 private:
  Vec3 up_;  // in the frame of the body
  double offset_;
};

}  // namespace

std::vector<Contact> find_ground_contacts(const MovingBody& body, const Environment& around,
                                          const ContactLengths& lengths, const PairMemory& memory) {
  std::vector<Contact> contacts;
  if (!around.ground) return contacts;
  KERF_ASSERT(body.moves() && body.scale > 0);
  const Vec3 up = around.up();
  const double reach = lengths.reach * body.scale;
  const double level = *around.ground + lengths.ground_skin * body.scale;
  const Height now(body.now, up, level), next(body.next, up, level);
  if (std::min(now.least(body.collider->bounds), next.least(body.collider->bounds)) > reach) return contacts;
  double lowest = reach;
  for (const Vec3& p : body.collider->corners) lowest = std::min({lowest, now(p), next(p)});
  const double near = std::min(reach, std::max(lowest, 0.0) + kNearLowest * reach);
  for (uint32_t i = 0; i < body.collider->corners.size(); ++i) {
    const Vec3& p = body.collider->corners[i];
    const double distance = now(p);
    if (std::min(distance, next(p)) <= near) contacts.push_back({body.now(p), up, distance, i, {}});
  }
  take_impulses(memory, contacts);
  reduce_on_plane(contacts, up, kStays * lengths.ground_skin * body.scale);
  return contacts;
}

double depth_below_ground(const MovingBody& body, const RigidMap& map, const Environment& around) {
  if (!around.ground) return 0;
  const Height height(map, around.up(), *around.ground);
  if (height.least(body.collider->bounds) >= 0) return 0;
  double lowest = 0;
  for (const Vec3& p : body.collider->corners) lowest = std::min(lowest, height(p));
  return -lowest;
}

}  // namespace kerf
