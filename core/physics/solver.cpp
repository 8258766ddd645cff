#include "core/physics/solver.h"

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <BulletDynamics/ConstraintSolver/btFixedConstraint.h>
#include <BulletDynamics/ConstraintSolver/btHingeConstraint.h>
#include <BulletDynamics/ConstraintSolver/btSequentialImpulseConstraintSolver.h>
#include <BulletDynamics/ConstraintSolver/btTypedConstraint.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <deque>
#include <glm/gtc/quaternion.hpp>
#include <limits>
#include <utility>

#include "core/base/assert.h"
#include "core/physics/contact/penetration.h"

namespace kerf {

namespace {

// Returns a unit vector perpendicular to a unit vector.
Vec3 across(const Vec3& axis) {
  const Vec3 other = std::abs(axis.x) < 0.5 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
  return glm::normalize(glm::cross(axis, other));
}

// Returns the frame of a joint in the principal frame of a body: origin at the anchor, third axis the axis.
btTransform joint_frame(const Joint& joint, const RigidFrame& frame) {
  KERF_ASSERT(joint.kind == Joint::Kind::kWeld || std::abs(glm::dot(joint.axis, joint.axis) - 1) < 1e-9);
  const glm::dquat back = glm::conjugate(frame.axes);
  const Vec3 at = back * (joint.anchor - frame.centre);
  const Vec3 side = across(joint.axis);
  const Vec3 x = back * side, y = back * glm::cross(joint.axis, side), z = back * joint.axis;
  return btTransform(btMatrix3x3(x.x, y.x, z.x, x.y, y.y, z.y, x.z, y.z, z.z), btVector3(at.x, at.y, at.z));
}

// Returns true if the sides of a joint lie much farther apart than the solver permits.
bool is_separated(const Joint& joint, const MovingBody& a, const MovingBody& b) {
  constexpr double kTornApart = 0.25;  // m, less for small bodies
  const Vec3 apart = a.body->placement.to_world(joint.anchor) - b.body->placement.to_world(joint.anchor);
  return glm::length(apart) > kTornApart * std::min(a.scale, b.scale);
}

constexpr double kLinearDamping = 0.1, kAngularDamping = 0.5;  // 1/s

btVector3 bullet(const Vec3& v) { return {v.x, v.y, v.z}; }
Vec3 from_bullet(const btVector3& v) { return {v.x(), v.y(), v.z()}; }
btTransform bullet(const Placement& p) {
  const glm::dmat3 m = glm::mat3_cast(p.orientation);
  const btMatrix3x3 turn(m[0][0], m[1][0], m[2][0], m[0][1], m[1][1], m[2][1], m[0][2], m[1][2], m[2][2]);
  return btTransform(turn, bullet(p.position));
}
Placement from_bullet(const btTransform& t) {
  const btQuaternion q = t.getRotation();
  return {from_bullet(t.getOrigin()), glm::normalize(glm::dquat(q.w(), q.x(), q.y(), q.z()))};
}

}  // namespace

std::vector<BodyJoint> joints_between(std::span<const MovingBody> bodies, std::span<const HeldJoint> held,
                                      const Joints& joints) {
  KERF_ASSERT(std::is_sorted(bodies.begin(), bodies.end(),
                             [](const MovingBody& a, const MovingBody& b) { return a.id < b.id; }));
  std::vector<BodyJoint> between;
  for (const HeldJoint& h : held) {
    const uint32_t first = index_of(bodies, h.parts[0].body), second = index_of(bodies, h.parts[1].body);
    if (first == second || std::max(first, second) == bodies.size()) continue;
    KERF_ASSERT(h.joint < joints.all.size());
    const Joint& joint = joints.all[h.joint];
    if (!is_separated(joint, bodies[first], bodies[second])) between.push_back({first, second, &joint});
  }
  return between;
}

bool are_joined(std::span<const BodyJoint> joints, uint32_t a, uint32_t b) {
  return std::any_of(joints.begin(), joints.end(), [&](const BodyJoint& j) {
    return (j.first == a && j.second == b) || (j.first == b && j.second == a);
  });
}

void remember_joints(std::span<const MovingBody> bodies, std::span<const BodyJoint> joints,
                     ContactMemory& memory) {
  if (joints.empty()) return;
  std::vector<std::pair<BodyId, BodyId>> joined;
  for (const BodyJoint& j : joints) joined.push_back(std::minmax(bodies[j.first].id, bodies[j.second].id));
  std::sort(joined.begin(), joined.end());
  joined.erase(std::unique(joined.begin(), joined.end()), joined.end());
  std::erase_if(memory, [&](const PairMemory& m) { return std::ranges::binary_search(joined, m.bodies()); });
  for (const auto& [a, b] : joined) memory.push_back({a, b, {}, {}, {}, 0, true});
  std::ranges::sort(memory, {}, &PairMemory::bodies);
}

std::unique_ptr<btTypedConstraint> make_constraint(const Joint& joint, const RigidFrame& first,
                                                   const RigidFrame& second, btRigidBody& first_rigid,
                                                   btRigidBody& second_rigid) {
  const btTransform in_first = joint_frame(joint, first), in_second = joint_frame(joint, second);
  if (joint.kind == Joint::Kind::kWeld)
    return std::make_unique<btFixedConstraint>(first_rigid, second_rigid, in_first, in_second);
  auto hinge = std::make_unique<btHingeConstraint>(first_rigid, second_rigid, in_first, in_second);
  constexpr double kSoftness = 0.9, kBias = 0.3, kBounce = 0;
  KERF_ASSERT(!joint.limits || joint.limits->low <= joint.limits->high);
  if (joint.limits) hinge->setLimit(joint.limits->low, joint.limits->high, kSoftness, kBias, kBounce);
  return hinge;
}

struct SolverMemory::Storage {
  // Elements are aligned and never move. Manifolds beyond those of a tick are kept unused.
  std::deque<btRigidBody> rigid;
  std::deque<btPersistentManifold> manifolds;
  std::vector<btCollisionObject*> objects;
  std::vector<btPersistentManifold*> used;
  btSequentialImpulseConstraintSolver solver;
};

SolverMemory::SolverMemory() : storage_(std::make_unique<Storage>()) {}
SolverMemory::~SolverMemory() = default;

// Bullet's representation of the bodies and contacts of one tick.
class BulletGroup {
 public:
  BulletGroup(std::span<MovingBody> bodies, const SolverSettings& settings, SolverMemory::Storage& storage)
      : bodies_(bodies),
        settings_(settings),
        rigid_(storage.rigid),
        manifolds_(storage.manifolds),
        objects_(storage.objects),
        used_(storage.used),
        solver_(storage.solver) {
    rigid_.clear();
    used_.clear();
    solver_.reset();
    for (const MovingBody& b : bodies) add(b);
  }

