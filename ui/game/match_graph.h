#pragma once

#include <memory>

#include "core/game/match/match.h"
#include "core/graph/drawn_graph.h"

namespace kerf {

// The component graph of the vehicle that the player cut last, with the faces that the beams removed from it.
class MatchGraph {
 public:
  // Takes what the last tick changed. To be called after every tick.
  void follow(const Match& match);
  void clear();

  // The graph, made anew at most every kPause seconds of the match while it changes; null before the first
  // cut. Linear in the faces of the body when it is made. Precondition: the match is the one that was
  // followed since clear().
  const std::shared_ptr<const DrawnGraph>& drawn(const Match& match);
  static constexpr double kPause = 0.25;

 private:
  void watch(BodyId body);

  BodyId body_;
  CutFaces removed_;  // from body_, at most the last DrawnGraph::kMost
  bool changed_ = false;
  Ticks made_ = 0;
  std::shared_ptr<const DrawnGraph> drawn_;
};

}  // namespace kerf
