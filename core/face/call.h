#pragma once

#include <functional>
#include <string>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/kerf_c.h"

namespace kerf {

// How a function of the library runs: with the floating-point modes that Kerf computes with and as many
// threads as the caller allows, and without letting an exception out. The message of what fails is kept for
// kerf_message().
class Call {
 public:
  // `control` may be null.
  explicit Call(const kerf_control* control);

  // Returns the result of the work: that of its status, or of what it throws.
  kerf_result run(const std::function<Status(const Progress&)>& work);

 private:
  kerf_control control_{};
  bool stopped_ = false;
};

// Keeps the message of an error for this thread, and returns its code.
kerf_result told(kerf_result result, const char* message) noexcept;

// The message that was kept last in this thread.
const char* last_message();

}  // namespace kerf
