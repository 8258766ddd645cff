#include "ui/game/match_graph.h"

#include "core/base/assert.h"

namespace kerf {

void MatchGraph::clear() { *this = MatchGraph(); }

void MatchGraph::watch(BodyId body) {
  if (body == body_) return;
  clear();
  body_ = body;
}

void MatchGraph::follow(const Match& match) {
  for (const Event& event : match.events()) {
    const bool enemy = event.vehicle != Match::kPlayer && event.vehicle != Event::kNobody;
    if (event.kind == Event::Kind::kCut && event.by == Match::kPlayer && enemy)
      watch(match.vehicles()[event.vehicle].chassis);
  }
  if (!body_.valid()) return;
  for (const Detached& piece : match.delta().detached) changed_ = changed_ || piece.from == body_;
  for (const BodyDelta& body : match.delta().bodies) {
    if (body.body != body_) continue;
    changed_ = true;
    std::vector<CutFace>& all = removed_[body_];
    all.insert(all.end(), body.removed.begin(), body.removed.end());
    if (all.size() > DrawnGraph::kMost) all.erase(all.begin(), all.end() - DrawnGraph::kMost);
  }
}

const std::shared_ptr<const DrawnGraph>& MatchGraph::drawn(const Match& match) {
  const Ticks now = match.standing().ticks;
  KERF_ASSERT(!drawn_ || now >= made_);
  const bool waits = drawn_ && seconds_of_ticks(now - made_) < kPause;
  if (!changed_ || waits || !match.world().contains(body_)) return drawn_;
  const CutGraph graph = cut_graph(match.world(), removed_);
  const auto start = start_beside_cut(graph);
  if (!start) return drawn_;
  drawn_ =
      std::make_shared<DrawnGraph>(draw_graph(graph, traverse_cut(graph, *start), GraphScope::kAroundCut));
  changed_ = false;
  made_ = now;
  return drawn_;
}

}  // namespace kerf
