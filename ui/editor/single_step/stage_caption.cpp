#include "ui/editor/single_step/stage_caption.h"

#include <imgui.h>

#include <algorithm>

#include "core/base/assert.h"
#include "ui/window/landmarks.h"
#include "ui/window/number_text.h"
#include "ui/window/theme.h"

namespace kerf {

namespace {
constexpr float kMostEms = 44;
}

void draw_stage_caption(const StageLog& stages, const Area& picture) {
  if (stages.done() == 0) return;
  KERF_ASSERT(stages.done() <= stages.told().size());
  const std::string text = "Stage " + grouped(stages.done()) + ". " + stages.told()[stages.done() - 1];
  const float em = ImGui::GetFontSize();
  const float room = std::min(kMostEms * em, static_cast<float>(picture.size.x) - 4 * em);
  if (room <= 0) return;
  const ImVec2 size = ImGui::CalcTextSize(text.c_str(), nullptr, false, room);
  const float left = static_cast<float>(picture.at.x + 0.5 * picture.size.x) - 0.5f * size.x;
  const float top = static_cast<float>(picture.at.y + picture.size.y) - size.y - 1.8f * em;
  const ImVec2 low{left - 0.8f * em, top - 0.5f * em},
      high{left + size.x + 0.8f * em, top + size.y + 0.5f * em};
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  list.AddRectFilled(low, high, colours::kPictureShade, 3);
  list.AddText(ImGui::GetFont(), em, {left, top}, colours::kPictureText, text.c_str(), nullptr, room);
  mark_area("stage caption", {{low.x, low.y}, {high.x - low.x, high.y - low.y}});
}

}  // namespace kerf
