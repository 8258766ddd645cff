#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "core/base/ids.h"
#include "core/mesh/files/mesh_format.h"
#include "core/world/world.h"
#include "core/world/world_delta.h"
#include "ui/editor/inspect/reference_mesh.h"
#include "ui/render/bodies/base_faces.h"
#include "ui/render/view/view_options.h"

namespace kerf {

// Quantity per face that a scalar map shows.
enum class FaceQuantity {
  kLevel,        // halvings of the area of its loaded face
  kLongestEdge,  // m
  kMinAngle,     // degrees; 0 for a face without area
  kTemperature,  // K
  kRimDistance,  // m, of its nearest corner from the nearest rim of a cut; none far from all rims
  kDeviation,    // m, of its centroid from the reference mesh, negative inside; none without a reference
};
inline constexpr size_t kFaceQuantities = 6;

// Returns the displayed name: "level", "distance to the rim".
const char* name_of(FaceQuantity quantity);
// Formats a value, lengths in file units: "3", "2.75 mm", "31.5°", "410 K".
std::string quantity_text(FaceQuantity quantity, double value, FileUnit unit);

// Computes the values of all faces of a body. `loaded` has the sides of faces that were open when the body
// was loaded; without it, all sides that no other face shares are rims. O(faces); for kRimDistance O(n log
// n) in the faces near rims, and O(n log n) for kDeviation, multithreaded. `reference` may be null.
FaceScalars face_scalars(const Body& body, FaceQuantity quantity, const LoadedShading* loaded,
                         const ReferenceMesh* reference = nullptr);

// Counts of faces by value: bin i holds those from `from + i * width()` on, the last one also `to`.
struct Histogram {
  double from = 0, to = 1;     // from < to
  double least = 0, most = 0;  // of all values
  std::vector<size_t> bins;    // at least one
  size_t faces = 0;            // with a value

  double width() const { return (to - from) / static_cast<double>(bins.size()); }
  // Returns the value below which a share (0 .. 1) of the faces lies, to a bin's width, within the values.
  double quantile(double share) const;
};

// A scale with the first colour at `low` and the last at `high`; low < high.
struct ScalarRange {
  double low = 0, high = 1;
  friend bool operator==(const ScalarRange&, const ScalarRange&) = default;
};
// Returns the range from `low` to `high`, widened a little if they are equal as floats.
ScalarRange range_between(double low, double high);

using ScalarLists = std::span<const std::shared_ptr<const FaceScalars>>;

// Counts the values of all lists in bins. `whole`: the values are integers; then a bin is a single value if
// there are no more values than bins. Precondition: bins > 0.
Histogram histogram_of(ScalarLists lists, size_t bins, bool whole);

// Draws a histogram over the width of the panel, in the colours of a scale, with a handle for each end
// of the range, which the mouse drags; they stay a hundredth of the histogram apart. The heights of columns
// are square roots of counts, so that small counts are visible. Landmarks: "scalar low" and "scalar high".
// Returns true if the range was changed.
bool draw_histogram(const Histogram& histogram, ColourScale scale, ScalarRange& range);

// The quantity that colours the faces, its values, and the range of the colours. While nothing is shown it
// holds no values and costs nothing.
class ScalarMap {
 public:
  std::optional<FaceQuantity> shown() const { return shown_; }
  // Shows a quantity, or nothing, with a fitted range.
  void show(std::optional<FaceQuantity> quantity);

  // Sets the mesh for kDeviation; null for none.
  void set_reference(std::shared_ptr<const ReferenceMesh> reference);
  const ReferenceMesh* reference() const { return reference_.get(); }

  // Records changes since update().
  void follow(const World& world, const Delta& delta);
  // The same for faces that steps of a stroke add and remove, by their counts, and for all faces once no
  // step waits. O(bodies).
  void follow_steps(const World& world, bool any_waits);
  // The same for heat that was conducted or added.
  void follow_heat(const World& world);
  void forget();
  // Returns true if values are out of date; false while nothing is shown.
  bool is_old() const { return shown_ && (all_old_ || !old_.empty()); }
  // Computes the values that are out of date. Hidden bodies have none. O(faces of bodies that changed, plus
  // a pass over all values).
  void update(const World& world, const LoadedShadings& loaded);

  const Histogram& histogram() const { return histogram_; }
  const ScalarRange& range() const { return range_; }
  // Fixes the range. Precondition: low < high.
  void set_range(const ScalarRange& range);
  // Fits the range to the values, without this share of the faces at each end; that of signed distances is
  // symmetric. Precondition: share < 0.5.
  void fit(double share);
  // Returns the scale of the quantity: the diverging one for distances with a sign.
  ColourScale scale() const;
  // Returns true if the range follows the values.
  bool fits() const { return fit_.has_value(); }

  // Returns the field for the viewport; null if nothing is shown or no face has a value.
  std::shared_ptr<const ScalarField> field(FileUnit unit) const;

 private:
  // Temperatures are unchanged while these are equal.
  struct HeatMoment {
    Ticks clock = 0;
    EnergyLedger energy;
    friend bool operator==(const HeatMoment&, const HeatMoment&) = default;
  };
  void renew(BodyId id, const Body& body, const LoadedShadings& loaded);
  void take_histogram();

  std::optional<FaceQuantity> shown_;
  std::shared_ptr<const ReferenceMesh> reference_;
  std::map<BodyId, std::shared_ptr<const FaceScalars>> values_;
  std::set<BodyId> old_;
  // Faces are unchanged while these are equal and no step is executed.
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
