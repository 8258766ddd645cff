#include "ui/editor/shared/statistics.h"

#include <unistd.h>
#include <algorithm>
#include <cmath>
#include <fstream>

#include "core/base/assert.h"
#include "core/document/cut_effects.h"
#include "core/joints/joined_parts.h"
#include "ui/editor/shared/world_changes.h"

namespace kerf {

namespace {
constexpr size_t kKept = 1'000'000;
}

void FrameStatistics::add(double milliseconds) {
  if (kept_.size() < kKept) {
    kept_.push_back(static_cast<float>(milliseconds));
  } else {
    kept_[frames_ % kKept] = static_cast<float>(milliseconds);
  }
  ++frames_;
  longest_ = std::max(longest_, milliseconds);
  last_ = milliseconds;
}

double FrameStatistics::percentile(double share) const {
  KERF_ASSERT(share >= 0 && share <= 1);
  if (kept_.empty()) return 0;
  std::vector<float> sorted = kept_;
  const double rank = std::ceil(share * static_cast<double>(sorted.size())) - 1;
  const auto index = static_cast<size_t>(std::clamp(rank, 0.0, static_cast<double>(sorted.size() - 1)));
  std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(index), sorted.end());
  return sorted[index];
}

void StepChart::record_step(const StepResult& step) {
  const StepStatistics& f = step.statistics;
  const bool cuts = step.moves > 0 || !step.delta.bodies.empty() || f.separate_s > 0;
  if (!cuts) return;  // only time passed
  size_t added = 0, dead = 0;
  for (const BodyDelta& body : step.delta.bodies) {
    added += body.added.size();
    dead += body.dead.size();
  }
  const std::array<std::pair<Line, double>, 7> now{{{kFind, 1e3 * f.query_s},
                                                    {kRefine, 1e3 * f.refine_s},
                                                    {kRemove, 1e3 * f.remove_s},
                                                    {kTree, 1e3 * f.update_tree_s},
                                                    {kSeparate, 1e3 * f.separate_s},
                                                    {kAdded, static_cast<double>(added)},
                                                    {kDead, static_cast<double>(dead)}}};
  for (const auto& [line, value] : now) add(line, value);
}

void StepChart::record_sent(size_t bytes) { add(kSent, static_cast<double>(bytes) / 1024); }

float StepChart::largest(Line line) const {
  const auto& values = lines_[line];
  return values.empty() ? 0 : *std::max_element(values.begin(), values.end());
}

void StepChart::add(Line line, double value) {
  std::vector<float>& values = lines_[line];
  if (values.size() == kKept) values.erase(values.begin());
  values.push_back(static_cast<float>(value));
}

size_t process_bytes() {
  std::ifstream file("/proc/self/statm");
  size_t all = 0, resident = 0;
  if (!(file >> all >> resident)) return 0;
  return resident * static_cast<size_t>(sysconf(_SC_PAGESIZE));
}

namespace {

// Leaves out parts that no cut separated, which joints hold or held.
void count_pieces(ShownStatistics& shown, const World& world, const std::set<PieceId>& specks) {
  shown.pieces = shown.specks = 0;
  for (const BodyId id : world.ids()) {
    const Body& body = world.body(id);
    for (uint32_t label = 0; label < body.pieces.size(); ++label) {
      if (body.pieces[label].faces == 0 || is_loaded_part(body, label)) continue;
      ++(specks.contains({id, label}) ? shown.specks : shown.pieces);
    }
  }
}

void add(const World& world, MemoryStatistics& statistics) {
  for (const BodyId id : world.ids()) {
    const Body& body = world.body(id);
    statistics.trees += body.tree.bytes();
    statistics.meshes += body.bytes() - body.tree.bytes();
  }
}

}  // namespace

void count_world(ShownStatistics& shown, const Document& document, bool tree_shown) {
  const World& world = document.world();
  shown.faces = world.live_faces();
  count_pieces(shown, world, specks(document));
  shown.tree_nodes = 0;
  shown.tree.reset();
  if (tree_shown) shown.tree.emplace();
  for (const BodyId id : world.ids()) {
    const Body& body = world.body(id);
    shown.tree_nodes += body.tree.box_count();
    if (tree_shown) shown.tree->add(tree_statistics(body.tree, body.mesh));
  }
}

namespace {

std::optional<size_t> last_knife_cut(const UndoStack& history) {
  for (size_t i = history.position(); i-- > 0;) {
    const Command& command = history.step(i).commands().front();
    if (std::holds_alternative<CutPlane>(command) || std::holds_alternative<CutPath>(command)) return i;
  }
  return std::nullopt;
}

}  // namespace

void record_stroke(ShownStatistics& shown, const UndoStack& history, const StepGroups& groups) {
  shown.stroke.reset();
  const auto last = history.last_cut();
  shown.cut_by_knife = last_knife_cut(history) > last;
  if (!last || shown.cut_by_knife) return;
  const StepGroups::Group* group = groups.at(*last + 1, true);
  shown.stroke.emplace();
  for (size_t i = group != nullptr ? group->from : *last; i <= *last; ++i) {
    if (!history.cuts(i) || history.is_cut_again(i)) continue;
    shown.stroke->statistics.add(history.step(i).totals().statistics);
    shown.stroke->removed_area += history.step(i).totals().removed_area;
  }
}

size_t MemoryStatistics::other() const {
  const size_t parts = meshes + trees + pictures.shading + pictures.shadows + pictures.graphics + history;
  return process - std::min(process, parts);
}

MemoryStatistics memory_statistics(std::span<const World* const> worlds, size_t history,
                                   const PictureMemory& pictures) {
  MemoryStatistics statistics;
  statistics.process = process_bytes();
  statistics.pictures = pictures;
  statistics.history = history;
  for (const World* world : worlds) {
    if (world != nullptr) add(*world, statistics);
  }
  return statistics;
}

}  // namespace kerf