  void add(TouchingPair& pair) {
    assert(pair.first < bodies_.size());
    assert(bodies_[pair.first].moves() ||
           (pair.second != TouchingPair::kGround && bodies_[pair.second].moves()));
    btRigidBody* second = pair.second == TouchingPair::kGround ? &ground_ : &rigid_[pair.second];
    for (size_t i = 0; i < pair.contacts.size(); ++i) {
      if (i % MANIFOLD_CACHE_SIZE == 0) used_.push_back(next_manifold(&rigid_[pair.first], second));
      fill(pair.contacts[i], max_warm_impulse(pair));
    }
  }

  void add(const BodyJoint& joint) {
    assert(joint.first != joint.second && std::max(joint.first, joint.second) < bodies_.size());
    constraints_.push_back(make_constraint(*joint.joint, bodies_[joint.first].frame,
                                           bodies_[joint.second].frame, rigid_[joint.first],
                                           rigid_[joint.second]));
  }

  void solve() {
    btContactSolverInfo info;
    info.m_timeStep = settings_.seconds;
    info.m_numIterations = settings_.iterations;
    info.m_splitImpulsePenetrationThreshold = 0;
    info.m_erp2 = kSolvedShare;
    info.m_restitutionVelocityThreshold *= settings_.metre;
    info.m_warmstartingFactor = 0.9;
    info.m_solverMode = SOLVER_USE_WARMSTARTING | SOLVER_USE_2_FRICTION_DIRECTIONS;
    objects_.clear();
    for (btRigidBody& b : rigid_) objects_.push_back(&b);
    objects_.push_back(&ground_);
    std::vector<btTypedConstraint*> constraints;
    for (const auto& c : constraints_) constraints.push_back(c.get());
    solver_.solveGroup(objects_.data(), static_cast<int>(objects_.size()), used_.data(),
                       static_cast<int>(used_.size()), constraints.data(),
                       static_cast<int>(constraints.size()), info, nullptr, nullptr);
  }

  void read_back(std::span<TouchingPair> pairs) {
    for (size_t i = 0; i < bodies_.size(); ++i) {
      if (!bodies_[i].fixed && !bodies_[i].asleep) move_on(bodies_[i], rigid_[i]);
    }
    size_t manifold = 0;
    for (TouchingPair& pair : pairs) {
      for (size_t i = 0; i < pair.contacts.size(); ++i) {
        const btManifoldPoint& p = used_[manifold + i / MANIFOLD_CACHE_SIZE]->getContactPoint(
            static_cast<int>(i % MANIFOLD_CACHE_SIZE));
        pair.contacts[i].impulse = {p.m_appliedImpulse, p.m_appliedImpulseLateral1,
                                    p.m_appliedImpulseLateral2};
      }
      manifold += (pair.contacts.size() + MANIFOLD_CACHE_SIZE - 1) / MANIFOLD_CACHE_SIZE;
    }
    assert(manifold == used_.size());
  }

