#pragma once

#include <optional>
#include <string>

#include "core/document/history/document.h"

namespace kerf {

// How far the beam has come with what waits in the queue of a document, for the status bar. It is told only
// of work that lasts, because a text that comes and goes only disturbs.
class CutProgress {
 public:
  // To be called once a frame after the queue was worked on; `seconds` have passed since the last call. While
  // it is `held_back`, nobody waits for the queue.
  void follow(const Document& document, bool held_back, double seconds);
  // Whether there is such work, and it can be stopped.
  bool can_stop() const { return lasts() && work_ == Work::kCut; }
  // What is at work, or empty: "Cutting, 40 %, Esc stops".
  std::string text() const;

 private:
  enum class Work {
    kNone,
    kCut,
    kEnd,     // the end of a stroke, which is not stopped
    kSearch,  // for what came apart
  };
  static Work work_of(const Document& document);
  bool lasts() const;

  Work work_ = Work::kNone;
  size_t waits_ = 0, done_ = 0;  // moves and the like, since the queue was empty last
  double seconds_ = 0;           // since then
};

}  // namespace kerf
