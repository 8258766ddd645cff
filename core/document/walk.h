#pragma once

#include <functional>

#include "core/document/document.h"

namespace kerf {

// How a document is walked.
struct Walk {
  size_t moves_a_step = 64;  // at most, see Document::step
  size_t leave = 0;          // the walk ends when no more than so many wait
  // Hears of each step, also of one that failed; the walk ends with what it returns where that is an error.
  // Without it the walk ends with the first step that fails.
  std::function<Status(const Result<StepResult>&)> told;
  const Progress* progress = nullptr;  // asked before each step and in it
};

// Walks what waits in a document, step by step. Fails as `told` says, and where `progress` stops it: before a
// step, or in one, whose stroke the document then undoes.
Status walk(Document& document, const Walk& how);

}  // namespace kerf
