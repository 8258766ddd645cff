#include "ui/editor/laser/cut_progress.h"

#include <algorithm>

#include "ui/window/number_text.h"

namespace kerf {

namespace {
constexpr double kUnseen = 0.3;  // s, of work that is not told of
}

CutProgress::Work CutProgress::work_of(const Document& document) {
  if (document.waiting() == 0) return Work::kNone;
  if (document.execution().beam_waits()) return document.execution().moves_wait() ? Work::kCut : Work::kEnd;
  return document.execution().next_searches() ? Work::kSearch : Work::kNone;
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
      return text_of("Cutting, %.0f %%, Esc stops", std::min(99.0, 100 * done / all));
    }
    case Work::kEnd:
      return "Smoothing the rim";
    case Work::kSearch:
      return "Looking for what came apart";
  }
  return "";
}

}  // namespace kerf
