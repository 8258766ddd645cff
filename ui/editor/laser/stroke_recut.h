#pragma once

#include <memory>

#include "ui/editor/shared/workspace.h"

namespace kerf {

// Cuts the last stroke again, or all strokes of the last group (see StepGroups), with the resolution and the
// radius of the panels.
class StrokeRecut {
 public:
  // The workspace must outlive it.
  explicit StrokeRecut(Workspace& workspace) : workspace_(workspace) {}

  // Returns the reason why nothing can be recut; null if something can.
  const char* disabled_reason() const;
  // Requests a recut at the current resolution and, with `radius`, the current radius.
  void request(bool radius);
  // Like request(), after a change of a slider, unless live update is off. A group is recut once no slider is
  // held, because each recut adds its strokes to the journal.
  void request_live(bool radius);
  // Called once per frame.
  void update();
  bool waits() const { return waits_; }

 private:
  const StepGroups::Group* group() const;
  void recut(bool radius);
  void recut_group(const StepGroups::Group& group, bool radius);
  void set_resolution(CutSettings& settings, bool radius) const;

  Workspace& workspace_;
  // Whether the queued recut also uses the current radius; expires when it begins or is dropped.
  std::weak_ptr<const bool> queued_;
  bool waits_ = false;              // until no slider is held
  bool waits_with_radius_ = false;  // the recut that waits also uses the current radius
};

}  // namespace kerf
