#include "ui/editor/shell/tab_bar.h"

#include <imgui.h>

#include <array>
#include <cmath>
#include <string>

#include "ui/window/landmarks.h"
#include "ui/window/property.h"
#include "ui/window/theme.h"

namespace kerf {

namespace {

using Draw = void (*)(ImDrawList& list, ImVec2 middle, float r, ImU32 colour);

// A plate with a slit, and the beam that cuts it.
void draw_cut(ImDrawList& list, ImVec2 m, float r, ImU32 colour) {
  list.AddLine({m.x + 0.9f * r, m.y - r}, {m.x, m.y + 0.25f * r}, colour, 2);
  list.AddLine({m.x - r, m.y + 0.45f * r}, {m.x - 0.25f * r, m.y + 0.45f * r}, colour, 2);
  list.AddLine({m.x + 0.35f * r, m.y + 0.45f * r}, {m.x + r, m.y + 0.45f * r}, colour, 2);
  for (const ImVec2& spark : {ImVec2(-0.5f, 0.95f), ImVec2(0.05f, 1), ImVec2(0.55f, 0.9f)})
    list.AddLine({m.x + 0.03f * r, m.y + 0.55f * r}, {m.x + spark.x * r, m.y + spark.y * r}, colour, 1);
}

void draw_eye(ImDrawList& list, ImVec2 m, float r, ImU32 colour) {
  list.AddBezierQuadratic({m.x - r, m.y}, {m.x, m.y - 1.25f * r}, {m.x + r, m.y}, colour, 1.5f);
  list.AddBezierQuadratic({m.x - r, m.y}, {m.x, m.y + 1.25f * r}, {m.x + r, m.y}, colour, 1.5f);
  list.AddCircleFilled(m, 0.32f * r, colour);
}

// Two crossed double arrows.
void draw_arrows(ImDrawList& list, ImVec2 m, float r, ImU32 colour) {
  for (const ImVec2& way : {ImVec2(1, 0), ImVec2(-1, 0), ImVec2(0, 1), ImVec2(0, -1)}) {
    const ImVec2 tip(m.x + way.x * r, m.y + way.y * r);
    list.AddLine(m, tip, colour, 1.5f);
    for (const float side : {-0.35f, 0.35f})
      list.AddLine(
          tip, {tip.x - 0.35f * r * way.x + side * r * way.y, tip.y - 0.35f * r * way.y + side * r * way.x},
          colour, 1.5f);
  }
}

void draw_thermometer(ImDrawList& list, ImVec2 m, float r, ImU32 colour) {
  const float half = 0.27f * r;
  list.AddRect({m.x - half, m.y - r}, {m.x + half, m.y + 0.45f * r}, colour, half, 0, 1.5f);
  list.AddCircleFilled({m.x, m.y + 0.6f * r}, 0.44f * r, colour);
  list.AddLine({m.x, m.y - 0.35f * r}, {m.x, m.y + 0.6f * r}, colour, 2);
  for (const float y : {-0.7f, -0.3f, 0.1f})
    list.AddLine({m.x + 0.5f * r, m.y + y * r}, {m.x + 0.85f * r, m.y + y * r}, colour, 1);
}

// A triangle and the smaller ones into which it is divided.
void draw_mesh(ImDrawList& list, ImVec2 m, float r, ImU32 colour) {
  const ImVec2 a(m.x - r, m.y + 0.8f * r), b(m.x + r, m.y + 0.8f * r), c(m.x, m.y - 0.9f * r);
  const auto middle = [](ImVec2 p, ImVec2 q) { return ImVec2(0.5f * (p.x + q.x), 0.5f * (p.y + q.y)); };
  list.AddTriangle(a, b, c, colour, 1.5f);
  list.AddTriangle(middle(a, b), middle(b, c), middle(c, a), colour, 1.5f);
}

struct TabLook {
  Tab tab;
  const char* name;
  const char* tip;
  const char* shortcut;
  Draw draw;
};
constexpr std::array kTabs{
    TabLook{Tab::kCut, "Cut", "The laser, the resolution, the pieces and the history.", "Alt+1", draw_cut},
    TabLook{Tab::kLook, "Look", "The view, the light, the tree, the graph and the figures.", "Alt+2",
            draw_eye},
    TabLook{Tab::kMove, "Move", "Bodies that fall, and time.", "Alt+3", draw_arrows},
    TabLook{Tab::kHeat, "Heat", "The material, and how hot it gets.", "Alt+4", draw_thermometer},
    TabLook{Tab::kPrepare, "Prepare", "Repairs, subdivides and simplifies; what the file holds.", "Alt+5",
            draw_mesh}};

void draw_tab(const TabLook& look, ImVec2 size, PanelPlaces& places) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  if (ImGui::InvisibleButton(look.name, size)) places.show_tab(look.tab);
  mark_last_item((std::string("tab ") + look.name).c_str());
  const bool over = ImGui::IsItemHovered(), chosen = places.tab() == look.tab;
  tooltip((std::string(look.tip) + " " + look.shortcut).c_str());
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float em = ImGui::GetFontSize(), middle = std::round(at.x + 0.5f * size.x);
  const ImU32 colour = chosen ? colours::accent() : over ? colours::text() : colours::secondary();
  if (chosen) {
    list.AddRectFilled(at, {at.x + size.x, at.y + size.y}, ImGui::GetColorU32(ImGuiCol_FrameBg));
    list.AddRectFilled({at.x, at.y + size.y - 2}, {at.x + size.x, at.y + size.y}, colours::accent());
  }
  look.draw(list, {middle, at.y + 0.8f * em}, 0.5f * em, colour);
  const float text = ImGui::CalcTextSize(look.name).x;
  list.AddText({std::round(middle - 0.5f * text), at.y + 1.45f * em}, chosen ? colours::text() : colour,
               look.name);
}

}  // namespace

float tab_bar_height() { return std::round(2.75f * ImGui::GetFontSize()); }

void draw_tab_bar(PanelPlaces& places) {
  const ImVec2 all = ImGui::GetWindowSize(), at = ImGui::GetWindowPos();
  for (size_t i = 0; i < kTabs.size(); ++i) {
    const auto edge = [&](size_t k) {
      return std::round(at.x + all.x * static_cast<float>(k) / static_cast<float>(kTabs.size()));
    };
    ImGui::SetCursorScreenPos({edge(i), at.y});
    draw_tab(kTabs.at(i), {edge(i + 1) - edge(i), all.y}, places);
  }
}

std::vector<UserAction> tab_actions(PanelPlaces& places) {
  std::vector<UserAction> actions;
  for (const TabLook& look : kTabs) {
    actions.push_back({.name = std::string("Tab: ") + look.name, .shortcut = look.shortcut, .tip = look.tip});
    actions.back().run = [&places, tab = look.tab] { places.show_tab(tab); };
    actions.back().checked = [&places, tab = look.tab] { return places.tab() == tab; };
  }
  return actions;
}

}  // namespace kerf
