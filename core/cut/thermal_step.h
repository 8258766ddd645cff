#pragma once

#include <functional>
#include <span>
#include <unordered_set>
#include <vector>

#include "core/cut/cut_stages.h"
#include "core/cut/cut_step.h"
#include "core/laser/laser.h"
#include "core/world/world.h"

namespace kerf {

// Faces of one body that rays heat. Private to core/cut.
struct BurnedBody {
  BodyId id;
  std::vector<FaceId> removed;                 // faces that reached their energy of removal
  std::unordered_set<uint32_t> removed_slots;  // for lookup; never iterated
  double deepest = 0;                          // max fraction of that energy, over the other heated faces
  std::vector<FaceId> coarse;                  // faces to split before they can be removed; each once
};

// Distributes the energy (J) that a beam emits over the faces that its rays hit, and updates the energy
// balance of the world; see thermal_step.
class Burn {
 public:
  // Returns true if a face of the body with this index is as fine as the resolution requires.
  using IsFine = std::function<bool(size_t body, FaceId)>;

  // `face`: size of the faces under the beam, in radii. Precondition: `bodies` are the cuttable bodies in the
  // order of their slots.
  Burn(World& world, const CutSettings& settings, std::vector<BurnedBody>& bodies, double face,
       IsFine is_fine);

  // Emits energy along the rays of the beam at a pose in world coordinates. Precondition: the trees of the
  // bodies are up to date except for faces that have reached their energy of removal.
  void emit(const Pose& pose, double joules);

  // Returns true if rays are waiting. A ray with enough energy to remove a wide coarse face waits at the
  // face, which is listed in BurnedBody::coarse, until it is split.
  bool any_waiting() const { return !waiting_.empty(); }
  // Returns the maximum distance of waiting rays from the axis (m).
  double waiting_within() const;
  // Emits the energy of the waiting rays. Without `splits`, rays remove coarse faces unsplit instead of
  // waiting again.
  void emit_waiting(bool splits);

  // Adds the heat of oxidation if a face hit at the last pose is hot enough to ignite. The heat is
  // distributed by mass over all faces hit, up to their energy of removal, because the burning melt flows
  // over them (see core/heat/material.h). `area`: of the kerf that the beam cuts (m^2). `speed`: of the beam
  // (m/s).
  void burn(double area, double speed);

  // Returns the maximum over all rays of the distance to the first hit (m); nullopt if all rays miss.
  std::optional<double> reach(const Pose& pose);

 private:
  struct Meeting {
    double length = 0;
    size_t body = 0;
    FaceId face;
  };
  struct WaitingRay {
    Pose ray, axis;
    double joules;
    double aside;  // distance of the face from the axis [m]
  };
  Pose ray_of(const BundleRay& ray, const Pose& pose) const;
  void find_hits(const Pose& ray);
  bool is_removed(const Meeting& at) const { return bodies_[at.body].removed_slots.contains(at.face.index); }
  double emit_ray(const Pose& ray, double joules, const Pose& axis, double& absorbed);
  bool needs_to_wait(const Meeting& at, double joules) const;
  void wait(const Meeting& at, WaitingRay ray);
  double spend(const Meeting& at, double joules);
  std::vector<FaceId> hit_faces(size_t body) const;
  double spread(size_t body, std::span<const FaceId> faces, double joules);
  bool is_wide(double area) const;
  double removal_energy(const Body& body, FaceId f) const;

  World& world_;
  const CutSettings& settings_;
  std::vector<BurnedBody>& bodies_;
  std::vector<BundleRay> bundle_;
  std::vector<Meeting> ray_hits_;   // of one ray, nearest first
  std::vector<Meeting> pose_hits_;  // by all rays at the last pose, if there is oxygen
  std::vector<RayHit> hits_;
  IsFine is_fine_;
  std::vector<WaitingRay> waiting_;
  bool splits_ = true;
};

// Executes one step of a cut by the thermal model, for cut_step: moves the beam through all cuttable bodies,
// in order, until settings.faces_per_step faces are processed.
//
// In each move, the faces that the beam reaches are split until they are fine enough (refine), except those
// that remaining material shields from the beam. The move is divided into parts in which the beam advances by
// a fraction of its radius and emits at most the energy that melts the area it covers. In each part a bundle
// of rays (ray_bundle) distributes the emitted energy: a ray heats the first face that it hits, and the
// energy not absorbed is reflected; once the face has its energy of removal, the ray continues with the
// remaining energy to the next face behind it. Therefore the speed of a cut depends neither on the size of
// faces nor on the rate of moves. Faces that reach their energy of removal are removed, with this energy.
// After each part, heat is conducted for the duration of the part (step_heat); after each move, separated
// pieces get their labels.
//
// A ray with enough energy to remove a face wider than the kerf (two radii) waits if the face can be split:
// faces that have reached their energy of removal are removed, the face is split, and the ray continues. If
// the resolution forbids the split, the face is removed for the energy of a strip of it as wide as the kerf
// (scales_removal).
//
// Fails like cut_step. A move without a duration emits nothing. The result does not depend on the division
// into steps.
Result<StepResult> thermal_step(World& world, const CutSettings& settings, std::span<const BeamMove> moves,
                                const Progress* progress = nullptr);

// Returns true if the resolution permits faces so large that their energy of removal is reduced to that of a
// strip.
bool scales_removal(const CutSettings& settings);

}  // namespace kerf
