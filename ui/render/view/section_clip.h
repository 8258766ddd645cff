#pragma once

#include <epoxy/gl.h>

#include "ui/render/view/view_options.h"

namespace kerf {

// While it exists, programs that write gl_ClipDistance[0] draw only what the section plane of the options
// leaves. Programs that do not write it must not draw meanwhile. Without a plane it does nothing.
class SectionClip {
 public:
  explicit SectionClip(const ViewOptions& options) : on_(shown_section(options) != nullptr) {
    if (on_) glEnable(GL_CLIP_DISTANCE0);
  }
  ~SectionClip() {
    if (on_) glDisable(GL_CLIP_DISTANCE0);
  }
  SectionClip(const SectionClip&) = delete;
  SectionClip& operator=(const SectionClip&) = delete;

 private:
  bool on_;
};

}  // namespace kerf
