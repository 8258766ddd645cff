#pragma once

#include <string>
#include <vector>

#include "core/document/history/document.h"
#include "ui/editor/shared/picture/view_state.h"
#include "ui/render/passes/beam_pass.h"

struct ImDrawList;

namespace kerf {

// The strokes of which nothing is cut yet: those behind the one that is being cut, and one that single steps
// hold back. Their beams are drawn dimmed where they begin, with what they wait for.
class WaitingStrokes {
 public:
  struct Stroke {
    size_t step = 0;  // of the history
    std::string waits_for;
    BeamPicture beam;
  };

  // To be called once a frame after the queue was worked on; `seconds` have passed since the last call.
  // `held_back`: the last stroke waits for the user. Returns whether the beams have changed. Casts rays for
  // each stroke that began to wait. A stroke that waits only briefly for another one is left out.
  bool follow(const Document& document, FileUnit unit, bool held_back, double seconds);

  const std::vector<Stroke>& strokes() const { return strokes_; }
  // Writes at each beam what it waits for.
  void draw(const ViewState& view, ImDrawList& list) const;

 private:
  std::vector<Stroke> strokes_;
  size_t revision_ = 0;  // of the document
  double behind_ = 0;    // s, that strokes have waited for one that is being cut
  bool held_back_ = false;
};

}  // namespace kerf
