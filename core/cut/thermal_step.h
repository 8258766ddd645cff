#pragma once

#include <functional>
#include <span>
#include <unordered_set>
#include <vector>

#include "core/cut/cut_stages.h"
#include "core/cut/cut_step.h"
#include "core/laser/laser.h"
#include "core/world/heat_flow.h"

namespace kerf {

// Faces of one body while rays burn it. Private to core/cut.
struct BurnedBody {
  BodyId id;
  std::vector<FaceId> gone;                 // have their energy of removal
  std::unordered_set<uint32_t> gone_slots;  // the slots of `gone`, to be looked up; never iterated
  double deepest = 0;                       // of the other faces that were heated: share of that energy
  std::vector<FaceId> coarse;               // would be gone, if they were not to be split first; each once
};

// Shares the energy that a beam emits (J) at a pose among the faces that its rays meet, and books it in the
// ledger of the world; see thermal_step.
class Burn {
 public:
  // Whether a face of the body with this index is as fine as the resolution wants it.
  using IsFine = std::function<bool(size_t body, FaceId)>;

  // `face`: the size of the faces under the beam, in radii. Precondition: `bodies` are those that the beam
  // may cut, in the order of their slots.
  Burn(World& world, const CutSettings& settings, std::vector<BurnedBody>& bodies, double face,
       IsFine is_fine);

  // Precondition: pose in world coordinates; the trees of the bodies are up to date but for `gone`.
  void emit(const Pose& pose, double joules);

  // A wide face that is not fine does not go: the ray that has the energy for it waits there, and the face is
  // listed in `coarse`.
  bool any_waiting() const { return !waiting_.empty(); }
  // The distance from the axis (m) up to which rays wait.
  double waiting_within() const;
  // Emits what waits. With `splits` it may have to wait again; without, such faces go as they are. Same
  // precondition.
  void emit_waiting(bool splits);

  // Where a face that was met at the last pose is hot enough, what the kerf gives by burning in oxygen is
  // shared by mass among all faces that were met, as far as they take it, because what burns flows over them
  // (see core/heat/material.h). The beam cuts a kerf of some area (m^2) at a speed (m/s).
  void burn(double area, double speed);

  // The largest distance along the rays of a beam at this pose to the first face that they meet (m), or
  // nothing if they meet none.
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
    double aside;  // m, of the face from the axis
  };
  void find_meetings(const Pose& ray);
  bool is_gone(const Meeting& at) const { return bodies_[at.body].gone_slots.contains(at.face.index); }
  double emit_ray(const Pose& ray, double joules, const Pose& axis, double& absorbed);
  bool must_wait(const Meeting& at, double joules) const;
  void wait(const Meeting& at, WaitingRay ray);
  double spend(const Meeting& at, double joules);
  std::vector<FaceId> faces_met(size_t body) const;
  double spread(size_t body, std::span<const FaceId> faces, double joules);
  bool is_wide(double area) const;
  double removal_energy(const Body& body, FaceId f) const;

  World& world_;
  const CutSettings& settings_;
  std::vector<BurnedBody>& bodies_;
  std::vector<BundleRay> bundle_;
  std::vector<Meeting> meetings_;  // of one ray, nearest first
  std::vector<Meeting> met_;       // by all rays at the last pose, where there is oxygen
  std::vector<RayHit> hits_;
  IsFine is_fine_;
  std::vector<WaitingRay> waiting_;
  bool splits_ = true;
};

// One step of a cut by the thermal model, which cut_step calls: moves of the beam through all bodies that it
// may cut, one after the other, until settings.bite faces were processed.
//
// In each move, the faces that the beam reaches are split until they are fine enough (refine); those behind
// a wall that still stands are not. The move is divided into parts in which the beam goes on by a fraction of
// its radius and emits no more than melts what it covers. In each part a bundle of rays (ray_bundle) shares
// the energy that is emitted: a ray heats the first face that it meets and is reflected for the rest; where
// the face has taken its energy of removal, what the ray has left goes on to the next face behind. So the
// speed of a cut depends neither on the size of faces nor on the rate of moves. Faces that have their energy
// of removal are removed with it; after each part heat flows for the duration of the part (let_heat_flow),
// and after each move separated pieces get their labels.
//
// A ray that has the energy for a face wider than the kerf (two radii) waits while the face can be split: the
// parts that are gone are removed, the face is split, and the ray goes on. If the resolution forbids to split
// it, it is removed for as much energy as a strip of it as wide as the kerf needs (scales_removal).
//
// Fails like cut_step. A move without a duration emits nothing. The result does not depend on the division
// into steps.
Result<StepResult> thermal_step(World& world, const CutSettings& settings, std::span<const BeamMove> moves,
                                const Progress* progress = nullptr);

// Whether the resolution lets faces stay so large that their energy of removal is scaled.
bool scales_removal(const CutSettings& settings);

}  // namespace kerf
