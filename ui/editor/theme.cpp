#include "ui/editor/theme.h"

#include <array>
#include <cmath>
#include <filesystem>

namespace kerf {

namespace {

// Humanist sans faces as Debian's packages install them, the best first.
constexpr std::array kFonts{
    "/usr/share/fonts/truetype/roboto/unhinted/RobotoTTF/Roboto-Regular.ttf",
    "/usr/share/fonts/truetype/inter/Inter-Regular.ttf",
    "/usr/share/fonts/truetype/open-sans/OpenSans-Regular.ttf",
    "/usr/share/fonts/truetype/noto/NotoSans-Regular.ttf",
    "/usr/share/fonts/truetype/lato/Lato-Regular.ttf",
    "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
};
constexpr float kTextPixels = 15.5f;

void load_font(float scale) {
  ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
  std::error_code ignored;
  for (const char* file : kFonts) {
    if (!std::filesystem::exists(file, ignored)) continue;
    if (fonts.AddFontFromFileTTF(file, std::round(kTextPixels * scale)) != nullptr) return;
  }
  fonts.AddFontDefault();
}

ImVec4 faded(ImU32 colour, float opacity) {
  ImVec4 c = ImGui::ColorConvertU32ToFloat4(colour);
  c.w *= opacity;
  return c;
}

void set_colours(ImGuiStyle& style) {
  using namespace colours;
  ImGui::StyleColorsDark(&style);
  const ImVec4 raised = ImGui::ColorConvertU32ToFloat4(IM_COL32(0x31, 0x39, 0x46, 255));
  const ImVec4 high = ImGui::ColorConvertU32ToFloat4(IM_COL32(0x3d, 0x47, 0x57, 255));
  const auto set = [&](ImGuiCol which, const ImVec4& c) { style.Colors[which] = c; };
  set(ImGuiCol_Text, faded(kText, 1));
  set(ImGuiCol_TextDisabled, faded(kSecondary, 1));
  set(ImGuiCol_WindowBg, faded(kPanel, 1));
  set(ImGuiCol_PopupBg, faded(kPanel, 0.98f));
  set(ImGuiCol_MenuBarBg, faded(kPanel, 1));
  set(ImGuiCol_Border, faded(kBorder, 1));
  for (const ImGuiCol c : {ImGuiCol_FrameBg, ImGuiCol_Button, ImGuiCol_Header}) set(c, faded(kField, 1));
  for (const ImGuiCol c : {ImGuiCol_FrameBgHovered, ImGuiCol_ButtonHovered, ImGuiCol_HeaderHovered})
    set(c, raised);
  for (const ImGuiCol c : {ImGuiCol_FrameBgActive, ImGuiCol_ButtonActive, ImGuiCol_HeaderActive})
    set(c, high);
  set(ImGuiCol_CheckMark, faded(kText, 1));
  set(ImGuiCol_SliderGrab, faded(kSecondary, 0.55f));
  set(ImGuiCol_SliderGrabActive, faded(kText, 0.6f));
  set(ImGuiCol_Separator, faded(kBorder, 0.35f));
  set(ImGuiCol_ScrollbarBg, faded(kPanel, 1));
  set(ImGuiCol_ScrollbarGrab, high);
  set(ImGuiCol_TitleBg, faded(kPanel, 1));
  set(ImGuiCol_TitleBgActive, faded(kPanel, 1));
  set(ImGuiCol_NavHighlight, faded(kAccent, 1));
  set(ImGuiCol_TextSelectedBg, faded(kAccent, 0.35f));
}

}  // namespace

void apply_theme(float scale) {
  ImGuiStyle& style = ImGui::GetStyle();
  style = ImGuiStyle();
  set_colours(style);
  style.WindowRounding = 0;
  style.FrameRounding = style.PopupRounding = style.GrabRounding = style.ScrollbarRounding = 3;
  style.FrameBorderSize = 1;
  style.WindowBorderSize = 0;
  style.PopupBorderSize = 1;
  style.WindowPadding = {14, 12};
  style.FramePadding = {8, 5};
  style.ItemSpacing = {8, 7};
  style.CellPadding = {4, 4};
  style.GrabMinSize = 12;
  style.ScrollbarSize = 12;
  style.ScaleAllSizes(scale);
  load_font(scale);
}

}  // namespace kerf
