#include "ui/editor/inspect/graph_canvas.h"

#include <imgui.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include "core/base/assert.h"
#include "ui/editor/shared/command_labels.h"
#include "ui/render/passes/mark_passes.h"
#include "ui/render/view/colours.h"
#include "ui/window/layout.h"
#include "ui/window/number_text.h"
#include "ui/window/theme.h"
#include "ui/window/widgets.h"

namespace kerf {

namespace {

constexpr double kZoomOfNotch = 1.2, kMinZoom = 0.5, kMaxZoom = 400;
constexpr double kMinRadius = 1, kMaxRadius = 9;  // of a node that is a single face, pixels
constexpr double kRadiusOfLink = 0.38;            // of a node, relative to the usual link
constexpr double kShareOfRoom = 0.48;             // radius of a node, relative to its nearest distance
constexpr double kTellApart = 16;                 // pixels from node to node
constexpr double kOutlined = 3;                   // pixels; smaller nodes have no outline
constexpr double kFilled = 0.46;                  // of the field, by half of the graph
constexpr double kOffMiddle = 0.35;               // of half of the field
constexpr double kScaleBar = 110;                 // pixels, at most
constexpr double kLongLink =
    1;  // of a layout; longer ones, as over the seam of an unrolled cut, are drawn faintly
constexpr double kOpaqueLink = 110, kFaintest = 12;
constexpr double kReach = 5;  // pixels around a node in which it is under the pointer

// The colour of a state on the field: the pale one of separated faces is darker in the light theme.
uint32_t colour_on_field(DrawnGraph::State state) {
  constexpr uint32_t kApartOnLight = 0xb07d10;
  const bool is_light = ImGui::GetStyleColorVec4(ImGuiCol_FrameBg).x > 0.5f;
  return is_light && state == DrawnGraph::State::kApart ? kApartOnLight : colour_of(state);
}

ImU32 opaque(uint32_t hex, int opacity = 255) {
  return IM_COL32(hex >> 16 & 0xffu, hex >> 8 & 0xffu, hex & 0xffu, opacity);
}

// Returns the length in a layout that a quarter of the links do not exceed; 0 without links. The links of a
// large cluster are many and long.
double usual_link(const DrawnGraph& graph, const GraphLayout& places) {
  std::vector<double> lengths;
  lengths.reserve(graph.edges.size());
  for (const auto& [a, b] : graph.edges) lengths.push_back(glm::length(places[a] - places[b]));
  if (lengths.empty()) return 0;
  const auto quarter = lengths.begin() + static_cast<ptrdiff_t>(lengths.size() / 4);
  std::nth_element(lengths.begin(), quarter, lengths.end());
  return *quarter;
}

// Returns the average length [m] of the unit of a layout along the links; 0 if unknown.
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

// Returns the largest of 1, 2 and 5 times a power of ten that does not exceed a length > 0.
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

std::vector<double> nearest_distances(const GraphLayout& places, double most) {
  KERF_ASSERT(most > 0);
  std::vector<double> nearest(places.size(), most);
  std::map<std::pair<int64_t, int64_t>, std::vector<uint32_t>> cells;  // squares with sides of `most`
  for (uint32_t i = 0; i < places.size(); ++i) {
    const auto x = static_cast<int64_t>(std::floor(places[i].x / most));
    const auto y = static_cast<int64_t>(std::floor(places[i].y / most));
    for (int64_t dx = -1; dx <= 1; ++dx) {
      for (int64_t dy = -1; dy <= 1; ++dy) {
        const auto cell = cells.find({x + dx, y + dy});
        if (cell == cells.end()) continue;
        for (const uint32_t other : cell->second) {
          const double distance = glm::length(places[i] - places[other]);
          nearest[i] = std::min(nearest[i], distance);
          nearest[other] = std::min(nearest[other], distance);
        }
      }
    }
    cells[{x, y}].push_back(i);
  }
  return nearest;
}

// The radius of a cluster grows with its faces, within the room between it and the nearest node.
double GraphCanvas::radius_of(const DrawnGraph& graph, uint32_t node) const {
  const uint32_t faces = graph.nodes[node].faces;
  const double wanted = faces == 1 ? radius_ : radius_ * std::min(2.2, 1.2 + 0.1 * std::sqrt(faces));
  return std::clamp(kShareOfRoom * room_[node] * half_ * zoom_, kMinRadius, wanted);
}

void GraphCanvas::draw_legend(const DrawnGraph& graph) const {
  struct Entry {
    DrawnGraph::State state;
    const char* name;
  };
  constexpr std::array kEntries{
      Entry{DrawnGraph::State::kMarked, "Reached"}, Entry{DrawnGraph::State::kUnmarked, "Not Reached"},
      Entry{DrawnGraph::State::kApart, "Separated"}, Entry{DrawnGraph::State::kRemoved, "Removed"}};
  std::vector<Entry> shown;
  float width = 0;
  for (const Entry& entry : kEntries) {
    const bool any = std::any_of(graph.nodes.begin(), graph.nodes.end(),
                                 [&](const DrawnGraph::Node& n) { return graph.state(n) == entry.state; });
    if (!any) continue;
    shown.push_back(entry);
    width = std::max(width, ImGui::CalcTextSize(entry.name).x);
  }
  const float em = ImGui::GetFontSize(), line = 1.3f * em;
  const ImVec2 at(static_cast<float>(centre_.x - 0.5 * size_.x) + 0.4f * em,
                  static_cast<float>(centre_.y - 0.5 * size_.y) + 0.4f * em);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(at,
                     {at.x + width + 1.9f * em, at.y + line * static_cast<float>(shown.size()) + 0.2f * em},
                     ImGui::GetColorU32(ImGuiCol_FrameBg, 0.85f), 3);
  for (size_t i = 0; i < shown.size(); ++i) {
    const float y = at.y + 0.1f * em + line * static_cast<float>(i);
    list.AddCircleFilled({at.x + 0.8f * em, y + 0.5f * line}, 0.3f * em,
                         opaque(colour_on_field(shown[i].state)));
    list.AddText({at.x + 1.5f * em, y + 0.5f * (line - em)}, colours::text(), shown[i].name);
  }
}

std::string graph_svg(const DrawnGraph& graph, const GraphLayout& places) {
  KERF_ASSERT(places.size() == graph.nodes.size());
  constexpr double kHalf = 500, kMargin = 20, kMaxNode = 6;
  const auto x = [](const Vec2& p) { return kHalf + (kHalf - kMargin) * p.x; };
  const auto y = [](const Vec2& p) { return kHalf + (kHalf - kMargin) * p.y; };
  const auto hex = [](uint32_t colour) { return text_of("#%06x", colour & 0xffffffu); };
  std::string svg =
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 1000 1000\">\n"
      "<rect width=\"1000\" height=\"1000\" fill=\"#ffffff\"/>\n<g stroke-width=\"0.8\">\n";
  for (const auto& edge : graph.edges) {
    const Vec2 a = places[edge[0]], b = places[edge[1]];
    const uint32_t colour =
        graph.is_cut(edge) ? overlay_colours::kRemoved : colour_of(graph.state(graph.nodes[edge[0]]));
    svg += text_of("<line x1=\"%.2f\" y1=\"%.2f\" x2=\"%.2f\" y2=\"%.2f\"", x(a), y(a), x(b), y(b)) +
           " stroke=\"" + hex(colour) + "\"/>\n";
  }
  svg += "</g>\n<g>\n";
  const double most = 2 * kMaxNode / (kHalf - kMargin) / (2 * kShareOfRoom);
  const std::vector<double> room = nearest_distances(places, most);
  for (size_t i = 0; i < places.size(); ++i) {
    const double radius = std::max(0.5, kShareOfRoom * room[i] * (kHalf - kMargin));
    svg += text_of("<circle cx=\"%.2f\" cy=\"%.2f\" r=\"%.2f\"", x(places[i]), y(places[i]), radius) +
           " fill=\"" + hex(colour_of(graph.state(graph.nodes[i]))) + "\"/>\n";
  }
  return svg + "</g>\n</svg>\n";
}

void GraphCanvas::execute_requests(const Drawn& drawn, double link) {
  if (framing_ == Framing::kNone || drawn.places.empty()) return;
  Vec2 low(std::numeric_limits<double>::infinity()), high(-low);
  for (const Vec2& p : drawn.places) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  const Vec2 extent = glm::max(high - low, Vec2(1e-9));
  const Vec2 fitting = 2 * kFilled * size_ / (extent * half_);
  const double all = std::clamp(std::min(fitting.x, fitting.y), kMinZoom, kMaxZoom);
  middle_ = 0.5 * (low + high);
  zoom_ = all;
  if (framing_ == Framing::kStart && drawn.start && link > 0) {
    zoom_ = std::clamp(kTellApart / (link * half_), all, kMaxZoom);
    // A start at the border of the graph is a little off the middle, so that less of the field is empty.
    const Vec2 reach = kOffMiddle * glm::min(0.5 * size_ / (half_ * zoom_), 0.5 * extent);
    middle_ = glm::clamp(drawn.places[*drawn.start], low + reach, high - reach);
  }
  framing_ = Framing::kNone;
}

// The child window of the canvas scrolls by an invisible pixel, to keep the wheel from the sidebar.
void GraphCanvas::listen() {
  const ImGuiIO& io = ImGui::GetIO();
  if (ImGui::IsItemHovered() && io.MouseWheel != 0) {
    const Vec2 from = (vec(io.MousePos) - centre_) / half_;
    const double before = zoom_;
    zoom_ = std::clamp(zoom_ * std::pow(kZoomOfNotch, io.MouseWheel), kMinZoom, kMaxZoom);
    middle_ += from * (1 / before - 1 / zoom_);
  }
  if (ImGui::IsItemActivated()) dragged_ = false;
  if (ImGui::IsItemActive() && ImGui::IsMouseDragging(ImGuiMouseButton_Left)) {
    dragged_ = true;
    middle_ -= vec(io.MouseDelta) / (half_ * zoom_);
  }
}

// Links longer than usual are fainter, so that those of a large cluster do not cover the others.
void GraphCanvas::draw_links(const DrawnGraph& graph, const GraphLayout& places, double link) const {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (const auto& edge : graph.edges) {
    const uint32_t hex =
        graph.is_cut(edge) ? overlay_colours::kRemoved : colour_on_field(graph.state(graph.nodes[edge[0]]));
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
  // Remaining nodes are drawn over removed ones.
  std::vector<uint32_t> order(graph.nodes.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_partition(order.begin(), order.end(), [&](uint32_t i) { return graph.nodes[i].removed; });
  for (const uint32_t i : order) {
    const Vec2 p = on_screen(places[i]), off = glm::abs(p - centre_) - 0.5 * size_;
    const double radius = radius_of(graph, i);
    if (std::max(off.x, off.y) > radius) continue;
    const int corners = radius < 4 ? 8 : 16;
    list.AddCircleFilled(im(p), static_cast<float>(radius),
                         opaque(colour_on_field(graph.state(graph.nodes[i]))), corners);
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
  const double radius = radius_of(graph, node) + 3;
  ImGui::GetWindowDrawList()->AddCircle(im(on_screen(places[node])), static_cast<float>(radius), colour, 20,
                                        2);
}

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
    execute_requests(drawn, link);
    listen();
    radius_ = std::clamp(kRadiusOfLink * link * half_ * zoom_, kMinRadius, kMaxRadius);
    room_ = nearest_distances(places, 2.2 * radius_ / (kShareOfRoom * half_ * zoom_));
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
    draw_legend(graph);
  }
  ImGui::EndChild();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
  return pointer;
}

}  // namespace kerf
