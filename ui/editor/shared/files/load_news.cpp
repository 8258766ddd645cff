#include "ui/editor/shared/files/load_news.h"

#include "core/base/assert.h"
#include "core/document/history/document.h"

namespace kerf {

namespace {

constexpr std::chrono::milliseconds kBetweenCopies(250);
constexpr int kCopyShare = 8;  // a copy may take one such part of the time

// Nobody stops it, so it does not fail.
CutSoFar copy_of(const SceneDescription& scene, const World& world, const LoadedShadings& shadings) {
  CutSoFar copy{scene, world, {}};
  for (const BodyId id : world.ids()) copy.prepared.emplace(id, prepare_shading(world.body(id), shadings));
  const Status cast = prepare_shadows(world, copy.prepared, nullptr);
  KERF_ASSERT(cast.ok());
  return copy;
}

}  // namespace

void LoadNews::show(const SceneDescription& scene, const World& world, const LoadedShadings& shadings) {
  const Clock::time_point began = Clock::now();
  if (!watched_ || began < next_ || world.live_faces() > Document::kMostFacesToCopy) return;
  {
    const std::lock_guard lock(mutex_);
    if (so_far_) return;
  }
  CutSoFar copy = copy_of(scene, world, shadings);
  const Clock::time_point ended = Clock::now();
  next_ = ended + std::max<Clock::duration>(kBetweenCopies, kCopyShare * (ended - began));
  const std::lock_guard lock(mutex_);
  so_far_ = std::move(copy);
}

std::optional<CutSoFar> LoadNews::take() {
  const std::lock_guard lock(mutex_);
  return std::exchange(so_far_, std::nullopt);
}

}  // namespace kerf
