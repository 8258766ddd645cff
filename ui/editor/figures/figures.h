#pragma once

#include "ui/editor/figures/frame_statistics.h"
#include "ui/editor/figures/memory_figures.h"
#include "ui/editor/figures/step_chart.h"
#include "ui/screen/shadow_figures.h"

namespace kerf {

// The figures in the panels and the status bar. They are updated four times per second, so that they are
// legible.
struct ShownFigures {
  size_t faces = 0, pieces = 0;
  size_t twin_faces = 0;  // in the right half
  double frame_ms = 0;
  size_t tree_nodes = 0;
  int tree_depth = 0;
  MemoryFigures memory;
  size_t faces_tested = 0, faces_of_step = 0;  // in the last step, and how many there were before it
};

// Everything that the editor counts and measures.
struct Figures {
  ShownFigures shown;
  bool world_changed = true;  // since `shown` was taken
  ShadowFigures shadows;
  FrameStatistics frames;
  FrameStatistics between_pictures;  // durations of frames without drawing
  // The same for frames in which something was cut.
  FrameStatistics cutting_frames, between_cutting_pictures;
  StepChart chart;
  StepFigures last_step, stroke;
  size_t revision = 0;  // of the document whose stroke or recut `stroke` is of
  size_t faces_before_step = 0;
  size_t recuts = 0;

  // Records a step of a document at this revision, and the number of faces before the step.
  void note_step(const StepResult& step, size_t revision_of_step, size_t faces_before);
  // Resets everything that belongs to one document.
  void forget_strokes();
};

// Updates the counts of a world for the panels. Depths of trees are computed only if they are shown, because
// that takes O(n).
void count_world(ShownFigures& shown, const World& world, bool depth_shown);

}  // namespace kerf
