#pragma once

#include <optional>
#include <set>

#include "core/base/tick.h"
#include "core/world/delta.h"
#include "core/world/world.h"
#include "ui/editor/scalar_map/face_scalars.h"
#include "ui/editor/scalar_map/histogram.h"

namespace kerf {

// Which quantity colours the faces, its values, and the range of the colours. While nothing is shown it holds
// no values and costs nothing.
class ScalarMap {
 public:
  std::optional<FaceQuantity> shown() const { return shown_; }
  // Shows a quantity, or nothing, with a range that fits.
  void show(std::optional<FaceQuantity> quantity);

  // Notes what has changed since update().
  void follow(const World& world, const Delta& delta);
  // The same for the faces that steps of a stroke add and remove, by their numbers, and for all that moved
  // once no step waits any more. O(bodies).
  void follow_steps(const World& world, bool any_waits);
  // The same for heat that has flowed or was brought in.
  void follow_heat(const World& world);
  void forget();
  // Whether values are out of date; false while nothing is shown.
  bool is_old() const { return shown_ && (all_old_ || !old_.empty()); }
  // Computes the values that are out of date. Bodies that are hidden have none. O(faces of bodies that
  // changed, plus a pass over all values).
  void update(const World& world, const LoadedShadings& loaded);

  const Histogram& histogram() const { return histogram_; }
  const ScalarRange& range() const { return range_; }
  // Keeps the range as it is from now on. Precondition: low < high.
  void set_range(const ScalarRange& range);
  // Lets the range follow the values but for this share of the faces at each end. Precondition: share < 0.5.
  void fit(double share);
  // Whether the range follows the values.
  bool fits() const { return fit_.has_value(); }

  // What the picture shows; null where nothing is shown or no face has a value.
  std::shared_ptr<const ScalarField> field(FileUnit unit) const;

 private:
  // Heat is where it was while these are the same.
  struct HeatMoment {
    Ticks clock = 0;
    EnergyLedger energy;
    friend bool operator==(const HeatMoment&, const HeatMoment&) = default;
  };
  void renew(BodyId id, const Body& body, const LoadedShadings& loaded);
  void take_histogram();

  std::optional<FaceQuantity> shown_;
  std::map<BodyId, std::shared_ptr<const FaceScalars>> values_;
  std::set<BodyId> old_;
  // Faces are what they were while these are the same and no step is executed.
  struct FaceCount {
    uint32_t slots = 0, live = 0;
    friend bool operator==(const FaceCount&, const FaceCount&) = default;
  };
  std::map<BodyId, FaceCount> counts_;
  bool any_waited_ = false;
  bool all_old_ = false;
  HeatMoment heat_;
  Histogram histogram_{.bins = {0}};
  ScalarRange range_;
  std::optional<double> fit_ = 0.0;
};

}  // namespace kerf
