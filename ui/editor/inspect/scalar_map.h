#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "core/base/tick.h"
#include "core/mesh/files/mesh_format.h"
#include "core/world/world.h"
#include "core/world/world_delta.h"
#include "ui/render/bodies/prepared_body.h"
#include "ui/render/view/view_options.h"

namespace kerf {

// What a scalar map shows of each face.
enum class FaceQuantity {
  kLevel,        // how often the area of its loaded face was halved
  kLongestEdge,  // m
  kMinAngle,     // degrees; 0 for a face without area
  kTemperature,  // K
  kRimDistance,  // m, of its nearest corner from the nearest rim that a cut made; none far from all rims
};
inline constexpr size_t kFaceQuantities = 5;

// The name for people: "level", "distance to the rim".
const char* name_of(FaceQuantity quantity);
// A value as a label, lengths in the numbers of the file: "3", "2.75 mm", "31.5°", "410 K".
std::string quantity_text(FaceQuantity quantity, double value, FileUnit unit);

// The values of all faces of a body. `loaded` tells which sides of faces were open when the body was loaded;
// without it all sides that no other face shares are rims. O(faces); for kRimDistance O(n log n) in the faces
// near rims.
FaceScalars face_scalars(const Body& body, FaceQuantity quantity, const LoadedShading* loaded);

// How many faces have which value: bin i counts those from `from + i * width()` on, the last one also `to`.
struct Histogram {
  double from = 0, to = 1;     // from < to
  double least = 0, most = 0;  // of all values
  std::vector<size_t> bins;    // at least one
  size_t faces = 0;            // with a value

  double width() const { return (to - from) / static_cast<double>(bins.size()); }
  // The value below which a share of the faces lies, 0 .. 1, to the width of a bin and within the values.
  double quantile(double share) const;
};

// A scale that has the first colour at `low` and the last at `high`; low < high.
struct ScalarRange {
  double low = 0, high = 1;
  friend bool operator==(const ScalarRange&, const ScalarRange&) = default;
};
// The range from `low` to `high`, widened a little where these are not apart for a float.
ScalarRange range_between(double low, double high);

using ScalarLists = std::span<const std::shared_ptr<const FaceScalars>>;

// Of all values of all lists, in `bins` bins over all of them. `whole`: the values are whole numbers; then a
// bin is one of them where there are no more of them than bins. Precondition: bins > 0.
Histogram histogram_of(ScalarLists lists, size_t bins, bool whole);

// Draws a histogram over the width of the panel, in the colours that its values have in the picture, with a
// handle for each end of the range, which the mouse drags; they never come closer than a hundredth of the
// histogram. The heights of its columns are the square roots of their counts, so that few faces show beside
// many. Landmarks: "scalar low" and "scalar high". Returns whether the range was changed.
bool draw_histogram(const Histogram& histogram, ScalarRange& range);

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
