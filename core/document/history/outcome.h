#pragma once

#include <optional>
#include <utility>

#include "core/base/assert.h"
#include "core/base/result.h"
#include "core/world/delta.h"

namespace kerf {

// The result of a command: what changed in the world, and the error if the command failed. The delta may be
// non-empty also on failure, because the queue of the document is executed before the command.
class Outcome {
 public:
  Outcome() = default;
  explicit Outcome(Delta changed) : delta(std::move(changed)) {}

  Delta delta;

  bool ok() const { return !error_; }
  explicit operator bool() const { return ok(); }
  // Precondition: !ok().
  const Error& error() const {
    KERF_ASSERT(error_);
    return *error_;
  }
  void fail(Error error) { error_ = std::move(error); }

  // Makes this the outcome of this command and the next one together. Precondition: ok().
  void append(Outcome later) {
    KERF_ASSERT(ok());
    delta.append(std::move(later.delta));
    error_ = std::move(later.error_);
  }

 private:
  std::optional<Error> error_;
};

}  // namespace kerf
