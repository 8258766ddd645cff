#pragma once

#include <optional>

#include "ui/render/renderer.h"
#include "ui/screen/shadow_figures.h"

namespace kerf {

// Draws ray-traced reference shadows over a picture. A part of them is traced in every frame while the
// picture stays the same.
class TracedShadows {
 public:
  // To be called after a picture of the world was drawn to `target`. Starts if `still` says that the picture
  // will not change, continues if it has not changed, and starts over for a `fresh` one. Draws over the
  // target and records its progress in `figures`.
  void work(const World& world, const ViewOptions& look, Renderer& renderer, const CameraView& view,
            const Target& target, bool fresh, bool still, ShadowFigures& figures);

  // Whether tracing is incomplete.
  bool busy() const { return traced_ && !traced_->done(); }

 private:
  std::optional<ShadowReference> traced_;
  ShadowCounts drawn_;
};

}  // namespace kerf
