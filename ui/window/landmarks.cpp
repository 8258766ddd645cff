#include "ui/window/landmarks.h"

#include <imgui.h>

#include <nlohmann/json.hpp>

#include "core/base/atomic_file.h"

namespace kerf {

namespace {

Landmarks* kept_landmarks() { return static_cast<Landmarks*>(ImGui::GetIO().UserData); }

Area last_item() {
  const ImVec2 at = ImGui::GetItemRectMin(), size = ImGui::GetItemRectSize();
  return {{at.x, at.y}, {size.x, size.y}};
}

}  // namespace

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
  return all.dump();
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