 private:
  void add(const MovingBody& b) {
    const bool still = b.fixed || b.asleep;
    btRigidBody::btRigidBodyConstructionInfo info(still ? 0 : b.frame.mass, nullptr, nullptr,
                                                  still ? btVector3(0, 0, 0) : bullet(b.frame.inertia));
    info.m_startWorldTransform = bullet(b.frame.in_world(b.body->placement));
    btRigidBody& rigid = rigid_.emplace_back(info);
    if (still) return;
    assert(b.frame.mass > 0 && b.rolling_loss >= 0 && b.rolling_brake >= 0);
    const double kept = 1 - kLinearDamping * settings_.seconds;
    const double spin = glm::length(b.body->motion.spin);
    const double braked = spin > 0 ? 1 - std::min(b.rolling_brake * settings_.seconds / spin, 1.0) : 1;
    const double spin_kept = braked * (1 - (kAngularDamping + b.rolling_loss) * settings_.seconds);
    const Vec3 centre = from_bullet(info.m_startWorldTransform.getOrigin());
    rigid.setLinearVelocity(bullet(kept * b.body->motion.velocity_at(centre, b.body->placement)));
    rigid.setAngularVelocity(bullet(spin_kept * b.body->motion.spin));
    rigid.applyCentralForce(bullet(b.frame.mass * settings_.gravity));
  }

  btPersistentManifold* next_manifold(btRigidBody* first, btRigidBody* second) {
    if (used_.size() == manifolds_.size()) manifolds_.emplace_back();
    btPersistentManifold& m = manifolds_[used_.size()];
    m.setBodies(first, second);
    m.setNumContacts(0);
    m.setContactBreakingThreshold(1e30);
    m.setContactProcessingThreshold(1e30);
    return &m;
  }

  // Returns the largest impulse of the last tick with which a contact may start (N s): impulses that acted
  // on a light body together with others must not act on it alone when its contacts change.
  double max_warm_impulse(const TouchingPair& pair) const {
    constexpr double kMaxChange = 1;  // m/s
    double mass = std::numeric_limits<double>::infinity();
    for (uint32_t i : {pair.first, pair.second}) {
      if (i != TouchingPair::kGround && bodies_[i].moves()) mass = std::min(mass, bodies_[i].frame.mass);
    }
    return kMaxChange * settings_.metre * mass;
  }

  void fill(const Contact& c, double max_warm_impulse) {
    assert(std::abs(glm::dot(c.normal, c.normal) - 1) < 1e-9);
    btPersistentManifold& m = *used_.back();
    const int at = m.getNumContacts();
    m.setNumContacts(at + 1);
    btManifoldPoint& p = m.getContactPoint(at);
    p = btManifoldPoint();  // the constructor leaves some members uninitialised
    p.m_combinedRollingFriction = p.m_combinedSpinningFriction = 0;
    p.m_positionWorldOnA = bullet(c.at);
    p.m_positionWorldOnB = bullet(c.at - c.distance * c.normal);
    p.m_normalWorldOnB = bullet(c.normal);
    p.m_distance1 = c.distance;
    p.m_combinedFriction = c.on_edge ? settings_.edge_friction : settings_.friction;
    p.m_combinedRestitution = c.distance > 0 ? 0 : settings_.restitution;
    p.m_appliedImpulse = std::min(c.impulse[0], max_warm_impulse);
  }

  // Moves a body by its velocities: a second-order step of a unit quaternion by a spin, which needs no sine.
  void move_on(MovingBody& b, const btRigidBody& rigid) const {
    const Vec3 velocity = from_bullet(rigid.getLinearVelocity()),
               spin = from_bullet(rigid.getAngularVelocity());
    Placement principal = from_bullet(rigid.getWorldTransform());  // after split impulses
    principal.position += settings_.seconds * velocity;
    const glm::dquat turn(0, 0.5 * settings_.seconds * spin);
    principal.orientation = glm::normalize(principal.orientation + turn * principal.orientation);
    b.body->placement = b.frame.body_at(principal);
    b.body->motion.spin = spin;
    b.body->motion.velocity = velocity + glm::cross(spin, b.body->placement.position - principal.position);
  }

  std::span<MovingBody> bodies_;
  const SolverSettings& settings_;
  std::deque<btRigidBody>& rigid_;
  btRigidBody ground_{btRigidBody::btRigidBodyConstructionInfo(0, nullptr, nullptr)};
  std::deque<btPersistentManifold>& manifolds_;
  std::vector<std::unique_ptr<btTypedConstraint>> constraints_;
  std::vector<btCollisionObject*>& objects_;
  std::vector<btPersistentManifold*>& used_;
  btSequentialImpulseConstraintSolver& solver_;
};

void solve_contacts(std::span<MovingBody> bodies, std::span<TouchingPair> pairs,
                    std::span<const BodyJoint> joints, const SolverSettings& settings, SolverMemory& memory) {
  assert(settings.seconds > 0 && settings.iterations > 0);
  assert(settings.metre > 0 && settings.friction >= 0 && settings.restitution >= 0);
  BulletGroup group(bodies, settings, *memory.storage_);
  for (TouchingPair& pair : pairs) group.add(pair);
  for (const BodyJoint& joint : joints) group.add(joint);
  group.solve();
  group.read_back(pairs);
}

}  // namespace kerf
