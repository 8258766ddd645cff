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
#include "core/world/world.h"
#include "ui/render/bodies/prepared_body.h"
#include "ui/screen/live_picture.h"

namespace kerf {

// The durations of frames. The last million of them are kept.
class FrameStatistics {
 public:
  void add(double milliseconds);
  size_t frames() const { return frames_; }
  // The percentile of the durations for a fraction 0 .. 1, by nearest rank; 0 without frames.
  double percentile(double share) const;
  double longest() const { return longest_; }
  // The durations kept, in their order as long as they are fewer than a million.
  const std::vector<float>& each() const { return kept_; }
  double last() const { return last_; }

 private:
  std::vector<float> kept_;
  size_t frames_ = 0;
  double longest_ = 0, last_ = 0;
};

// The durations and changes of the last steps and the bytes sent for the last pictures, as lines of a chart.
class StepChart {
 public:
  enum Line { kFind, kRefine, kRemove, kTree, kSeparate, kBorn, kGone, kSent, kLines };
  static constexpr size_t kKept = 240;

  void record_step(const StepResult& step);  // milliseconds and faces
  void record_sent(size_t bytes);            // of one picture, kilobytes

  // The values of a line, oldest first.
  std::span<const float> line(Line line) const { return lines_[line]; }
  float last(Line line) const { return lines_[line].empty() ? 0 : lines_[line].back(); }
  float largest(Line line) const;

 private:
  void add(Line line, double value);
  std::array<std::vector<float>, kLines> lines_;
};

// The memory used by this process in bytes, or 0 if that is unknown.
size_t process_bytes();

// The memory usage of the process, in bytes.
struct MemoryStatistics {
  size_t process = 0;
  size_t meshes = 0, trees = 0;  // of all worlds that are held
  PictureMemory pictures;
  size_t history = 0;  // before-images

  // The memory of the process minus all of these parts: the program itself, drivers and their buffers. It is
  // too small by `graphics` if the graphics card has its own memory.
  size_t other() const;
};

// The current statistics, for these worlds (entries may be null) and a history of the given size in bytes.
// O(bodies).
MemoryStatistics memory_statistics(std::span<const World* const> worlds, size_t history,
                                   const PictureMemory& pictures);

// The statistics in the panels and the status bar. They are updated four times per second, so that they are
// legible.
struct ShownStatistics {
  FileUnit unit = FileUnit::kMetre;  // that areas are shown in
  size_t faces = 0;
  size_t pieces = 0, specks = 0;  // specks are counted apart
  size_t twin_faces = 0;          // in the right half
  double frame_ms = 0;
  std::string time;  // how fast it passes; empty: it stands still
  std::string work;  // what the beam still does after the user has let go; may be empty
  size_t tree_nodes = 0;
  std::optional<int> tree_depth;  // unknown until a panel shows it
  MemoryStatistics memory;
  // The statistics of the last stroke that was not undone, however it came into the world; nothing without
  // one.
  struct Stroke {
    StepStatistics statistics;
    double removed_area = 0;  // m^2
  };
  std::optional<Stroke> stroke;
};

// Everything that the editor counts and measures.
struct Statistics {
  ShownStatistics shown;
  bool world_changed = true;  // since `shown` was taken
  bool depth_wanted = false;  // of the trees
  ShadowStatistics shadows;
  FrameStatistics frames;
  FrameStatistics between_pictures;  // durations of frames without drawing
  // Durations, whole and without drawing, of frames in which something was cut.
  FrameStatistics cutting_frames, between_cutting_pictures;
  StepChart chart;
  size_t recuts = 0;
};

// Updates the counts of the world of a document for the panels. Depths of trees are computed only if they are
// shown, because that takes O(n).
void count_world(ShownStatistics& shown, const Document& document, bool depth_shown);

// Updates the statistics of the last stroke.
void record_stroke(ShownStatistics& shown, const Document& document);

}  // namespace kerf
