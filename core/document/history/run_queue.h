#pragma once

#include <functional>

#include "core/document/history/document.h"

namespace kerf {

// How the queue of a document is executed.
struct QueueRun {
  size_t moves_a_step = 64;  // the limit that Document::step is given
  size_t leave = 0;          // execution ends when the queue is not longer than this
  // Called after each step with its result, also if the step failed. Execution ends with the error that it
  // returns, if any. Without this function, execution ends with the first step that fails.
  std::function<Status(const Result<StepResult>&)> told;
  const Progress* progress = nullptr;  // may stop execution before and within each step
};

// Executes the queue of a document step by step. Fails with the error of `told`, or with cancelled() if
// `progress` stopped it; a stroke that was stopped within a step is undone by the document.
Status run_queue(Document& document, const QueueRun& how);

// Stops what the beam is at: the stroke that is being executed ends where it is, and those that wait behind
// it are undone, so that they can be redone. Also undoes a stroke of which nothing was executed. Does nothing
// if no moves wait.
Outcome stop_strokes(Document& document);

}  // namespace kerf
