#include "ui/editor/inspect/heat_probe.h"

#include <imgui.h>

#include <algorithm>

#include "core/base/assert.h"
#include "core/base/tick.h"
#include "ui/render/bodies/pick.h"
#include "ui/window/landmarks.h"
#include "ui/window/number_text.h"
#include "ui/window/theme.h"

namespace kerf {

namespace {

constexpr double kBefore = 1e-3, kWithin = 1e-4;  // diagonals of the world
constexpr double kLeastSpan = 100;                // K

std::optional<double> temperature_at(const World& world, const ViewState& view, const Pose& ray) {
  const auto seen = pick(world, view.look, ray);
  const double diagonal = world.loaded_bounds().diagonal();
  if (!seen || seen->length > (kBefore + kWithin) * diagonal) return std::nullopt;
  const Body& body = world.body(seen->body);
  return body.heat.temperature(body.mesh, seen->face, body.sheet.substance, body.sheet.thickness);
}

// The part of the box in which the curve lies.
struct Plot {
  ImVec2 at, size;
  double from = 0, to = 1, least = kAmbient, most = kAmbient;

  ImVec2 place(const HeatProbe::Sample& s) const {
    return {at.x + static_cast<float>((s.seconds - from) / (to - from)) * size.x,
            at.y + size.y - static_cast<float>((s.temperature - least) / (most - least)) * size.y};
  }
};

Plot plot_of(const std::vector<HeatProbe::Sample>& samples, ImVec2 at, ImVec2 size) {
  KERF_ASSERT(samples.front().seconds < samples.back().seconds);
  Plot plot{at, size, samples.front().seconds, samples.back().seconds};
  for (const HeatProbe::Sample& s : samples) plot.most = std::max(plot.most, s.temperature);
  plot.most = std::max(plot.most, kAmbient + kLeastSpan);
  return plot;
}

}  // namespace

void HeatProbe::follow(const World& world, const ViewState& view, const std::optional<Vec3>& clicked,
                       bool inspects) {
  if (clicked != at_) {
    at_ = clicked;
    samples_.clear();
    if (!at_) return;
    const Vec3 eye = view.seen_first().eye, way = glm::normalize(*at_ - eye);
    ray_ = {*at_ - kBefore * world.loaded_bounds().diagonal() * way, way};
  }
  if (!at_ || (!inspects && !view.look.show.heat)) return;
  const double seconds = static_cast<double>(world.clock()) / kTicksPerSecond;
  if (!samples_.empty() && seconds < samples_.back().seconds) samples_.clear();
  if (!samples_.empty() && seconds == samples_.back().seconds) return;
  if (const auto now = temperature_at(world, view, ray_)) add({seconds, *now});
}

// Where there are too many, every second one goes.
void HeatProbe::add(const Sample& sample) {
  if (samples_.size() >= kMostSamples) {
    size_t kept = 0;
    for (size_t i = 0; i < samples_.size(); i += 2) samples_[kept++] = samples_[i];
    samples_.resize(kept);
  }
  samples_.push_back(sample);
}

void draw_heat_probe(const HeatProbe& probe, const Area& picture) {
  const std::vector<HeatProbe::Sample>& samples = probe.samples();
  if (samples.size() < 2) return;
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const float em = ImGui::GetFontSize(), line = 1.2f * em;
  const ImVec2 size(17 * em, 9 * em);
  const Vec2 end = picture.at + picture.size;
  const ImVec2 at(static_cast<float>(end.x) - size.x - em, static_cast<float>(end.y) - size.y - em);
  list.AddRectFilled(at, {at.x + size.x, at.y + size.y}, IM_COL32(0x1b, 0x1f, 0x26, 230), 3);
  list.AddText({at.x + 0.6f * em, at.y + 0.4f * em}, colours::kPictureText,
               text_of("%.0f K at the point", samples.back().temperature).c_str());
  const Plot plot = plot_of(samples, {at.x + 0.6f * em, at.y + 0.8f * em + line},
                            {size.x - 1.2f * em, size.y - 1.6f * em - 2 * line});
  list.AddRectFilled(plot.at, {plot.at.x + plot.size.x, plot.at.y + plot.size.y}, IM_COL32(10, 12, 16, 160));
  std::vector<ImVec2> curve;
  for (const HeatProbe::Sample& s : samples) curve.push_back(plot.place(s));
  list.AddPolyline(curve.data(), static_cast<int>(curve.size()), colours::accent(), 0, 1.6f);
  list.AddText({plot.at.x + 0.3f * em, plot.at.y + 0.1f * em}, colours::kPictureSecondary,
               text_of("%.0f K", plot.most).c_str());
  const float below = plot.at.y + plot.size.y + 0.2f * em;
  list.AddText({plot.at.x, below}, colours::kPictureSecondary,
               text_of("over %.3g s", plot.to - plot.from).c_str());
  mark_area("heat probe", {{at.x, at.y}, {size.x, size.y}});
}

}  // namespace kerf
