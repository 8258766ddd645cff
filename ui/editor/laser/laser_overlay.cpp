#include "ui/editor/laser/laser_overlay.h"

#include <imgui.h>
#include <algorithm>
#include <utility>

#include "core/base/assert.h"
#include "ui/editor/shared/file_frames.h"
#include "ui/editor/shared/gizmo.h"
#include "ui/editor/shared/viewport.h"
#include "ui/render/passes/beam_effects.h"
#include "ui/render/view/frame_space.h"
#include "ui/window/layout.h"
#include "ui/window/number_text.h"
#include "ui/window/theme.h"
#include "ui/window/widgets.h"

namespace kerf {

namespace {
constexpr double kUnseen = 0.3;  // s, before work is shown
}

CutProgress::Work CutProgress::work_of(const Document& document) {
  if (document.waiting() == 0) return Work::kNone;
  const CommandQueue& queue = document.queue();
  if (queue.pending().holds_beam()) return queue.pending().holds_moves() ? Work::kCut : Work::kEnd;
  return queue.next_searches() ? Work::kSearch : Work::kNone;
}

void CutProgress::follow(const Document& document, bool held_back, double seconds) {
  const Work work = held_back ? Work::kNone : work_of(document);
  if (work == Work::kNone) {
    *this = CutProgress();
    return;
  }
  const bool begins = work_ == Work::kNone;
  const size_t waits = document.waiting();
  if (!begins) {
    done_ += waits_ - std::min(waits, waits_);
    seconds_ += seconds;
  }
  work_ = work;
  waits_ = waits;
}

bool CutProgress::lasts() const { return seconds_ >= kUnseen; }

std::string CutProgress::text() const {
  if (!lasts()) return "";
  switch (work_) {
    case Work::kNone:
      break;
    case Work::kCut: {
      const auto done = static_cast<double>(done_), all = static_cast<double>(done_ + waits_);
      return text_of("Cutting, %.0f %%, Esc to stop", std::min(99.0, 100 * done / all));
    }
    case Work::kEnd:
      return "Smoothing the rim";
    case Work::kSearch:
      return "Searching for separated pieces";
  }
  return "";
}

namespace {

constexpr size_t kMaxWaiting = 8;
constexpr double kWaitingStrength = 0.35;  // relative to a beam that is on
constexpr double kShownAfter = 0.3;        // s, of waiting for another stroke
constexpr double kWaitingLength = 3;       // diagonals of the world, of a beam that hits nothing

// Returns the history entries of the waiting strokes, in order.
std::vector<size_t> waiting_steps(const Document& document, bool held_back) {
  const BeamQueue& pending = document.queue().pending();
  std::vector<size_t> steps;
  if (!pending.holds_beam()) return steps;
  const UndoStack& history = document.history();
  const size_t first = held_back ? pending.front_step() : pending.front_step() + 1;
  for (size_t i = first; i < history.position() && steps.size() < kMaxWaiting; ++i) {
    if (history.cuts(i) && history.step(i).waiting() && pending.holds(i)) steps.push_back(i);
  }
  return steps;
}

// "Cut 2" of "Cut 2: roof, radius 4 mm".
std::string short_name(const UndoStack& history, size_t step, FileUnit unit) {
  const std::string words = step_words(history, step, unit);
  return words.substr(0, words.find(':'));
}

BeamPicture beam_of(const Document& document, size_t step) {
  const UndoStack& history = document.history();
  const World& world = document.world();
  const auto* begin = std::get_if<BeginStroke>(&history.commands_of(step).front());
  KERF_ASSERT(begin != nullptr);
  const CutSettings& settings = history.settings_of(step);
  const double length =
      std::min(settings.laser.range.high, kWaitingLength * world.loaded_bounds().diagonal());
  BeamPicture beam = picture_of_beam(world, settings, begin->pose, length);
  beam.strength = kWaitingStrength;
  return beam;
}

}  // namespace

bool WaitingStrokes::follow(const Document& document, FileUnit unit, bool held_back, double seconds) {
  std::vector<size_t> steps = waiting_steps(document, held_back);
  behind_ = steps.empty() || held_back ? 0 : behind_ + seconds;
  if (!held_back && behind_ < kShownAfter) steps.clear();
  if (revision_ == document.revision() && held_back_ == held_back &&
      std::ranges::equal(steps, strokes_, {}, {}, &Stroke::step))
    return false;
  revision_ = document.revision();
  held_back_ = held_back;
  const bool had_any = !strokes_.empty();
  strokes_.clear();
  for (const size_t step : steps) {
    const size_t now = document.queue().pending().front_step();
    const std::string why = step == now ? "Waiting for its first stage"
                                        : "Waiting for " + short_name(document.history(), now, unit);
    strokes_.push_back({step, why, beam_of(document, step)});
  }
  return had_any || !strokes_.empty();
}

void WaitingStrokes::draw(const ViewState& view, ImDrawList& list) const {
  const float em = ImGui::GetFontSize();
  for (size_t i = 0; i < strokes_.size(); ++i) {
    const BeamPicture& beam = strokes_[i].beam;
    const auto at = FirstPicture(view).place_of(beam.strike.value_or(beam.to));
    if (!at) continue;
    const ImVec2 text = ImGui::CalcTextSize(strokes_[i].waits_for.c_str());
    const ImVec2 place{static_cast<float>(at->x) + em, static_cast<float>(at->y) - 0.5f * em};
    const ImVec2 low{place.x - 0.4f * em, place.y - 0.2f * em};
    list.AddRectFilled(low, {place.x + text.x + 0.4f * em, place.y + text.y + 0.2f * em},
                       colours::kPictureShade, 3);
    list.AddText(place, colours::kPictureText, strokes_[i].waits_for.c_str());
    list.AddCircle(to_im(*at), 0.35f * em, colours::kPictureText, 0, 1.3f);
    mark_area(("waiting stroke " + std::to_string(i)).c_str(),
              {{low.x, low.y}, {text.x + 0.8 * em, text.y + 0.4 * em}});
  }
}

namespace {

constexpr double kCar = 4.5;  // m, diagonal of a world with particles of the default size

}  // namespace

void BeamSparks::advance(double seconds, const LaserTool& beam, const Document& document,
                         const WaitingStrokes& waiting, bool waiting_changed, ViewState& view) {
  if (!view.look.sparks) particles_.clear();
  const UpAxis axis = view.camera.up_axis();
  const Vec3 up = axis == UpAxis::kZ ? Vec3(0, 0, 1) : Vec3(0, 1, 0);
  const World& world = document.world();
  const double before = std::exchange(removed_, document.history().totals().removed_mass);
  const double mass = removed_ - before;
  const bool wanted = mass > 0 && view.look.sparks && !view.look.stage;
  const auto shown = wanted ? beam.picture(document) : std::nullopt;
  if (shown && shown->strike) {
    const Vec3 along = glm::normalize(shown->to - shown->from);
    particles_.add({*shown->strike, along, world.loaded_bounds().diagonal() / kCar, mass}, up);
  }
  if (particles_.empty() && !had_particles_ && !waiting_changed) return;
  particles_.advance(seconds, up, height_of_drawn_ground(world, axis));
  auto effects = std::make_shared<Effects>();
  particles_.append_to(*effects);
  for (const WaitingStrokes::Stroke& stroke : waiting.strokes()) effects->beams.push_back(stroke.beam);
  had_particles_ = !particles_.empty();
  view.look.effects = had_particles_ || !effects->beams.empty() ? std::move(effects) : nullptr;
  view.picture_old = true;
}

namespace {

constexpr std::array kHints{
    "Left-drag to cut",
    "Middle-drag to orbit, scroll to zoom",
    "F1 shows all shortcuts",
};

std::array<Vec2, 4> corners_of(const Area& a) {
  return {a.at, a.at + Vec2(a.size.x, 0), a.at + Vec2(0, a.size.y), a.at + a.size};
}

// Returns true if a line perpendicular to `axis` separates two sets of points.
bool apart_along(const Vec2& axis, std::span<const Vec2> a, std::span<const Vec2> b) {
  const auto less = [&](const Vec2& p, const Vec2& q) { return glm::dot(axis, p) < glm::dot(axis, q); };
  const auto [low_a, high_a] = std::minmax_element(a.begin(), a.end(), less);
  const auto [low_b, high_b] = std::minmax_element(b.begin(), b.end(), less);
  return less(*high_a, *low_b) || less(*high_b, *low_a);
}

bool hides_axes(const ViewState& view, const Area& area) {
  const std::vector<AxisEnd> ends = axis_ends(view);
  return std::any_of(ends.begin(), ends.end(), [&](const AxisEnd& end) { return area.contains(end.at); });
}

Vec2 size_of_hints() {
  const double em = ImGui::GetFontSize(), line = ImGui::GetTextLineHeightWithSpacing();
  double widest = 0;
  for (const char* hint : kHints) widest = std::max<double>(widest, ImGui::CalcTextSize(hint).x);
  return {widest + 2 * em, static_cast<double>(kHints.size()) * line + em};
}

void draw_hints(const Area& box) {
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const float em = ImGui::GetFontSize();
  const auto left = static_cast<float>(box.at.x), top = static_cast<float>(box.at.y);
  const auto width = static_cast<float>(box.size.x), height = static_cast<float>(box.size.y);
  list.AddRectFilled({left, top}, {left + width, top + height}, colours::kPictureShade, 3);
  float y = top + 0.65f * em;
  for (size_t i = 0; i < kHints.size(); ++i) {
    const float x = left + 0.5f * (width - ImGui::CalcTextSize(kHints[i]).x);
    list.AddText({x, y}, i == 0 ? colours::kPictureText : colours::kPictureSecondary, kHints[i]);
    y += ImGui::GetTextLineHeightWithSpacing();
  }
}

}  // namespace

std::optional<std::array<Vec2, 8>> seen_corners(const World::Bounds& bounds, const CameraView& view,
                                                const Area& picture) {
  std::array<Vec2, 8> corners;
  for (unsigned i = 0; i < 8; ++i) {
    const Vec3 seen = view.project({(i & 1u) != 0 ? bounds.max.x : bounds.min.x,
                                    (i & 2u) != 0 ? bounds.max.y : bounds.min.y,
                                    (i & 4u) != 0 ? bounds.max.z : bounds.min.z});
    if (seen.z <= 0) return std::nullopt;
    corners[i] = picture.at + Vec2(0.5 + 0.5 * seen.x, 0.5 - 0.5 * seen.y) * picture.size;
  }
  return corners;
}

bool meets_hull(const Area& area, std::span<const Vec2> points) {
  KERF_ASSERT(!points.empty());
  const std::array<Vec2, 4> corners = corners_of(area);
  if (apart_along({1, 0}, corners, points) || apart_along({0, 1}, corners, points)) return false;
  for (const Vec2& p : points) {
    for (const Vec2& q : points) {
      if (p != q && apart_along({q.y - p.y, p.x - q.x}, corners, points)) return false;
    }
  }
  return true;
}

std::optional<Area> free_place(const Area& picture, Vec2 size, double margin,
                               const std::function<bool(const Area&)>& is_free) {
  const Vec2 room = picture.size - size - Vec2(2 * margin);
  if (room.x < 0 || room.y < 0) return std::nullopt;
  for (const double down : {1.0, 0.0}) {
    for (const double along : {0.5, 0.0, 1.0}) {
      const Area place{picture.at + Vec2(margin) + room * Vec2(along, down), size};
      if (is_free(place)) return place;
    }
  }
  return std::nullopt;
}

void draw_hint_box(const World& world, const ViewState& view, const Area& taken) {
  const Area& picture = view.layout.first;
  const auto corners = seen_corners(world.bounds(), view.seen_first(), picture);
  if (!corners) return;
  const auto is_free = [&](const Area& area) {
    return !meets_hull(area, *corners) && !meets_hull(area, corners_of(taken)) && !hides_axes(view, area);
  };
  const auto place = free_place(picture, size_of_hints(), 1.2 * ImGui::GetFontSize(), is_free);
  if (!place) return;
  draw_hints(*place);
  mark_area("hints", *place);
}

}  // namespace kerf
