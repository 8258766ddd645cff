#include "ui/editor/path/uncut_lines.h"

#include <imgui.h>
#include <algorithm>
#include <utility>

#include "core/document/cut_report.h"
#include "ui/editor/shared/command_labels.h"
#include "ui/editor/shared/panel_rows.h"
#include "ui/render/passes/beam_effects.h"
#include "ui/window/number_text.h"
#include "ui/window/theme.h"
#include "ui/window/widgets.h"

namespace kerf {

namespace {

constexpr ImU32 kUncutColour = IM_COL32(0xff, 0xb0, 0x20, 255), kUncutShade = IM_COL32(10, 12, 16, 150);

void draw_uncut(std::span<const UncutLine> lines, const PrimaryViewport& picture, ImDrawList& list) {
  for (const UncutLine& line : lines) {
    for (const std::vector<Vec3>& part : line.parts) {
      std::vector<ImVec2> run;
      for (const Vec3& p : part) {
        if (const auto place = picture.place_of(p)) run.push_back(to_im(*place));
      }
      const auto count = static_cast<int>(run.size());
      list.AddPolyline(run.data(), count, kUncutShade, 0, 5);
      list.AddPolyline(run.data(), count, kUncutColour, 0, 2.6f);
    }
  }
}

}  // namespace

std::vector<UncutLine> uncut_lines(std::span<const StrokePath> strokes, const Interval& range,
                                   const World& world) {
  constexpr int kSamples = 32;  // of each segment, and one
  std::vector<UncutLine> all;
  for (size_t i = 0; i < strokes.size(); ++i) {
    const StrokePath& stroke = strokes[i];
    if (stroke.radius == 0.0) continue;
    const double high = stroke.range.value_or(range).high;
    UncutLine line{i, 0, {}};
    for (size_t k = 0; k + 1 < stroke.keys.size(); ++k) {
      const Pose &from = stroke.keys[k], &to = stroke.keys[k + 1];
      std::vector<std::vector<Vec3>> parts;
      size_t met = 0;
      for (int s = 0; s <= kSamples; ++s) {
        const double share = static_cast<double>(s) / kSamples;
        const Pose beam{glm::mix(from.origin, to.origin, share),
                        glm::normalize(glm::mix(from.direction, to.direction, share))};
        const auto hit = first_hit(world, beam);
        const bool meets = hit && *hit <= high;
        if (!meets || parts.empty()) parts.emplace_back();
        if (meets) parts.back().push_back(beam.origin + *hit * beam.direction);
        met += meets ? 1 : 0;
      }
      const double left = static_cast<double>(met) / (kSamples + 1);
      if (left <= kUncutShare) continue;
      line.share += left * (stroke.times[k + 1] - stroke.times[k]) / duration_of(stroke);
      line.parts.insert(line.parts.end(), parts.begin(), parts.end());
    }
    std::erase_if(line.parts, [](const auto& part) { return part.size() < 2; });
    if (!line.parts.empty()) all.push_back(std::move(line));
  }
  return all;
}

void UncutMarks::begin(const Workspace& workspace, std::span<const StrokePath> strokes) {
  lines_.clear();
  strokes_.clear();
  position_before_ = workspace.session.document.history().position();
  if (workspace.laser.model == Model::kThermal) strokes_.assign(strokes.begin(), strokes.end());
}

void UncutMarks::update(const Workspace& workspace) {
  const Document& document = workspace.session.document;
  if (document.revision() != revision_) clear();
  const bool is_done = document.waiting() == 0 && !workspace.changes.is_pending();
  if (strokes_.empty() || !is_done) return;
  const std::vector<StrokePath> all = std::exchange(strokes_, {});
  if (document.history().position() == position_before_) return;  // it failed
  const double diagonal = workspace.world().bounds().diagonal();
  lines_ = uncut_lines(all, workspace.laser.settings(diagonal).laser.range, workspace.world());
  revision_ = document.revision();
}

void UncutMarks::draw(Workspace& workspace, ImDrawList& list) const {
  if (lines_.empty() || workspace.cutting()) return;
  const Area& first = workspace.view.layout.first;
  list.PushClipRect(to_im(first.at), to_im(first.at + first.size), true);
  draw_uncut(lines_, PrimaryViewport(workspace.view), list);
  list.PopClipRect();
  workspace.services.badges.draw(workspace.view, Badges::Sign::kMode,
                                 count_text(lines_.size(), "line") + " not cut through", "uncut lines");
}

void UncutMarks::draw_list() const {
  if (lines_.empty()) return;
  secondary_text("Lines not cut through, and the uncut share of each:");
  constexpr size_t kMaxListed = 12;
  for (size_t i = 0; i < std::min(lines_.size(), kMaxListed); ++i)
    secondary_text(text_of("Line %zu: %.0f %%", lines_[i].stroke + 1, 100 * lines_[i].share));
  if (lines_.size() > kMaxListed) secondary_text(count_text(lines_.size() - kMaxListed, "line") + " more");
}

}  // namespace kerf
