#include "ui/editor/ruler/ruler_list.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "core/base/assert.h"

namespace kerf {

namespace {

constexpr const char* kName = "name";
constexpr const char* kFrom = "from";
constexpr const char* kTo = "to";

std::optional<Vec3> point_of(const nlohmann::json& json) {
  if (!json.is_array() || json.size() != 3) return std::nullopt;
  Vec3 point(0);
  for (int i = 0; i < 3; ++i) {
    const nlohmann::json& number = json[static_cast<size_t>(i)];
    if (!number.is_number() || !std::isfinite(number.get<double>())) return std::nullopt;
    point[i] = number.get<double>();
  }
  return point;
}

std::optional<RulerMark> mark_of(const nlohmann::json& json) {
  if (!json.is_object()) return std::nullopt;
  const nlohmann::json name = json.value(kName, nlohmann::json());
  const auto from = point_of(json.value(kFrom, nlohmann::json()));
  const auto to = point_of(json.value(kTo, nlohmann::json()));
  if (!name.is_string() || !from || !to) return std::nullopt;
  return RulerMark{name.get<std::string>(), *from, *to};
}

// In quotes, in which a quote is written twice.
std::string quoted(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + '"';
}

std::string csv_number(double number) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), ",%.9g", number);
  return text.data();
}

}  // namespace

void RulerList::begin_edit() {
  undone_to_.push_back(marks_);
  redone_to_.clear();
}

void RulerList::add(const Vec3& from, const Vec3& to) {
  const auto has = [&](const std::string& name) {
    return std::any_of(marks_.begin(), marks_.end(), [&](const RulerMark& m) { return m.name == name; });
  };
  size_t number = marks_.size() + 1;
  while (has("Distance " + std::to_string(number))) ++number;
  marks_.push_back({"Distance " + std::to_string(number), from, to});
}

void RulerList::move(size_t mark, bool to_end, const Vec3& at) {
  KERF_ASSERT(mark < marks_.size());
  (to_end ? marks_[mark].to : marks_[mark].from) = at;
}

void RulerList::rename(size_t mark, std::string name) {
  KERF_ASSERT(mark < marks_.size());
  marks_[mark].name = std::move(name);
}

void RulerList::remove(size_t mark) {
  KERF_ASSERT(mark < marks_.size());
  marks_.erase(marks_.begin() + static_cast<std::ptrdiff_t>(mark));
}

void RulerList::undo() {
  KERF_ASSERT(can_undo());
  redone_to_.push_back(std::exchange(marks_, std::move(undone_to_.back())));
  undone_to_.pop_back();
}

void RulerList::redo() {
  KERF_ASSERT(can_redo());
  undone_to_.push_back(std::exchange(marks_, std::move(redone_to_.back())));
  redone_to_.pop_back();
}

nlohmann::json RulerList::to_json() const {
  if (marks_.empty()) return nullptr;
  nlohmann::json all = nlohmann::json::array();
  for (const RulerMark& m : marks_) {
    all.push_back(
        {{kName, m.name}, {kFrom, {m.from.x, m.from.y, m.from.z}}, {kTo, {m.to.x, m.to.y, m.to.z}}});
  }
  return all;
}

void RulerList::read(const nlohmann::json& entry) {
  *this = RulerList();
  if (!entry.is_array()) return;
  for (const nlohmann::json& json : entry) {
    if (auto mark = mark_of(json)) marks_.push_back(std::move(*mark));
  }
}

std::string RulerList::to_csv() const {
  std::string text = "name,from x,from y,from z,to x,to y,to z,length\n";
  for (const RulerMark& m : marks_) {
    text += quoted(m.name);
    for (const double number : {m.from.x, m.from.y, m.from.z, m.to.x, m.to.y, m.to.z, m.length()})
      text += csv_number(number);
    text += '\n';
  }
  return text;
}

}  // namespace kerf
