#include "ui/editor/panels/resolution_panel.h"

#include <imgui.h>

#include <cmath>
#include <cstdio>

#include "ui/editor/changes/world_changes.h"
#include "ui/editor/view/file_frames.h"
#include "ui/editor/view/shortcut_text.h"
#include "ui/window/number_format.h"
#include "ui/window/number_text.h"
#include "ui/window/property.h"

namespace kerf {

namespace {

bool rule_row(ResolutionControls& to) {
  property("Split to");
  int rule = static_cast<int>(to.rule);
  const bool changed = ImGui::Combo("##rule", &rule, "Edge length\0Tolerance\0Depth\0");
  if (changed) to.rule = static_cast<Resolution::Rule>(rule);
  tooltip(
      "What says when faces under the beam are small enough: the length of their edges, how far what is "
      "removed may overshoot the beam, or how often they were split.");
  return changed;
}

bool scheme_row(ResolutionControls& to) {
  property("Scheme");
  int scheme = static_cast<int>(to.scheme);
  const bool changed = ImGui::Combo("##scheme", &scheme, "One to four\0Longest edge\0");
  if (changed) to.scheme = static_cast<Scheme>(scheme);
  tooltip(
      "How a face is split: in four, as in the paper, or in two at its longest edge, which makes far fewer "
      "faces of thin ones.");
  return changed;
}

bool rim_row(ResolutionControls& to) {
  property("Rim");
  int rim = static_cast<int>(to.rim);
  const bool changed = ImGui::Combo("##rim", &rim, "Faces\0Smooth\0");
  if (changed) to.rim = static_cast<Rim>(rim);
  tooltip(
      "Faces: all that the beam touches goes, so the rim is a saw. Smooth: when the stroke ends, faces "
      "across "
      "the boundary of the beam are cut along it.");
  return changed;
}

bool reset_item(double& value, double standard) {
  if (!ImGui::BeginPopupContextItem()) return false;
  const bool reset = ImGui::MenuItem("Reset to default");
  if (reset) value = standard;
  ImGui::EndPopup();
  return reset;
}

// The radius of the beam, and the unit that it is shown in.
struct ShownRadius {
  double length;
  FileUnit unit;
};

// A share of the radius, from twice the radius to a 32nd of it; finer to the right, as with depth.
bool fraction_row(const char* name, double& fraction, double standard, const ShownRadius& radius,
                  const char* meaning) {
  property(name);
  double halvings = -std::log2(fraction);
  const double low = -std::log2(ResolutionControls::kMostFraction),
               high = -std::log2(ResolutionControls::kLeastFraction);
  const std::string text = format_of_text(length_label(radius.length * fraction, radius.unit));
  const double before = fraction;
  if (ImGui::SliderScalar("##fraction", ImGuiDataType_Double, &halvings, &low, &high, text.c_str(),
                          ImGuiSliderFlags_NoInput)) {
    fraction = std::exp2(-std::round(4 * halvings) / 4);
  }
  tooltip(meaning);
  const bool reset = reset_item(fraction, standard);
  return reset || fraction != before;
}

bool edge_row(ResolutionControls& to, const ShownRadius& radius) {
  return fraction_row(
      "Edge", to.edge_fraction, ResolutionControls().edge_fraction, radius,
      "Longest edge under the beam, from twice the radius to a 32nd of it. Finer to the right. "
      "Right click for the default.");
}

bool tolerance_row(ResolutionControls& to, const ShownRadius& radius) {
  return fraction_row(
      "Tolerance", to.tolerance_fraction, ResolutionControls().tolerance_fraction, radius,
      "How far what is removed may overshoot the beam, from twice the radius to a 32nd of it. "
      "Finer to the right. Right click for the default.");
}

bool depth_row(ResolutionControls& to) {
  property("Depth");
  const int before = to.depth;
  const WholeFormat format = to.depth == 0   ? WholeFormat("0: faces go whole")
                             : to.depth == 1 ? WholeFormat("%d split")
                                             : WholeFormat("%d splits");
  ImGui::SliderInt("##depth", &to.depth, 0, ResolutionControls::kLargestDepth, format.c_str(),
                   ImGuiSliderFlags_AlwaysClamp);
  tooltip(
      "How often a face under the beam is split in four. 0 turns refinement off: faces are removed whole, "
      "as in the paper's figure 3.");
  return to.depth != before;
}

void recut_row(const ResolutionParts& on, bool changed) {
  property("Last stroke");
  const char* why_not = why_no_recut(on.document);
  ImGui::BeginDisabled(why_not != nullptr);
  if (ImGui::Button("Cut again", {-1, 0})) on.requests.recut = true;
  ImGui::EndDisabled();
  const std::string meaning = with_shortcut(
      on.view, "Takes the last stroke back and cuts it at this resolution.", "Cut the last stroke again");
  tooltip(why_not != nullptr ? why_not : meaning.c_str());
  property("");
  ImGui::Checkbox("as the slider moves", &on.settings.live_recut);
  tooltip(
      "Moving a slider above, or that of the radius, cuts the last stroke again: the same cut, just with "
      "different parameters.");
  if (changed && on.settings.live_recut && why_not == nullptr) on.requests.recut = true;
}

// Whether anything changed.
bool resolution_rows(ResolutionControls& to, const ShownRadius& radius) {
  bool changed = rule_row(to);
  switch (to.rule) {
    case Resolution::Rule::kTargetEdge:
      changed = edge_row(to, radius) || changed;
      break;
    case Resolution::Rule::kTolerance:
      changed = tolerance_row(to, radius) || changed;
      break;
    case Resolution::Rule::kDepth:
      changed = depth_row(to) || changed;
      break;
  }
  changed = scheme_row(to) || changed;
  return rim_row(to) || changed;
}

void faces_row(size_t faces, const char* meaning) { figure_row("Faces", grouped(faces), meaning); }

std::string smallest_angle_text(double largest_cosine) {
  if (largest_cosine < 0) return "no face is left of them";
  char text[32];
  std::snprintf(text, sizeof text, "%.1f degrees", std::acos(largest_cosine) * 180 / 3.14159265358979);
  return text;
}

void stroke_rows(const std::optional<ShownFigures::Stroke>& stroke, FileUnit unit) {
  const std::string none = "nothing is cut";
  figure_row("Made", stroke ? grouped(stroke->figures.faces_made) : none,
             "Faces that splitting made in the last stroke.");
  figure_row("Least angle", stroke ? smallest_angle_text(stroke->figures.largest_cosine) : none,
             "Smallest angle of all faces that the last stroke made and left.");
  figure_row("Removed", stroke ? area_label(stroke->removed_area, unit) : none,
             "Area that the last stroke has taken away.");
}

void split_rows(const ResolutionParts& on) {
  property("Split view");
  bool shown = on.split.shown;
  if (ImGui::Checkbox((with_shortcut(on.view, "two resolutions", "Split view") + "###split").c_str(), &shown))
    on.show_split(shown);
  tooltip("The last stroke once more beside the picture, at a resolution of its own.");
  if (!on.split.shown) return;
  ImGui::PushID("right half");
  property("Right half");
  ImGui::Dummy({1, ImGui::GetFrameHeight()});
  if (resolution_rows(on.split.resolution, {on.laser.radius, on.view.frame.unit})) on.view.picture_old = true;
  faces_row(on.figures.shown.twin_faces, "Faces of all bodies in the right half.");
  ImGui::PopID();
}

}  // namespace

void draw_resolution_panel(const ResolutionParts& on) {
  if (!begin_properties("resolution")) return;
  const bool changed = resolution_rows(on.laser.resolution, {on.laser.radius, on.view.frame.unit});
  recut_row(on, changed);
  faces_row(on.figures.shown.faces, "Faces of all bodies as they stand.");
  stroke_rows(on.figures.shown.stroke, on.view.frame.unit);
  split_rows(on);
  end_properties();
}

}  // namespace kerf
