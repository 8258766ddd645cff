#include "ui/screen/traced_shadows.h"

namespace kerf {

namespace {
constexpr size_t kPixelsOfFrame = 6000;
}

void TracedShadows::work(const World& world, const ViewOptions& look, Renderer& renderer,
                         const CameraView& view, const Target& target, bool fresh, bool still,
                         ShadowStatistics& statistics) {
  const bool wanted = look.show.shadow_reference && look.shadow.inspected < look.lights.size();
  if (!wanted || fresh) traced_.reset();
  if (wanted && still && !traced_) {
    traced_ = renderer.shadow_reference(world, view, look, look.shadow.inspected, true, target.width,
                                        target.height);
    drawn_ = renderer.shadow_counts(world, view, look, look.shadow.inspected, look.shadow.method, true,
                                    target.width, target.height);
  }
  waits_ = wanted && !traced_;
  statistics.traced = 0;
  statistics.wrong.reset();
  if (!traced_) return;
  if (still) traced_->trace(kPixelsOfFrame);
  renderer.draw_reference(*traced_, drawn_, target);
  statistics.traced = traced_->share_done();
  if (traced_->done()) statistics.wrong = differing_pixels(drawn_, *traced_);
}

}  // namespace kerf
