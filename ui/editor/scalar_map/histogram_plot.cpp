#include "ui/editor/scalar_map/histogram_plot.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "ui/window/landmarks.h"
#include "ui/window/property.h"
#include "ui/window/theme.h"

namespace kerf {

namespace {

constexpr float kPlotEms = 5, kStripEms = 0.45f, kGripEms = 0.38f;
constexpr double kLeastApart = 0.01;  // of the histogram, between the handles

ImU32 colour_at(const ScalarRange& range, double value) {
  const glm::vec3 c = scalar_colour((value - range.low) / (range.high - range.low));
  return ImGui::ColorConvertFloat4ToU32({c.r, c.g, c.b, 1});
}

// The plot on the screen.
struct Frame {
  const Histogram& histogram;
  ImVec2 at, size;

  double share_of(double value) const {
    return std::clamp((value - histogram.from) / (histogram.to - histogram.from), 0.0, 1.0);
  }
  float x_of(double value) const { return at.x + static_cast<float>(share_of(value)) * size.x; }
  double value_at(float x) const {
    const double share = std::clamp<double>((x - at.x) / size.x, 0, 1);
    return histogram.from + share * (histogram.to - histogram.from);
  }
};

void draw_columns(const Frame& frame, const ScalarRange& range, float height, ImDrawList& list) {
  const Histogram& h = frame.histogram;
  const auto most = static_cast<double>(*std::max_element(h.bins.begin(), h.bins.end()));
  for (size_t i = 0; i < h.bins.size(); ++i) {
    if (h.bins[i] == 0) continue;
    const double begin = h.from + h.width() * static_cast<double>(i);
    const auto tall = static_cast<float>(std::sqrt(static_cast<double>(h.bins[i]) / most)) * height;
    const float left = frame.x_of(begin), right = std::max(left + 1, frame.x_of(begin + h.width()) - 1);
    list.AddRectFilled({left, frame.at.y + height - std::max(1.0f, tall)}, {right, frame.at.y + height},
                       colour_at(range, begin + 0.5 * h.width()));
  }
}

// The colours along the axis, from the first to the last between the handles.
void draw_strip(const Frame& frame, const ScalarRange& range, float top, ImDrawList& list) {
  const float bottom = frame.at.y + frame.size.y;
  for (float x = frame.at.x; x < frame.at.x + frame.size.x; x += 2) {
    const float right = std::min(x + 2, frame.at.x + frame.size.x);
    list.AddRectFilled({x, top}, {right, bottom}, colour_at(range, frame.value_at(0.5f * (x + right))));
  }
}

void draw_handle(float x, const Frame& frame, bool held, ImDrawList& list) {
  const float grip = kGripEms * ImGui::GetFontSize(), bottom = frame.at.y + frame.size.y;
  const ImU32 colour = held ? colours::accent() : colours::text();
  list.AddLine({x, frame.at.y}, {x, bottom}, IM_COL32(0, 0, 0, 120), 3);
  list.AddLine({x, frame.at.y}, {x, bottom}, colour, 1);
  list.AddTriangleFilled({x - grip, frame.at.y}, {x + grip, frame.at.y}, {x, frame.at.y + 1.3f * grip},
                         colour);
}

// Takes the handle that is nearer to the press, and keeps to it as long as the button is held.
bool drag(const Frame& frame, ScalarRange& range) {
  if (!ImGui::IsItemActive()) return false;
  ImGuiStorage& storage = *ImGui::GetStateStorage();
  const ImGuiID held = ImGui::GetID("held handle");
  const float x = ImGui::GetIO().MousePos.x;
  if (ImGui::IsItemActivated())
    storage.SetBool(held, std::abs(x - frame.x_of(range.high)) < std::abs(x - frame.x_of(range.low)));
  const ScalarRange before = range;
  const Histogram& h = frame.histogram;
  const double apart = kLeastApart * (h.to - h.from), value = frame.value_at(x);
  if (storage.GetBool(held)) {
    range.high = std::max(value, range.low + apart);
  } else {
    range.low = std::min(value, range.high - apart);
  }
  return !(range == before);
}

}  // namespace

bool draw_histogram(const Histogram& histogram, ScalarRange& range) {
  const float em = ImGui::GetFontSize(), grip = kGripEms * em;
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const ImVec2 whole{std::max(4 * em, ImGui::GetContentRegionAvail().x), kPlotEms * em};
  ImGui::InvisibleButton("histogram", whole);
  const bool hovered = ImGui::IsItemHovered() || ImGui::IsItemActive();
  // The grips of handles at the ends stand out by half.
  const Frame frame{histogram, {corner.x + grip, corner.y}, {whole.x - 2 * grip, whole.y}};
  const bool changed = drag(frame, range);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float strip = kStripEms * em, height = whole.y - strip - 2;
  list.AddRectFilled(corner, {corner.x + whole.x, corner.y + height}, ImGui::GetColorU32(ImGuiCol_FrameBg),
                     3);
  draw_columns(frame, range, height, list);
  draw_strip(frame, range, corner.y + height + 2, list);
  for (const auto& [name, value] :
       {std::pair("scalar low", range.low), std::pair("scalar high", range.high)}) {
    const float x = frame.x_of(value);
    draw_handle(x, frame, hovered, list);
    mark_area(name, {{x - grip, corner.y}, {2 * grip, whole.y}});
  }
  tooltip(
      "How many faces have which value (columns by the square root of their number). Drag a handle to where "
      "the colours are to begin or to end.");
  return changed;
}

}  // namespace kerf
