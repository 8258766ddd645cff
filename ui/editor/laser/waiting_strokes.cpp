#include "ui/editor/laser/waiting_strokes.h"

#include <imgui.h>

#include <algorithm>

#include "ui/editor/shared/picture/first_picture.h"
#include "ui/editor/shared/statistics/step_words.h"
#include "ui/render/picture/beam_strike.h"
#include "ui/window/imgui_vector.h"
#include "ui/window/landmarks.h"
#include "ui/window/theme.h"

namespace kerf {

namespace {

constexpr size_t kMostWaiting = 8;
constexpr double kWaitingStrength = 0.35;  // of a beam that is on
constexpr double kShownAfter = 0.3;        // s, of waiting for another stroke
constexpr double kWaitingLength = 3;       // diagonals of the world, of a beam that meets nothing

// The steps of the history whose strokes wait, the first ones first.
std::vector<size_t> waiting_steps(const Document& document, bool held_back) {
  const Execution& execution = document.execution();
  std::vector<size_t> steps;
  if (!execution.beam_waits()) return steps;
  const History& history = document.history();
  const size_t first = held_back ? execution.next_step() : execution.next_step() + 1;
  for (size_t i = first; i < history.position() && steps.size() < kMostWaiting; ++i) {
    if (history.cuts(i) && history.step(i).waiting() && execution.waits_for(i)) steps.push_back(i);
  }
  return steps;
}

// "Cut 2" of "Cut 2: roof, radius 4 mm".
std::string short_name(const History& history, size_t step, FileUnit unit) {
  const std::string words = step_words(history, step, unit);
  return words.substr(0, words.find(':'));
}

BeamPicture beam_of(const Document& document, size_t step) {
  const History& history = document.history();
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
    const size_t now = document.execution().next_step();
    const std::string why =
        step == now ? "Waits for its first stage" : "Waits for " + short_name(document.history(), now, unit);
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

}  // namespace kerf
