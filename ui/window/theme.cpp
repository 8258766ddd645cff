#include "ui/window/theme.h"

#include <cmath>
#include <filesystem>

#include "core/base/assert.h"

namespace kerf {

namespace {

// Humanist sans faces as installed by Debian's packages, the best first.
constexpr std::array kFonts{
    "/usr/share/fonts/truetype/roboto/unhinted/RobotoTTF/Roboto-Regular.ttf",
    "/usr/share/fonts/truetype/inter/Inter-Regular.ttf",
    "/usr/share/fonts/truetype/open-sans/OpenSans-Regular.ttf",
    "/usr/share/fonts/truetype/noto/NotoSans-Regular.ttf",
    "/usr/share/fonts/truetype/lato/Lato-Regular.ttf",
    "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
};
constexpr float kTextPixels = 15.5f;
constexpr float kOwnTextPixels = 13;  // design size of ImGui's own font
constexpr float kLarge = 2;           // size of the large font, in that of the text
constexpr float kSharpPixels = 36;    // from this size on, glyphs look alike at all fractions of a pixel

// Latin, Greek, Cyrillic, punctuation, currencies and letterlike signs: the text font draws names of files
// and pieces. The large font draws only texts of Kerf itself.
constexpr ImWchar kRanges[] = {0x20,   0x24f,  0x370,  0x52f,  0x1e00, 0x1eff, 0x2000,
                               0x206f, 0x20a0, 0x20bf, 0x2100, 0x214f, 0};

// The atlas of both fonts has 1024x1024 pixels at scale 1 and 4096x4096 at scale 8.
ImFont* add_font(ImFontAtlas& fonts, const char* file, float pixels, const ImWchar* ranges) {
  ImFontConfig config;
  if (pixels > kSharpPixels) config.OversampleH = 1;
  return fonts.AddFontFromFileTTF(file, pixels, &config, ranges);
}

void load_font(float scale, bool own_font) {
  ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
  fonts.Clear();
  std::error_code ignored;
  for (const char* file : kFonts) {
    if (own_font || !std::filesystem::exists(file, ignored)) continue;
    if (add_font(fonts, file, std::round(kTextPixels * scale), kRanges) == nullptr) continue;
    add_font(fonts, file, std::round(kLarge * kTextPixels * scale), nullptr);
    return;
  }
  ImFontConfig own;
  for (const float size : {kOwnTextPixels, kLarge * kOwnTextPixels}) {
    own.SizePixels = std::round(size * scale);
    fonts.AddFontDefault(&own);
  }
}

struct Colours {
  ImU32 panel, field, raised, high, border, text, secondary;
};
constexpr Colours kDark{IM_COL32(0x1b, 0x1f, 0x26, 255), IM_COL32(0x26, 0x2c, 0x36, 255),
                        IM_COL32(0x31, 0x39, 0x46, 255), IM_COL32(0x3d, 0x47, 0x57, 255),
                        IM_COL32(0x5d, 0x6b, 0x7e, 255), IM_COL32(0xe6, 0xe9, 0xee, 255),
                        IM_COL32(0x9a, 0xa6, 0xb6, 255)};
constexpr Colours kLight{IM_COL32(0xf1, 0xf3, 0xf6, 255), IM_COL32(0xff, 0xff, 0xff, 255),
                         IM_COL32(0xe2, 0xe7, 0xee, 255), IM_COL32(0xcf, 0xd7, 0xe2, 255),
                         IM_COL32(0x7b, 0x87, 0x96, 255), IM_COL32(0x1a, 0x1f, 0x26, 255),
                         IM_COL32(0x4d, 0x58, 0x66, 255)};

// At least 4.5:1 on the panel, to be usable for text.
ImU32 accent_of(const GuiLook& look) {
  const bool blue = look.palette == BoxPalette::kOrangeAndBlue;
  if (look.theme == Theme::kLight)
    return blue ? IM_COL32(0x0b, 0x5c, 0xb8, 255) : IM_COL32(0xa8, 0x50, 0x00, 255);
  return blue ? IM_COL32(0x4a, 0xa3, 0xff, 255) : IM_COL32(0xff, 0x9d, 0x2e, 255);
}

ImVec4 faded(ImU32 colour, float opacity) {
  ImVec4 c = ImGui::ColorConvertU32ToFloat4(colour);
  c.w *= opacity;
  return c;
}

void set_colours(ImGuiStyle& style, const GuiLook& look) {
  const Colours& c = look.theme == Theme::kLight ? kLight : kDark;
  if (look.theme == Theme::kLight) {
    ImGui::StyleColorsLight(&style);
  } else {
    ImGui::StyleColorsDark(&style);
  }
  const ImU32 accent = accent_of(look);
  const auto set = [&](ImGuiCol which, ImU32 colour, float opacity = 1) {
    style.Colors[which] = faded(colour, opacity);
  };
  set(ImGuiCol_Text, c.text);
  set(ImGuiCol_TextDisabled, c.secondary);
  for (const ImGuiCol i : {ImGuiCol_WindowBg, ImGuiCol_MenuBarBg, ImGuiCol_ScrollbarBg, ImGuiCol_TitleBg,
                           ImGuiCol_TitleBgActive})
    set(i, c.panel);
  set(ImGuiCol_PopupBg, c.panel);
  set(ImGuiCol_Border, c.border);
  for (const ImGuiCol i : {ImGuiCol_FrameBg, ImGuiCol_Button, ImGuiCol_TableHeaderBg}) set(i, c.field);
  set(ImGuiCol_Header, look.theme == Theme::kLight ? c.raised : c.field);
  for (const ImGuiCol i : {ImGuiCol_FrameBgHovered, ImGuiCol_ButtonHovered, ImGuiCol_HeaderHovered})
    set(i, c.raised);
  for (const ImGuiCol i :
       {ImGuiCol_FrameBgActive, ImGuiCol_ButtonActive, ImGuiCol_HeaderActive, ImGuiCol_ScrollbarGrab})
    set(i, c.high);
  set(ImGuiCol_TableRowBgAlt, c.text, 0.03f);
  set(ImGuiCol_CheckMark, c.text);
  set(ImGuiCol_SliderGrab, c.secondary, 0.55f);
  set(ImGuiCol_SliderGrabActive, c.text, 0.6f);
  set(ImGuiCol_Separator, c.border, 0.35f);
  set(ImGuiCol_SeparatorHovered, accent, 0.6f);
  set(ImGuiCol_SeparatorActive, accent);
  set(ImGuiCol_ModalWindowDimBg, IM_COL32(0, 0, 0, 255), 0.45f);
  set(ImGuiCol_NavHighlight, accent);
  set(ImGuiCol_PlotHistogram, accent, 0.5f);  // of progress bars, under their text
  set(ImGuiCol_TextSelectedBg, accent, 0.35f);
}

}  // namespace

void apply_theme(const GuiLook& look) {
  KERF_ASSERT(look.scale > 0);
  ImGuiStyle& style = ImGui::GetStyle();
  style = ImGuiStyle();
  set_colours(style, look);
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
  style.ScaleAllSizes(look.scale);
  load_font(look.scale, look.own_font);
}

}  // namespace kerf
