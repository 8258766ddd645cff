#pragma once

#include <optional>

#include "core/document/document.h"
#include "ui/editor/tools/laser_controls.h"
#include "ui/render/beam_pass.h"
#include "ui/render/camera.h"

namespace kerf {

// The laser in the user's hand: turns where the pointer goes into a stroke. The emitter stands beside the
// eye, up and to the right of it; the beam aims at the point of the pointer's ray at a distance that is
// chosen where the stroke begins (what the pointer is on, or the camera's pivot) and kept, so the beam moves
// without jumps.
class LaserTool {
 public:
  // x and y of the pointer as in CameraView::ray; `pixel` is the size of a pixel in y.
  void press(Document& document, const CameraView& view, Vec2 pointer, const LaserControls& controls);
  void move(Document& document, const CameraView& view, Vec2 pointer, double pixel);
  void release(Document& document);

  bool cutting() const { return cutting_; }

  // Looks where the beam strikes, before it burns away what it strikes. The beam stands where the document
  // has got to with the stroke, which may be behind the pointer.
  void find_strike(const Document& document);
  // The beam, while it is on: until the stroke has ended and all of it is cut.
  std::optional<BeamPicture> picture(const Document& document) const;

 private:
  Pose aim(const CameraView& view, Vec2 pointer) const;

  bool cutting_ = false;
  double focus_ = 1;              // m along the pointer's ray
  double reach_ = 1;              // m along the beam
  double radius_ = 0.01;          // m
  double overshoot_ = 0.01;       // m, how far beside the beam the rim of what it burns may be
  Vec2 pointer_{0};               // of the last pose
  Pose pose_;                     // that the pointer asks for
  Pose beam_;                     // where the beam is
  std::optional<double> strike_;  // m along the beam
};

}  // namespace kerf
