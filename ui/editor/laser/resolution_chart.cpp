#include "ui/editor/laser/resolution_chart.h"

#include <imgui.h>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <span>

#include "core/base/assert.h"
#include "ui/editor/shared/command_labels.h"
#include "ui/window/layout.h"
#include "ui/window/number_text.h"
#include "ui/window/theme.h"
#include "ui/window/widgets.h"

namespace kerf {

namespace {

constexpr size_t kMovesAtOnce = 16;
constexpr size_t kDistancesAtOnce = 10'000;  // of points from sweeps, about a millisecond
constexpr float kHeightEms = 8;

// The volumes that the beam of a stroke sweeps, in the frame of a body.
std::vector<SweptCylinder> sweeps_of(const std::vector<Command>& stroke, const Placement& placement) {
  const auto* begin = std::get_if<BeginStroke>(&stroke.front());
  KERF_ASSERT(begin != nullptr);
  const Laser& laser = begin->settings.laser;
  std::vector<SweptCylinder> sweeps;
  Pose from = begin->pose;
  for (const Command& command : stroke) {
    const auto* move = std::get_if<MoveBeam>(&command);
    if (move == nullptr && !sweeps.empty()) continue;
    const Pose to = move != nullptr ? move->pose : begin->pose;
    sweeps.emplace_back(placement.to_body(from), placement.to_body(to), laser.radius, laser.range);
    from = to;
  }
  return sweeps;
}

double distance_from_boundary(const std::vector<SweptCylinder>& sweeps, const Vec3& p) {
  double signed_distance = std::numeric_limits<double>::infinity();
  for (const SweptCylinder& sweep : sweeps)
    signed_distance = std::min(signed_distance, sweep.signed_distance(p));
  return std::abs(signed_distance);
}

std::string text_of_sample(const ResolutionChart::Sample& sample, double radius, FileUnit unit) {
  std::string text = "Edge " + length_label(sample.fraction * radius, unit) + ": " +
                     count_text(sample.faces, "face") + " created";
  if (sample.error) text += ", error " + length_label(*sample.error, unit);
  return text + text_of(", %.0f ms. Click to use.", 1000 * sample.seconds);
}

bool have_errors(std::span<const ResolutionChart::Sample> samples) {
  return std::ranges::all_of(samples, [](const ResolutionChart::Sample& s) { return s.error.has_value(); });
}

// Returns the heights of the samples in the chart: their errors [m] if all have one, else their times [s].
std::vector<double> heights_of(std::span<const ResolutionChart::Sample> samples) {
  const bool are_errors = have_errors(samples);
  std::vector<double> heights;
  for (const ResolutionChart::Sample& s : samples) heights.push_back(are_errors ? *s.error : s.seconds);
  return heights;
}

// "Rim Error 0.2 mm to 3 mm", or the range of times unless all samples have errors.
std::string range_of_heights(std::span<const ResolutionChart::Sample> samples, FileUnit unit) {
  const auto [low, high] = std::ranges::minmax(heights_of(samples));
  if (!have_errors(samples)) return text_of("Time %.0f to ", 1000 * low) + text_of("%.0f ms", 1000 * high);
  return "Rim Error " + length_label(low, unit) + " to " + length_label(high, unit);
}

std::string range_of_faces(std::span<const ResolutionChart::Sample> samples) {
  const auto [low, high] = std::ranges::minmax(samples, {}, &ResolutionChart::Sample::faces);
  return grouped(low.faces) + " to " + count_text(high.faces, "face") + " created";
}

// A logarithmic axis over the range of some positive values.
class LogAxis {
 public:
  LogAxis(float from, float to) : from_(from), to_(to) {}
  void add(double value) {
    low_ = std::min(low_, std::log(value));
    high_ = std::max(high_, std::log(value));
  }
  float place(double value) const {
    const double share = high_ > low_ ? (std::log(value) - low_) / (high_ - low_) : 0.5;
    return from_ + static_cast<float>(share) * (to_ - from_);
  }

 private:
  float from_, to_;
  double low_ = std::numeric_limits<double>::infinity(), high_ = -low_;
};

}  // namespace

RimError::RimError(const World& world, const std::vector<Command>& stroke, double edge) : edge_(edge) {
  KERF_ASSERT(edge > 0);
  std::vector<Mesh::Side> sides;
  for (const BodyId id : world.ids()) {
    const Body& body = world.body(id);
    const auto sweeps = static_cast<uint32_t>(sweeps_.size());
    sweeps_.push_back(sweeps_of(stroke, body.placement));
    sides.clear();
    body.mesh.append_open_sides(sides);
    for (const Mesh::Side& side : sides)
      sides_.push_back({body.mesh.position(side.from), body.mesh.position(side.to), sweeps});
  }
}

void RimError::advance() {
  KERF_ASSERT(!done());
  for (size_t work = 0; work < kDistancesAtOnce && !done(); ++next_) {
    const Side& side = sides_[next_];
    const std::vector<SweptCylinder>& sweeps = sweeps_[side.sweeps];
    double farthest = 0;
    for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0}) {
      work += sweeps.size();
      farthest = std::max(farthest, distance_from_boundary(sweeps, (1 - t) * side.from + t * side.to));
      if (farthest > edge_) break;
    }
    if (farthest <= edge_) error_ = std::max(error_.value_or(0), farthest);
  }
}

