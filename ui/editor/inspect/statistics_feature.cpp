#include "ui/editor/shared/feature.h"

#include <imgui.h>

#include <algorithm>

#include "ui/window/number_text.h"
#include "ui/window/theme.h"
#include "ui/window/widgets.h"

namespace kerf {

namespace {

constexpr size_t kManyFaces = 100'000;  // from which on the memory of the program itself is negligible
constexpr float kPlotHeight = 1.7f, kNumberWidth = 5.2f;  // sizes of the text

struct ChartRow {
  StepChart::Line line;
  const char* name;
  const char* meaning;
};

constexpr std::array kStages{
    ChartRow{StepChart::kFind, "Find", "Time for querying the tree for the faces under the beam."},
    ChartRow{StepChart::kRefine, "Refine", "Time for splitting these faces until they are fine enough."},
    ChartRow{StepChart::kRemove, "Remove", "Time for removing faces from the mesh."},
    ChartRow{StepChart::kTree, "Tree", "Time for updating the tree."},
    ChartRow{StepChart::kSeparate, "Separate", "Time for finding separated parts and reporting changes."}};

// Draws the line of a row up to `top`, with its last number next to it.
void plot_row(const StepChart& chart, const ChartRow& row, float top, const std::string& last) {
  property(row.name);
  const float em = ImGui::GetFontSize();
  const std::span<const float> values = chart.line(row.line);
  ImGui::PushID(row.name);
  ImGui::PushStyleColor(ImGuiCol_PlotLines, colours::accent());
  ImGui::PlotLines("##line", values.data(), static_cast<int>(values.size()), 0, nullptr, 0,
                   std::max(top, 1e-6f),
                   {std::max(em, ImGui::GetContentRegionAvail().x - kNumberWidth * em), kPlotHeight * em});
  ImGui::PopStyleColor();
  tooltip(row.meaning);
  ImGui::PopID();
  ImGui::SameLine();
  const float free = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(last.c_str()).x;
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(0.0f, free));
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(last.c_str());
}

void stage_rows(const StepChart& chart) {
  float top = 0;  // one scale, so that the stages can be compared
  for (const ChartRow& row : kStages) top = std::max(top, chart.largest(row.line));
  for (const ChartRow& row : kStages) plot_row(chart, row, top, text_of("%.2f ms", chart.last(row.line)));
}

void change_rows(const StepChart& chart) {
  const float top = std::max(chart.largest(StepChart::kAdded), chart.largest(StepChart::kDead));
  const auto faces = [&](StepChart::Line line) { return grouped(static_cast<size_t>(chart.last(line))); };
  plot_row(chart, {StepChart::kAdded, "Created", "Faces that are new or have new corners."}, top,
           faces(StepChart::kAdded));
  plot_row(chart, {StepChart::kDead, "Removed", "Faces that no longer exist."}, top, faces(StepChart::kDead));
  plot_row(chart, {StepChart::kSent, "Uploaded", "Data sent to the GPU for a frame."},
           chart.largest(StepChart::kSent), text_of("%.0f kB", chart.last(StepChart::kSent)));
}

void memory_row(const char* name, size_t bytes, size_t faces, const char* meaning) {
  property(name);
  std::string text = text_of("%.0f MB", static_cast<double>(bytes) / (1 << 20));
  if (faces >= kManyFaces)
    text += text_of(", %.0f bytes/face", static_cast<double>(bytes) / static_cast<double>(faces));
  ImGui::TextUnformatted(text.c_str());
  tooltip(meaning);
}

void memory_rows(const MemoryStatistics& memory, size_t faces) {
  memory_row("Process", memory.process, faces, "Memory of the whole process, including drivers.");
  memory_row("Meshes", memory.meshes, faces,
             "Faces, edges and corners of all bodies, of the right view, and of the loaded scene if kept for "
             "recuts.");
  memory_row("Trees", memory.trees, faces, "AABB trees of these meshes.");
  memory_row("Shading", memory.pictures.shading, faces, "Smooth normals of the loaded faces.");
  memory_row("Shadows", memory.pictures.shadows, faces,
             "Shadow casters and their shadow volumes for each light.");
  memory_row(
      "Graphics", memory.pictures.graphics, faces,
      "Buffers of faces and volumes; a graphics card with its own memory holds them outside the process.");
  memory_row("History", memory.history, faces, "Changes made by steps, for undo.");
  memory_row("Other", memory.other(), faces,
             "The rest of the process: program, drivers and images, and the copies of a software renderer.");
}

void draw_statistics_panel(const StepChart& chart, const ShownStatistics& shown) {
  if (!begin_properties("##statistics")) return;
  stage_rows(chart);
  change_rows(chart);
  memory_rows(shown.memory, shown.faces);
  end_properties();
}

class StatisticsFeature : public Feature {
 public:
  explicit StatisticsFeature(Statistics& statistics) : statistics_(statistics) {}
  std::vector<PanelPart> panel_parts() override {
    return {{"statistics", [this] { draw_statistics_panel(statistics_.chart, statistics_.shown); }}};
  }

 private:
  Statistics& statistics_;
};

}  // namespace

std::unique_ptr<Feature> statistics_feature(Workspace& workspace) {
  return std::make_unique<StatisticsFeature>(workspace.services.statistics);
}

}  // namespace kerf
