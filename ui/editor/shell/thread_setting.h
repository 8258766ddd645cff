#pragma once

#include <optional>

#include "core/base/assert.h"
#include "core/base/parallel.h"

namespace kerf {

// Keeps the limit of threads that the settings ask for.
class ThreadSetting {
 public:
  // 0 is as many as the machine has. Precondition: threads >= 0.
  void follow(int threads) {
    KERF_ASSERT(threads >= 0);
    if (threads == threads_) return;
    threads_ = threads;
    limit_.reset();
    if (threads > 0) limit_.emplace(static_cast<size_t>(threads));
  }

 private:
  int threads_ = 0;
  std::optional<ThreadLimit> limit_;
};

}  // namespace kerf
