#include "ui/editor/graph/graph_canvas.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

#include "core/base/assert.h"
#include "ui/editor/shared/files/file_frames.h"
#include "ui/render/passes/graph_pass.h"
#include "ui/render/view/overlay_colours.h"
#include "ui/window/landmarks.h"
#include "ui/window/theme.h"

namespace kerf {

namespace {

constexpr double kZoomOfNotch = 1.2, kLeastZoom = 0.5, kMostZoom = 400;
constexpr double kLeastRadius = 1.5, kMostRadius = 9;  // of a node that is a single face, pixels
constexpr double kRadiusOfLink = 0.38;                 // of a node, relative to the usual link
constexpr double kTellApart = 16;                      // pixels from node to node
constexpr double kOutlined = 3;                        // pixels; smaller nodes have no outline
constexpr double kFilled = 0.46;                       // of the field, by half of the graph
constexpr double kOffMiddle = 0.35;                    // of half of the field
constexpr double kScaleBar = 110;                      // pixels, at most
constexpr double kLongLink =
    1;  // of a layout; longer ones, as over the seam of an unrolled cut, are drawn faintly
constexpr double kOpaqueLink = 110, kFaintest = 12;
constexpr double kReach = 5;  // pixels around a node in which it is under the pointer

ImU32 opaque(uint32_t hex, int opacity = 255) {
  return IM_COL32(hex >> 16 & 0xffu, hex >> 8 & 0xffu, hex & 0xffu, opacity);
}

// The length in a layout that a quarter of the links do not exceed; 0 without links. Those of a large cluster
// are many and long.
double usual_link(const DrawnGraph& graph, const GraphLayout& places) {
  std::vector<double> lengths;
  lengths.reserve(graph.edges.size());
  for (const auto& [a, b] : graph.edges) lengths.push_back(glm::length(places[a] - places[b]));
  if (lengths.empty()) return 0;
  const auto quarter = lengths.begin() + static_cast<ptrdiff_t>(lengths.size() / 4);
  std::nth_element(lengths.begin(), quarter, lengths.end());
  return *quarter;
}

// How many metres the unit of a layout stands for on average along the links; 0 where that cannot be told.
double metres_per_unit_of(const DrawnGraph& graph, const GraphLayout& places) {
  double in_space = 0, in_plane = 0;
  for (const auto& [a, b] : graph.edges) {
    const double link = glm::length(places[a] - places[b]);
    if (link > kLongLink) continue;
    in_plane += link;
    in_space += glm::length(graph.nodes[a].middle - graph.nodes[b].middle);
  }
  return in_plane > 0 ? in_space / in_plane : 0;
}

// The largest of 1, 2 and 5 times a power of ten that does not exceed a length. Precondition: it is positive.
double round_length(double most) {
  const double power = std::pow(10, std::floor(std::log10(most)));
  for (const double times : {5.0, 2.0}) {
    if (times * power <= most) return times * power;
  }
  return power;
}

ImVec2 im(const Vec2& p) { return {static_cast<float>(p.x), static_cast<float>(p.y)}; }
Vec2 vec(const ImVec2& p) { return {p.x, p.y}; }

}  // namespace

// That of a cluster grows slowly with its faces.
double GraphCanvas::radius_of(const DrawnGraph::Node& node) const {
  return node.faces == 1 ? radius_ : radius_ * std::min(2.2, 1.2 + 0.1 * std::sqrt(node.faces));
}

// Frames what is wished for.
void GraphCanvas::fulfil(const Drawn& drawn, double link) {
  if (wish_ == Wish::kNone || drawn.places.empty()) return;
  Vec2 low(std::numeric_limits<double>::infinity()), high(-low);
  for (const Vec2& p : drawn.places) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  const Vec2 extent = glm::max(high - low, Vec2(1e-9));
  const Vec2 fitting = 2 * kFilled * size_ / (extent * half_);
  const double all = std::clamp(std::min(fitting.x, fitting.y), kLeastZoom, kMostZoom);
  middle_ = 0.5 * (low + high);
  zoom_ = all;
  if (wish_ == Wish::kStart && drawn.start && link > 0) {
    zoom_ = std::clamp(kTellApart / (link * half_), all, kMostZoom);
    // A start at the border of the graph is a little off the middle, so that less of the field is empty.
    const Vec2 reach = kOffMiddle * glm::min(0.5 * size_ / (half_ * zoom_), 0.5 * extent);
    middle_ = glm::clamp(drawn.places[*drawn.start], low + reach, high - reach);
  }
  wish_ = Wish::kNone;
}

// The child window of the canvas scrolls by a pixel that nobody sees, so that the wheel does not scroll the
// column of panels.
void GraphCanvas::listen() {
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

// Links that are longer than usual are fainter, so that those of a large cluster leave the others to be seen.
void GraphCanvas::draw_links(const DrawnGraph& graph, const GraphLayout& places, double link) const {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (const auto& edge : graph.edges) {
    const uint32_t hex =
        graph.is_cut(edge) ? overlay_colours::kRemoved : colour_of(graph.state(graph.nodes[edge[0]]));
    const double length = std::max(glm::length(places[edge[0]] - places[edge[1]]), link);
    const double opacity = length > kLongLink ? kFaintest : kOpaqueLink * 2 * link / (length + link);
    list.AddLine(im(on_screen(places[edge[0]])), im(on_screen(places[edge[1]])),
                 opaque(hex, static_cast<int>(std::max(opacity, kFaintest))));
  }
}

// Returns the node under the pointer.
std::optional<uint32_t> GraphCanvas::draw_nodes(const DrawnGraph& graph, const GraphLayout& places) const {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Vec2 pointer = vec(ImGui::GetIO().MousePos);
  std::optional<uint32_t> over;
  double nearest = std::numeric_limits<double>::infinity();
  // What stays lies over what was removed.
  std::vector<uint32_t> order(graph.nodes.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_partition(order.begin(), order.end(), [&](uint32_t i) { return graph.nodes[i].removed; });
  for (const uint32_t i : order) {
    const Vec2 p = on_screen(places[i]), off = glm::abs(p - centre_) - 0.5 * size_;
    const double radius = radius_of(graph.nodes[i]);
    if (std::max(off.x, off.y) > radius) continue;
    const int corners = radius < 4 ? 8 : 16;
    list.AddCircleFilled(im(p), static_cast<float>(radius), opaque(colour_of(graph.state(graph.nodes[i]))),
                         corners);
    if (radius >= kOutlined)
      list.AddCircle(im(p), static_cast<float>(radius), IM_COL32(10, 12, 16, 200), corners, 1);
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

// At the lower left.
void GraphCanvas::draw_scale(const DrawnGraph& graph, const GraphLayout& places, FileUnit unit) const {
  const double metres = metres_per_unit_of(graph, places);
  if (!(metres > 0)) return;
  const double per_pixel = metres / (half_ * zoom_), length = round_length(kScaleBar * per_pixel);
  const float em = ImGui::GetFontSize(), width = static_cast<float>(length / per_pixel);
  const ImVec2 from(static_cast<float>(centre_.x - 0.5 * size_.x) + 0.7f * em,
                    static_cast<float>(centre_.y + 0.5 * size_.y) - 0.7f * em);
  const ImVec2 to(from.x + width, from.y);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const std::string text = "about " + length_label(length, unit);
  const float wide = std::max(width, ImGui::CalcTextSize(text.c_str()).x);
  list.AddRectFilled({from.x - 0.3f * em, from.y - 1.5f * em},
                     {from.x + wide + 0.3f * em, from.y + 0.4f * em},
                     ImGui::GetColorU32(ImGuiCol_FrameBg, 0.8f), 3);
  list.AddLine(from, to, colours::secondary(), 1.5f);
  for (const ImVec2& end : {from, to})
    list.AddLine({end.x, end.y - 0.25f * em}, {end.x, end.y + 0.25f * em}, colours::secondary(), 1.5f);
  list.AddText({from.x, from.y - 1.4f * em}, colours::secondary(), text.c_str());
}

GraphCanvas::Pointer GraphCanvas::draw(const Drawn& drawn, float height) {
  const auto& [graph, places, lit, start, scale] = drawn;
  KERF_ASSERT(places.size() == graph.nodes.size());
  KERF_ASSERT((!lit || *lit < graph.nodes.size()) && (!start || *start < graph.nodes.size()));
  Pointer pointer;
  hovered_ = false;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  ImGui::PushStyleColor(ImGuiCol_ChildBg, ImGui::GetColorU32(ImGuiCol_FrameBg));
  if (ImGui::BeginChild("##canvas", {0, height}, true, ImGuiWindowFlags_NoScrollbar)) {
    const Vec2 at = vec(ImGui::GetWindowPos());
    size_ = vec(ImGui::GetWindowSize());
    centre_ = at + 0.5 * size_;
    half_ = kFilled * std::min(size_.x, size_.y);
    ImGui::SetCursorScreenPos(im(at));
    ImGui::InvisibleButton("##field", im(size_ + Vec2(0, 2)));
    mark_area("graph canvas", {at, size_});
    ImGui::SetScrollY(1);
    hovered_ = ImGui::IsItemHovered();
    const double link = usual_link(graph, places);
    fulfil(drawn, link);
    listen();
    radius_ = std::clamp(kRadiusOfLink * link * half_ * zoom_, kLeastRadius, kMostRadius);
    draw_links(graph, places, link);
    pointer.over = draw_nodes(graph, places);
    if (!hovered_) pointer.over.reset();
    if (ImGui::IsItemDeactivated() && !dragged_) pointer.clicked = pointer.over;
    if (start) {
      draw_ring(graph, places, *start, colours::text());
      mark_area("graph start", {on_screen(places[*start]) - Vec2(2), Vec2(4)});
    }
    const std::optional<uint32_t> ringed = pointer.over ? pointer.over : lit;
    if (ringed) draw_ring(graph, places, *ringed, colours::accent());
    if (scale) draw_scale(graph, places, *scale);
  }
  ImGui::EndChild();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
  return pointer;
}

}  // namespace kerf
