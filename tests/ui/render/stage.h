#pragma once

#include "core/document/single_step.h"
#include "ui/gl/context.h"
#include "ui/gl/image.h"
#include "ui/render/renderer.h"

namespace kerf::test {

// A document and a renderer that follows it, without a screen.
class Stage {
 public:
  explicit Stage(World world);

  // Cuts with a beam that moves from one pose to another, into faces of about its radius, and leaves heat
  // beside the rim (see CutSettings).
  void cut(const Pose& from, const Pose& to, double radius, double heat_width = 0);

  // The same stroke waits, and is executed stage by stage; the stage may not be moved meanwhile.
  void begin_cut(const Pose& from, const Pose& to, double radius, double heat_width = 0);
  StageRecord next_stage();

  // Lets time pass in which bodies move.
  void pass(Ticks ticks);
  // Applies a command that is no stroke's.
  void apply(const Command& command);

  Pixels draw(const CameraView& view, const ViewOptions& options, int width, int height);

  const Document& document() const { return document_; }
  const World& world() const { return document_.world(); }
  Renderer& renderer() { return *renderer_; }

 private:
  gl::OffscreenContext context_;
  std::optional<Renderer> renderer_;
  Document document_;
  std::optional<SingleStep> single_;
};

// A ball beside a ring, each a body, and a beam that cut the top off the ball: four pieces to look at.
Stage ball_and_ring();
CameraView view_of_ball_and_ring(double aspect);

struct PictureDifference {
  double mean = 0;     // of the channels, of 255
  double changed = 0;  // part of the pixels with a channel off by more than 24
};
PictureDifference difference(const Pixels& a, const Pixels& b);

}  // namespace kerf::test
