#pragma once

#include <optional>

#include "ui/render/renderer.h"
#include "ui/screen/shadow_figures.h"

namespace kerf {

// The ray-traced reference over a picture, traced a little every frame while the picture stands still.
class TracedShadows {
 public:
  // To be called after a picture of the world was drawn to `target`. Begins where `still` says that the
  // picture will stay, goes on where it has stayed, forgets everything where it is a `fresh` one. Draws over
  // the target and notes in `figures` how far it is.
  void work(const World& world, const ViewOptions& look, Renderer& renderer, const CameraView& view,
            const Target& target, bool fresh, bool still, ShadowFigures& figures);

  // Whether there is more to trace.
  bool busy() const { return traced_ && !traced_->done(); }

 private:
  std::optional<ShadowReference> traced_;
  ShadowCounts drawn_;
};

}  // namespace kerf
