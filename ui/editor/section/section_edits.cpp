#include "ui/editor/section/section_edits.h"

#include <imgui.h>

#include "core/base/assert.h"

namespace kerf {

namespace {

void show(ViewState& view, const SectionPlane& plane) {
  view.look.section = plane;
  view.look.show.section = true;
  view.picture_old = true;
}

}  // namespace

void place_section(ViewState& view, const World& world) {
  if (!view.look.show.section || view.look.section || world.ids().empty()) return;
  show(view, section_through(world.bounds(), -view.seen_first().forward));
}

void flip_section(ViewState& view) {
  KERF_ASSERT(view.look.section);
  show(view, {view.look.section->point, -view.look.section->normal});
}

void turn_section_across(ViewState& view, int axis) {
  KERF_ASSERT(view.look.section && axis >= 0 && axis < 3);
  Vec3 normal(0);
  normal[axis] = view.seen_first().forward[axis] > 0 ? -1 : 1;
  show(view, {view.look.section->point, normal});
}

void turn_section_to_view(ViewState& view) {
  KERF_ASSERT(view.look.section);
  show(view, {view.look.section->point, -view.seen_first().forward});
}

void copy_section(const ViewState& view, Message& message) {
  KERF_ASSERT(view.look.section);
  ImGui::SetClipboardText(section_text(*view.look.section).c_str());
  message.say("The section plane is in the clipboard as text, as kerf render --section takes it");
}

void paste_section(ViewState& view, Message& message) {
  const char* text = ImGui::GetClipboardText();
  const Result<SectionPlane> plane = parse_section(text != nullptr ? text : "");
  if (!plane) return message.say("The clipboard holds no section plane: " + plane.error().message, true);
  show(view, *plane);
  message.say("");
}

}  // namespace kerf
