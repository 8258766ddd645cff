#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "core/document/drawing_layers.h"
#include "core/document/job_files.h"
#include "ui/editor/path/drawing_placement.h"
#include "ui/editor/shared/viewport.h"

struct ImDrawList;

namespace kerf {

struct ImportedDrawing {
  std::filesystem::path file;
  std::string text;
  JobFile job;
  PlaneBounds box;  // of the lines [m]
  // Layers or colours in the order of the file, with the number of their lines.
  std::vector<std::pair<std::string, size_t>> layers;

  Vec2 middle() const { return 0.5 * (box.min + box.max); }
  Vec2 half() const { return 0.5 * (box.max - box.min); }
  double extent() const { return glm::length(box.max - box.min); }
};

// Reads an SVG or DXF file; fails like read_job().
Result<ImportedDrawing> import_drawing(const std::filesystem::path& file);

// Returns the smallest radius of the layers that are cut; `radius` [m] is that of layers without their own.
double smallest_radius(const ImportedDrawing& drawing, const LayerTable& layers, double radius);
// Returns the settings of all layers of a drawing, with this speed [m/s] for those without their own.
LayerTable with_speed(const ImportedDrawing& drawing, LayerTable layers, double speed);

// Returns the ImU32 of a stroke colour of SVG if it is legible over the viewport, else the accent.
uint32_t layer_colour(const std::string& layer);

// The lines of a drawing on the surfaces that the beam hits first.
class DrawingPreview {
 public:
  void invalidate() { is_valid_ = false; }
  bool is_valid() const { return is_valid_; }
  // Projects the lines if they are out of date, and finds the parts that surfaces hide from the eye if the
  // camera has moved. Called once per frame.
  void update(const ImportedDrawing& drawing, const DrawingPlacement& placement, const World& world,
              const PrimaryViewport& picture);
  const std::vector<ProjectedLine>& lines() const { return lines_; }
  // Draws the lines of the layers that are cut, as wide as the beam; its radius [m, >= 0] is that of layers
  // without their own. Hidden parts, and those where the beam hits nothing, are faint.
  void draw(const ImportedDrawing& drawing, const LayerTable& layers, double radius,
            const PrimaryViewport& picture, ImDrawList& list) const;

 private:
  void find_hidden(const World& world, const PrimaryViewport& picture);

  std::vector<ProjectedLine> lines_;
  std::vector<std::vector<char>> hidden_;  // by point of the lines
  CameraView seen_from_;
  bool is_valid_ = false;
};

// Draws the frame with its handles; the one at the pointer, a place of the window, is highlighted.
void draw_drawing_frame(const PrimaryViewport& picture, const JobPlane& plane, Vec2 half, Vec2 pointer,
                        ImDrawList& list);

}  // namespace kerf