bool ResolutionChart::Stroke::is_same(const Stroke& other) const {
  const auto are_same = [](const Pose& a, const Pose& b) {
    return a.origin == b.origin && a.direction == b.direction;
  };
  return step == other.step && radius == other.radius && pattern == other.pattern && scheme == other.scheme &&
         rim == other.rim && std::ranges::equal(poses, other.poses, are_same);
}

ResolutionChart::Stroke ResolutionChart::last_stroke(const UndoStack& history) {
  const size_t step = history.base_of(*history.last_cut());
  const CutSettings& settings = history.last_settings();
  const Laser& laser = settings.laser;
  const Resolution& resolution = settings.resolution;
  Stroke stroke{step, laser.radius, laser.pattern, resolution.scheme, resolution.rim, {}};
  for (const Command& command : history.step(step).commands()) {
    if (const auto* start = std::get_if<BeginStroke>(&command)) stroke.poses.push_back(start->pose);
    if (const auto* move = std::get_if<MoveBeam>(&command)) stroke.poses.push_back(move->pose);
  }
  return stroke;
}

void ResolutionChart::begin(const Document& document) {
  KERF_ASSERT(document.history().last_cut());
  clear();
  next_ = 0;
  stroke_ = last_stroke(document.history());
  revision_ = document.revision();
}

void ResolutionChart::advance(Document& document, double seconds) {
  using Clock = std::chrono::steady_clock;
  const UndoStack& history = document.history();
  if (!busy() && samples_.empty()) return;
  if (document.revision() != revision_) {
    if (busy() || !history.last_cut() || !last_stroke(history).is_same(stroke_)) return clear();
    revision_ = document.revision();
  }
  if (!busy()) return;
  ResolutionControls controls;
  show(kFractions.at(next_), controls);
  twin_.follow(document, controls);
  if (!twin_.there()) return clear();
  const Clock::time_point began = Clock::now();
  const auto passed = [&] { return std::chrono::duration<double>(Clock::now() - began).count(); };
  if (!rim_) {
    while (twin_.waiting() > 0 && passed() < seconds) {
      if (!twin_.step(kMovesAtOnce)) return clear();
    }
    seconds_ += passed();
    if (twin_.waiting() > 0) return;
    const double edge = kFractions.at(next_) * history.last_settings().laser.radius;
    rim_.emplace(twin_.world(), history.commands_of(*history.last_cut()), edge);
    return;
  }
  while (!rim_->done() && passed() < seconds) rim_->advance();
  if (!rim_->done()) return;
  samples_.push_back({kFractions.at(next_), twin_.faces_made(), std::exchange(seconds_, 0), rim_->error()});
  rim_.reset();
  if (++next_ == kFractions.size()) twin_.forget();
}

void ResolutionChart::show(double fraction, ResolutionControls& controls) const {
  controls.scheme = stroke_.scheme;
  controls.rule = Resolution::Rule::kTargetEdge;
  controls.edge_fraction = fraction;
  controls.rim = stroke_.rim;
}

std::optional<double> ResolutionChart::draw(FileUnit unit, std::optional<double> current) const {
  if (samples_.empty()) return std::nullopt;
  const float em = ImGui::GetFontSize(), width = ImGui::GetContentRegionAvail().x;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::InvisibleButton("##chart", {width, kHeightEms * em});
  mark_last_item("resolution chart");
  const bool hovered = ImGui::IsItemHovered(), clicked = ImGui::IsItemClicked();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(at, {at.x + width, at.y + kHeightEms * em}, ImGui::GetColorU32(ImGuiCol_FrameBg), 3);
  LogAxis faces(at.x + 1.2f * em, at.x + width - 1.2f * em);
  LogAxis heights(at.y + (kHeightEms - 2) * em, at.y + 1.8f * em);
  std::vector<double> shown = heights_of(samples_);
  for (double& height : shown) heights.add(height = std::max(height, 1e-12));
  for (const Sample& s : samples_) faces.add(static_cast<double>(s.faces) + 1);
  std::optional<size_t> nearest;
  std::vector<ImVec2> places;
  for (size_t i = 0; i < samples_.size(); ++i)
    places.push_back({faces.place(static_cast<double>(samples_[i].faces) + 1), heights.place(shown[i])});
  const ImVec2 pointer = ImGui::GetIO().MousePos;
  for (size_t i = 0; hovered && i < places.size(); ++i) {
    if (!nearest || std::abs(places[i].x - pointer.x) < std::abs(places[*nearest].x - pointer.x)) nearest = i;
  }
  list.AddPolyline(places.data(), static_cast<int>(places.size()), colours::secondary(), 0, 1.5f);
  for (size_t i = 0; i < places.size(); ++i) {
    list.AddCircleFilled(places[i], nearest == i ? 5.0f : 3.5f,
                         nearest == i ? colours::accent() : colours::text());
    if (current == samples_[i].fraction) list.AddCircle(places[i], 7, colours::accent(), 0, 1.5f);
  }
  list.AddText({at.x + 0.4f * em, at.y + 0.2f * em}, colours::secondary(),
               range_of_heights(samples_, unit).c_str());
  const std::string right = range_of_faces(samples_);
  list.AddText(
      {at.x + width - ImGui::CalcTextSize(right.c_str()).x - 0.4f * em, at.y + (kHeightEms - 1.3f) * em},
      colours::secondary(), right.c_str());
  if (!nearest) return std::nullopt;
  ImGui::SetTooltip("%s", text_of_sample(samples_[*nearest], stroke_.radius, unit).c_str());
  return clicked ? std::optional(samples_[*nearest].fraction) : std::nullopt;
}

}  // namespace kerf
