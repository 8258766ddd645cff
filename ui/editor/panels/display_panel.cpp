#include "ui/editor/panels/display_panel.h"

#include <imgui.h>

#include <cmath>

#include "ui/editor/view/shortcut_text.h"
#include "ui/window/number_format.h"
#include "ui/window/property.h"

namespace kerf {

namespace {

// The size changes when the slider is let go, for the slider itself changes with it.
void scale_row(Settings& settings, double& wanted) {
  property("Text size");
  constexpr double kLow = Settings::kLeastScale * 100, kHigh = Settings::kMostScale * 100;
  double percent = wanted > 0 ? 100 * wanted : 100 * settings.ui_scale;
  if (ImGui::SliderScalar("##scale", ImGuiDataType_Double, &percent, &kLow, &kHigh,
                          RealFormat("%.0f %%").c_str(), ImGuiSliderFlags_AlwaysClamp)) {
    wanted = std::round(percent / 5) * 0.05;
  }
  if (ImGui::IsItemDeactivated() && wanted > 0) {
    settings.ui_scale = wanted;
    wanted = 0;
  }
  tooltip("Of the panels and menus, on top of what the display asks for.");
}

}  // namespace

void DisplayPanel::draw(Settings& settings, const ViewState& view) {
  if (!begin_properties("display")) return;
  property("Theme");
  int theme = settings.theme == Theme::kLight ? 1 : 0;
  if (ImGui::Combo("##theme", &theme, "Dark\0Light\0"))
    settings.theme = theme == 1 ? Theme::kLight : Theme::kDark;
  tooltip(with_shortcut(view, "Colours of the panels; the picture stays as it is.", "Light theme").c_str());
  scale_row(settings, wanted_scale_);
  end_properties();
}

}  // namespace kerf
