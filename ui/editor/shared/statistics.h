#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/cut/cut_step.h"
#include "core/document/document.h"
#include "core/mesh/files/mesh_format.h"
#include "core/tree/tree_statistics.h"
#include "core/world/world.h"
#include "ui/render/bodies/base_faces.h"
#include "ui/screen/live_picture.h"

namespace kerf {

class StepGroups;

// Durations of frames. The last million are kept.
class FrameStatistics {
 public:
  void add(double milliseconds);
  size_t frames() const { return frames_; }
  // Returns a percentile of the durations for a fraction 0 .. 1, by nearest rank; 0 without frames.
  double percentile(double share) const;
  double longest() const { return longest_; }
  // The kept durations, in order if they are fewer than a million.
  const std::vector<float>& each() const { return kept_; }
  double last() const { return last_; }

 private:
  std::vector<float> kept_;
  size_t frames_ = 0;
  double longest_ = 0, last_ = 0;
};

// Durations and changes of the last steps, and bytes uploaded for the last frames, as lines of a chart.
class StepChart {
 public:
  enum Line { kFind, kRefine, kRemove, kTree, kSeparate, kAdded, kDead, kSent, kLines };
  static constexpr size_t kKept = 240;

  void record_step(const StepResult& step);  // milliseconds and faces
  void record_sent(size_t bytes);            // of one frame, kilobytes

  // Values of a line, oldest first.
  std::span<const float> line(Line line) const { return lines_[line]; }
  float last(Line line) const { return lines_[line].empty() ? 0 : lines_[line].back(); }
  float largest(Line line) const;

 private:
  void add(Line line, double value);
  std::array<std::vector<float>, kLines> lines_;
};

// Returns the memory used by this process [bytes], or 0 if unknown.
size_t process_bytes();

// Memory usage [bytes].
struct MemoryStatistics {
  size_t process = 0;
  size_t meshes = 0, trees = 0;  // of all worlds
  PictureMemory pictures;
  size_t history = 0;  // before-images

  // The rest of the process: the program itself, drivers and their buffers. Too small by `graphics` if the
  // graphics card has its own memory.
  size_t other() const;
};

// Measures the memory with these worlds (entries may be null) and history [bytes]. O(bodies).
MemoryStatistics memory_statistics(std::span<const World* const> worlds, size_t history,
                                   const PictureMemory& pictures);

// The statistics in the panels and the status bar, updated four times per second to be legible.
struct ShownStatistics {
  FileUnit unit = FileUnit::kMetre;  // of areas
  size_t faces = 0;
  size_t pieces = 0, specks = 0;  // specks are not among the pieces
  size_t twin_faces = 0;          // of the right half
  size_t selected = 0;            // pieces
  std::string file;               // the open file
  bool unsaved = false;           // it lacks changes
  std::string autosave;           // age of the autosaved changes; empty: there are none
  double frame_ms = 0;
  std::string time;  // speed of time; empty: paused
  std::string work;  // of the beam after the end of its stroke; may be empty
  size_t tree_nodes = 0;
  std::optional<TreeStatistics> tree;  // sums over all bodies; nullopt until Statistics::tree_wanted
  MemoryStatistics memory;
  // The last stroke that is not undone, or the sum over its group (see StepGroups); nullopt without one or
  // if a knife has cut since.
  struct Stroke {
    StepStatistics statistics;
    double removed_area = 0;  // m^2
  };
  std::optional<Stroke> stroke;
  bool cut_by_knife = false;  // the last cut that is not undone
};

struct Statistics {
  ShownStatistics shown;
  bool world_changed = true;  // since `shown` was updated
  bool tree_wanted = false;   // ShownStatistics::tree
  ShadowStatistics shadows;
  FrameStatistics frames;
  FrameStatistics between_pictures;  // durations without drawing
  // Frames in which something was cut: whole durations, and without drawing.
  FrameStatistics cutting_frames, between_cutting_pictures;
  StepChart chart;
  size_t recuts = 0;
};

// Updates the counts of a document's world. Those of trees take O(n) and are computed only if shown.
void count_world(ShownStatistics& shown, const Document& document, bool tree_shown);

void record_stroke(ShownStatistics& shown, const UndoStack& history, const StepGroups& groups);

}  // namespace kerf
