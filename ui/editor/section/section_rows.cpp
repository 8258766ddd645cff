#include "ui/editor/section/section_rows.h"

#include <imgui.h>

#include "ui/editor/section/section_edits.h"
#include "ui/window/landmarks.h"
#include "ui/window/property.h"

namespace kerf {

namespace {

bool button(const char* name, const char* landmark, const char* meaning, bool first = false) {
  if (!first) ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
  const bool clicked = ImGui::Button(name);
  mark_last_item(landmark);
  tooltip(meaning);
  return clicked;
}

void draw_turns(ViewState& view) {
  property("Turn");
  if (button("X", "section X", "Across the X axis.", true)) turn_section_across(view, 0);
  if (button("Y", "section Y", "Across the Y axis.")) turn_section_across(view, 1);
  if (button("Z", "section Z", "Across the Z axis.")) turn_section_across(view, 2);
  if (button("View", "section view", "Parallel to the picture.")) turn_section_to_view(view);
  if (button("Flip", "section flip", "Shows the other side.")) flip_section(view);
}

void draw_text(ViewState& view, Message& message) {
  property("As text");
  if (button("Copy", "section copy", "To the clipboard, as kerf render --section takes it.", true))
    copy_section(view, message);
  if (button("Paste", "section paste", "From the clipboard.")) paste_section(view, message);
}

}  // namespace

void SectionRows::draw(ViewState& view, Message& message) {
  if (shown_section(view.look) == nullptr || !begin_properties("section plane")) return;
  SectionPlane plane = *view.look.section;
  bool typed = fields_.vector("Section", plane.point, "%.5g",
                              "X, Y and Z of the point that the plane goes through and turns about.");
  typed |= fields_.vector("Normal", plane.normal, "%.4g",
                          "The direction that the plane faces, of any length. What lies on this side is not "
                          "drawn.");
  if (typed && plane.normal != Vec3(0)) {
    view.look.section = SectionPlane::facing(plane.point, plane.normal);
    view.picture_old = true;
  }
  draw_turns(view);
  draw_text(view, message);
  end_properties();
}

}  // namespace kerf
