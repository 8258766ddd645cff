#pragma once

#include <cassert>
#include <optional>
#include <utility>

#include "core/base/result.h"
#include "core/world/delta.h"

namespace kerf {

// What a command did to a world, and why it failed where it did. A command that fails may have changed the
// world all the same, for what waited before it is done first: the delta always tells all that changed.
class Outcome {
 public:
  Outcome() = default;
  explicit Outcome(Delta changed) : delta(std::move(changed)) {}

  Delta delta;

  bool ok() const { return !error_; }
  explicit operator bool() const { return ok(); }
  // Precondition: !ok().
  const Error& error() const {
    assert(error_);
    return *error_;
  }
  void fail(Error error) { error_ = std::move(error); }

  // Makes this the outcome of this command and the next one together. Precondition: ok().
  void append(Outcome later) {
    assert(ok());
    delta.append(std::move(later.delta));
    error_ = std::move(later.error_);
  }

 private:
  std::optional<Error> error_;
};

}  // namespace kerf
