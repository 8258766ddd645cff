#include "ui/editor/graph/graph_canvas.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/assert.h"
#include "ui/render/passes/graph_pass.h"
#include "ui/render/view/overlay_colours.h"
#include "ui/window/landmarks.h"
#include "ui/window/theme.h"

namespace kerf {

namespace {

constexpr double kZoomOfNotch = 1.2, kLeastZoom = 0.5, kMostZoom = 400;
constexpr double kLeastRadius = 1.5, kMostRadius = 8;  // of a node that is a single face, pixels
constexpr double kLongLink =
    1;  // of a layout; longer ones, as over the seam of an unrolled cut, are drawn faintly
constexpr double kReach = 5;  // pixels around a node in which it is under the pointer

ImU32 opaque(uint32_t hex, int opacity = 255) {
  return IM_COL32(hex >> 16 & 0xffu, hex >> 8 & 0xffu, hex & 0xffu, opacity);
}

ImVec2 im(const Vec2& p) { return {static_cast<float>(p.x), static_cast<float>(p.y)}; }
Vec2 vec(const ImVec2& p) { return {p.x, p.y}; }

}  // namespace

// That of a cluster grows slowly with its faces.
double GraphCanvas::radius_of(const DrawnGraph::Node& node) const {
  return node.faces == 1 ? radius_ : radius_ * std::min(2.2, 1.2 + 0.1 * std::sqrt(node.faces));
}

// The child window of the canvas scrolls by a pixel that nobody sees, so that the wheel does not scroll the
// column of panels.
void GraphCanvas::listen(Vec2 at) {
  centre_ = at + 0.5 * size_;
  half_ = 0.46 * std::min(size_.x, size_.y);
  const ImGuiIO& io = ImGui::GetIO();
  if (ImGui::IsItemHovered() && io.MouseWheel != 0) {
    const Vec2 from = (vec(io.MousePos) - centre_) / half_;
    const double before = zoom_;
    zoom_ = std::clamp(zoom_ * std::pow(kZoomOfNotch, io.MouseWheel), kLeastZoom, kMostZoom);
    middle_ += from * (1 / before - 1 / zoom_);
  }
  if (ImGui::IsItemActivated()) dragged_ = false;
  if (ImGui::IsItemActive() && ImGui::IsMouseDragging(ImGuiMouseButton_Left)) {
    dragged_ = true;
    middle_ -= vec(io.MouseDelta) / (half_ * zoom_);
  }
}

void GraphCanvas::draw_links(const DrawnGraph& graph, const GraphLayout& places) const {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (const auto& edge : graph.edges) {
    const uint32_t hex =
        graph.is_cut(edge) ? overlay_colours::kRemoved : colour_of(graph.state(graph.nodes[edge[0]]));
    const bool is_long = glm::length(places[edge[0]] - places[edge[1]]) > kLongLink;
    list.AddLine(im(on_screen(places[edge[0]])), im(on_screen(places[edge[1]])),
                 opaque(hex, is_long ? 12 : 110));
  }
}

// Returns the node under the pointer.
std::optional<uint32_t> GraphCanvas::draw_nodes(const DrawnGraph& graph, const GraphLayout& places) const {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Vec2 pointer = vec(ImGui::GetIO().MousePos);
  std::optional<uint32_t> over;
  double nearest = std::numeric_limits<double>::infinity();
  for (uint32_t i = 0; i < graph.nodes.size(); ++i) {
    const Vec2 p = on_screen(places[i]), off = glm::abs(p - centre_) - 0.5 * size_;
    const double radius = radius_of(graph.nodes[i]);
    if (std::max(off.x, off.y) > radius) continue;
    list.AddCircleFilled(im(p), static_cast<float>(radius), opaque(colour_of(graph.state(graph.nodes[i]))),
                         radius < 4 ? 8 : 16);
    const double away = glm::length(pointer - p);
    if (away >= std::min(nearest, radius + kReach)) continue;
    nearest = away;
    over = i;
  }
  return over;
}

void GraphCanvas::draw_ring(const DrawnGraph& graph, const GraphLayout& places, uint32_t node,
                            uint32_t colour) const {
  const double radius = radius_of(graph.nodes[node]) + 3;
  ImGui::GetWindowDrawList()->AddCircle(im(on_screen(places[node])), static_cast<float>(radius), colour, 20,
                                        2);
}

GraphCanvas::Pointer GraphCanvas::draw(const DrawnGraph& graph, const GraphLayout& places, float height,
                                       std::optional<uint32_t> lit, std::optional<uint32_t> start) {
  KERF_ASSERT(places.size() == graph.nodes.size());
  KERF_ASSERT((!lit || *lit < graph.nodes.size()) && (!start || *start < graph.nodes.size()));
  Pointer pointer;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  ImGui::PushStyleColor(ImGuiCol_ChildBg, ImGui::GetColorU32(ImGuiCol_FrameBg));
  if (ImGui::BeginChild("##canvas", {0, height}, true, ImGuiWindowFlags_NoScrollbar)) {
    const Vec2 at = vec(ImGui::GetWindowPos());
    size_ = vec(ImGui::GetWindowSize());
    ImGui::SetCursorScreenPos(im(at));
    ImGui::InvisibleButton("##field", im(size_ + Vec2(0, 2)));
    mark_area("graph canvas", {at, size_});
    ImGui::SetScrollY(1);
    listen(at);
    const double spread = std::sqrt(static_cast<double>(std::max<size_t>(1, graph.nodes.size())));
    radius_ = std::clamp(0.5 * half_ * zoom_ / spread, kLeastRadius, kMostRadius);
    draw_links(graph, places);
    pointer.over = draw_nodes(graph, places);
    if (!ImGui::IsItemHovered()) pointer.over.reset();
    if (ImGui::IsItemDeactivated() && !dragged_) pointer.clicked = pointer.over;
    if (start) {
      draw_ring(graph, places, *start, colours::text());
      mark_area("graph start", {on_screen(places[*start]) - Vec2(2), Vec2(4)});
    }
    if (pointer.over) lit = pointer.over;
    if (lit) draw_ring(graph, places, *lit, colours::accent());
  }
  ImGui::EndChild();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
  return pointer;
}

}  // namespace kerf
