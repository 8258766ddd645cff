#include "ui/render/bodies/prepared_body.h"

#include <array>
#include <mutex>

#include "core/base/parallel.h"

namespace kerf {

namespace {

FloatFrame picture_frame(const Body& body) {
  return FloatFrame::around(body.bounds().min, body.bounds().max);
}

// Calls what(id, body, progress) for each body, with progress in proportion to their faces, until one
// fails.
template <typename What>
Status for_each_body(const World& world, const Progress* progress, What what) {
  ProgressShares shares(progress);
  const auto all = static_cast<double>(world.live_faces());
  for (const BodyId id : world.ids()) {
    const Body& body = world.body(id);
    const Progress own = shares.next(static_cast<double>(body.mesh.live_faces()) / all);
    if (const Status done = what(id, body, &own); !done) return done;
  }
  return Done{};
}

// The progress of two concurrent computations, each of which is half of the work.
class JointProgress {
 public:
  explicit JointProgress(const Progress* whole) : whole_(whole) {}
  Progress of(size_t computation) {
    return {[this, computation](double fraction) {
      const std::lock_guard lock(mutex_);
      done_[computation] = fraction;
      stopped_ = stopped_ || (whole_ && !whole_->report(0.5 * (done_[0] + done_[1])));
      return !stopped_;
    }};
  }

 private:
  const Progress* whole_;
  std::mutex mutex_;
  std::array<double, 2> done_{};
  bool stopped_ = false;
};

}  // namespace

PreparedBody prepare_shading(const Body& body, const LoadedShadings& loaded) {
  const auto found = loaded.find(body.loaded_as);
  if (found == loaded.end()) {
    const FloatFrame frame = picture_frame(body);
    return {frame, std::make_shared<const BaseFaces>(body.mesh, frame), nullptr};
  }
  const auto& [frame, bases] = found->second;
  if (body.loaded_faces.empty()) return {frame, bases, nullptr};
  return {frame, std::make_shared<const BaseFaces>(bases->pick(body.loaded_faces)), nullptr};
}

Result<PreparedBodies> prepare_shading(const World& world, const Progress* progress) {
  PreparedBodies prepared;
  const Status done = for_each_body(world, progress, [&](BodyId id, const Body& body, const Progress* own) {
    const FloatFrame frame = picture_frame(body);
    Result<BaseFaces> bases = BaseFaces::build(body.mesh, frame, own);
    if (!bases) return Status(bases.error());
    prepared.emplace(id, PreparedBody{frame, std::make_shared<const BaseFaces>(std::move(*bases)), nullptr});
    return Status(Done{});
  });
  if (!done) return done.error();
  return prepared;
}

Status prepare_shadows(const World& world, PreparedBodies& prepared, const Progress* progress) {
  return for_each_body(world, progress, [&](BodyId id, const Body& body, const Progress* own) {
    const auto found = prepared.find(id);
    if (found == prepared.end()) return Status(Done{});
    Result<ShadowCaster> caster = ShadowCaster::build(body.mesh, found->second.frame, own);
    if (!caster) return Status(caster.error());
    found->second.caster = std::make_unique<ShadowCaster>(std::move(*caster));
    return Status(Done{});
  });
}

Result<PreparedBodies> prepare_drawing(const World& world, const Progress* progress) {
  PreparedBodies prepared;
  const Status done = for_each_body(world, progress, [&](BodyId id, const Body& body, const Progress* own) {
    const FloatFrame frame = picture_frame(body);
    JointProgress joint(own);
    const Progress shading = joint.of(0), casting = joint.of(1);
    Result<BaseFaces> bases = cancelled();
    Result<ShadowCaster> caster = cancelled();
    do_both([&] { bases = BaseFaces::build(body.mesh, frame, &shading); },
            [&] { caster = ShadowCaster::build(body.mesh, frame, &casting); });
    if (!bases || !caster) return Status(cancelled());
    prepared.emplace(id, PreparedBody{frame, std::make_shared<const BaseFaces>(std::move(*bases)),
                                      std::make_unique<ShadowCaster>(std::move(*caster))});
    return Status(Done{});
  });
  if (!done) return done.error();
  return prepared;
}

}  // namespace kerf
