#include "ui/editor/prepare/preview_rows.h"

#include <imgui.h>

#include "ui/editor/shared/files/file_frames.h"
#include "ui/editor/shared/panels/panel_rows.h"
#include "ui/window/landmarks.h"
#include "ui/window/number_text.h"
#include "ui/window/property.h"

namespace kerf {

namespace {

struct PreviewRow {
  const char* name;
  std::string before, after;
  const char* meaning;
};

void draw_row(const PreviewRow& row) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(row.name);
  tooltip(row.meaning);
  for (const std::string& text : {row.before, row.after}) {
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(text.c_str());
  }
}

std::string angle_text(double degrees) { return text_of("%.3g degrees", degrees); }

void draw_statistics(const Preview& preview, FileUnit unit) {
  if (!ImGui::BeginTable("preview", 3, ImGuiTableFlags_SizingStretchProp)) return;
  for (const char* heading : {"", "Before", "After"}) ImGui::TableSetupColumn(heading);
  ImGui::TableNextRow();
  for (const char* heading : {"", "Before", "After"}) {
    ImGui::TableNextColumn();
    ImGui::TextDisabled("%s", heading);
  }
  const Preview::Statistics &before = preview.before, &after = preview.after;
  draw_row({"Faces", grouped(before.faces), grouped(after.faces), "How many faces the pieces have."});
  draw_row({"Least angle", angle_text(before.least_angle), angle_text(after.least_angle),
            "The smallest angle of all these faces."});
  draw_row({"Distance", "", preview.distance > 0 ? length_label(preview.distance, unit) : "none",
            "How far the old and the new surface are from each other at most, measured both ways."});
  ImGui::EndTable();
  mark_last_item("preview figures");
}

}  // namespace

void draw_preview(const LivePreview& preview, const char* why_not, FileUnit unit, bool& previewed) {
  ImGui::Checkbox("Preview", &previewed);
  mark_last_item("preview");
  tooltip("Draws the edges that the new mesh would have over the surface as it is. Nothing is changed yet.");
  if (!previewed || why_not != nullptr) {
    if (previewed) secondary_text(why_not);
    return;
  }
  if (preview.busy()) {
    ImGui::SameLine();
    ImGui::TextDisabled("%.0f %%", 100 * preview.fraction());
  }
  if (const Preview* shown = preview.shown()) draw_statistics(*shown, unit);
  if (!preview.fault().empty()) secondary_text(preview.fault());
}

}  // namespace kerf
