#pragma once

#include <span>
#include <unordered_set>
#include <vector>

#include "core/cut/step_state.h"
#include "core/laser/ray_bundle.h"

namespace kerf {

// Faces of one body while rays burn it. Private to core/cut.
struct BurnedBody {
  BodyId id;
  std::vector<FaceId> gone;                 // have their energy of removal
  std::unordered_set<uint32_t> gone_slots;  // the slots of `gone`, to be looked up; never iterated
  double deepest = 0;                       // of the other faces that were heated: share of that energy
};

// Shares the energy that a beam emits (J) at a pose among the faces that its rays meet, and books it in the
// ledger of the world; see thermal_step.
class Burn {
 public:
  // `face`: the size of the faces under the beam, in radii. Precondition: `bodies` are those that the beam
  // may cut, in the order of their slots.
  Burn(World& world, const CutSettings& settings, std::vector<BurnedBody>& bodies, double face);

  // Precondition: pose in world coordinates; the trees of the bodies are up to date but for `gone`.
  void emit(const Pose& pose, double joules);

  // Where a face that was met at the last pose is hot enough, what the kerf gives by burning in oxygen is
  // shared by mass among all faces that were met, as far as they take it, because what burns flows over them
  // (see core/heat/oxygen.h). The beam cuts a kerf of some area (m^2) at a speed (m/s).
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
  void find_meetings(const Pose& ray);
  double spend(const Meeting& at, double joules);
  std::vector<FaceId> faces_met(size_t body) const;
  double spread(size_t body, std::span<const FaceId> faces, double joules);
  double removal_energy(const Body& body, FaceId f) const;

  World& world_;
  const CutSettings& settings_;
  std::vector<BurnedBody>& bodies_;
  std::vector<BundleRay> bundle_;
  std::vector<Meeting> meetings_;  // of one ray, nearest first
  std::vector<Meeting> met_;       // by all rays at the last pose, where there is oxygen
  std::vector<RayHit> hits_;
};

}  // namespace kerf
