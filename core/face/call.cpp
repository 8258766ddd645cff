#include "core/face/call.h"

#include <xmmintrin.h>

#include <cfenv>
#include <new>
#include <utility>

#include "core/base/parallel.h"

namespace kerf {

namespace {

constexpr unsigned kMostThreads = 1024;

std::string& kept_message() {
  static thread_local std::string message;
  return message;
}

// Rounding to nearest, without flushing of small numbers to zero, while it exists. Programs that were
// compiled with -ffast-math run with the latter.
class DefaultArithmetic {
 public:
  DefaultArithmetic() : control_(_mm_getcsr()) {
    std::fegetenv(&environment_);
    std::fesetenv(FE_DFL_ENV);
    _mm_setcsr(kDefault);
  }
  ~DefaultArithmetic() {
    std::fesetenv(&environment_);
    _mm_setcsr(control_);
  }
  DefaultArithmetic(const DefaultArithmetic&) = delete;
  DefaultArithmetic& operator=(const DefaultArithmetic&) = delete;

 private:
  static constexpr unsigned kDefault = 0x1f80;

  std::fenv_t environment_{};
  unsigned control_;
};

}  // namespace

kerf_result told(kerf_result result, std::string message) {
  kept_message() = std::move(message);
  return result;
}

const char* last_message() { return kept_message().c_str(); }

Call::Call(const kerf_control* control) {
  if (control != nullptr) control_ = *control;
}

kerf_result Call::run(const std::function<Status(const Progress&)>& work) {
  if (control_.threads > kMostThreads) return told(KERF_BAD_INPUT, "threads: must be at most 1024");
  const DefaultArithmetic arithmetic;
  const Progress progress{[&](double share) {
    stopped_ = stopped_ || (control_.progress != nullptr && control_.progress(share, control_.user) != 0);
    return !stopped_;
  }};
  try {
    Status status = Done{};
    with_threads(control_.threads, [&] { status = work(progress); });
    if (status) return KERF_OK;
    if (stopped_) return told(KERF_CANCELLED, "cancelled");
    const bool bad = status.error().code == ErrorCode::kBadInput;
    return told(bad ? KERF_BAD_INPUT : KERF_FAILED, status.error().message);
  } catch (const std::bad_alloc&) {
    return told(KERF_FAILED, "there is not enough memory");
  } catch (const std::exception& fault) {
    return told(KERF_FAILED, fault.what());
  }
}

}  // namespace kerf
