#include "ui/editor/shared/picture/badges.h"

#include <imgui.h>

#include <algorithm>

#include "ui/window/fitted_text.h"
#include "ui/window/landmarks.h"
#include "ui/window/theme.h"

namespace kerf {

namespace {

constexpr float kBadgeHeight = 1.8f, kBadgesApart = 0.4f, kBadgeMargin = 0.7f;  // sizes of the text

// A triangle while time passes, two bars while it is stopped, a disc for a mode, in a square of this side.
void draw_badge_sign(Badges::Sign sign, ImVec2 at, float side, ImDrawList& list) {
  if (sign == Badges::Sign::kPlaying)
    return list.AddTriangleFilled(at, {at.x, at.y + side}, {at.x + 0.9f * side, at.y + 0.5f * side},
                                  colours::kPictureText);
  if (sign == Badges::Sign::kMode)
    return list.AddCircleFilled({at.x + 0.5f * side, at.y + 0.5f * side}, 0.42f * side, colours::accent());
  const float bar = 0.3f * side;
  for (const float x : {at.x, at.x + side - bar})
    list.AddRectFilled({x, at.y}, {x + bar, at.y + side}, colours::kPictureText);
}

}  // namespace

void Badges::draw(const ViewState& view, Sign sign, const std::string& text, const char* landmark,
                  float least_ems) {
  const Area& picture = view.layout.first;
  const float em = ImGui::GetFontSize(), side = 0.62f * em, gap = 0.5f * em;
  const float room = static_cast<float>(picture.size.x) - 2 * kBadgeMargin * em - side - gap;
  const std::string fitted = fitted_text(text, room);
  const float width = side + gap + std::max(width_of_text(fitted), std::min(room, least_ems * em));
  const float left = static_cast<float>(picture.at.x + 0.5 * picture.size.x) - 0.5f * width;
  const float top = static_cast<float>(picture.at.y) + em +
                    static_cast<float>(drawn_++) * (kBadgeHeight + kBadgesApart) * em;
  const ImVec2 low{left - kBadgeMargin * em, top - 0.4f * em},
      high{left + width + kBadgeMargin * em, top + 1.4f * em};
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  list.AddRectFilled(low, high, colours::kPictureShade, 3);
  draw_badge_sign(sign, {left, top + 0.5f * (ImGui::GetTextLineHeight() - side)}, side, list);
  list.AddText({left + side + gap, top}, colours::kPictureText, fitted.c_str());
  mark_area(landmark, {{low.x, low.y}, {high.x - low.x, high.y - low.y}});
}

}  // namespace kerf
