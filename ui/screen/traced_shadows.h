#pragma once

#include <optional>

#include "ui/editor/editor_state.h"

namespace kerf {

// The ray-traced reference over the picture, traced a little every frame while the picture stands still.
class TracedShadows {
 public:
  // After a picture of the document was drawn to `target`: begins anew where `still` says that it will stay,
  // goes on where it has stayed, forgets everything where it moves. Draws over the target and notes how far
  // it is.
  void work(EditorState& state, Renderer& renderer, const CameraView& view, const Target& target, bool fresh,
            bool still);

  // Whether there is more to trace.
  bool busy() const { return traced_ && !traced_->done(); }

 private:
  std::optional<ShadowReference> traced_;
  ShadowCounts drawn_;
};

}  // namespace kerf
