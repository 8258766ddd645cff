#include "ui/window/layout.h"

#include <imgui.h>
#include <algorithm>
#include <cmath>

#include "core/base/assert.h"
#include "core/base/json.h"
#include "core/base/platform.h"

namespace kerf {

namespace {

constexpr double kMinViewport = 320, kMinViewportHeight = 160;
constexpr double kMinSideEms = 12, kMinStripEms = 6;
constexpr double kMinHalf = 120;

// Returns the size of a panel area within the available space; 0 if it would be unusable.
double share(double wanted_ems, double min_ems, double em, double room) {
  const double size = std::min(std::round(wanted_ems * em), std::floor(room));
  return size < std::min(wanted_ems, min_ems) * em ? 0 : std::max(size, 0.0);
}

Landmarks* kept_landmarks() { return static_cast<Landmarks*>(ImGui::GetIO().UserData); }

Area last_item() {
  const ImVec2 at = ImGui::GetItemRectMin(), size = ImGui::GetItemRectSize();
  return {{at.x, at.y}, {size.x, size.y}};
}

}  // namespace

Layout lay_out(Vec2 window, double em, double menu, double status, const PanelSizes& panels) {
  const double height = std::max(1.0, window.y - menu - status);
  const double side = share(panels.side, kMinSideEms, em, window.x - kMinViewport);
  const double second = share(panels.second_side, kMinSideEms, em, window.x - side - kMinViewport);
  const double strip = share(panels.strip, kMinStripEms, em, height - kMinViewportHeight);
  const double width = std::max(1.0, window.x - side - second);
  Layout layout;
  layout.viewport = {{second, menu}, {width, height - strip}};
  layout.side = {{window.x - side, menu}, {side, height}};
  layout.second_side = {{0, menu}, {second, height}};
  layout.strip = {{second, menu + height - strip}, {width, strip}};
  layout.status = {{0, menu + height}, {window.x, status}};
  layout.first = layout.viewport;
  layout.em = em;
  return layout;
}

Layout split_in_two(Layout whole, double share) {
  KERF_ASSERT(!whole.split() && share >= 0 && share <= 1);
  const Area& all = whole.viewport;
  const double least = std::min(kMinHalf, std::floor(0.5 * all.size.x));
  const double left = std::clamp(std::round(share * all.size.x), least, all.size.x - least);
  whole.first = {all.at, {left, all.size.y}};
  whole.second = {{all.at.x + left, all.at.y}, {all.size.x - left, all.size.y}};
  return whole;
}

void Landmarks::mark(const Layout& layout) {
  mark("viewport", layout.viewport);
  mark("side", layout.side);
  mark("second_side", layout.second_side);
  mark("strip", layout.strip);
  mark("status", layout.status);
  mark("first", layout.first);
  mark("second", layout.second);
}

std::string Landmarks::text() const {
  nlohmann::ordered_json parts = nlohmann::ordered_json::object();
  for (const auto& [name, area] : areas_) parts[name] = {area.at.x, area.at.y, area.size.x, area.size.y};
  const nlohmann::ordered_json all{{"busy", busy_}, {"pointer", {pointer_.x, pointer_.y}}, {"parts", parts}};
  // Names of pieces may hold any bytes.
  return all.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

std::optional<Area> Landmarks::find(const std::string& name) const {
  const auto found = areas_.find(name);
  return found != areas_.end() ? std::optional(found->second) : std::nullopt;
}

Status Landmarks::finish(bool busy, Vec2 pointer) {
  busy_ = busy;
  pointer_ = pointer;
  if (!file_) return Done{};
  const std::string text = this->text() + "\n";
  if (text == written_) return Done{};
  if (const Status written = write_file_atomically(*file_, text); !written) return written;
  written_ = text;
  return Done{};
}

void keep_landmarks(Landmarks* landmarks) { ImGui::GetIO().UserData = landmarks; }

void prefix_landmarks(const char* prefix) {
  if (Landmarks* landmarks = kept_landmarks()) landmarks->set_prefix(prefix);
}

void mark_last_item(const char* name) {
  if (Landmarks* landmarks = kept_landmarks()) landmarks->mark(name, last_item());
}

void mark_area(const char* name, const Area& area) {
  if (Landmarks* landmarks = kept_landmarks()) landmarks->mark(name, area);
}

void mark_window(const char* name) {
  const ImVec2 at = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  mark_area(name, {{at.x, at.y}, {size.x, size.y}});
}

void mark_last_item(const char* name, int number) {
  if (Landmarks* landmarks = kept_landmarks())
    landmarks->mark(std::string(name) + ' ' + std::to_string(number), last_item());
}

}  // namespace kerf
