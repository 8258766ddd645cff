#include "ui/editor/prepare/prepare_panel.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/assert.h"
#include "core/mesh/openmesh/smooth.h"
#include "ui/editor/prepare/preview_rows.h"
#include "ui/editor/shared/panels/panel_rows.h"
#include "ui/window/fitted_text.h"
#include "ui/window/landmarks.h"
#include "ui/window/number_text.h"
#include "ui/window/property.h"
#include "ui/window/row_button.h"

namespace kerf {

namespace {

using PrepareTool = Preparation::Tool;

constexpr size_t kMostSubdivisions = 4;
constexpr size_t kMostTyped = 1'000'000'000'000;  // faces
constexpr double kUsualError = 0.001;             // of the size of the world

// In the order of the tools and of the schemes.
constexpr std::array kTools{"Simplify to faces", "Simplify to an error", "Subdivide", "Smooth",
                            "Turn inner shells"};
constexpr std::array kSchemes{"Loop", "Square root of 3", "Midpoints"};

const char* button_name(PrepareTool tool) {
  if (tool == PrepareTool::kSubdivide) return "Subdivide###prepare";
  if (tool == PrepareTool::kTurnShells) return "Turn Inner Shells###prepare";
  return tool == PrepareTool::kSmooth ? "Smooth###prepare" : "Simplify###prepare";
}

}  // namespace

std::string prepared_text(std::span<const PieceRow> pieces, const PieceMap& looks) {
  if (chosen_pieces(looks) == 0) return "All pieces";
  return pieces.size() == 1 ? pieces[0].name : std::to_string(pieces.size()) + " chosen pieces";
}

std::string forecast_text(std::span<const PieceRow> pieces, const Preparation& preparation, FileUnit unit) {
  const FaceForecast faces = forecast(pieces, preparation);
  const std::string now = count_text(faces.before, "face");
  if (preparation.tool == PrepareTool::kTurnShells)
    return "Closed parts that lie in others and face the same way become cavities.";
  const std::string become = now + (faces.before == 1 ? " becomes " : " become ");
  if (!faces.after) return become + "as few as stay within " + length_label(preparation.error, unit) + ".";
  if (*faces.after == faces.before) return now + (faces.before == 1 ? " moves." : " move.");
  return become + "about " + grouped(*faces.after) + ".";
}

Preparation with_numbers(const Preparation& preparation, std::span<const PieceRow> pieces,
                         const World& world) {
  Preparation p = preparation;
  size_t faces = 0;
  for (const PieceRow& row : pieces) faces += row.faces;
  if (p.faces == 0) p.faces = std::max<size_t>(1, faces / 2);
  if (!(p.error > 0)) p.error = kUsualError * world.loaded_bounds().diagonal();
  return p;
}

void PreparePanel::draw_times(Preparation& preparation, const char* meaning, size_t most) {
  size_t times = std::min(preparation.times, most);
  if (fields_.count("Times", times, meaning, 1, most)) preparation.times = times;
}

void PreparePanel::draw_numbers(Preparation& preparation, const Preparation& shown, const World& world,
                                FileUnit unit) {
  switch (shown.tool) {
    case PrepareTool::kSimplifyToFaces: {
      size_t faces = shown.faces;
      if (fields_.count("Faces", faces, "How many faces are left, of all these pieces together.", 1,
                        kMostTyped))
        preparation.faces = faces;
      break;
    }
    case PrepareTool::kSimplifyToError: {
      double error = shown.error;
      const LengthUnit shown_unit = label_unit(kUsualError * world.loaded_bounds().diagonal(), unit);
      const char* meaning = "How far the new surface and the old one may be from each other.";
      if (length_field(fields_, "Error", error, shown_unit, meaning, "", kPositive))
        preparation.error = error;
      break;
    }
    case PrepareTool::kSubdivide:
      marked_choice_row(
          "Scheme", "##scheme", preparation.scheme, kSchemes, "scheme",
          "Loop and the square root of 3 round the surface; midpoints leave it as it is. A face becomes four "
          "or three.");
      draw_times(preparation, "How often every face is divided.", kMostSubdivisions);
      break;
    case PrepareTool::kSmooth:
      draw_times(preparation, "How often vertices move half the way to the middle of their neighbours.",
                 kMostSmoothing);
      break;
    case PrepareTool::kTurnShells:
      break;
  }
}

bool PreparePanel::draw(const World& world, const ViewState& view, Preparation& preparation,
                        const LivePreview& preview, bool& previewed) {
  const std::vector<PieceRow> pieces = pieces_to_prepare(world, view.look.pieces);
  if (pieces.empty()) {
    ImGui::TextDisabled("Nothing is open.");
    return false;
  }
  ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
  draw_fitted_text(prepared_text(pieces, view.look.pieces),
                   "It is for the chosen pieces, or for all of them if none is chosen.");
  ImGui::PopStyleColor();
  if (begin_properties("preparation")) {
    const char* meaning =
        "What is done to the mesh. Boundaries, edges of three faces or more and edges between materials "
        "stay.";
    if (marked_choice_row("Tool", "##preparation", preparation.tool, kTools, "preparation", meaning))
      preparation.times = 1;
    draw_numbers(preparation, with_numbers(preparation, pieces, world), world, view.frame.unit);
    end_properties();
  }
  const Preparation wanted = with_numbers(preparation, pieces, world);
  draw_preview(preview, why_no_preview(world, pieces, wanted), view.frame.unit, previewed);
  ImGui::TextWrapped("%s", forecast_text(pieces, wanted, view.frame.unit).c_str());
  const bool pressed = row_button(button_name(wanted.tool), 1, why_no_preparation(pieces, wanted),
                                  "Makes a new mesh of each piece. One undo takes it back.");
  mark_last_item("prepare");
  return pressed;
}

}  // namespace kerf
