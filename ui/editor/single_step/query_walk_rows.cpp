#include "ui/editor/single_step/query_walk_rows.h"

#include <imgui.h>

#include "ui/render/passes/stage_pass.h"
#include "ui/window/landmarks.h"
#include "ui/window/number_format.h"
#include "ui/window/number_text.h"
#include "ui/window/property.h"
#include "ui/window/theme.h"

namespace kerf {

namespace {

using Found = TouchedWalk::Outcome;
using Kind = StageMarks::Kind;

void visited_row(StageLog& stages) {
  const QueryWalk& query = stages.query();
  property("Tested");
  int visited = static_cast<int>(query.visited());
  const std::string shown =
      format_of_text(grouped(query.visited()) + " of " + grouped(query.size()) + " boxes");
  if (ImGui::SliderInt("##visited", &visited, 1, static_cast<int>(query.size()), shown.c_str(),
                       ImGuiSliderFlags_AlwaysClamp))
    stages.visit(static_cast<size_t>(visited));
  mark_last_item("query slider");
  tooltip("The boxes in the order in which the query tested them; the keys [ and ] go box by box.");
}

void drawn_row(StageLog& stages) {
  property("Last query");
  bool drawn = stages.query().drawn;
  if (ImGui::Checkbox("shown", &drawn)) stages.draw_query(drawn);
  mark_last_item("query shown");
  tooltip("Draws the boxes that the last query of the tree tested, coloured by what became of them.");
}

// A number beside the colour of its boxes.
void count_row(const char* name, const QueryWalk& query, Found outcome, Kind kind, const char* meaning) {
  property(name);
  const uint32_t hex = colour_of(kind);
  const float side = 0.7f * ImGui::GetFontSize();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float top = at.y + 0.5f * (ImGui::GetFrameHeight() - side);
  ImGui::GetWindowDrawList()->AddRectFilled({at.x, top}, {at.x + side, top + side},
                                            IM_COL32(hex >> 16 & 0xffu, hex >> 8 & 0xffu, hex & 0xffu, 255),
                                            2);
  ImGui::SetCursorScreenPos({at.x + 1.5f * side, at.y});
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(grouped(query.count(outcome)).c_str());
  tooltip(meaning);
}

}  // namespace

void draw_query_walk(StageLog& stages) {
  const QueryWalk& query = stages.query();
  ImGui::Separator();
  if (!begin_properties("query")) return;
  drawn_row(stages);
  if (query.empty()) {
    end_properties();
    return;
  }
  visited_row(stages);
  count_row("Entered", query, Found::kEntered, Kind::kEntered, "Boxes that may meet the beam.");
  count_row("Culled", query, Found::kCulled, Kind::kCulled,
            "Boxes outside the beam, with all that is in them.");
  count_row("Missed", query, Found::kMissed, Kind::kMissed,
            "Faces that were tested and that the beam misses.");
  count_row("Hit", query, Found::kTouched, Kind::kTouched, "Faces that were tested and that the beam hits.");
  end_properties();
  ImGui::TextWrapped("%s", query.words().c_str());
  mark_last_item("query words");
}

}  // namespace kerf
