#include "ui/editor/files/frame_question.h"

#include <imgui.h>

#include "ui/editor/shared/files/file_frames.h"
#include "ui/window/frame_combos.h"
#include "ui/window/landmarks.h"
#include "ui/window/property.h"
#include "ui/window/theme.h"

namespace kerf {

namespace {

constexpr float kUnderAxes = 9.6f;  // sizes of the text
constexpr ImGuiWindowFlags kBar = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                  ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize |
                                  ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav;

// The unit for which a unit is mistaken most often.
FileUnit other_unit(FileUnit unit) {
  switch (unit) {
    case FileUnit::kMillimetre:
      return FileUnit::kInch;
    case FileUnit::kCentimetre:
      return FileUnit::kMetre;
    case FileUnit::kMetre:
    case FileUnit::kInch:
      break;
  }
  return FileUnit::kMillimetre;
}

const char* plural(FileUnit unit) {
  switch (unit) {
    case FileUnit::kMillimetre:
      return "millimetres";
    case FileUnit::kCentimetre:
      return "centimetres";
    case FileUnit::kMetre:
      return "metres";
    case FileUnit::kInch:
      break;
  }
  return "inches";
}

void draw_sizes(const Vec3& size, FileUnit unit) {
  ImGui::TextUnformatted(extents_label(size, unit).c_str());
  mark_last_item("frame size");
  const FileUnit other = other_unit(unit);
  ImGui::TextDisabled("or, in %s, %s", plural(other), extents_label(size, other).c_str());
}

void draw_rows(const Vec3& size, ViewState& view, Settings& settings) {
  const std::string kind = view.frame_asked_for;
  const float em = ImGui::GetFontSize();
  FileFrame frame = view.frame;
  ImGui::PushStyleColor(ImGuiCol_Text, colours::secondary());
  ImGui::TextUnformatted("Guessed from the kind and the size of the file:");
  ImGui::PopStyleColor();
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Up");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(4 * em);
  bool changed = up_axis_combo(frame.up);
  ImGui::SameLine();
  ImGui::TextUnformatted("Unit");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(4.5f * em);
  changed = unit_combo(frame.unit) || changed;
  if (changed) show_in_frame(view, frame);
  draw_sizes(size, view.frame.unit);
  if (ImGui::Button(("For all ." + kind + " files").c_str())) {
    settings.frames[kind] = view.frame;
    view.frame_asked_for.clear();
  }
  mark_last_item("frame for all");
  tooltip("Files of this kind are shown so from now on. The File panel changes it.");
  ImGui::SameLine();
  if (ImGui::Button("For this file")) {
    settings.frames[kind].reset();
    view.frame_asked_for.clear();
  }
  mark_last_item("frame for this");
  tooltip("Other files of this kind are shown as their size suggests. The File panel changes it.");
}

}  // namespace

void draw_frame_question(const Vec3& size, ViewState& view, Settings& settings, bool cut_once) {
  if (cut_once) view.frame_asked_for.clear();
  if (view.frame_asked_for.empty() || view.layout.split()) return;
  const float em = ImGui::GetFontSize();
  const Area& area = view.layout.viewport;
  const auto right = static_cast<float>(area.at.x + area.size.x), top = static_cast<float>(area.at.y);
  ImGui::SetNextWindowPos({right - 0.8f * em, top + kUnderAxes * em}, ImGuiCond_Always, {1, 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 3);
  if (ImGui::Begin("##frame", nullptr, kBar)) draw_rows(size, view, settings);
  ImGui::End();
  ImGui::PopStyleVar();
}

}  // namespace kerf
