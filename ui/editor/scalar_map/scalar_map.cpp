#include "ui/editor/scalar_map/scalar_map.h"

#include <cctype>
#include <utility>

#include "core/base/assert.h"

namespace kerf {

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
  if (delta.anew || !delta.came.empty() || !delta.went.empty() || !delta.detached.empty() ||
      !delta.hid_or_showed.empty())
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

// Equal values stay the same list, so that they are not sent again.
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
