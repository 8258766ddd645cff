#include "ui/editor/inspect/scalar_map.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/assert.h"
#include "core/base/deterministic_math.h"
#include "core/base/parallel.h"
#include "core/mesh/face_batches.h"
#include "ui/editor/shared/command_labels.h"
#include "ui/editor/shared/file_frames.h"
#include "ui/render/bodies/rim_distance.h"
#include "ui/window/number_text.h"

namespace kerf {

namespace {

constexpr size_t kGrain = 1 << 14;
constexpr float kRimReach = 0.5f;  // in the float frame, in which a body is about 2 wide

double min_angle(const Triangle& t) { return std::acos(largest_cosine(t)) * 180 / kPi; }

float local_value(const Body& body, FaceId f, const Triangle& t, FaceQuantity quantity) {
  switch (quantity) {
    case FaceQuantity::kLevel:
      return static_cast<float>(body.mesh.data(f).halvings);
    case FaceQuantity::kLongestEdge:
      return static_cast<float>(std::sqrt(longest_edge2(t)));
    case FaceQuantity::kMinAngle:
      return static_cast<float>(min_angle(t));
    case FaceQuantity::kTemperature:
      return static_cast<float>(
          body.heat.temperature(body.mesh, f, body.sheet.substance, body.sheet.thickness));
    case FaceQuantity::kRimDistance:
      break;
  }
  return kNoScalar;
}

template <typename Value>
void fill(FaceScalars& values, const Mesh& mesh, const Value& value) {
  for_each_range(values.size(), kGrain, [&](size_t first, size_t end) {
    for_each_triangle(mesh, first, end, [&](FaceId f, const Triangle& t) { values[f.index] = value(f, t); });
  });
}

// Returns the bases of a body copied from the loaded one; none, with no open sides, without a loaded one.
BaseFaces bases_of(const Body& body, const LoadedShading* loaded) {
  if (loaded == nullptr) return {};
  return body.loaded_faces.empty() ? *loaded->bases : loaded->bases->pick(body.loaded_faces);
}

void fill_rim_distances(FaceScalars& values, const Body& body, const LoadedShading* loaded) {
  const FloatFrame frame =
      loaded != nullptr ? loaded->frame : FloatFrame::around(body.bounds().min, body.bounds().max);
  const BaseFaces bases = bases_of(body, loaded);
  if (bases.are_whole(body.mesh)) return;
  RimDistance rims(kRimReach, 0);
  std::vector<VertexId> all, affected;
  for (uint32_t v = 0; v < body.mesh.vertex_slots(); ++v) all.emplace_back(v);
  rims.update(body.mesh, bases, frame, all, affected);
  if (!rims.any()) return;
  fill(values, body.mesh, [&](FaceId f, const Triangle&) {
    float nearest = RimDistance::kFar;
    for (const VertexId v : body.mesh.corners(f)) nearest = std::min(nearest, rims.of(v));
    return nearest < RimDistance::kFar ? static_cast<float>(nearest / frame.scale) : kNoScalar;
  });
}

}  // namespace

const char* name_of(FaceQuantity quantity) {
  constexpr std::array<const char*, kFaceQuantities> kNames{"level", "longest edge", "least angle",
                                                            "temperature", "distance to the rim"};
  return kNames[static_cast<size_t>(quantity)];
}

std::string quantity_text(FaceQuantity quantity, double value, FileUnit unit) {
  switch (quantity) {
    case FaceQuantity::kLevel:
      return text_of("%.0f", value);
    case FaceQuantity::kLongestEdge:
    case FaceQuantity::kRimDistance:
      return value == 0 ? "0" : length_label(value, unit);
    case FaceQuantity::kMinAngle:
      return text_of("%.1f\u00b0", value);
    case FaceQuantity::kTemperature:
      break;
  }
  return text_of("%.0f K", value);
}

FaceScalars face_scalars(const Body& body, FaceQuantity quantity, const LoadedShading* loaded) {
  FaceScalars values(body.mesh.face_slots(), kNoScalar);
  if (quantity == FaceQuantity::kRimDistance) {
    fill_rim_distances(values, body, loaded);
  } else {
    fill(values, body.mesh, [&](FaceId f, const Triangle& t) { return local_value(body, f, t, quantity); });
  }
  return values;
}

namespace {

template <typename Visit>
void for_each_value(ScalarLists lists, const Visit& visit) {
  for (const auto& list : lists) {
    for (const float value : *list) {
      if (value != kNoScalar) visit(static_cast<double>(value));
    }
  }
}

void find_extent(ScalarLists lists, Histogram& h) {
  h.least = std::numeric_limits<double>::infinity();
  h.most = -h.least;
  for_each_value(lists, [&](double value) {
    h.least = std::min(h.least, value);
    h.most = std::max(h.most, value);
    ++h.faces;
  });
  if (h.faces == 0) h.least = h.most = 0;
}

}  // namespace

ScalarRange range_between(double low, double high) {
  constexpr double kMinShare = 1e-4;
  const double apart = std::max(kMinShare * std::max(std::abs(low), std::abs(high)), 1e-30);
  return {low, std::max(high, low + apart)};
}

double Histogram::quantile(double share) const {
  const double wanted = share * static_cast<double>(faces);
  double below = 0;
  for (size_t i = 0; i < bins.size(); ++i) {
    const auto here = static_cast<double>(bins[i]);
    if (here > 0 && below + here >= wanted) {
      const double at = from + width() * (static_cast<double>(i) + std::max(0.0, wanted - below) / here);
      return std::clamp(at, least, most);
    }
    below += here;
  }
  return most;
}

Histogram histogram_of(ScalarLists lists, size_t bins, bool whole) {
  KERF_ASSERT(bins > 0);
  Histogram h;
  find_extent(lists, h);
  const ScalarRange range = range_between(h.least, h.most);
  h.from = range.low;
  h.to = range.high;
  if (whole && h.most - h.least < static_cast<double>(bins)) {
    h.from = h.least - 0.5;
    h.to = h.most + 0.5;
    bins = static_cast<size_t>(h.most - h.least) + 1;
  }
  h.bins.assign(bins, 0);
  const double per_bin = h.width();
  for_each_value(lists, [&](double value) {
    const auto bin = static_cast<size_t>(std::max(0.0, (value - h.from) / per_bin));
    ++h.bins[std::min(bin, bins - 1)];
  });
  return h;
}

namespace {
constexpr size_t kBins = 64;
constexpr double kSplitOftenest =
    0.01;  // of the faces; a few at the rim are split many times more than all others
}  // namespace

void ScalarMap::show(std::optional<FaceQuantity> quantity) {
  if (shown_ == quantity) return;
  shown_ = quantity;
  fit_ = quantity == FaceQuantity::kLevel ? kSplitOftenest : 0.0;
  histogram_ = {.bins = {0}};
  forget();
}

void ScalarMap::forget() {
  values_.clear();
  old_.clear();
  counts_.clear();
  all_old_ = true;
}

void ScalarMap::follow(const World& world, const Delta& delta) {
  if (!shown_ || delta.empty()) return;
  if (delta.replaced || !delta.created.empty() || !delta.destroyed.empty() || !delta.detached.empty() ||
      !delta.visibility_changed.empty())
    return forget();
  for (const BodyDelta& body : delta.bodies) {
    if (world.contains(body.body)) old_.insert(body.body);
  }
}

void ScalarMap::follow_steps(const World& world, bool any_waits) {
  if (!shown_) return;
  for (const BodyId id : world.ids()) {
    const Mesh& mesh = world.body(id).mesh;
    const FaceCount now{mesh.face_slots(), mesh.live_faces()};
    if (std::exchange(counts_[id], now) != now) old_.insert(id);
  }
  if (std::exchange(any_waited_, any_waits) && !any_waits) all_old_ = true;
}

void ScalarMap::follow_heat(const World& world) {
  if (shown_ != FaceQuantity::kTemperature) return;
  const HeatMoment now{world.clock(), world.energy()};
  if (now == heat_) return;
  heat_ = now;
  all_old_ = true;
}

void ScalarMap::update(const World& world, const LoadedShadings& loaded) {
  if (!is_old()) return;
  std::erase_if(values_, [&](const auto& entry) { return !world.contains(entry.first); });
  for (const BodyId id : world.ids()) {
    if (all_old_ || old_.contains(id)) renew(id, world.body(id), loaded);
  }
  all_old_ = false;
  old_.clear();
  take_histogram();
}

// Equal values keep the same list, so that they are not sent again.
void ScalarMap::renew(BodyId id, const Body& body, const LoadedShadings& loaded) {
  if (body.hidden) {
    values_.erase(id);
    return;
  }
  const auto found = loaded.find(body.loaded_as);
  FaceScalars values = face_scalars(body, *shown_, found != loaded.end() ? &found->second : nullptr);
  std::shared_ptr<const FaceScalars>& kept = values_[id];
  if (kept == nullptr || *kept != values) kept = std::make_shared<const FaceScalars>(std::move(values));
}

void ScalarMap::take_histogram() {
  std::vector<std::shared_ptr<const FaceScalars>> lists;
  for (const auto& [id, values] : values_) lists.push_back(values);
  histogram_ = histogram_of(lists, kBins, shown_ == FaceQuantity::kLevel);
  if (fit_) fit(*fit_);
}

void ScalarMap::set_range(const ScalarRange& range) {
  KERF_ASSERT(range.low < range.high);
  range_ = range;
  fit_.reset();
}

void ScalarMap::fit(double share) {
  KERF_ASSERT(share >= 0 && share < 0.5);
  fit_ = share;
  const Histogram& h = histogram_;
  range_ = share > 0
               ? range_between(std::max(h.least, h.quantile(share)), std::min(h.most, h.quantile(1 - share)))
               : range_between(h.least, h.most);
}

std::shared_ptr<const ScalarField> ScalarMap::field(FileUnit unit) const {
  if (!shown_ || values_.empty() || histogram_.faces == 0) return nullptr;
  ScalarField field{
      values_, static_cast<float>(range_.low), static_cast<float>(range_.high), name_of(*shown_), {}};
  if (!(field.low < field.high)) return nullptr;
  field.name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(field.name[0])));
  for (size_t i = 0; i < field.labels.size(); ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(field.labels.size() - 1);
    field.labels[i] = quantity_text(*shown_, glm::mix(range_.low, range_.high, t), unit);
  }
  return std::make_shared<const ScalarField>(std::move(field));
}

}  // namespace kerf
