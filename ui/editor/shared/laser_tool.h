#pragma once

#include <optional>

#include "core/document/document.h"
#include "ui/editor/shared/laser_controls.h"
#include "ui/render/passes/beam_effects.h"
#include "ui/render/view/camera.h"

namespace kerf {

// Converts pointer motion into strokes. The emitter is a little above and to the right of the eye. The beam
// aims at a point on the pointer's ray whose distance is chosen at the start of the stroke (the surface under
// the pointer, or the camera's pivot) and kept, so that the poses depend on the pointer alone and not on how
// far the stroke has been cut. A surface at another distance is cut beside the pointer by less than 0.4
// degrees of the view's angle, because the emitter is so near to the eye.
class LaserTool {
 public:
  // x and y of the pointer as in CameraView::ray; `pixel` is the size of a pixel in y. `heard` is when the
  // pointer was there, in seconds of a clock that never goes back: poses of the stroke carry it.
  // The document learns of a stroke when its beam meets a body, so that one that meets nothing leaves no step
  // in the history and no command in the journal. While time passes, bodies may move into the beam: then a
  // stroke begins when the pointer has moved further than within a click.
  void press(Document& document, const CameraView& view, Vec2 pointer, const LaserControls& controls,
             double heard);
  void move(Document& document, const CameraView& view, Vec2 pointer, double pixel, double heard);
  // Begins a stroke, and continues it, with given poses in place of those of the pointer: the beam comes from
  // `distance` (m) away from what it aims at.
  // A turn to the opposite direction ends the stroke and begins another. Preconditions: fire() is called
  // while no stroke is drawn, the distance is positive, and directions are unit vectors.
  void fire(Document& document, const Pose& pose, double distance, const CutSettings& settings, double heard);
  void carry_to(Document& document, const Pose& pose, double heard);
  // A beam of the thermal model that is held still goes on emitting: to be called once a frame with the
  // present time. Does nothing while moves wait; the next call makes up for the time.
  void go_on(Document& document, double heard);
  // Returns whether a stroke has ended that met nothing.
  bool release(Document& document);
  // Says whether bodies move by themselves at the moment. To be called once a frame.
  void follow_time(Document& document, bool passes);

  bool cutting() const { return cutting_; }
  // Whether the beam heats what it is held on.
  bool emits() const { return cutting_ && held_.empty() && settings_.model == Model::kThermal; }

  // A stroke that was drawn earlier, or elsewhere, is cut again: the beam is drawn as its settings say, from
  // about `emitter` metres away. Does nothing while a stroke is drawn.
  void take_over(const CutSettings& settings, double emitter);
  // Records the pose that the cut has reached, which may lag behind the pointer. The beam is drawn there.
  void reach(const Pose& pose) { beam_ = pose; }
  // Finds the point where the beam strikes at that pose: the rim of what it has cut, or a surface behind it.
  void find_strike(const Document& document);
  // The beam to be drawn while it is on, i.e. until the stroke has ended and its last move is cut.
  std::optional<BeamPicture> picture(const Document& document) const;

 private:
  void set_up(const CutSettings& settings);
  double distance_of_emitter(const World& world, const CameraView& view) const;
  Pose aim(const CameraView& view, Vec2 pointer) const;
  void begin(const Document& document, const CutSettings& settings, double heard);
  void move_to(Document& document, const Pose& pose, double heard);
  bool has_moved() const { return held_.size() > 1; }
  void begin_held(Document& document);

  bool cutting_ = false;
  std::vector<Command> held_;     // of the stroke, while it has met nothing and the document has none of them
  bool time_passes_ = false;      // bodies move by themselves
  double began_ = 0;              // s of the clock of `heard`, when the stroke began
  double told_ = 0;               // s since then, at the last pose that the document was told
  double focus_ = 1;              // m along the pointer's ray
  double emitter_ = 1;            // m from the point aimed at back to the emitter
  double reach_ = 1;              // m along the beam
  double radius_ = 0.01;          // m
  double overshoot_ = 0.01;       // m, how far beside the beam the rim of what it burns may be
  Vec2 pointer_{0};               // of the last pose
  CutSettings settings_;          // of the stroke
  Pose pose_;                     // that the pointer asks for
  Pose beam_;                     // that the cut has reached
  std::optional<double> strike_;  // m along the beam
};

}  // namespace kerf
