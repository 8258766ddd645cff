#pragma once

#include <optional>

#include "ui/render/renderer.h"
#include "ui/screen/shadow_statistics.h"

namespace kerf {

// Draws ray-traced reference shadows over a picture. A part of them is traced in every frame while the
// picture stays the same.
class TracedShadows {
 public:
  // To be called after a picture of the world was drawn to `target`. Starts or continues while the picture is
  // `still`, which says that its shadows will not change, and starts over for a `fresh` one, which may have
  // others. Draws over the target and records its progress in `statistics`.
  void work(const World& world, const ViewOptions& look, Renderer& renderer, const CameraView& view,
            const Target& target, bool fresh, bool still, ShadowStatistics& statistics);

  // Whether tracing is incomplete, or has not begun because the picture was not still.
  bool busy() const { return waits_ || (traced_ && !traced_->done()); }

 private:
  std::optional<ShadowReference> traced_;
  ShadowCounts drawn_;
  bool waits_ = false;  // for a picture that is still
};

}  // namespace kerf
